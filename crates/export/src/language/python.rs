//! Python.

use super::{Language, Rows};

pub(super) static LANGUAGE: Language = Language {
    name: "python",
    aliases: &["py", "python3", "numpy"],
    title: "Python 3, numbers and NumPy arrays, a module",
    file: "NAME.py",
    comment: "",
    rows: Rows { before: "    (", between: ", ", after: "),\n", suffix: "" },
    reserved: &[],
    template: TEMPLATE,
};

const TEMPLATE: &str = r#""""{HEAD}
Functions of a number or a NumPy array:
    {NAME}_epsilon(u)                         the coefficient of restitution
    {NAME}_loss(u)                            1 - epsilon, with all its digits where u is small
    {NAME}_slope(u)                           d epsilon/d u
    {NAME}_u_of_velocity(velocity, g_star)    u of the size of a velocity; both in the same unit
    {NAME}_epsilon_of_velocity(velocity, g_star)
?VELOCITY     {NAME}_u_at_m_per_s(velocity)             the same for the g* above
?VELOCITY     {NAME}_epsilon_at_m_per_s(velocity)

Self-check: python3 {FILE}

Written by: restitution export --lang {LANGUAGE} {OPTIONS} --name {NAME}
"""

import math

# The polynomial of each piece, in the distance to its end as a part of its width, constant first.
_{NAME}_table = (
{TABLE}
)
?NEAR _{NAME}_near = ({NEAR},)
_{NAME}_arrays = []


def _{NAME}_locate(u):
    """The row of u, the distance to the end of its piece, the exponent of its width, and how many periods of the law at
    infinity lie between."""
    periods = 0
?LAW     if u >= {LAW_FROM}:
?LAW         u = min(u, {HIGH})
?LAW         periods = (math.frexp(u)[1] - math.frexp({LAW_FROM})[1]) // {OCTAVES}
?LAW         mantissa, exponent = math.frexp(math.ldexp(u, -{OCTAVES} * periods))
?LAW         first = {LAW_FIRST} - {LAW_ROW}
?LAW     else:
?LAW         mantissa, exponent = math.frexp(u + {SHIFT})
?LAW         first = {FIRST}
!LAW     mantissa, exponent = math.frexp(u + {SHIFT})
!LAW     first = {FIRST}
    part = math.ldexp(2.0 * mantissa - 1.0, {BITS})
    piece = int(part)
    row = min(((exponent + 1022) << {BITS}) + piece - first, {LAST_ROW})
    return row, 1.0 - (part - piece), exponent - 1 - {BITS}, periods


def _{NAME}_locate_all(np, u):
    """The same for an array."""
    periods = np.zeros(u.shape, dtype=np.intc)
    shifted, first = u + {SHIFT}, {FIRST}
?LAW     far = u >= {LAW_FROM}
?LAW     octaves = np.frexp(np.minimum(u, {HIGH}))[1].astype(np.intc) - math.frexp({LAW_FROM})[1]
?LAW     periods = np.where(far, octaves // {OCTAVES}, 0)
?LAW     shifted = np.where(far, np.ldexp(np.minimum(u, {HIGH}), -{OCTAVES} * periods), shifted)
?LAW     first = np.where(far, {LAW_FIRST} - {LAW_ROW}, first)
    mantissa, exponent = np.frexp(shifted)
    part = np.ldexp(2.0 * mantissa - 1.0, {BITS})
    piece = np.floor(part)
    row = ((exponent + 1022) << {BITS}) + piece.astype(np.intc) - first
    return np.clip(row, 0, {LAST_ROW}), 1.0 - (part - piece), exponent - 1 - {BITS}, periods


def _{NAME}_apply(kernel, u):
    """kernel at a number, or at every element of an array."""
    if isinstance(u, (int, float)):
        u = float(u)
?LAW         if not {LOW} <= u:
!LAW         if not {LOW} <= u <= {HIGH}:
            return math.nan
        row, *place = _{NAME}_locate(u)
        return kernel(math, u, row, _{NAME}_table[row], *place)
    import numpy as np

    if not _{NAME}_arrays:
        _{NAME}_arrays.append(np.array(_{NAME}_table).T.copy())
    u = np.asarray(u, dtype=np.float64)
?LAW     inside = u >= {LOW}
!LAW     inside = (u >= {LOW}) & (u <= {HIGH})
    u = np.where(inside, u, {LOW})
    row, *place = _{NAME}_locate_all(np, u)
    return np.where(inside, kernel(np, u, row, _{NAME}_arrays[0][:, row], *place), np.nan)


def _{NAME}_rise(c, distance):
    """What epsilon has above its value at the end of the piece."""
    rise = c[{DEGREE}] * distance
    for k in range({DEGREE} - 1, 0, -1):
        rise = (rise + c[k]) * distance
    return rise


def _{NAME}_epsilon(xp, u, row, c, distance, exponent, periods):
    value = c[0] + _{NAME}_rise(c, distance)
?LAW     return xp.ldexp(value, -5 * periods)
!LAW     return value


def _{NAME}_loss(xp, u, row, c, distance, exponent, periods):
    loss = (1.0 - c[0]) - _{NAME}_rise(c, distance)
?LAW     far = 1.0 - xp.ldexp(c[0] + _{NAME}_rise(c, distance), -5 * periods)
?LAW     loss = (far if periods > 0 else loss) if xp is math else xp.where(periods > 0, far, loss)
?NEAR     if xp is math and row >= {NEAR_ROW}:
?NEAR         return loss
?NEAR     if xp is not math:
?NEAR         u = xp.where(row < {NEAR_ROW}, u, 0.0)
?NEAR !ROOT     x, near = u, 0.0
?NEAR ?ROOT     x, near = xp.sqrt(u), 0.0
?NEAR     for k in _{NAME}_near[::-1]:
?NEAR         near = near * x + k
?NEAR     return u * near if xp is math else xp.where(row < {NEAR_ROW}, u * near, loss)
!NEAR     return loss


def _{NAME}_slope(xp, u, row, c, distance, exponent, periods):
    total = 0.0
    for k in range({DEGREE}, 0, -1):
        total = total * distance + k * c[k]
    return -xp.ldexp(total, -exponent - {FALL} * periods)


def {NAME}_epsilon(u):
    """Coefficient of restitution at u, a number or an array; NaN outside the range."""
    return _{NAME}_apply(_{NAME}_epsilon, u)


def {NAME}_loss(u):
    """1 - epsilon at u, a number or an array; NaN outside the range."""
    return _{NAME}_apply(_{NAME}_loss, u)


def {NAME}_slope(u):
    """d epsilon/d u at u, a number or an array; NaN outside the range."""
    return _{NAME}_apply(_{NAME}_slope, u)


def {NAME}_u_of_velocity(velocity, g_star):
    """u of the size of a velocity; g_star is the characteristic velocity, in the same unit."""
    return {U_AT_G_STAR} * (abs(velocity) / g_star) ** 0.2


def {NAME}_epsilon_of_velocity(velocity, g_star):
    """Coefficient of restitution of the size of a velocity."""
    return {NAME}_epsilon({NAME}_u_of_velocity(velocity, g_star))


?VELOCITY def {NAME}_u_at_m_per_s(velocity):
?VELOCITY     """u of the size of a velocity in m/s, for g* = {G_STAR} m/s."""
?VELOCITY     return {NAME}_u_of_velocity(velocity, {G_STAR})
?VELOCITY 
?VELOCITY 
?VELOCITY def {NAME}_epsilon_at_m_per_s(velocity):
?VELOCITY     """Coefficient of restitution of the size of a velocity in m/s."""
?VELOCITY     return {NAME}_epsilon_of_velocity(velocity, {G_STAR})
?VELOCITY 
?VELOCITY 
def {NAME}_self_check():
    """The largest relative errors of epsilon and of 1 - epsilon at certified values, and whether they are kept."""
    check = ( # u, certified epsilon and 1 - epsilon
{POINTS}
    )
    worst = max(abs({NAME}_epsilon(u) / epsilon - 1) for u, epsilon, loss in check)
    worst_loss = max(abs({NAME}_loss(u) - loss) / (loss or 1) for u, epsilon, loss in check)
    return worst, worst_loss, worst <= {TOLERANCE} and worst_loss <= {LOSS_BOUND}


if __name__ == "__main__":
    worst, worst_loss, kept = {NAME}_self_check()
    print(f"largest relative errors {worst:.2e} of {TOLERANCE}, {worst_loss:.2e} of {LOSS_BOUND}")
    raise SystemExit(0 if kept else 1)
"#;
