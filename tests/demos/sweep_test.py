"""sweep_test.py COMMAND DATABASE ROOT: regular waves in Bullet against the frequency domain.

Default: the coarse frigate, a few waves, two headings. With CUTWATER_FULL: demos/runs, the frigate
of 433 panels, 19 waves at four headings. Bounds (acceptance): amplitude 1 % of each mode's peak
over the sweep, phase 3 degrees where the amplitude is above 20 % of the peak, absent modes in head
seas below 1e-3 (m/m, rad/m).
"""
import csv
import os
import subprocess
import sys

from results import FULL, record

MODES = ["surge", "sway", "heave", "roll", "pitch", "yaw"]


def run(*arguments):
    subprocess.run(arguments, check=True)


def rows(path):
    with open(path, encoding="utf-8") as file:
        return [{k: float(v) for k, v in row.items()} for row in csv.DictReader(file)]


def check(table, beta):
    wrong = []
    for j, mode in enumerate(MODES, 1):
        of_mode = [row for row in table if row["j"] == j]
        peak = max(row["freq_amplitude"] for row in of_mode)
        what = f"sweep beta {beta} deg, {mode}: "
        if beta == 180 and mode in ("sway", "roll", "yaw"):
            largest = max(row["time_amplitude"] for row in of_mode)
            record("6 Commands", what + "amplitude that must be absent", "0", largest, "1e-3")
            if not largest < 1e-3:
                wrong.append(what + f"{largest} instead of nothing")
            continue
        off = max(abs(row["time_amplitude"] - row["freq_amplitude"]) for row in of_mode)
        amplitude = 100 * off / peak
        phases = [row["time_phase_deg"] - row["freq_phase_deg"]
                  for row in of_mode if row["freq_amplitude"] > 0.2 * peak]
        phase = max(abs((p + 180) % 360 - 180) for p in phases)
        record("6 Commands", what + "amplitude [% of peak]", "frequency domain", amplitude, "1")
        record("6 Commands", what + "phase [deg]", "frequency domain", phase, "3")
        print(f"{what}amplitude {amplitude:.3f} % of peak, phase {phase:.3f} deg")
        if amplitude > 1 or phase > 3:
            wrong.append(what + f"amplitude {amplitude} %, phase {phase} deg")
    return wrong


def main():
    command, database, root = sys.argv[1:]
    wrong = []
    if FULL:
        database = "frigate_433.h5"
        run(command, "solve", os.path.join(root, "meshes/frigate/ship.toml"), "-o", database)
    for beta in (30, 90, 150, 180) if FULL else (30, 180):
        name = f"sweep_{beta:03d}.toml"
        text = open(os.path.join(root, "demos/runs", name), encoding="utf-8").read()
        text = text.replace("../../out/demo/frigate.h5", database)
        if not FULL:
            text = text.replace("omega = { from = 0.2, to = 2.0, step = 0.1 }",
                                "omega = [0.4, 0.7, 1.0, 1.5]")
        with open(name, "w", encoding="utf-8") as file:
            file.write(text)
        run(command, "sweep", name, "-o", f"sweep_{beta:03d}.csv")
        wrong += check(rows(f"sweep_{beta:03d}.csv"), beta)
    sys.exit("\n".join(wrong) or None)


main()
