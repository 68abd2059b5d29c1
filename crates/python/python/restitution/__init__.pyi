from collections.abc import Callable
from decimal import Decimal
from fractions import Fraction
from typing import Any, Literal, NamedTuple, SupportsIndex, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

_End = Literal["zero-compression", "zero-force"]
_Number = int | float | str | Fraction | Decimal
_Law = str | tuple[_Number, _Number]
_Floats = NDArray[np.float64]
_Progress = bool | Callable[[int, int | None], object]

@overload
def epsilon(u: float, end: _End = ...) -> float: ...
@overload
def epsilon(u: ArrayLike, end: _End = ...) -> _Floats: ...
@overload
def loss(u: float, end: _End = ...) -> float: ...
@overload
def loss(u: ArrayLike, end: _End = ...) -> _Floats: ...
@overload
def u_of_epsilon(epsilon: float, end: _End = ...) -> float: ...
@overload
def u_of_epsilon(epsilon: ArrayLike, end: _End = ...) -> _Floats: ...
@overload
def duration(u: float, end: _End = ...) -> float: ...
@overload
def duration(u: ArrayLike, end: _End = ...) -> _Floats: ...
@overload
def turning_time(u: float) -> float: ...
@overload
def turning_time(u: ArrayLike) -> _Floats: ...
@overload
def largest_compression(u: float) -> float: ...
@overload
def largest_compression(u: ArrayLike) -> _Floats: ...

class Restitution:
    @classmethod
    def from_g_star(cls, g_star: float | str | Any, end: _End = ...) -> Restitution: ...
    @classmethod
    def from_measured(cls, velocity: float | str | Any, epsilon: float, end: _End = ...) -> Restitution: ...
    @classmethod
    def from_u_at_unit_velocity(cls, u: float, end: _End = ...) -> Restitution: ...
    @classmethod
    def from_material(
        cls,
        *,
        young: float | str | Any,
        poisson: float,
        density: float | str | Any,
        radius: float | str | Any,
        dissipative_constant: float | str | Any | None = ...,
        measured: tuple[float | str | Any, float] | None = ...,
        against: Literal["sphere", "plane", "rigid-plane"] = ...,
        young2: float | str | Any | None = ...,
        poisson2: float | None = ...,
        density2: float | str | Any | None = ...,
        radius2: float | str | Any | None = ...,
        end: _End = ...,
    ) -> Restitution: ...
    @property
    def end(self) -> _End: ...
    @property
    def g_star(self) -> float: ...
    @property
    def dissipative_constant(self) -> float | None: ...
    @overload
    def epsilon(self, velocity: float | str) -> float: ...  # type: ignore[overload-overlap]
    @overload
    def epsilon(self, velocity: ArrayLike) -> _Floats: ...
    @overload
    def __call__(self, velocity: float | str) -> float: ...  # type: ignore[overload-overlap]
    @overload
    def __call__(self, velocity: ArrayLike) -> _Floats: ...
    @overload
    def loss(self, velocity: float | str) -> float: ...  # type: ignore[overload-overlap]
    @overload
    def loss(self, velocity: ArrayLike) -> _Floats: ...
    @overload
    def u(self, velocity: float | str) -> float: ...  # type: ignore[overload-overlap]
    @overload
    def u(self, velocity: ArrayLike) -> _Floats: ...
    @overload
    def velocity(self, u: float) -> float: ...
    @overload
    def velocity(self, u: ArrayLike) -> _Floats: ...
    @overload
    def duration(self, velocity: float | str) -> float: ...  # type: ignore[overload-overlap]
    @overload
    def duration(self, velocity: ArrayLike) -> _Floats: ...
    @overload
    def largest_compression(self, velocity: float | str) -> float: ...  # type: ignore[overload-overlap]
    @overload
    def largest_compression(self, velocity: ArrayLike) -> _Floats: ...

class Fit:
    @property
    def g_star(self) -> float: ...
    @property
    def log_error(self) -> float: ...
    @property
    def interval(self) -> tuple[float, float]: ...
    @property
    def scatter(self) -> float: ...
    @property
    def largest_residual(self) -> float: ...
    @property
    def largest_residual_row(self) -> int: ...
    @property
    def rows(self) -> int: ...
    @property
    def p(self) -> float | None: ...
    @property
    def is_doubtful(self) -> bool: ...
    @property
    def rises(self) -> bool: ...
    @property
    def tests(self) -> list[tuple[str, float, float]]: ...
    @property
    def curve(self) -> Restitution: ...

class LawFit(NamedTuple):
    law: str
    scale: float
    exponent: float | None
    residual: float
    criterion: float | None

def fit(
    g: ArrayLike | Any,
    epsilon: ArrayLike | None = ...,
    *,
    sigma: ArrayLike | None = ...,
    end: _End = ...,
    loss: Literal["squares", "huber"] = ...,
) -> Fit: ...
def compare(g: ArrayLike | Any, epsilon: ArrayLike | None = ..., *, sigma: ArrayLike | None = ...) -> list[LawFit]: ...

class Certified:
    def __init__(self, value: str, radius: str) -> None: ...
    @property
    def value(self) -> str: ...
    @property
    def radius(self) -> str: ...
    @property
    def decimal(self) -> Decimal: ...
    @property
    def interval(self) -> tuple[Fraction, Fraction]: ...
    def contains(self, number: _Number) -> bool: ...
    def mpmath(self) -> Any: ...
    def mpi(self) -> Any: ...
    def arb(self) -> Any: ...
    def __float__(self) -> float: ...

@overload
def coefficients(
    quantity: Literal["C", "a", "y", "h"], order: SupportsIndex, digits: SupportsIndex = ..., law: _Law = ..., progress: _Progress | None = ...
) -> list[Certified]: ...
@overload
def coefficients(
    quantity: Literal["psi"], order: SupportsIndex, digits: SupportsIndex = ..., law: _Law = ..., progress: _Progress | None = ...
) -> list[Fraction]: ...
def trajectory(
    damping_order: SupportsIndex, time_order: _Number, law: _Law = ..., progress: _Progress | None = ...
) -> list[list[tuple[Fraction, Fraction]]]: ...
def epsilon_digits(
    u: _Number,
    digits: SupportsIndex = ...,
    law: _Law = ...,
    end: _End = ...,
    quantity: Literal["epsilon", "loss"] = ...,
    progress: _Progress | None = ...,
) -> Certified: ...
def saturation(digits: SupportsIndex = ..., law: _Law = ...) -> tuple[Certified, Certified]: ...

class Approximant:
    num: list[Certified]
    den: list[Certified]
    variable: str
    def __init__(self, num: list[Certified], den: list[Certified], variable: str) -> None: ...
    @overload
    def __call__(self, x: float) -> float: ...
    @overload
    def __call__(self, x: _Floats) -> _Floats: ...
    def sympy(self, symbol: Any = ...) -> Any: ...

def pade(
    numerator: SupportsIndex,
    denominator: SupportsIndex,
    *,
    variable: Literal["u", "s", "sqrt-u"] = ...,
    digits: SupportsIndex = ...,
    law: _Law = ...,
    progress: _Progress | None = ...,
) -> Approximant: ...

class ClosedForm:
    text: str
    latex: str
    python: str
    value: Certified
    def __init__(self, text: str, latex: str, python: str, sympy: str, value: Certified) -> None: ...
    def sympy(self) -> Any: ...

def closed_form(
    quantity: Literal["C", "a", "h"],
    order: SupportsIndex,
    digits: SupportsIndex = ...,
    law: _Law = ...,
    progress: _Progress | None = ...,
) -> ClosedForm: ...

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
