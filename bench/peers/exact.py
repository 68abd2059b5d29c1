"""Exact trajectories with FLINT: the first J+1 coefficients of x_0 .. x_N. usage: exact.py N J

The series of motion.py in fractions. Prints the seconds, then `n,j,value`.
"""

import sys
import time

from flint import fmpq, fmpq_series
from motion import Motion

if __name__ == "__main__":
    order, terms = int(sys.argv[1]), int(sys.argv[2])
    start = time.perf_counter()
    result = Motion(fmpq, fmpq_series).trajectories(order, terms + 1)
    print(time.perf_counter() - start)
    for n, f in enumerate(result):
        for j in range(terms + 1):
            print(f"{n},{j},{f[j].p}/{f[j].q}")
