//! C, C++ and CUDA.

use super::{head, number, row};
use crate::{Listing, Pieces, Variable};

const TEMPLATE: &str = r#"/*
{HEAD} *
 * restitution_epsilon(u) is C99, C++11 and CUDA. Self-check:
 *     cc -x c -DRESTITUTION_SELF_CHECK FILE -lm && ./a.out
 */
#ifndef {GUARD}
#define {GUARD}

#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#ifdef __CUDACC__
#define RESTITUTION_FUNCTION __host__ __device__ static inline
#else
#define RESTITUTION_FUNCTION static inline
#endif

/* Coefficient of restitution at u. */
RESTITUTION_FUNCTION double restitution_epsilon(double u)
{
    static const double c[{ROWS}][{WIDTH}] = {
{TABLE}    };
    double x, v, centre, t;
    uint64_t n, bits;
    const double *r;
    if (!(u >= {LOW} && u <= {HIGH}))
        return (double)NAN;
    x = {X};
    v = x + {SHIFT};
    memcpy(&n, &v, sizeof n);
    n >>= {DROP};                       /* the number of the piece */
    bits = (2 * n + 1) << {HALF_DROP};  /* its centre */
    memcpy(&centre, &bits, sizeof centre);
    t = x - (centre - {SHIFT});
    r = c[n - {FIRST}u];
    return {HORNER};
}

/* Coefficients of restitution at count values of u. */
RESTITUTION_FUNCTION void restitution_epsilon_array(const double *u, double *epsilon, size_t count)
{
    size_t i;
    for (i = 0; i < count; ++i)
        epsilon[i] = restitution_epsilon(u[i]);
}

#endif

#ifdef RESTITUTION_SELF_CHECK
#include <stdio.h>

int main(void)
{
    static const double check[{CHECKS}][2] = { /* u, certified epsilon */
{POINTS}    };
    double worst = 0;
    size_t i;
    for (i = 0; i < {CHECKS}; ++i) {
        double error = fabs(restitution_epsilon(check[i][0]) / check[i][1] - 1);
        if (!(error <= worst))
            worst = error;
    }
    printf("largest relative error %.2e, tolerance {TOLERANCE}\n", worst);
    return worst <= {TOLERANCE} ? 0 : 1;
}
#endif
"#;

pub(super) fn write(listing: &Listing) -> String {
    let Pieces { grid, first, variable, ref rows, .. } = listing.pieces;
    let lines = |rows: &mut dyn Iterator<Item = Vec<f64>>| -> String {
        rows.map(|numbers| format!("        {{ {} }},\n", row(&numbers, ""))).collect()
    };
    let horner = (0..listing.width()).rev().fold(String::new(), |inner, k| match inner.as_str() {
        "" => format!("r[{k}]"),
        _ => format!("r[{k}] + t * {}", if inner.contains(' ') { format!("({inner})") } else { inner }),
    });
    let guard = format!("RESTITUTION_EPSILON_{:016X}", fingerprint(listing));
    TEMPLATE
        .replace("{HEAD}", &head(listing, " * "))
        .replace("{GUARD}", &guard)
        .replace("{ROWS}", &rows.len().to_string())
        .replace("{WIDTH}", &listing.width().to_string())
        .replace("{TABLE}", &lines(&mut rows.iter().cloned()))
        .replace("{LOW}", &number(listing.range.0))
        .replace("{HIGH}", &number(listing.range.1))
        .replace("{X}", if variable == Variable::U { "u" } else { "sqrt(u)" })
        .replace("{SHIFT}", &number(grid.shift))
        .replace("{DROP}", &(52 - grid.bits).to_string())
        .replace("{HALF_DROP}", &(51 - grid.bits).to_string())
        .replace("{FIRST}", &first.to_string())
        .replace("{HORNER}", &horner)
        .replace("{CHECKS}", &listing.checks.len().to_string())
        .replace("{POINTS}", &lines(&mut listing.checks.iter().map(|(u, e)| vec![*u, *e])))
        .replace("{TOLERANCE}", &format!("{:e}", listing.tolerance))
}

/// Tells the include guards of different tables apart.
fn fingerprint(listing: &Listing) -> u64 {
    let constants = listing.pieces.rows.iter().flatten();
    constants.fold(0xcbf2_9ce4_8422_2325, |hash, c| (hash ^ c.to_bits()).wrapping_mul(0x0100_0000_01b3))
}
