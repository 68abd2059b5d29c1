"""Times ours and its peers in turn, in one run, and checks that they found the same numbers.

usage: compare.py [--repetitions R] [--peers flint,pari] [--cases exact,coefficients,closed]

Every program times its own computation, without start and printing; only `restitution table`, which gives
the closed forms, is timed from its start to its last digit. Medians over R interleaved repetitions
(default 5); the spread is the smallest and the largest.
"""

import argparse
import os
import shutil
import statistics
import subprocess
import sys
import time
from decimal import MAX_EMAX, MIN_EMIN, Context, Decimal, setcontext
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
BUILT = Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target")) / "release"
CASES = [
    ("exact", 3, 200),
    ("exact", 3, 800),
    ("coefficients", 40, 100),
    ("coefficients", 4, 1000),
    ("closed", 4, 100_000),
    ("closed", 4, 1_000_000),
]
WITHOUT_PARI = {"closed"}
LONG = Context(prec=1_100_000, Emax=MAX_EMAX, Emin=MIN_EMIN)  # differences of long numbers; all else is short
setcontext(Context(prec=20, Emax=MAX_EMAX, Emin=MIN_EMIN))


def command(program, what, first, second):
    """The command line and the environment that make `program` compute a case."""
    if program == "ours" and what == "closed":
        table = ["table", "--quantity", "C", "--order", str(first), "--digits", str(second), "--format", "csv"]
        return [str(BUILT / "restitution"), *table], {}
    if program == "ours":
        return [str(BUILT / "examples" / f"time_{what}"), str(first), str(second)], {}
    if program == "flint":
        return [sys.executable, str(HERE / f"{what}.py"), str(first), str(second)], {}
    names = ("N", "J") if what == "exact" else ("K", "D")
    sizes = dict(zip(names, (str(first), str(second))))
    return ["gp", "-q", "-f", "-s", "2G", str(HERE / f"{what}.gp")], sizes


def run(program, case):
    """The seconds a program took and the lines it printed."""
    words, extra = command(program, *case)
    start = time.perf_counter()
    done = subprocess.run(words, env={**os.environ, **extra}, capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"{' '.join(words)} failed: {done.stderr.strip()[-500:]}")
    whole = time.perf_counter() - start
    seconds, *lines = done.stdout.splitlines()
    return whole if seconds.startswith("k,") else float(seconds), lines


def numbers(lines):
    """k, value and radius of every line; a program without bounds leaves the radius out."""
    rows = (line.replace(" ", "").split(",") for line in lines)
    return {int(row[0]): (Decimal(row[1]), Decimal(row[2]) if len(row) > 2 else None) for row in rows}


def agreement(what, ours, theirs):
    """How far the results agree; ends the run if they contradict each other."""
    if what == "exact":
        if ours != theirs:
            sys.exit("the exact coefficients differ")
        return f"{len(ours)} fractions equal"
    ours, theirs = numbers(ours), numbers(theirs)
    if ours.keys() != theirs.keys():
        sys.exit("the programs give coefficients of different orders")
    digits = []
    for k, (value, radius) in ours.items():
        other, slack = theirs[k]
        difference = abs(LONG.subtract(value, other))
        if slack is not None and difference > radius + slack:
            sys.exit(f"C_{k} differs by {difference:.1e}, more than both radii together")
        digits.append(int(-(difference / abs(value)).log10()) if difference else 10**6)
    common = min(min(digits), min(int(-(radius / abs(value)).log10()) for value, radius in ours.values()))
    if common < 30:
        sys.exit(f"only {common} digits agree")
    return f"{common} digits equal"


def spread(times):
    return f"{statistics.median(times):8.4f} ({min(times):.4f}-{max(times):.4f})"


def main():
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("--repetitions", type=int, default=5)
    arguments.add_argument("--peers", default="flint,pari")
    arguments.add_argument("--cases", default=",".join(dict.fromkeys(what for what, *_ in CASES)))
    options = arguments.parse_args()
    peers = [name for name in options.peers.split(",") if name != "pari" or shutil.which("gp")]
    print(f"{'case':<20} {'peer':<6} {'ours, s':<26} {'peer, s':<26} {'ours/peer':>9}  check")
    for case in (case for case in CASES if case[0] in options.cases.split(",")):
        asked = [name for name in peers if name != "pari" or case[0] not in WITHOUT_PARI]
        times, results = {name: [] for name in ["ours", *asked]}, {}
        for _ in range(options.repetitions):
            for name in times:
                seconds, results[name] = run(name, case)
                times[name].append(seconds)
        for name in asked:
            ratio = statistics.median(times["ours"]) / statistics.median(times[name])
            check = agreement(case[0], results["ours"], results[name])
            label = f"{case[0]} {case[1]} {case[2]}"
            print(f"{label:<20} {name:<6} {spread(times['ours']):<26} {spread(times[name]):<26} {ratio:>9.3f}  {check}", flush=True)


if __name__ == "__main__":
    main()
