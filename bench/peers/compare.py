"""Times ours and its peers in turn, in one run, and checks that they found the same numbers.

usage: compare.py [--repetitions R] [--peers flint,pari] [--cases exact,coefficients,closed]

A case is what is computed and its two sizes: `exact N J` the fractions q_(n,j), n <= N, j <= J, `coefficients K D` C_1 .. C_K
to D digits by the general way, `closed K D` the same by closed forms. Ours is timed as a whole, from the start of the
process to its last line; peers time their own computation, without start and printing. Medians over R interleaved
repetitions (default 5); the spread is the smallest and the largest. At the end: how times grow between two cases that
differ in one size, t ~ size^exponent.
"""

import argparse
import math
import os
import shutil
import statistics
import subprocess
import sys
import time
from decimal import MAX_EMAX, MIN_EMIN, Context, Decimal, setcontext
from fractions import Fraction
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
BUILT = Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target")) / "release"
CASES = [
    ("exact", 3, 200),
    ("exact", 3, 800),
    ("exact", 12, 400),
    ("coefficients", 40, 50),
    ("coefficients", 100, 50),
    ("coefficients", 40, 100),
    ("coefficients", 4, 1000),
    ("coefficients", 8, 1000),
    ("closed", 4, 100_000),
    ("closed", 4, 1_000_000),
]
SIZES = {"exact": ("N", "J"), "coefficients": ("K", "D"), "closed": ("K", "D")}
WITHOUT_PARI = {"closed"}
LONG = Context(prec=1_100_000, Emax=MAX_EMAX, Emin=MIN_EMIN)  # differences of long numbers; all else is short
setcontext(Context(prec=20, Emax=MAX_EMAX, Emin=MIN_EMIN))


def ours(what, first, second):
    """Our command for a case; orders up to 4, which the command takes from closed forms, by an example."""
    if what == "coefficients" and first <= 4:
        return [str(BUILT / "examples" / "time_coefficients"), str(first), str(second)]
    csv = ["--format", "csv"]
    if what == "exact":
        # As many powers as the last of FLINT's coefficients needs: for lower n these are a few more.
        last = Fraction(2 + 5 * second + 3 * first, 2)
        orders = ["--damping-order", str(first), "--time-order", str(math.ceil(last))]
        return [str(BUILT / "restitution"), "trajectory", *orders, *csv]
    sizes = ["--quantity", "C", "--order", str(first), "--digits", str(second)]
    return [str(BUILT / "restitution"), "table", *sizes, *csv]


def command(program, what, first, second):
    """The command line and the environment that make `program` compute a case."""
    if program == "ours":
        return ours(what, first, second), {}
    if program == "flint":
        return [sys.executable, str(HERE / f"{what}.py"), str(first), str(second)], {}
    sizes = dict(zip(SIZES[what], (str(first), str(second))))
    return ["gp", "-q", "-f", "-s", "2G", str(HERE / f"{what}.gp")], sizes


def run(program, case):
    """The seconds a program took and the lines it printed."""
    words, extra = command(program, *case)
    start = time.perf_counter()
    done = subprocess.run(words, env={**os.environ, **extra}, capture_output=True, text=True)
    whole = time.perf_counter() - start
    if done.returncode:
        sys.exit(f"{' '.join(words)} failed: {done.stderr.strip()[-500:]}")
    seconds, *lines = done.stdout.splitlines()
    return whole if program == "ours" else float(seconds), lines


def fractions(lines):
    """Ours by `n,exponent`, with every integer over 1."""
    rows = (line.split(",") for line in lines)
    return {(n, exponent): value if "/" in value else f"{value}/1" for n, exponent, value in rows}


def exponent(n, j):
    """The power of t that belongs to q_(n,j)."""
    return str(Fraction(2 + 3 * int(n) + 5 * int(j), 2))


def numbers(lines):
    """k, value and radius of every line; a program without bounds leaves the radius out."""
    rows = (line.replace(" ", "").split(",") for line in lines)
    return {int(row[0]): (Decimal(row[1]), Decimal(row[2]) if len(row) > 2 else None) for row in rows}


def agreement(what, ours, theirs):
    """How far the results agree; ends the run if they contradict each other."""
    if what == "exact":
        ours = fractions(ours)
        for n, j, value in (line.split(",") for line in theirs):
            if ours.get((n, exponent(n, j))) != value:
                sys.exit(f"the exact coefficients q_({n},{j}) differ")
        return f"{len(theirs)} fractions equal"
    ours, theirs = numbers(ours), numbers(theirs)
    ours.pop(0, None)
    if ours.keys() != theirs.keys():
        sys.exit("the programs give coefficients of different orders")
    digits = []
    for k, (value, radius) in ours.items():
        other, slack = theirs[k]
        difference = abs(LONG.subtract(value, other))
        if slack is not None and difference > radius + slack:
            sys.exit(f"C_{k} differs by {difference:.1e}, more than both radii together")
        digits.append(int(-(difference / abs(value)).log10()) if difference else 10**6)
    common = min(min(digits), min(int(-(radius / abs(value)).log10()) for value, radius in ours.values() if radius))
    if common < 30:
        sys.exit(f"only {common} digits agree")
    return f"{common} digits equal"


def spread(times):
    return f"{statistics.median(times):8.4f} ({min(times):.4f}-{max(times):.4f})"


def growth(medians):
    """Prints how times grow between two cases that differ in one size."""
    print(f"\n{'growth':<34} {'program':<8} exponent")
    for small in medians:
        for large in medians:
            if small[0] != large[0]:
                continue
            larger = [i for i in (1, 2) if small[i] != large[i]]
            if len(larger) != 1 or small[larger[0]] > large[larger[0]]:
                continue
            size = larger[0]
            label = f"{small[0]} {small[1]} {small[2]} -> {large[1]} {large[2]}"
            for program in medians[small].keys() & medians[large].keys():
                ratio = medians[large][program] / medians[small][program]
                power = math.log(ratio) / math.log(large[size] / small[size])
                print(f"{label:<34} {program:<8} {SIZES[small[0]][size - 1]}^{power:.2f}")


def main():
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("--repetitions", type=int, default=5)
    arguments.add_argument("--peers", default="flint,pari")
    arguments.add_argument("--cases", default=",".join(dict.fromkeys(what for what, *_ in CASES)))
    options = arguments.parse_args()
    peers = [name for name in options.peers.split(",") if name != "pari" or shutil.which("gp")]
    print(f"{'case':<20} {'peer':<6} {'ours, s':<26} {'peer, s':<26} {'ours/peer':>9}  check")
    medians = {}
    for case in (case for case in CASES if case[0] in options.cases.split(",")):
        asked = [name for name in peers if name != "pari" or case[0] not in WITHOUT_PARI]
        times, results = {name: [] for name in ["ours", *asked]}, {}
        for _ in range(options.repetitions):
            for name in times:
                seconds, results[name] = run(name, case)
                times[name].append(seconds)
        medians[case] = {name: statistics.median(seconds) for name, seconds in times.items()}
        for name in asked:
            ratio = medians[case]["ours"] / medians[case][name]
            check = agreement(case[0], results["ours"], results[name])
            label = f"{case[0]} {case[1]} {case[2]}"
            print(f"{label:<20} {name:<6} {spread(times['ours']):<26} {spread(times[name]):<26} {ratio:>9.3f}  {check}", flush=True)
    growth(medians)


if __name__ == "__main__":
    main()
