//! C, C++ and CUDA.

use super::{Language, Rows};

pub(super) static LANGUAGE: Language = Language {
    name: "c",
    aliases: &["h", "c99", "c++", "cpp", "cxx", "cc", "hpp", "cuda", "cu"],
    title: "C99, C++11 and CUDA, a header",
    file: "NAME.h",
    comment: " * ",
    rows: Rows { before: "        { ", between: ", ", after: " },\n", suffix: "" },
    reserved: &[],
    template: TEMPLATE,
};

const TEMPLATE: &str = r#"/*
{HEAD}
 * Functions, for C99, C++11 and CUDA; link with -lm:
 *     {NAME}_epsilon(u)                         the coefficient of restitution
 *     {NAME}_loss(u)                            1 - epsilon, with all its digits where u is small
 *     {NAME}_slope(u)                           d epsilon/d u
 *     {NAME}_epsilon_array(u, epsilon, count)   many at once
 *     {NAME}_u_of_velocity(velocity, g_star)    u of the size of a velocity; both in the same unit
 *     {NAME}_epsilon_of_velocity(velocity, g_star)
?VELOCITY  *     {NAME}_u_at_m_per_s(velocity)             the same for the g* above
?VELOCITY  *     {NAME}_epsilon_at_m_per_s(velocity)
 * No argument and no compiler flag makes them read beyond their tables.
 *
 * Self-check: cc -x c -D{CAPITALS}_SELF_CHECK {FILE} -o check -lm && ./check
 *
 * Written by: restitution export --lang {LANGUAGE} {OPTIONS} --name {NAME}
 */
#ifndef {CAPITALS}_{FINGERPRINT}
#define {CAPITALS}_{FINGERPRINT}

#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#ifdef __CUDACC__
#define {CAPITALS}_FUNCTION __host__ __device__ static inline
#else
#define {CAPITALS}_FUNCTION static inline
#endif

/* The polynomial of a piece, in the distance to its end as a part of its width, constant first. */
{CAPITALS}_FUNCTION const double *{NAME}_row(int row)
{
    static const double table[{ROWS}][{WIDTH}] = {
{TABLE}
    };
    return table[row];
}

/* The row of u, the distance to the end of its piece, the exponent of its width, and how many periods of the
   law at infinity lie between; -1 outside the range. Bits decide, which no flag changes. */
{CAPITALS}_FUNCTION int {NAME}_locate(double u, double *distance, int *exponent, int *periods)
{
    const uint64_t low = UINT64_C({LOW_BITS}), high = UINT64_C({HIGH_BITS});
    uint64_t bits, row;
    double shifted;
    memcpy(&bits, &u, sizeof bits);
    if (bits == UINT64_C(1) << 63) /* -0 */
        bits = 0;
    if (bits < low || bits > high)
        return -1;
    *periods = 0;
?LAW     if (bits >= UINT64_C({LAW_BITS})) {
?LAW         *periods = (int)((bits - UINT64_C({LAW_BITS})) >> 52) / {OCTAVES};
?LAW         bits -= (uint64_t)(*periods * {OCTAVES}) << 52;
?LAW         row = (bits >> {REST}) - {LAW_FIRST}u + {LAW_ROW}u;
?LAW     } else {
?LAW         shifted = u + {SHIFT};
?LAW         memcpy(&bits, &shifted, sizeof bits);
?LAW         row = (bits >> {REST}) - {FIRST}u;
?LAW     }
!LAW     shifted = u + {SHIFT};
!LAW     memcpy(&bits, &shifted, sizeof bits);
!LAW     row = (bits >> {REST}) - {FIRST}u;
    *exponent = (int)(bits >> 52) - {BITS} - 1023;
    bits = ((bits << {BITS}) & UINT64_C(0x000fffffffffffff)) | UINT64_C(0x3ff0000000000000);
    memcpy(&shifted, &bits, sizeof shifted);
    *distance = 2 - shifted;
    return row < {ROWS}u ? (int)row : {LAST_ROW};
}

