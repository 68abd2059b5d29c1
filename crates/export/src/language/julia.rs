//! Julia.

use super::{Language, Rows};

pub(super) static LANGUAGE: Language = Language {
    name: "julia",
    aliases: &["jl"],
    title: "Julia 1, functions to include",
    file: "NAME.jl",
    comment: "# ",
    rows: Rows { before: "    (", between: ", ", after: "),\n", suffix: "" },
    reserved: &[],
    template: TEMPLATE,
};

const TEMPLATE: &str = r#"{HEAD}
# Functions of a Float64; broadcast with a dot, {NAME}_epsilon.(u):
#     {NAME}_epsilon(u)                         the coefficient of restitution
#     {NAME}_loss(u)                            1 - epsilon, with all its digits where u is small
#     {NAME}_slope(u)                           d epsilon/d u
#     {NAME}_u_of_velocity(velocity, g_star)    u of the size of a velocity; both in the same unit
#     {NAME}_epsilon_of_velocity(velocity, g_star)
?VELOCITY #     {NAME}_u_at_m_per_s(velocity)             the same for the g* above
?VELOCITY #     {NAME}_epsilon_at_m_per_s(velocity)
#
# Self-check: julia -e 'include("{FILE}"); exit({NAME}_self_check() ? 0 : 1)'
#
# Written by: restitution export --lang {LANGUAGE} {OPTIONS} --name {NAME}

# The polynomial of each piece, in the distance to its end as a part of its width, constant first.
const {NAME}_table = NTuple{{WIDTH},Float64}[
{TABLE}
]
?NEAR const {NAME}_near = ({NEAR},)

# The row of u from 0, the distance to the end of its piece, the exponent of its width, and how many periods of the law at
# infinity lie between; row -1 outside the range.
@inline function {NAME}_locate(u::Float64)
    bits = u == 0.0 ? UInt64(0) : reinterpret(UInt64, u)
    if bits < UInt64({LOW_BITS}) || bits > UInt64({HIGH_BITS})
        return -1, 0.0, 0, 0
    end
    periods = 0
?LAW     if bits >= UInt64({LAW_BITS})
?LAW         periods = Int64((bits - UInt64({LAW_BITS})) >> 52) ÷ {OCTAVES}
?LAW         bits -= UInt64(periods * {OCTAVES}) << 52
?LAW         row = Int64(bits >> {REST}) - {LAW_FIRST} + {LAW_ROW}
?LAW     else
?LAW         bits = reinterpret(UInt64, u + {SHIFT})
?LAW         row = Int64(bits >> {REST}) - {FIRST}
?LAW     end
!LAW     bits = reinterpret(UInt64, u + {SHIFT})
!LAW     row = Int64(bits >> {REST}) - {FIRST}
    exponent = Int64(bits >> 52) - {BITS} - 1023
    distance = 2.0 - reinterpret(Float64, ((bits << {BITS}) & 0x000fffffffffffff) | 0x3ff0000000000000)
    return clamp(row, 0, {LAST_ROW}), distance, exponent, periods
end

# What epsilon has above its value at the end of the piece.
@inline function {NAME}_rise(c, distance)
    rise = 0.0
    for k in {DEGREE}:-1:1
        rise = (rise + c[k + 1]) * distance
    end
    return rise
end

"""Coefficient of restitution at u; NaN outside the range."""
function {NAME}_epsilon(u::Real)
    row, distance, _, periods = {NAME}_locate(Float64(u))
    row < 0 && return NaN
    c = {NAME}_table[row + 1]
    value = c[1] + {NAME}_rise(c, distance)
?LAW     return periods > 0 ? ldexp(value, -5 * periods) : value
!LAW     return value
end

"""1 - epsilon at u; NaN outside the range."""
function {NAME}_loss(u::Real)
    row, distance, _, periods = {NAME}_locate(Float64(u))
    row < 0 && return NaN
?NEAR     if row < {NEAR_ROW}
?NEAR !ROOT         x = Float64(u)
?NEAR ?ROOT         x = sqrt(abs(Float64(u)))
?NEAR         sum = 0.0
?NEAR         for c in reverse({NAME}_near)
?NEAR             sum = sum * x + c
?NEAR         end
?NEAR         return Float64(u) * sum
?NEAR     end
    c = {NAME}_table[row + 1]
?LAW     periods > 0 && return 1.0 - ldexp(c[1] + {NAME}_rise(c, distance), -5 * periods)
    return (1.0 - c[1]) - {NAME}_rise(c, distance)
end

"""d epsilon/d u at u; NaN outside the range."""
function {NAME}_slope(u::Real)
    row, distance, exponent, periods = {NAME}_locate(Float64(u))
    row < 0 && return NaN
    c = {NAME}_table[row + 1]
    sum = 0.0
    for k in {DEGREE}:-1:1
        sum = sum * distance + k * c[k + 1]
    end
    return -ldexp(sum, -exponent - {FALL} * periods)
end

"""u of the size of a velocity; g_star is the characteristic velocity, in the same unit."""
{NAME}_u_of_velocity(velocity::Real, g_star::Real) = {U_AT_G_STAR} * (abs(velocity) / g_star)^0.2

"""Coefficient of restitution of the size of a velocity."""
{NAME}_epsilon_of_velocity(velocity::Real, g_star::Real) = {NAME}_epsilon({NAME}_u_of_velocity(velocity, g_star))
?VELOCITY 
?VELOCITY """u of the size of a velocity in m/s, for g* = {G_STAR} m/s."""
?VELOCITY {NAME}_u_at_m_per_s(velocity::Real) = {NAME}_u_of_velocity(velocity, {G_STAR})
?VELOCITY 
?VELOCITY """Coefficient of restitution of the size of a velocity in m/s."""
?VELOCITY {NAME}_epsilon_at_m_per_s(velocity::Real) = {NAME}_epsilon_of_velocity(velocity, {G_STAR})

"""Whether certified values are met."""
function {NAME}_self_check()
    check = [ # u, certified epsilon and 1 - epsilon
{POINTS}
    ]
    worst = maximum(abs({NAME}_epsilon(u) / epsilon - 1) for (u, epsilon, _) in check)
    worst_loss = maximum(abs({NAME}_loss(u) - loss) / (loss > 0 ? loss : 1.0) for (u, _, loss) in check)
    println("largest relative errors $worst of {TOLERANCE}, $worst_loss of {LOSS_BOUND}")
    return worst <= {TOLERANCE} && worst_loss <= {LOSS_BOUND}
end
"#;
