"""Quantities with units: text as on the command line, pint's quantities, or bare numbers in SI."""

from . import _core

_SI = {
    "velocity": "m/s",
    "length": "m",
    "time": "s",
    "density": "kg/m**3",
    "modulus": "Pa",
}


def si(value, dimension):
    """The number of SI units in `value`, which should be a `dimension`.

    >>> si("0.32cm/s", "velocity")
    0.0032
    >>> si(2, "length")
    2.0
    >>> si("2kg", "length")
    Traceback (most recent call last):
    ValueError: '2kg' is a mass, not a length: give one of m, km, cm, mm, um, nm, in, ft, or a bare number in m
    """
    if isinstance(value, str):
        return _core.quantity(value, dimension)
    return float(stripped(value, dimension))


def stripped(value, dimension):
    """A number or an array without the unit that pint gave it, in SI."""
    if hasattr(value, "to") and hasattr(value, "magnitude"):
        return value.to(_SI[dimension]).magnitude
    if isinstance(value, str):
        return _core.quantity(value, dimension)
    return value
