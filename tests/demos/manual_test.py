"""manual_test.py CUTWATER ROOT: what the prose shows is what is built and run. plugin/README.md
quotes docs/samples/y_up.cpp, and the ship.toml of docs/your_own_ship.md floats."""
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

cutwater, root = (os.path.abspath(word) for word in sys.argv[1:3])


def read(path):
    with open(os.path.join(root, path), encoding="utf-8") as file:
        return file.read()


def block(text, language):
    return re.search(rf"```{language}\n(.*?)```", text, re.S).group(1)


def marked(text, mark):
    """The lines between two marks, without their common indent."""
    lines = text.split(f"//! [{mark}]\n")[1].splitlines()
    indent = min(len(line) - len(line.lstrip()) for line in lines if line.strip())
    return "\n".join(line[indent:] for line in lines).strip()


class Manual(unittest.TestCase):
    def test_the_plugins_readme_quotes_its_sample(self):
        sample = read("docs/samples/y_up.cpp")
        expected = marked(sample, "includes") + "\n\n" + marked(sample, "ship")
        self.assertEqual(block(read("plugin/README.md"), "cpp").strip(), expected)

    def test_the_ship_file_of_the_manual_floats(self):
        with tempfile.TemporaryDirectory() as folder:
            shutil.copy(os.path.join(root, "meshes/boat/boat.glb"), folder)
            name = os.path.join(folder, "ship.toml")
            with open(name, "w", encoding="utf-8") as file:
                file.write(block(read("docs/your_own_ship.md"), "toml"))
            run = subprocess.run([cutwater, "hydrostatics", name], capture_output=True, text=True,
                                 check=False)
            self.assertEqual(run.returncode, 0, run.stderr)
            self.assertNotIn("warning", run.stderr)
            values = dict(line.split(",")[:2] for line in run.stdout.splitlines())
            self.assertGreater(float(values["gm_t"]), 0.0)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
