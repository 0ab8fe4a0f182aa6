"""keys_test.py CUTWATER ROOT: the manual's tables of keys are what the program reads: the same
keys in each table, by the list that a wrong key is answered with, and the same ranges."""
import os
import re
import subprocess
import sys
import tempfile
import unittest

cutwater, root = sys.argv[1:3]
frigate = os.path.join(root, "meshes/frigate/frigate_224.obj")

SHIP = {
    "hull": f'[hull]\nmesh = "{frigate}"\n',
    "mass": "[mass]\ncog = [-2.4, 0.0, 1.29]\n",
}
DATABASE = f'database = "{frigate}"\n'  # read after the run file: any file will do


def tables(text):
    """{(file, table, kind of waves): {key: range}} of the manual's page."""
    found = {}
    file = table = kind = None
    for line in text.splitlines():
        if heading := re.match(r"## (\w+\.toml)", line):
            file = heading.group(1)
        elif heading := re.match(r"### \[*(\w+)\]*", line):
            table, kind = heading.group(1), ""
        elif line.startswith("`type = "):
            kind = re.match(r'`type = "([\w-]+)"', line).group(1)
        elif line.startswith("| `"):
            cells = [cell.strip() for cell in line.strip("| ").split("|")]
            for key in re.findall(r"`([^`]+)`", cells[0]):
                found.setdefault((file, table, kind), {})[key] = cells[2]
    return found


class Keys(unittest.TestCase):
    def setUp(self):
        with open(os.path.join(root, "docs/keys.md"), encoding="utf-8") as page:
            self.tables = tables(page.read())
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def refusal(self, file, table, kind, line):
        """What the program says to a file whose table holds this line."""
        name = os.path.join(self.folder, file)
        parts = dict(SHIP) if file == "ship.toml" else {}
        if file == "run.toml":
            parts["top"] = DATABASE
        text = parts.get(table, f"[{table}]\n")
        if table == "compartment":
            text = "[[compartment]]\ncentre = [0.0, 0.0, 0.0]\nsize = [1.0, 1.0, 1.0]\n"
        if kind == "components":
            wave = {"omega": "omega = 1.0", "amplitude": "amplitude = 1.0"}
            wave[line.split()[0]] = line
            items = ", ".join(wave.values())
            text += f'type = "components"\ncomponents = [{{ {items} }}]\n'
        else:
            if kind:
                text += f'type = "{kind}"\n'
            if kind == "table" and not line.startswith("file"):
                with open(os.path.join(self.folder, "s.csv"), "w", encoding="utf-8") as out:
                    out.write("omega,S\n0.5,1\n1.5,0\n")
                text += 'file = "s.csv"\n'
            if kind == "regular" and not line.startswith("omega"):
                text += "omega = 1.0\n"
            if table == "body":
                text += "gyradii = [1.0, 1.0, 1.0]\nsize = [1.0, 1.0, 1.0]\n"
            text += line + "\n"
        parts[table] = text
        top = parts.pop("top", "")
        with open(name, "w", encoding="utf-8") as out:
            out.write(top + "".join(parts.values()))
        verb = ["hydrostatics", name] if file == "ship.toml" else ["simulate", name]
        run = subprocess.run([cutwater, *verb], capture_output=True, text=True, check=False)
        self.assertEqual(run.returncode, 1, run.stderr)
        return run.stderr.strip().splitlines()[-1]

    def test_tables_hold_the_keys_that_are_read(self):
        waves = ("run.toml", "waves", "")
        for (file, table, kind), keys in self.tables.items():
            with self.subTest(file=file, table=table, kind=kind):
                said = self.refusal(file, table, kind, "no_such_key = 1")
                known = set(said.split("known here: ")[1].split(", "))
                expected = set(keys)
                if table == "waves" and kind not in ("", "components"):
                    expected |= set(self.tables[waves])
                if table == "top":
                    known -= {"bullet", "motion", "waves", "body", "compartment"}
                self.assertEqual(known, expected)

    def test_ranges_are_those_that_are_checked(self):
        checked = 0
        for (file, table, kind), keys in self.tables.items():
            for key, allowed in keys.items():
                bounds = re.fullmatch(r"(-?[\d.e+-]+?)\.\.(-?[\d.e+-]+)", allowed)
                if not bounds:
                    continue
                with self.subTest(file=file, table=table, key=key):
                    whole = key in ("panels", "substeps", "order", "components", "seed",
                                    "member",
                                    "hull_triangles")
                    beyond = "9000000000000" if whole else "9e90"
                    said = self.refusal(file, table, kind, f"{key} = {beyond}")
                    told = re.search(r"(?:must be in|each value must be in) (\S+)\.\.(\S+)$", said)
                    self.assertTrue(told, said)
                    self.assertEqual([float(told.group(i)) for i in (1, 2)],
                                     [float(bounds.group(i)) for i in (1, 2)], said)
                    checked += 1
        self.assertGreater(checked, 40)

    def test_choices_are_those_that_are_taken(self):
        for (file, table, kind), keys in self.tables.items():
            for key, allowed in keys.items():
                names = re.findall(r"`([\w-]+)`", allowed)
                if not names or names == ["true", "false"]:
                    continue
                with self.subTest(file=file, table=table, key=key):
                    said = self.refusal(file, table, kind, f'{key} = "no such choice"')
                    told = re.search(r"must be one of (.*)$", said)
                    self.assertTrue(told, said)
                    taken = set(re.findall(r'"([^"]+)"', told.group(1)))
                    self.assertEqual(taken, set(names), said)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
