"""meshes_test.py MAKE_MESHES MESHES: the hull files are what make_meshes makes.

Numbers may differ in their last digits, as those of another compiler's or processor's do.
"""
import glob
import os
import re
import shutil
import subprocess
import sys
import tempfile

from glb_file import Glb

make_meshes, meshes = sys.argv[1:3]
NUMBER = re.compile(r"-?\d+\.?\d*(?:e-?\d+)?")


def words_and_numbers(path):
    if path.endswith(".glb"):
        glb = Glb(path)
        text = str([(name, glb.parts[name]) for name in glb.parts])
    else:
        with open(path, encoding="utf-8") as file:
            text = file.read()
    return NUMBER.sub("#", text), [float(word) for word in NUMBER.findall(text)]


def same(ours, theirs):
    """OBJ files have ten digits, 1e-8 of 90 m; GLB files those of single precision, 5e-7 of 6 m."""
    (words, numbers), (other, others) = words_and_numbers(ours), words_and_numbers(theirs)
    tolerance = 1e-6 if ours.endswith(".glb") else 1e-7
    return words == other and all(abs(a - b) <= tolerance for a, b in zip(numbers, others))


with tempfile.TemporaryDirectory() as folder:
    # S-175 is lofted through a table.
    os.mkdir(os.path.join(folder, "s175"))
    shutil.copy(os.path.join(meshes, "s175/offsets.csv"), os.path.join(folder, "s175"))
    subprocess.run([make_meshes, folder], check=True)
    kept, made = (sorted(os.path.relpath(path, root) for ending in ("obj", "glb")
                         for path in glob.glob(f"{root}/*/*.{ending}"))
                  for root in (meshes, folder))
    if kept != made:
        sys.exit(f"meshes/ holds {kept}, make_meshes makes {made}")
    different = [name for name in kept
                 if not same(os.path.join(folder, name), os.path.join(meshes, name))]
    sys.exit(f"make_meshes makes others of {different}" if different else None)
