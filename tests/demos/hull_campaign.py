"""hull_campaign.py CUTWATER [--count N] [--only SEED] [--jobs 2] [--keep FOLDER]

Random ships (hull_bodies.py), spoiled, go through `cutwater panel`. It prints a table of what
became of them. It fails if one crashed or took more than 30 s, if one changed its volume by
more than 1 % without a line that names volumes, or if more than 1 % (of a short draw: more than
one) were refused.
`--only SEED --keep FOLDER` tries a single body and leaves its files.
"""
import argparse
import collections
import concurrent.futures
import os
import re
import subprocess
import sys
import tempfile
import time

from hull_bodies import body
from panel_checks import Panels
from results import FULL, record

LIMIT = 30.0   # [s] of one body
SILENT = 0.01  # the share of the volume that must not change without a word
PANELS = 433


def ran(command, seed, folder):
    """(outcome, volume's error, seconds, what it is, lines) of one body."""
    made = body(seed)
    assert made.error < 1e-2, f"body {seed}: the lines' volumes differ by {made.error:.2g}"
    mesh, out = (os.path.join(folder, f"{seed}{end}.obj") for end in ("", "_panels"))
    made.mesh.write(mesh)
    start = time.monotonic()
    try:
        done = subprocess.run([command, "panel", mesh, "-n", str(PANELS), "-o", out], check=False,
                              capture_output=True, text=True, timeout=LIMIT)
    except subprocess.TimeoutExpired:
        return "timeout", 0.0, LIMIT, made.what, []
    seconds = time.monotonic() - start
    lines = (done.stderr + done.stdout).splitlines()
    if done.returncode != 0:
        return "refused" if done.returncode == 1 else "crashed", 0.0, seconds, made.what, lines
    panels = Panels(out)
    error = panels.volumes()[2] / made.volume - 1
    way = "surface" if "over the surface" in done.stderr else "sections"
    # Where the ship ends in a line, four panels may meet there: as many edges one way as the other.
    edges = panels.edges()
    gaps = [edge for edge in panels.open_edges() if edges[edge][0] != edges[edge][1]]
    if gaps:
        lines.append(f"{len(gaps)} open edges")
    return way, error, seconds, made.what, lines


def said(lines):
    """Whether a line names a volume that was lost or gained: not the summary of what was written,
    nor that of the way that was not taken."""
    return any("m3" in line and "of the hull's" not in line and "by sections" not in line
               for line in lines)


def reason(line):
    """A refusal without its numbers and files."""
    return re.sub(r"[-+]?\d[\d.e+-]*", "#", re.sub(r"\S*\.obj:? ?", "", line))


def report(results):
    """Prints the table; the lines for what must not be."""
    wrong, reasons = [], collections.Counter()
    counts = collections.Counter(outcome for outcome, *_ in results.values())
    for seed, (outcome, error, seconds, what, lines) in sorted(results.items()):
        silent = abs(error) > SILENT and not said(lines)
        if outcome in ("crashed", "timeout") or silent:
            wrong.append(f"body {seed} ({what}): {outcome}, V {100 * error:+.2f} %")
        if outcome == "refused":
            reasons[reason(lines[-1] if lines else "no word")] += 1
            print(f"refused: body {seed} ({what}): {lines[-1] if lines else ''}")
        elif abs(error) > SILENT:
            word = "silent" if silent else "said"
            print(f"V {100 * error:+.2f} %, {word}: body {seed} ({what}), {outcome}")
    leaky = [seed for seed, result in results.items()
             if result[4] and result[4][-1].endswith("open edges")]
    errors = {seed: abs(result[1]) for seed, result in results.items()}
    worst, times = max(errors, key=errors.get), [result[2] for result in results.values()]
    print(f"{len(results)} bodies: " + ", ".join(f"{n} {way}" for way, n in counts.most_common()))
    for text, number in reasons.most_common():
        print(f"  {number} x {text}")
    print(f"worst volume {100 * results[worst][1]:+.2f} % (body {worst}); not closed: {leaky}; "
          f"time {sum(times) / len(times):.2f} s, longest {max(times):.1f} s")
    if counts["refused"] > max(1, len(results) // 100):
        wrong.append(f"{counts['refused']} refused")
    if leaky:
        wrong.append(f"{len(leaky)} not closed")
    record("Any hull", f"{len(results)} random bodies, refused", "", counts["refused"], "< 1 %")
    return wrong


def main():
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("command")
    options.add_argument("--count", type=int, default=640 if FULL else 12)
    options.add_argument("--only", type=int)
    options.add_argument("--jobs", type=int, choices=(1, 2), default=2)
    options.add_argument("--keep")
    given = options.parse_args()
    seeds = range(given.count) if given.only is None else [given.only]
    with tempfile.TemporaryDirectory() as folder:
        with concurrent.futures.ProcessPoolExecutor(given.jobs) as pool:
            waiting = {seed: pool.submit(ran, os.path.abspath(given.command), seed,
                                         given.keep or folder) for seed in seeds}
            results = {seed: future.result() for seed, future in waiting.items()}
    if given.only is not None:
        print("\n".join(results[given.only][4]))
    wrong = report(results)
    print("\n".join(wrong))
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
