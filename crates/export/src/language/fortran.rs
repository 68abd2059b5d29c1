//! Fortran.

use super::{Language, Rows};

pub(super) static LANGUAGE: Language = Language {
    name: "fortran",
    aliases: &["f90", "f95", "f03", "f08", "for", "f"],
    title: "Fortran 2008, a module",
    file: "NAME.f90",
    comment: "! ",
    rows: Rows {
        before: "    data {what}(:, {i}) / &\n        ",
        between: ", &\n        ",
        after: " /\n",
        suffix: "_dp",
    },
    reserved: &[
        "dp",
        "int64",
        "real64",
        "iso_fortran_env",
        "table",
        "near_zero",
        "check",
        "locate",
        "rise",
        "not_a_number",
    ],
    template: TEMPLATE,
};

const TEMPLATE: &str = r#"{HEAD}
! The module {NAME} has, for numbers and arrays:
!     {NAME}_epsilon(u)                         the coefficient of restitution
!     {NAME}_loss(u)                            1 - epsilon, with all its digits where u is small
!     {NAME}_slope(u)                           d epsilon/d u
!     {NAME}_u_of_velocity(velocity, g_star)    u of the size of a velocity; both in the same unit
!     {NAME}_epsilon_of_velocity(velocity, g_star)
?VELOCITY !     {NAME}_u_at_m_per_s(velocity)             the same for the g* above
?VELOCITY !     {NAME}_epsilon_at_m_per_s(velocity)
! No argument and no compiler flag makes them read beyond their tables. The name of this file may end in .f90 or .F90.
!
! Self-check: echo "use {NAME}; call {NAME}_self_check(); end" > check.f90
!     gfortran {FILE} check.f90 -o check && ./check
!
! Written by: restitution export --lang {LANGUAGE} {OPTIONS}
!     --name {NAME}
module {NAME}
    use, intrinsic :: iso_fortran_env, only: dp => real64, int64
    implicit none
    private
    public :: {NAME}_epsilon, {NAME}_loss
    public :: {NAME}_slope
    public :: {NAME}_u_of_velocity
    public :: {NAME}_epsilon_of_velocity
?VELOCITY     public :: {NAME}_u_at_m_per_s
?VELOCITY     public :: {NAME}_epsilon_at_m_per_s
    public :: {NAME}_self_check

    ! The polynomial of each piece, in the distance to its end as a part of its width, constant first.
    real(dp), save :: table(0:{DEGREE}, 0:{LAST_ROW})
?NEAR     real(dp), parameter :: near_zero(0:{NEAR_LAST}) = [ &
?NEAR         {NEAR}]
    real(dp), save :: check(3, {CHECKS}) ! u, certified epsilon and 1 - epsilon
{TABLE}
{POINTS}

contains

    ! The row of u, the distance to the end of its piece, the exponent of its width, and how many periods of the
    ! law at infinity lie between; row -1 outside the range. Bits decide, which no flag changes.
    elemental subroutine locate(u, row, distance, exponent, periods)
        real(dp), intent(in) :: u
        integer, intent(out) :: row, exponent, periods
        real(dp), intent(out) :: distance
        integer(int64) :: bits
        bits = transfer(u, bits)
        if (shiftl(bits, 1) == 0) bits = 0 ! -0
        row = -1
        distance = 0
        exponent = 0
        periods = 0
        if (bits < {LOW_BITS}_int64 .or. bits > {HIGH_BITS}_int64) return
?LAW         if (bits >= {LAW_BITS}_int64) then
?LAW             periods = int(shiftr(bits - {LAW_BITS}_int64, 52)) / {OCTAVES}
?LAW             bits = bits - shiftl(int(periods * {OCTAVES}, int64), 52)
?LAW             row = int(shiftr(bits, {REST}) - {LAW_FIRST}_int64 + {LAW_ROW}_int64)
?LAW         else
?LAW             bits = transfer(u + {SHIFT}_dp, bits)
?LAW             row = int(shiftr(bits, {REST}) - {FIRST}_int64)
?LAW         end if
!LAW         bits = transfer(u + {SHIFT}_dp, bits)
!LAW         row = int(shiftr(bits, {REST}) - {FIRST}_int64)
        row = max(0, min(row, {LAST_ROW}))
        exponent = int(shiftr(bits, 52)) - {BITS} - 1023
        distance = 1 - real(ibits(bits, 0, {REST}), dp) * scale(1.0_dp, -{REST})
    end subroutine

    elemental function not_a_number() result(value)
        real(dp) :: value
        value = transfer(9221120237041090560_int64, value)
    end function

    ! What epsilon has above its value at the end of the piece.
    elemental function rise(row, distance) result(sum)
        integer, intent(in) :: row
        real(dp), intent(in) :: distance
        real(dp) :: sum
        integer :: k
        sum = 0
        do k = {DEGREE}, 1, -1
            sum = (sum + table(k, row)) * distance
        end do
    end function

    ! Coefficient of restitution at u, a number or an array; NaN outside the range.
    elemental function {NAME}_epsilon(u) result(epsilon)
        real(dp), intent(in) :: u
        real(dp) :: epsilon, distance
        integer :: row, exponent, periods
        call locate(u, row, distance, exponent, periods)
        if (row < 0) then
            epsilon = not_a_number()
            return
        end if
        epsilon = table(0, row) + rise(row, distance)
