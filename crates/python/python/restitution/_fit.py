"""The characteristic velocity from measurements, and which law follows them."""

from typing import NamedTuple

from . import _core
from ._curve import Restitution
from ._units import stripped


class Fit(_core._Fit):
    """The result of `fit`.

    g_star, log_error, interval, scatter, largest_residual, largest_residual_row, rows; whether the law follows the
    data: p, is_doubtful (at most one false alarm in twenty), rises, tests; and the `curve`.

    >>> found = fit([0.1, 0.2, 0.4, 0.8], [0.62, 0.58, 0.52, 0.47])
    >>> found.curve.epsilon(found.g_star) < 1 and not found.rises
    True
    """

    __slots__ = ()

    @property
    def curve(self):
        """The curve that was fitted, a Restitution."""
        return Restitution._of(super().curve)


class LawFit(NamedTuple):
    """A law fitted to data: `scale` is g* or c, `criterion` Akaike's with its correction (None for too few rows)."""

    law: str
    scale: float
    exponent: "float | None"
    residual: float
    criterion: "float | None"


def _columns(g, epsilon, sigma):
    """The arrays, from a frame of pandas where one is given instead of velocities."""
    if epsilon is not None:
        return stripped(g, "velocity"), epsilon, sigma
    if not hasattr(g, "columns"):
        raise ValueError("there are no coefficients: give g and epsilon, or a frame with these columns")
    missing = [name for name in ("g", "epsilon") if name not in g.columns]
    if missing:
        raise ValueError(f"the frame has no column '{missing[0]}': its columns are {list(g.columns)}")
    if sigma is None and "sigma" in g.columns:
        sigma = g["sigma"]
    return g["g"], g["epsilon"], sigma


def fit(g, epsilon=None, *, sigma=None, end="zero-compression", loss="squares"):
    """Fits the characteristic velocity g* to measured coefficients of restitution.

    Parameters
    ----------
    g : array_like of velocities in m/s, a pint quantity, or a pandas frame with the columns g, epsilon and, if
        there are standard deviations, sigma
    epsilon : array_like of as many coefficients, above 0 and at most 2
    sigma : array_like or float, optional
        Standard deviations of epsilon, which weight the rows.
    end : {"zero-compression", "zero-force"}
    loss : {"squares", "huber"}
        Least squares, or Huber's loss, which outliers pull less.

    Returns
    -------
    Fit
        With g_star, log_error, interval, scatter, largest_residual, rows, the curve, and whether the law follows the
        data at all: p, is_doubtful, rises, tests.

    Examples
    --------
    >>> import restitution
    >>> curve = restitution.Restitution.from_g_star(0.0032)
    >>> g = [0.001, 0.002, 0.005, 0.01]
    >>> round(fit(g, curve.epsilon(g)).g_star, 12)
    0.0032
    >>> fit([0.1, 0.2, 0.4, 0.8, 1.6], [0.2, 0.31, 0.44, 0.52, 0.65]).rises
    True
    >>> fit([1.0], [0.5])
    Traceback (most recent call last):
    ValueError: a fit and its error need at least 2 rows, and there are 1: invert a single pair instead
    """
    g, epsilon, sigma = _columns(g, epsilon, sigma)
    return Fit(_core.fit(g, epsilon, sigma, end, loss))


def compare(g, epsilon=None, *, sigma=None):
    """Fits several laws to the same data and returns them, best first by Akaike's corrected criterion.

    The laws: viscoelastic spheres at both ends of contact, a constant, plastic spheres (g^(-1/4)), a power law with a
    free exponent. A difference of 2 in the criterion says little, one of 10 a lot. Parameters as in `fit`.

    >>> g = [0.1, 0.2, 0.5, 1.0, 2.0, 5.0]
    >>> compare(g, [0.5 * x**-0.25 for x in g])[0].law
    'plastic'
    >>> compare([1.0], [0.5])
    Traceback (most recent call last):
    ValueError: a fit and its error need at least 2 rows, and there are 1: invert a single pair instead
    """
    g, epsilon, sigma = _columns(g, epsilon, sigma)
    return [LawFit(*row) for row in _core.compare(g, epsilon, sigma)]
