"""The motion as power series with FLINT, in numbers of either kind: fractions for exact.py, balls for coefficients.py.

Quasi-linear arithmetic: x_0 by Newton's iteration, x_1 .. x_N by variation of parameters, powers of x by Miller's recurrence
in the damping. `number(p, q)` is p/q, `series(coefficients, prec=n)` a power series of n such numbers.
"""

from flint import ctx


class Motion:
    def __init__(self, number, series):
        self.number, self.of_numbers = number, series

    def series(self, coefficients, length):
        return self.of_numbers(coefficients, prec=length)

    def weighted(self, s, length, weight):
        """Multiplies coefficient j by weight(j)."""
        return self.series([s[j] * weight(j) for j in range(length)], length)

    def undamped(self, length):
        """F with x_0 = t F(s), s = t^(5/2): every step doubles the right terms."""
        f, n = self.series([1], 1), 1
        e = lambda j: self.number(5 * j, 2)
        while n < length:
            known, n = n, min(2 * n, length)
            ctx.cap = n
            f = self.series([f[i] for i in range(known)], n)
            residual = self.weighted(f, n, lambda j: e(j) * (e(j) + 1)) + f * f.sqrt() * self.series([0, 1], n)
            v = self.weighted(f, n, lambda j: e(j) + 1)
            a = v * residual
            a = self.series([0] + [a[j] / e(j) for j in range(1, n)], n)
            w = v.inv()
            f = f - self.weighted(a * w * w, n, lambda j: 1 / (e(j) + 1)) * v
        return f

    def trajectories(self, order, length):
        """F_0 .. F_N with x_n = t^(1+3n/2) F_n(s)."""
        f0, number = self.undamped(length), self.number
        ctx.cap = length
        root = f0.sqrt()
        v = self.weighted(f0, length, lambda j: number(5 * j, 2) + 1)
        w = v.inv()
        w2, inverse, s = w * w, f0.inv(), self.series([0, 1], length)
        f, h = [f0], [f0 * root]
        for n in range(1, order + 1):
            lower = self.series([0], length)
            for k in range(1, n):
                lower = lower + (number(3 * k, 2) - (n - k)) * f[k] * h[n - k]
            lower = lower * inverse * number(1, n)
            right = self.weighted(h[n - 1], length, lambda j: number(5 * j + 3 * n, 3)) + lower * s
            a = self.weighted(v * right, length, lambda j: number(2, 5 * j + 3 * n))
            f.append(-(self.weighted(a * w2, length, lambda j: number(2, 5 * j + 3 * n + 2)) * v))
            if n < order:
                h.append(number(3, 2) * root * f[n] + lower)
        return f
