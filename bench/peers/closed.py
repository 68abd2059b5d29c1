"""C_1 .. C_4 of spheres from their closed forms with FLINT's Gamma function. usage: closed.py 4 D

B(p, 3/2) = Gamma(p) Gamma(3/2)/Gamma(p + 3/2) for p = 3/5 and 9/5: four values of Gamma at rational
points, on all cores. Formulas as in docs/closed-forms.md. Prints the seconds, then `k,value,radius`.
"""

import os
import sys
import time

from flint import arb, ctx, fmpq


def beta(p):
    three_halves = fmpq(3, 2)
    return arb.gamma_fmpq(p) * arb.pi().sqrt() / 2 / arb.gamma_fmpq(p + three_halves)


def coefficients(digits):
    ctx.prec, ctx.threads = int(digits * 3.3220) + 64, os.cpu_count()
    first = beta(fmpq(3, 5))
    a_3 = arb(7) / 25 + arb(575) / 1452 * beta(fmpq(9, 5)) / first**3
    scaled = [arb(1), arb(3) / 5, a_3, arb(7) / 5 * a_3 - arb(7) / 25]
    c_1 = -first / (arb(5) / 4).root(5) ** 2
    return [a * c_1**k for k, a in enumerate(scaled, 1)]


if __name__ == "__main__":
    order, digits = int(sys.argv[1]), int(sys.argv[2])
    if order != 4:
        sys.exit("usage: closed.py 4 D")
    start = time.perf_counter()
    c = coefficients(digits)
    print(time.perf_counter() - start)
    for k, value in enumerate(c, 1):
        print(f"{k},{value.mid().str(digits + 5, radius=False)},{value.rad().str(3, radius=False)}")
