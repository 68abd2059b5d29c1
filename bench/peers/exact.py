"""Exact trajectories with FLINT: the first J+1 coefficients of x_0 .. x_N. usage: exact.py N J

Quasi-linear arithmetic on rational power series: x_0 by Newton's iteration, x_1 .. x_N by variation of
parameters, powers of x by Miller's recurrence in the damping. Prints the seconds, then `n,j,value`.
"""

import sys
import time

from flint import ctx, fmpq, fmpq_series


def series(coefficients, length):
    return fmpq_series(coefficients, prec=length)


def weighted(s, length, weight):
    """Multiplies coefficient j by weight(j)."""
    return series([s[j] * weight(j) for j in range(length)], length)


def undamped(length):
    """F with x_0 = t F(s), s = t^(5/2), by Newton's iteration: every step doubles the right terms."""
    f, n = series([1], 1), 1
    while n < length:
        known, n = n, min(2 * n, length)
        ctx.cap = n
        f = series([f[i] for i in range(known)], n)
        e = lambda j: fmpq(5 * j, 2)
        residual = weighted(f, n, lambda j: e(j) * (e(j) + 1)) + f * f.sqrt() * series([0, 1], n)
        v = weighted(f, n, lambda j: e(j) + 1)
        a = v * residual
        a = series([0] + [a[j] / e(j) for j in range(1, n)], n)
        w = v.inv()
        f = f - weighted(a * w * w, n, lambda j: 1 / (e(j) + 1)) * v
    return f


def trajectories(order, terms):
    length = terms + 1
    f0 = undamped(length)
    ctx.cap = length
    root = f0.sqrt()
    v = weighted(f0, length, lambda j: fmpq(5 * j, 2) + 1)
    w = v.inv()
    w2, inverse, s = w * w, f0.inv(), series([0, 1], length)
    f, h = [f0], [f0 * root]
    for n in range(1, order + 1):
        lower = series([0], length)
        for k in range(1, n):
            lower = lower + (fmpq(3 * k, 2) - (n - k)) * f[k] * h[n - k]
        lower = lower * inverse * fmpq(1, n)
        e = lambda j: fmpq(5 * j + 3 * n, 2)
        a = weighted(v * (weighted(h[n - 1], length, lambda j: e(j) * fmpq(2, 3)) + lower * s), length, lambda j: 1 / e(j))
        f.append(-(weighted(a * w2, length, lambda j: 1 / (e(j) + 1)) * v))
        if n < order:
            h.append(fmpq(3, 2) * root * f[n] + lower)
    return f


if __name__ == "__main__":
    order, terms = int(sys.argv[1]), int(sys.argv[2])
    start = time.perf_counter()
    result = trajectories(order, terms)
    print(time.perf_counter() - start)
    for n, f in enumerate(result):
        for j in range(terms + 1):
            print(f"{n},{j},{f[j].p}/{f[j].q}")
