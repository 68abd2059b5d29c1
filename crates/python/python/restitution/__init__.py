"""The coefficient of restitution of colliding viscoelastic spheres.

For simulations, float64 in and float64 out, scalars and arrays of any shape:

    >>> import restitution
    >>> ice = restitution.Restitution.from_g_star("0.32cm/s")
    >>> print(f"{ice.epsilon(0.01):.6f}")
    0.299498
    >>> ice.epsilon([0.001, 0.01]).round(4)
    array([0.4681, 0.2995])

For theory, exact fractions and certified digits of any number:

    >>> restitution.coefficients("C", order=3, digits=20)[3]
    Certified('-0.52288256808841496390')
    >>> restitution.trajectory(0, 6)[0]
    [(Fraction(1, 1), Fraction(1, 1)), (Fraction(7, 2), Fraction(-4, 35)), (Fraction(6, 1), Fraction(1, 175))]

`epsilon`, `loss`, `u_of_epsilon`, `duration`, `turning_time`, `largest_compression` take the dimensionless damping
parameter u; `Restitution` holds two given bodies and takes their impact velocity; `fit` finds the bodies' characteristic
velocity from measurements. `coefficients`, `trajectory`, `pade`, `closed_form`, `epsilon_digits`, `saturation` are
certified. Wrong arguments raise ValueError with a sentence that names the remedy.
"""

from ._core import duration, epsilon, largest_compression, loss, turning_time, u_of_epsilon
from ._curve import Restitution
from ._fit import Fit, LawFit, compare, fit
from ._theory import (
    Approximant,
    Certified,
    ClosedForm,
    closed_form,
    coefficients,
    epsilon_digits,
    pade,
    saturation,
    trajectory,
)

__all__ = [
    "Approximant",
    "Certified",
    "ClosedForm",
    "Fit",
    "LawFit",
    "Restitution",
    "closed_form",
    "coefficients",
    "compare",
    "duration",
    "epsilon",
    "epsilon_digits",
    "fit",
    "largest_compression",
    "loss",
    "pade",
    "saturation",
    "trajectory",
    "turning_time",
    "u_of_epsilon",
]
