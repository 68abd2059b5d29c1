"""Exact and certified numbers."""

import contextlib
import math
import re
import sys
from decimal import Decimal
from fractions import Fraction

from . import _core


class Certified:
    """A real number to proved digits: the true one differs from `value` by no more than `radius`.

    >>> c = Certified("-0.52288256808841496390", "4.0e-21")
    >>> float(c)
    -0.5228825680884149
    >>> c.decimal
    Decimal('-0.52288256808841496390')
    >>> c.contains("-0.5228825680884149639")
    True
    >>> Certified("0.5", "-1")
    Traceback (most recent call last):
    ValueError: a radius is a number of at least 0, not -1
    """

    __slots__ = ("_radius", "_value")

    def __init__(self, value, radius):
        if not Decimal(radius) >= 0:
            raise ValueError(f"a radius is a number of at least 0, not {radius}")
        Decimal(value)
        self._value, self._radius = value, radius

    @property
    def value(self):
        """The proved digits, as text."""
        return self._value

    @property
    def radius(self):
        """How far the true number is from `value` at most, as text."""
        return self._radius

    @property
    def decimal(self):
        """The digits as a Decimal."""
        return Decimal(self._value)

    @property
    def interval(self):
        """Two fractions between which the true number lies."""
        middle, radius = Fraction(self._value), Fraction(self._radius)
        return middle - radius, middle + radius

    def contains(self, number):
        """Whether `number` (text, Fraction, Decimal, int or float, taken exactly) may be the true one."""
        low, high = self.interval
        return low <= Fraction(number) <= high

    def mpmath(self):
        """The value as an mpf with the bits that the digits need; needs mpmath."""
        import mpmath

        with mpmath.workprec(self._bits()):
            return mpmath.mpf(self._value)

    def mpi(self):
        """The enclosure as an interval of mpmath."""
        import mpmath

        low, high = self.interval
        iv = mpmath.iv
        before, iv.prec = iv.prec, self._bits()
        try:
            low = iv.mpf(low.numerator) / low.denominator
            high = iv.mpf(high.numerator) / high.denominator
            return iv.mpf([low.a, high.b])
        finally:
            iv.prec = before

    def arb(self):
        """The enclosure as a ball of python-flint."""
        import flint

        before, flint.ctx.prec = flint.ctx.prec, self._bits()
        try:
            return flint.arb(self._value) + flint.arb(0, flint.arb(self._radius).upper())
        finally:
            flint.ctx.prec = before

    def _digits(self):
        return len(self.decimal.as_tuple().digits)

    def _bits(self):
        return math.ceil(len(self._value) * math.log2(10)) + 64

    def __float__(self):
        return float(self._value)

    def __str__(self):
        return self._value

    def __repr__(self):
        return f"Certified({self._value!r})"

    def _latex(self):
        mantissa, e, exponent = self._value.partition("e")
        return f"{mantissa}\\cdot 10^{{{int(exponent)}}}" if e else mantissa

    def _repr_latex_(self):
        return f"${self._latex()}$"

    def __eq__(self, other):
        if not isinstance(other, Certified):
            return NotImplemented
        return (self._value, self._radius) == (other._value, other._radius)

    def __hash__(self):
        return hash((self._value, self._radius))

    def __reduce__(self):
        return (Certified, (self._value, self._radius))


_SPHERES = ("3/2", "1/2")


def exact(number):
    """The Fraction that is meant: text is read exactly, and a float is the binary number that it is."""
    if isinstance(number, str):
        number = number.strip()
    return Fraction(number)


def _law(law):
    if isinstance(law, str):
        return law
    try:
        a, gamma = law
    except (TypeError, ValueError):
        raise ValueError("a law is two exponents: give (A, GAMMA), such as ('3/2', '1/2')") from None
    return f"{exact(a)},{exact(gamma)}"


def _count(number, what, least):
    number = number.__index__()
    if number < least:
        raise ValueError(f"{what} is a whole number of at least {least}, not {number}")
    return number


@contextlib.contextmanager
def _watched(progress):
    """What is called with the progress, if anything; True prints it on one line of stderr."""
    if progress is not True:
        yield progress or None
        return
    shown = []

    def show(done, total):
        shown[:] = [f"{done} s" if total is None else f"{done}/{total}"]
        print(f"\r{shown[0]}", end="", file=sys.stderr, flush=True)

    try:
        yield show
    finally:
        if shown:
            print(file=sys.stderr, flush=True)


