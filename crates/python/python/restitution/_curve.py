"""The coefficient of restitution of two given bodies."""

from . import _core
from ._units import si, stripped


class Restitution(_core._Curve):
    """The coefficient of restitution of two given bodies as a function of their impact velocity.

    Made by `from_g_star`, `from_measured`, `from_u_at_unit_velocity` or `from_material`; velocities are numbers in
    m/s, text with a unit ("0.32cm/s") or quantities of pint, and arrays of any shape where a curve is evaluated.

    >>> ball = Restitution.from_measured("1cm/s", 0.5)
    >>> round(ball.epsilon(0.01), 12)
    0.5
    >>> ball.epsilon("-1m/s")
    nan
    """

    __slots__ = ()

    @classmethod
    def _of(cls, curve):
        return cls.__new__(cls, curve)

    @classmethod
    def from_g_star(cls, g_star, end="zero-compression"):
        """From the characteristic velocity g*, at which -C_1 u = 1 (Ramirez et al. 1999, eq. 31).

        >>> Restitution.from_g_star("0.32cm/s")
        Restitution.from_g_star(0.0032, end='zero-compression')
        >>> Restitution.from_g_star(-1)
        Traceback (most recent call last):
        ValueError: the characteristic velocity g* is -1.0: give a positive number
        """
        return cls._of(_core._Curve.from_g_star(si(g_star, "velocity"), end))

    @classmethod
    def from_measured(cls, velocity, epsilon, end="zero-compression"):
        """From one measured pair: the curve through `epsilon` at `velocity`.

        >>> Restitution.from_measured(0.01, 1.5)
        Traceback (most recent call last):
        ValueError: a coefficient of restitution of 1.5 has no damping that belongs to it: give a number strictly between 0 and 1
        """
        return cls._of(_core._Curve.from_measured(si(velocity, "velocity"), float(epsilon), end))

    @classmethod
    def from_u_at_unit_velocity(cls, u, end="zero-compression"):
        """From the damping parameter at 1 m/s, (3/2) A (rho/m_eff)^(2/5) in SI units."""
        return cls._of(_core._Curve.from_u_at_unit_velocity(float(u), end))

    @classmethod
    def from_material(
        cls,
        *,
        young,
        poisson,
        density,
        radius,
        dissipative_constant=None,
        measured=None,
        against="sphere",
        young2=None,
        poisson2=None,
        density2=None,
        radius2=None,
        end="zero-compression",
    ):
        """From the bodies and what they dissipate.

        Parameters
        ----------
        young, poisson, density, radius
            Of the sphere: Pa, 1, kg/m^3, m, or text with a unit.
        dissipative_constant
            A of eq. (5), in s; or instead of it
        measured : pair (velocity, epsilon)
            One measured impact, which fixes A.
        against : {"sphere", "plane", "rigid-plane"}
            What it meets; young2, poisson2, density2, radius2 describe it where it differs.

        Examples
        --------
        >>> ice = dict(young="9.4GPa", poisson=0.33, density=917, radius="2.75cm")
        >>> ball = Restitution.from_material(**ice, measured=("1cm/s", 0.5), against="plane")
        >>> round(ball.epsilon(0.01), 12)
        0.5
        >>> Restitution.from_material(**ice)
        Traceback (most recent call last):
        ValueError: nothing says what the bodies dissipate: give dissipative_constant or measured
        """
        if (dissipative_constant is None) == (measured is None):
            said = "nothing says" if measured is None else "two things say"
            raise ValueError(f"{said} what the bodies dissipate: give dissipative_constant or measured")
        if against not in ("sphere", "plane", "rigid-plane"):
            raise ValueError(f"'{against}' is nothing to meet: give 'sphere', 'plane' or 'rigid-plane'")
        if against != "sphere" and radius2 is not None:
            raise ValueError("a plane has no radius: leave radius2 out")
        others = (young2, poisson2, density2)
        if against == "rigid-plane" and any(other is not None for other in others):
            raise ValueError("a rigid plane has no material: leave young2, poisson2, density2 out")
        first = (si(young, "modulus"), float(poisson), si(density, "density"))
        second = (
            first[0] if young2 is None else si(young2, "modulus"),
            first[1] if poisson2 is None else float(poisson2),
            first[2] if density2 is None else si(density2, "density"),
        )
        radius = si(radius, "length")
        other = (radius if radius2 is None else si(radius2, "length")) if against == "sphere" else None
        a = 0.0 if dissipative_constant is None else si(dissipative_constant, "time")
        if dissipative_constant is not None and not a > 0.0:
            raise ValueError(f"the dissipative constant is {a}: give a positive number")
        curve = _core._Curve.from_bodies(
            first, radius, None if against == "rigid-plane" else second, other, a, end
        )
        if measured is not None:
            velocity, epsilon = measured
            curve = curve.calibrated(si(velocity, "velocity"), float(epsilon))
        return cls._of(curve)

    def epsilon(self, velocity):
        """The coefficient at impact velocities in m/s (numbers, text, pint, arrays of any shape); NaN below 0."""
        return super().epsilon(stripped(velocity, "velocity"))

    def loss(self, velocity):
        """1 - epsilon at impact velocities, accurate where it is small."""
        return super().loss(stripped(velocity, "velocity"))

    def u(self, velocity):
        """The damping parameter u = (3/2) A (rho/m_eff)^(2/5) g^(1/5) at impact velocities."""
        return super().u(stripped(velocity, "velocity"))

    def duration(self, velocity):
        """How long the contact lasts, in s; NaN where it is not followed (u > 20). Needs the bodies."""
        return super().duration(stripped(velocity, "velocity"))

    def largest_compression(self, velocity):
        """The largest compression, in m; NaN where it is not followed (u > 20). Needs the bodies."""
        return super().largest_compression(stripped(velocity, "velocity"))

    __call__ = epsilon

    def __repr__(self):
        bodies = "" if self.dissipative_constant is None else f", A={self.dissipative_constant!r} s"
        return f"Restitution.from_g_star({self.g_star!r}, end={self.end!r}){bodies}"

    def __reduce__(self):
        return (_restored, (type(self), self.state))


def _restored(cls, state):
    return cls._of(_core._Curve.restored(state))
