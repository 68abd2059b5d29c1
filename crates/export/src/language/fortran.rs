//! Fortran.

use super::{head, number, row};
use crate::{Listing, Pieces, Variable};

const TEMPLATE: &str = r#"{HEAD}!
! Self-check: gfortran -cpp -DRESTITUTION_SELF_CHECK FILE && ./a.out
module restitution
    use, intrinsic :: iso_fortran_env, only: dp => real64, int64
    use, intrinsic :: ieee_arithmetic, only: ieee_value, ieee_quiet_nan
    implicit none
    private
    public :: restitution_epsilon

    ! Coefficients of each piece, in the distance to its centre, constant first.
    real(dp), save :: c(0:{DEGREE}, 0:{LAST})
{TABLE}
contains

    ! Coefficient of restitution at u, a number or an array; NaN outside the range.
    elemental function restitution_epsilon(u) result(epsilon)
        real(dp), intent(in) :: u
        real(dp) :: epsilon, x, t
        integer(int64) :: n
        integer :: k, row
        if (.not. (u >= {LOW}_dp .and. u <= {HIGH}_dp)) then
            epsilon = ieee_value(u, ieee_quiet_nan)
            return
        end if
        x = {X}
        n = shiftr(transfer(x + {SHIFT}_dp, n), {DROP})
        t = x - (transfer(shiftl(2 * n + 1, {HALF_DROP}), x) - {SHIFT}_dp)
        row = int(n - {FIRST}_int64)
        epsilon = c({DEGREE}, row)
        do k = {DEGREE} - 1, 0, -1
            epsilon = epsilon * t + c(k, row)
        end do
    end function
end module

#ifdef RESTITUTION_SELF_CHECK
program self_check
    use, intrinsic :: iso_fortran_env, only: dp => real64
    use restitution, only: restitution_epsilon
    implicit none
    real(dp) :: check(2, {CHECKS}), worst ! u, certified epsilon
{POINTS}
    worst = maxval(abs(restitution_epsilon(check(1, :)) / check(2, :) - 1))
    print '(a, es9.2, a)', 'largest relative error ', worst, ', tolerance {TOLERANCE}'
    if (.not. worst <= {TOLERANCE}_dp) stop 1
end program
#endif
"#;

/// Numbers in a line, which must not exceed 132 characters.
const IN_A_LINE: usize = 4;

pub(super) fn write(listing: &Listing) -> String {
    let Pieces { grid, first, variable, ref rows, .. } = listing.pieces;
    let table: String = rows.iter().enumerate().map(|(i, row)| data("c", i, row)).collect();
    let points: String =
        listing.checks.iter().enumerate().map(|(i, (u, e))| data("check", i + 1, &[*u, *e])).collect();
    TEMPLATE
        .replace("{HEAD}", &head(listing, "! "))
        .replace("{DEGREE}", &(listing.width() - 1).to_string())
        .replace("{LAST}", &(rows.len() - 1).to_string())
        .replace("{TABLE}", &table)
        .replace("{LOW}", &number(listing.range.0))
        .replace("{HIGH}", &number(listing.range.1))
        .replace("{X}", if variable == Variable::U { "u" } else { "sqrt(u)" })
        .replace("{SHIFT}", &number(grid.shift))
        .replace("{DROP}", &(52 - grid.bits).to_string())
        .replace("{HALF_DROP}", &(51 - grid.bits).to_string())
        .replace("{FIRST}", &first.to_string())
        .replace("{CHECKS}", &listing.checks.len().to_string())
        .replace("{POINTS}", &points)
        .replace("{TOLERANCE}", &format!("{:e}", listing.tolerance))
}

/// A `data` statement for one column.
fn data(name: &str, index: usize, numbers: &[f64]) -> String {
    let lines: Vec<String> = numbers.chunks(IN_A_LINE).map(|part| row(part, "_dp")).collect();
    format!("    data {name}(:, {index}) / &\n        {} /\n", lines.join(", &\n        "))
}
