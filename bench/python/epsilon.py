"""epsilon of a million dampings: this package beside the printed formula (35) in NumPy and in numba.

Formula (35) of Ramirez et al. 1999 with Table I is 5 % wrong at u = 1 and 51 % at u = 2. Each is timed in turn, round by
round, in one process; printed are medians of nanoseconds per value, and their ratios to NumPy's.
"""

import statistics
import time

import numpy as np
import restitution

C1 = 1.1534488580952888
D = (2.5839, 3.5839, 2.9839, 1.1487, 0.3265)
ROUNDS = 21


def formula_35(s):
    """(1 + d_1 s)/(1 + d_2 s + ... + d_5 s^4) as printed, s = -C_1 u."""
    return (1 + D[0] * s) / (1 + s * (D[1] + s * (D[2] + s * (D[3] + s * D[4]))))


def contestants(u):
    s = C1 * u
    yield "NumPy, formula (35)", lambda: formula_35(s)
    try:
        import numba
    except ImportError:
        print("numba is not installed: its column is left out")
    else:
        single = numba.vectorize(["float64(float64)"])(formula_35)
        shared = numba.vectorize(["float64(float64)"], target="parallel")(formula_35)
        yield "numba, formula (35)", lambda: single(s)
        yield "numba, formula (35), all cores", lambda: shared(s)
    for end in ("zero-compression", "zero-force"):
        yield f"restitution.epsilon, {end}", lambda end=end: restitution.epsilon(u, end)
    curve = restitution.Restitution.from_u_at_unit_velocity(1.0)
    g = u**5
    yield "Restitution.epsilon, from velocities", lambda: curve.epsilon(g)


def main():
    u = np.random.default_rng(1999).uniform(0, 8, 1_000_000)
    rows = list(contestants(u))
    seconds = {name: [] for name, _ in rows}
    for _ in range(ROUNDS):
        for name, call in rows:
            start = time.perf_counter()
            call()
            seconds[name].append(time.perf_counter() - start)
    reference = statistics.median(seconds[rows[0][0]])
    for name, times in seconds.items():
        median = statistics.median(times)
        print(f"{name:40s} {1e9 * median / len(u):7.2f} ns/value {median / reference:6.2f} x NumPy")


if __name__ == "__main__":
    main()
