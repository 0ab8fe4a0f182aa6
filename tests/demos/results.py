"""Lines of tests/RESULTS.md from Python tests, as support/Results.h writes them from C++."""
import os

FULL = "CUTWATER_FULL" in os.environ


def record(topic, quantity, reference, reached, bound):
    path = os.environ.get("CUTWATER_RESULTS")
    if path:
        with open(path, "a", encoding="utf-8") as lines:
            lines.write(f"{topic}\t{quantity}\t{reference}\t{reached:.4g}\t{bound}\n")