?LAW         if (periods > 0) epsilon = scale(epsilon, -5 * periods)
    end function

    ! 1 - epsilon at u, a number or an array; NaN outside the range.
    elemental function {NAME}_loss(u) result(loss)
        real(dp), intent(in) :: u
        real(dp) :: loss, distance
?NEAR         real(dp) :: x
        integer :: row, exponent, periods
?NEAR         integer :: k
        call locate(u, row, distance, exponent, periods)
        if (row < 0) then
            loss = not_a_number()
            return
        end if
?NEAR         if (row < {NEAR_ROW}) then
?NEAR !ROOT             x = u
?NEAR ?ROOT             x = sqrt(u)
?NEAR             loss = 0
?NEAR             do k = {NEAR_LAST}, 0, -1
?NEAR                 loss = loss * x + near_zero(k)
?NEAR             end do
?NEAR             loss = u * loss
?NEAR             return
?NEAR         end if
?LAW         if (periods > 0) then
?LAW             loss = 1 - scale(table(0, row) + rise(row, distance), -5 * periods)
?LAW             return
?LAW         end if
        loss = (1 - table(0, row)) - rise(row, distance)
    end function

    ! d epsilon/d u at u, a number or an array; NaN outside the range.
    elemental function {NAME}_slope(u) result(slope)
        real(dp), intent(in) :: u
        real(dp) :: slope, distance
        integer :: k, row, exponent, periods
        call locate(u, row, distance, exponent, periods)
        if (row < 0) then
            slope = not_a_number()
            return
        end if
        slope = 0
        do k = {DEGREE}, 1, -1
            slope = slope * distance + k * table(k, row)
        end do
        slope = -scale(slope, -exponent - {FALL} * periods)
    end function

    ! u of the size of a velocity; g_star is the characteristic velocity, in the same unit.
    elemental function {NAME}_u_of_velocity(velocity, g_star) result(u)
        real(dp), intent(in) :: velocity, g_star
        real(dp) :: u
        u = {U_AT_G_STAR}_dp * (abs(velocity) / g_star)**0.2_dp
    end function

    ! Coefficient of restitution of the size of a velocity.
    elemental function {NAME}_epsilon_of_velocity(velocity, g_star) &
        result(epsilon)
        real(dp), intent(in) :: velocity, g_star
        real(dp) :: epsilon
        epsilon = {NAME}_epsilon( &
            {NAME}_u_of_velocity(velocity, g_star))
    end function
?VELOCITY 
?VELOCITY     ! The same for g* = {G_STAR} m/s; the velocity in m/s.
?VELOCITY     elemental function {NAME}_u_at_m_per_s(velocity) result(u)
?VELOCITY         real(dp), intent(in) :: velocity
?VELOCITY         real(dp) :: u
?VELOCITY         u = {NAME}_u_of_velocity(velocity, {G_STAR}_dp)
?VELOCITY     end function
?VELOCITY 
?VELOCITY     elemental function {NAME}_epsilon_at_m_per_s(velocity) result(epsilon)
?VELOCITY         real(dp), intent(in) :: velocity
?VELOCITY         real(dp) :: epsilon
?VELOCITY         epsilon = {NAME}_epsilon_of_velocity( &
?VELOCITY             velocity, {G_STAR}_dp)
?VELOCITY     end function

    ! Stops with an error if certified values are not met.
    subroutine {NAME}_self_check()
        real(dp) :: worst, worst_loss
        worst = maxval(abs({NAME}_epsilon(check(1, :)) / check(2, :) - 1))
        worst_loss = maxval(abs({NAME}_loss(check(1, :)) - check(3, :)) &
            / merge(check(3, :), 1.0_dp, check(3, :) > 0))
        print '(4(a, es9.2))', 'largest relative errors ', worst, ' of ', {TOLERANCE}_dp, ', ', &
            worst_loss, ' of ', {LOSS_BOUND}_dp
        if (.not. (worst <= {TOLERANCE}_dp .and. worst_loss <= {LOSS_BOUND}_dp)) error stop 1
    end subroutine
end module
"#;