def coefficients(quantity, order, digits=20, law=_SPHERES, progress=None):
    """Expansion coefficients of the coefficient of restitution, every digit proved.

    Parameters
    ----------
    quantity : {"C", "a", "y", "h", "psi"}
        C_k of eps = 1 + C_1 u + C_2 u^2 + ..., a_k of eps = 1 - a_1 s + a_2 s^2 - ... with s = -C_1 u (A30-A36 of
        Ramirez et al. 1999), y_k of the largest compression, h_k of the contact that ends at zero force (half powers
        of u for spheres), psi_k of the exact series between both ends.
    order : int
        The largest k.
    digits : int
        Significant digits.
    law : (A, GAMMA)
        The exponents of x'' + u x^GAMMA x' + x^A = 0: text, Fraction or int.
    progress : bool or callable(done, total)
        Whether, or how, progress is shown: True prints it on stderr. Ctrl-C ends the work.

    Returns
    -------
    list of Certified, from k = 0 to order; of Fraction for psi, which is exact.

    Examples
    --------
    >>> for k, c in enumerate(coefficients("C", order=2, digits=15)):
    ...     print(k, c)
    0 1.00000000000000
    1 -1.15344885809529
    2 0.798266560944795
    >>> coefficients("psi", order=2)
    [Fraction(1, 1), Fraction(4, 15), Fraction(13, 150)]
    >>> coefficients("C", order=2, law=(-1, 0))
    Traceback (most recent call last):
    ValueError: the elastic exponent must be positive, not -1: give A > 0, such as 3/2
    """
    order, digits = _count(order, "an order", 0), _count(digits, "a number of digits", 1)
    if quantity == "psi":
        return _core.psi(order, _law(law))
    with _watched(progress) as watch:
        found = _core.coefficients(quantity, order, digits, _law(law), watch)
    return [Certified(*pair) for pair in found]


def trajectory(damping_order, time_order, law=_SPHERES, progress=None):
    """The exact trajectories x_0(t) .. x_N(t) of the damped collision, up to a power of time (A13), (A14).

    Parameters
    ----------
    damping_order : int
        N, the highest power of the damping.
    time_order : number
        The highest power of time that is wanted.
    law, progress
        As in `coefficients`; done and total are a percentage.

    Returns
    -------
    list over n of lists of (exponent, coefficient), all Fractions.

    Examples
    --------
    >>> trajectory(1, 5)[1]
    [(Fraction(5, 2), Fraction(-4, 15)), (Fraction(5, 1), Fraction(3, 70))]
    >>> trajectory(0, 0)
    Traceback (most recent call last):
    ValueError: a power of time is a number above 0, not 0
    """
    damping_order, power = _count(damping_order, "a damping order", 0), exact(time_order)
    if power <= 0:
        raise ValueError(f"a power of time is a number above 0, not {power}")
    rows = [[] for _ in range(damping_order + 1)]
    with _watched(progress) as watch:
        found = _core.trajectory(damping_order, power, _law(law), watch)
    for n, exponent, coefficient in found:
        rows[n].append((exponent, coefficient))
    return rows


def epsilon_digits(u, digits=30, law=_SPHERES, end="zero-compression", quantity="epsilon", progress=None):
    """The coefficient of restitution by certified integration: every digit is proved.

    Parameters
    ----------
    u : text, Fraction, int, Decimal or float
        The damping, taken exactly: 0.1 is the binary number, "0.1" is 1/10.
    quantity : {"epsilon", "loss"}
        The coefficient, or 1 - epsilon to as many digits however small it is.
    law, progress
        As in `coefficients`; done is the seconds gone and total None, as the steps are not known before.

    Examples
    --------
    >>> epsilon_digits("0.1", 30)
    Certified('0.892147587290229345269672993933')
    >>> epsilon_digits(-1)
    Traceback (most recent call last):
    ValueError: the damping must not be negative, not -1
    """
    u = exact(u)
    if u < 0:
        raise ValueError(f"the damping must not be negative, not {u}")
    if quantity not in ("epsilon", "loss"):
        raise ValueError(f"'{quantity}' is nothing to compute: give 'epsilon' or 'loss'")
    digits = _count(digits, "a number of digits", 1)
    with _watched(progress) as watch:
        return Certified(*_core.epsilon_digits(u, digits, _law(law), end, quantity == "loss", watch))


def saturation(digits=30, law=_SPHERES):
    """R = lim u epsilon^p and R^(1/p), the exit speed at unlimited velocity, p = 1/5 for spheres.

    >>> [str(x) for x in saturation(10)]
    ['1.388361926', '5.158381704']
    """
    radius, speed = _core.saturation(_count(digits, "a number of digits", 1), _law(law))
    return Certified(*radius), Certified(*speed)


