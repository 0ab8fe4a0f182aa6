"""hello_ship_boat_test.py PROGRAM: without arguments it sails the boat that the build made."""
import csv
import io
import subprocess
import sys

program = sys.argv[1]
done = subprocess.run([program], capture_output=True, text=True, check=True)
rows = [{name: float(value) for name, value in row.items()}
        for row in csv.DictReader(io.StringIO(done.stdout))]
assert len(rows) == 3601 and abs(rows[-1]["t"] - 60.0) < 1e-6, rows[-1]
assert "boat.h5" in done.stderr, done.stderr

# 3 m/s for a minute with a helmsman. A wave of 0.6 m moves the water by less than 1 m.
assert abs(rows[-1]["x"] - 180.0) < 10.0, rows[-1]
assert max(abs(row["y"]) for row in rows) < 20.0
assert max(abs(row["yaw_deg"]) for row in rows) < 15.0
# At rest its centre of gravity is 0.3 m above calm water; waves of Hs 0.6 m reach 0.6 m.
assert abs(rows[0]["z"] - 0.3) < 1e-3, rows[0]
assert all(abs(row["z"] - 0.3) < 0.8 for row in rows)
# It moves, and does not turn over.
late = rows[1200:]
for name, least, most in (("roll_deg", 1.0, 25.0), ("pitch_deg", 0.3, 10.0)):
    reached = max(abs(row[name]) for row in late)
    assert least < reached < most, (name, reached)

refused = subprocess.run([program, "nowhere.h5"], capture_output=True, text=True, check=False)
assert refused.returncode == 1 and refused.stdout == "", refused
assert "nowhere.h5" in refused.stderr and refused.stderr.count("\n") == 1, refused.stderr
