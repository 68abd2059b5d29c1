"""Expansion coefficients with FLINT's balls: C_1 .. C_K to about D digits. usage: coefficients.py K D

The series of motion.py in ball arithmetic, then the turning point and the inverse collision as Newton
iterations and series in u. The tail of the sums at T is cut where it should be small; unlike ours it
is not bounded. Prints the seconds, then `k,value,radius`.
"""

import sys
import time

from flint import arb, arb_series, ctx
from motion import Motion

MOTION = Motion(lambda p, q: arb(p) / q, arb_series)
series = MOTION.series


def values_at(f, half_duration, length):
    """x_n(T) and x_n'(T) by Horner's rule."""
    s, w = half_duration ** (arb(5) / 2), half_duration ** (arb(3) / 2)
    positions, velocities = [], []
    for n, fn in enumerate(f):
        position = velocity = arb(0)
        for j in reversed(range(length)):
            position = position * s + fn[j]
            velocity = velocity * s + fn[j] * (arb(5 * j + 3 * n) / 2 + 1)
        positions.append(position * w**n * half_duration)
        velocities.append(velocity * w**n)
    return positions, velocities


def compression(order, positions, velocities):
    """The largest compression as a series in u: Taylor coefficients in time from the equation of motion."""
    ctx.cap = order + 1
    in_u = lambda c: series(c, order + 1)
    u, degree = in_u([0, 1]), order + 2
    x = [in_u(positions), in_u(velocities)]
    root = [x[0].sqrt()]
    half = in_u([1]) / (root[0] * 2)
    for k in range(degree - 1):
        if k >= 1:
            rest = x[k]
            for i in range(1, k):
                rest = rest - root[i] * root[k - i]
            root.append(rest * half)
        force = in_u([0])
        for i in range(k + 1):
            force = force - root[i] * (u * x[k - i + 1] * (k - i + 1) + x[k - i])
        x.append(force * (arb(1) / ((k + 1) * (k + 2))))
    shift, right = in_u([0]), 1
    while right < order + 1:
        right *= 2
        value = slope = in_u([0])
        for m in range(degree, 0, -1):
            value = value * shift + x[m] * m
        for m in range(degree, 1, -1):
            slope = slope * shift + x[m] * (m * (m - 1))
        shift = shift - value / slope
    y = in_u([0])
    for m in range(degree, -1, -1):
        y = y * shift + x[m]
    return y


def inverse_collision(order, y):
    """epsilon = h^5 with h^4 Y(-u h) = Y(u), one coefficient of h after the other."""
    h = [arb(1)]
    for k in range(1, order + 1):
        ctx.cap = k + 1
        power, step, sum_ = series(h, k + 1) ** 4, series([0] + [-c for c in h], k + 1), series([0], k + 1)
        for n in range(k + 1):
            sum_ = sum_ + power * y[n]
            power = power * step
        h.append((y[k] - sum_[k]) / (4 * y[0]))
    ctx.cap = order + 1
    return series(h, order + 1) ** 5


def coefficients(order, digits):
    guard = int(0.6 * order) + 10
    ctx.prec = int((digits + guard) * 3.33) + 32
    length = int((digits + guard) / 0.74) + int(0.5 * order) + 11
    f = MOTION.trajectories(order, length)
    half_duration = (arb(4) / 5) ** (arb(3) / 5) * (arb(2) / 5).gamma() * arb.pi().sqrt() / (2 * (arb(9) / 10).gamma())
    return inverse_collision(order, compression(order, *values_at(f, half_duration, length)))


if __name__ == "__main__":
    order, digits = int(sys.argv[1]), int(sys.argv[2])
    start = time.perf_counter()
    c = coefficients(order, digits)
    print(time.perf_counter() - start)
    for k in range(1, order + 1):
        print(f"{k},{c[k].mid().str(digits + 5, radius=False)},{c[k].rad().str(3, radius=False)}")