class Approximant:
    """A Padé approximant: `num` and `den` are lists of Certified, by powers of `variable`; den[0] is 1.

    >>> p = pade(1, 4, digits=12)
    >>> round(p(1.0), 4)
    0.3309
    """

    __slots__ = ("den", "num", "variable")

    def __init__(self, num, den, variable):
        self.num, self.den, self.variable = num, den, variable

    def __call__(self, x):
        """The quotient at a number or an array, in its own arithmetic from float64 constants."""

        def value(part):
            total = 0.0
            for c in reversed(part):
                total = total * x + float(c)
            return total

        return value(self.num) / value(self.den)

    def sympy(self, symbol=None):
        """The quotient as an expression of sympy, its constants with the digits that are proved."""
        import sympy

        x = sympy.Symbol(self.variable.replace("-", "_")) if symbol is None else symbol

        def value(part):
            return sum(sympy.Float(str(c), c._digits()) * x**k for k, c in enumerate(part))

        return value(self.num) / value(self.den)

    def _repr_latex_(self):
        x = {"sqrt-u": "\\sqrt{u}"}.get(self.variable, self.variable)

        def value(part):
            power = ["", f" {x}", *(f" {x}^{{{k}}}" for k in range(2, len(part)))]
            return " + ".join(c._latex() + power[k] for k, c in enumerate(part)).replace("+ -", "- ")

        return f"$\\frac{{{value(self.num)}}}{{{value(self.den)}}}$"

    def __repr__(self):
        num, den = ([str(c) for c in part] for part in (self.num, self.den))
        return f"Approximant(num={num}, den={den}, variable={self.variable!r})"


def pade(numerator, denominator, *, variable="u", digits=17, law=_SPHERES, progress=None):
    """The Padé approximant of the coefficient of restitution, its constants certified.

    Parameters
    ----------
    numerator, denominator : int
        The degrees L and M.
    variable : {"u", "s", "sqrt-u"}
        u and s = -C_1 u for the contact that ends at zero compression; sqrt-u for the one that ends at zero force
        (the [3/6] in it is the formula of Mueller and Poeschel 2011).
    digits : int
        Proved digits of each constant.
    law, progress
        As in `coefficients`.

    Examples
    --------
    >>> [str(c) for c in pade(3, 6, variable="sqrt-u", digits=6).num]
    ['1.00000', '1.07232', '0.574198', '0.141552']
    >>> pade(1, 4, variable="x")
    Traceback (most recent call last):
    ValueError: 'x' is no variable: give 's', 'u' or 'sqrt-u'
    """
    degrees = _count(numerator, "a degree", 0), _count(denominator, "a degree", 0)
    digits = _count(digits, "a number of digits", 1)
    with _watched(progress) as watch:
        parts = _core.pade(*degrees, variable, digits, _law(law), watch)
    num, den = ([Certified(*pair) for pair in part] for part in parts)
    return Approximant(num, den, variable)


class ClosedForm:
    """A coefficient in closed form: `text`, `latex`, `python` (mpmath) and its certified `value`."""

    __slots__ = ("_sympy", "latex", "python", "text", "value")

    def __init__(self, text, latex, python, sympy, value):
        self.text, self.latex, self.python, self._sympy, self.value = text, latex, python, sympy, value

    def sympy(self):
        """The expression of sympy; an iterated Beta integral stands as a symbol such as M_3_5__9_5__3_5.

        >>> import sympy
        >>> form = closed_form("a", 3)
        >>> abs(sympy.N(form.sympy(), 20) - sympy.Float(str(form.value), 20)) < 1e-18
        True
        """
        import sympy

        names = {name: getattr(sympy, name) for name in ("Rational", "beta")}
        names.update({name: sympy.Symbol(name, positive=True) for name in re.findall(r"M_\w+", self._sympy)})
        return sympy.sympify(eval(self._sympy, {"__builtins__": {}}, names))  # the library's own text

    def _repr_latex_(self):
        return f"${self.latex}$"

    def __str__(self):
        return self.text

    def __repr__(self):
        return f"ClosedForm({self.text!r})"


def closed_form(quantity, order, digits=30, law=_SPHERES, progress=None):
    """A coefficient of the expansion in closed form, in Beta values and, from order 5 on, iterated Beta integrals.

    Parameters
    ----------
    quantity : {"a", "C", "h"}
    order : int
        Up to 12 in whole powers of u.
    digits : int
        Proved digits of the value: a million take seconds up to order 4.
    law, progress
        As in `coefficients`; done is the seconds gone and total None, as the steps are not known before.

    Examples
    --------
    >>> print(closed_form("a", 3))
    7/25 + 575/1452 B(9/5, 3/2)/B(3/5, 3/2)^3
    >>> closed_form("a", 3, digits=12).value
    Certified('0.340729027136')
    >>> closed_form("y", 3)
    Traceback (most recent call last):
    ValueError: 'y' has no closed form here: give 'C', 'a' or 'h'
    """
    order, digits = _count(order, "an order", 0), _count(digits, "a number of digits", 1)
    with _watched(progress) as watch:
        *forms, value = _core.closed_form(quantity, order, digits, _law(law), watch)
    return ClosedForm(*forms, Certified(*value))