{CAPITALS}_FUNCTION double {NAME}_not_a_number(void)
{
    const uint64_t bits = UINT64_C(0x7ff8000000000000);
    double value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

/* What epsilon has above its value at the end of the piece. */
{CAPITALS}_FUNCTION double {NAME}_rise(const double *c, double distance)
{
    double rise = c[{DEGREE}] * distance;
    int k;
    for (k = {DEGREE} - 1; k > 0; --k)
        rise = (rise + c[k]) * distance;
    return rise;
}

/* Coefficient of restitution at u. */
{CAPITALS}_FUNCTION double {NAME}_epsilon(double u)
{
    double distance;
    const double *c;
    int exponent, periods, row = {NAME}_locate(u, &distance, &exponent, &periods);
    if (row < 0)
        return {NAME}_not_a_number();
    c = {NAME}_row(row);
?LAW     if (periods > 0)
?LAW         return ldexp(c[0] + {NAME}_rise(c, distance), -5 * periods);
    return c[0] + {NAME}_rise(c, distance);
}

/* 1 - epsilon at u. */
{CAPITALS}_FUNCTION double {NAME}_loss(double u)
{
?NEAR     static const double near_zero[{NEAR_COUNT}] = { {NEAR} };
    double distance;
    const double *c;
    int exponent, periods, row = {NAME}_locate(u, &distance, &exponent, &periods);
    if (row < 0)
        return {NAME}_not_a_number();
?NEAR     if (row < {NEAR_ROW}) {
?NEAR !ROOT         double x = u, sum = near_zero[{NEAR_LAST}];
?NEAR ?ROOT         double x = sqrt(u), sum = near_zero[{NEAR_LAST}];
?NEAR         int k;
?NEAR         for (k = {NEAR_LAST} - 1; k >= 0; --k)
?NEAR             sum = sum * x + near_zero[k];
?NEAR         return u * sum;
?NEAR     }
    c = {NAME}_row(row);
?LAW     if (periods > 0)
?LAW         return 1 - ldexp(c[0] + {NAME}_rise(c, distance), -5 * periods);
    return (1 - c[0]) - {NAME}_rise(c, distance);
}

/* d epsilon/d u at u. */
{CAPITALS}_FUNCTION double {NAME}_slope(double u)
{
    double distance, sum = 0;
    const double *c;
    int k, exponent, periods, row = {NAME}_locate(u, &distance, &exponent, &periods);
    if (row < 0)
        return {NAME}_not_a_number();
    c = {NAME}_row(row);
    for (k = {DEGREE}; k > 0; --k)
        sum = sum * distance + k * c[k];
    return -ldexp(sum, -exponent - {FALL} * periods);
}

/* Coefficients of restitution at count values of u. */
{CAPITALS}_FUNCTION void {NAME}_epsilon_array(const double *u, double *epsilon, size_t count)
{
    size_t i;
    for (i = 0; i < count; ++i)
        epsilon[i] = {NAME}_epsilon(u[i]);
}

/* u of the size of a velocity; g_star is the characteristic velocity, in the same unit. */
{CAPITALS}_FUNCTION double {NAME}_u_of_velocity(double velocity, double g_star)
{
    return {U_AT_G_STAR} * pow(fabs(velocity) / g_star, 0.2);
}

/* Coefficient of restitution of the size of a velocity. */
{CAPITALS}_FUNCTION double {NAME}_epsilon_of_velocity(double velocity, double g_star)
{
    return {NAME}_epsilon({NAME}_u_of_velocity(velocity, g_star));
}
?VELOCITY 
?VELOCITY /* The same for g* = {G_STAR} m/s; the velocity in m/s. */
?VELOCITY {CAPITALS}_FUNCTION double {NAME}_u_at_m_per_s(double velocity)
?VELOCITY {
?VELOCITY     return {NAME}_u_of_velocity(velocity, {G_STAR});
?VELOCITY }
?VELOCITY 
?VELOCITY {CAPITALS}_FUNCTION double {NAME}_epsilon_at_m_per_s(double velocity)
?VELOCITY {
?VELOCITY     return {NAME}_epsilon_of_velocity(velocity, {G_STAR});
?VELOCITY }

#endif

#ifdef {CAPITALS}_SELF_CHECK
#include <stdio.h>

int main(void)
{
    static const double check[{CHECKS}][3] = { /* u, certified epsilon and 1 - epsilon */
{POINTS}
    };
    double worst = 0, worst_loss = 0;
    size_t i;
    for (i = 0; i < {CHECKS}; ++i) {
        double u = check[i][0], loss = check[i][2] > 0 ? check[i][2] : 1;
        worst = fmax(worst, fabs({NAME}_epsilon(u) / check[i][1] - 1));
        worst_loss = fmax(worst_loss, fabs({NAME}_loss(u) - check[i][2]) / loss);
    }
    printf("largest relative errors %.2e of %.2e, %.2e of %.2e\n", worst, {TOLERANCE}, worst_loss, {LOSS_BOUND});
    return worst <= {TOLERANCE} && worst_loss <= {LOSS_BOUND} ? 0 : 1;
}
#endif
"#;
