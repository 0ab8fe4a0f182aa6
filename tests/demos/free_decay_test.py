"""free_decay_test.py PROGRAM DATABASE EXTREMA.csv: the dropped sphere of IEA OES Task 10.

From mesh to motion: our own solver's coefficients, memory and Bullet, against the linear answer.
Bounds 0.03 s and 0.01 m: the acceptance line; the reference's own uncertainty is 0.001 m, and two
panel codes of the task differ by 0.01 m.
"""
import re
import subprocess
import sys

from results import record


def linear_extrema(path):
    with open(path, encoding="utf-8") as file:
        rows = [line.strip().split(",") for line in file if not line.startswith("#")]
    return [(float(t), float(z)) for code, _, t, z in rows[1:] if code == "linear_here"]


program, database, reference = sys.argv[1:]
output = subprocess.run([program, database, "free_decay.csv"], check=True, capture_output=True,
                        text=True).stdout
swings = [(float(t), float(z)) for z, t in re.findall(r"swing \d+: (\S+) m at (\S+) s", output)]
expected = linear_extrema(reference)
assert len(expected) == 8 and len(swings) >= 8, output
late = max(abs(s[0] - e[0]) for s, e in zip(swings, expected))
off = max(abs(s[1] - e[1]) for s, e in zip(swings, expected))
WHAT = "sphere dropped from 1 m, solved mesh: worst "
record("5 Plugin", WHAT + "time of 8 extrema [s]", "linear_here", late, "0.03")
record("5 Plugin", WHAT + "height of 8 extrema [m]", "linear_here", off, "0.01")
print(f"times within {late:.4f} s, heights within {off:.5f} m")
assert late <= 0.03 and off <= 0.01
