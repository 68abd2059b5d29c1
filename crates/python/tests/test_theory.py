"""Exact and certified numbers against reference digits and other systems."""

import signal
import subprocess
import sys
import time
from decimal import Decimal
from fractions import Fraction

import pytest
import restitution

REFERENCE_C = {
    1: "-1.15344885809528879913056743910",
    2: "0.798266560944795406250261259769",
    3: "-0.522882568088414963898491512417",
    12: "0.0157091956824846352484791691006",
}


def test_coefficients_are_the_reference_digits():
    found = restitution.coefficients("C", 12, digits=28)
    for k, text in REFERENCE_C.items():
        assert abs(found[k].decimal - Decimal(text)) <= Decimal(found[k].radius) + Decimal("1e-29")


def test_time_reversal_fixes_the_even_coefficients():
    a = restitution.coefficients("a", 4, digits=40)
    low, high = (Fraction(7, 5) * end - Fraction(7, 25) for end in a[3].interval)
    assert low <= a[4].interval[1] and a[4].interval[0] <= high


def test_closed_form_laws():
    """The linear dashpot: eps = exp(-pi zeta/sqrt(1 - zeta^2)), zeta = u/2."""
    import mpmath

    mpmath.mp.dps = 50
    digits = restitution.epsilon_digits("1/2", 40, law=(1, 0))
    zeta = mpmath.mpf(1) / 4
    expected = mpmath.exp(-mpmath.pi * zeta / mpmath.sqrt(1 - zeta**2))
    assert abs(digits.mpmath() - expected) < mpmath.mpf(10) ** -40


def test_a_float_is_the_binary_number_that_it_is():
    assert restitution.epsilon_digits(0.1, 30) != restitution.epsilon_digits("0.1", 30)
    assert restitution.epsilon_digits(0.5, 30) == restitution.epsilon_digits("1/2", 30) == restitution.epsilon_digits(Fraction(1, 2), 30)


def test_trajectories_are_the_papers_but_for_its_misprint():
    x = restitution.trajectory(1, 10)
    assert x[0][:3] == [(1, 1), (Fraction(7, 2), Fraction(-4, 35)), (6, Fraction(1, 175))]
    assert x[1][-1] == (10, Fraction(61216, 426391875))


def test_psi():
    assert restitution.coefficients("psi", 4)[3:] == [Fraction(4897, 160875), Fraction(453263, 40540500)]


def test_conversions():
    mpmath = pytest.importorskip("mpmath")
    c = restitution.coefficients("C", 3, digits=50)[3]
    assert float(c) == -0.5228825680884149
    with mpmath.workdps(60):
        assert abs(c.mpmath() - mpmath.mpf(c.value)) < mpmath.mpf(10) ** -55
        interval = c.mpi()
        assert interval.a <= c.mpmath() <= interval.b
    assert str(c) in c._repr_latex_() and c.contains(c.value) and not c.contains(0)
    assert c._bits() > 166


def test_arb_holds_the_enclosure():
    flint = pytest.importorskip("flint")
    c = restitution.coefficients("C", 3, digits=50)[3]
    flint.ctx.prec = 300
    low, high = c.interval
    ball = c.arb()
    for bound in (low, high):
        assert ball.contains(flint.arb(flint.fmpq(bound.numerator, bound.denominator)).mid())


@pytest.mark.parametrize(
    "call",
    [
        lambda: restitution.coefficients("q", 3),
        lambda: restitution.coefficients("C", -1),
        lambda: restitution.coefficients("C", 3, digits=0),
        lambda: restitution.coefficients("C", 3, law=(1, 2, 3)),
        lambda: restitution.coefficients("C", 3, law=(0, 0)),
        lambda: restitution.coefficients("C", 3, law="x"),
        lambda: restitution.coefficients("h", 3, law=(1, 1)),
        lambda: restitution.trajectory(-1, 3),
        lambda: restitution.trajectory(1, "x"),
        lambda: restitution.epsilon_digits("-1"),
        lambda: restitution.epsilon_digits("nan"),
        lambda: restitution.epsilon_digits(float("inf")),
        lambda: restitution.epsilon_digits("3", law=(1, 0)),
        lambda: restitution.epsilon_digits("1", end="never"),
        lambda: restitution.Restitution.from_g_star("0.32 parsec/s"),
        lambda: restitution.Restitution.from_g_star(float("nan")),
        lambda: restitution.fit([1, 2, 3], [0.5, 0.4]),
        lambda: restitution.fit([1, -2], [0.5, 0.4]),
        lambda: restitution.fit([1, 2], [50, 40]),
    ],
)
def test_wrong_requests_are_one_sentence(call):
    with pytest.raises((ValueError, OverflowError)) as error:
        call()
    assert str(error.value) and "\n" not in str(error.value)


@pytest.mark.parametrize(
    "work",
    [
        lambda watch: restitution.coefficients("C", 12, digits=20, progress=watch),
        lambda watch: restitution.pade(6, 6, progress=watch),
        lambda watch: restitution.trajectory(3, 40, progress=watch),
    ],
)
def test_progress_is_told(work):
    seen = []
    work(lambda done, total: seen.append((done, total)))
    assert seen == sorted(seen) and seen[-1][0] == seen[-1][1] > 0


class Enough(Exception):
    pass


def test_where_steps_cannot_be_counted_seconds_are_told_and_an_error_ends_the_work():
    """A second of work at least, on any machine: the digits grow until it takes one."""

    def refuse(done, total):
        raise Enough(done, total)

    digits = 50_000
    with pytest.raises(Enough) as told:
        while True:
            restitution.closed_form("a", 4, digits=digits, progress=refuse)
            digits *= 3
    assert told.value.args == (1, None)


def test_progress_is_one_line_of_stderr(capsys):
    restitution.coefficients("C", 120, digits=100, progress=True)
    shown = capsys.readouterr().err
    assert shown.startswith("\r") and shown.endswith("120/120\n")


@pytest.mark.parametrize(
    "work",
    [
        'restitution.coefficients("C", 2000, digits=2000)',
        'restitution.pade(500, 500, digits=2000)',
        'restitution.trajectory(200, 5000)',
        'restitution.closed_form("a", 4, digits=30_000_000)',
        'restitution.epsilon_digits("1/3", 2000)',
        'restitution.coefficients("psi", 3000)',
        'restitution.saturation(2000)',
    ],
)
def test_ctrl_c_interrupts(work):
    # A process that was started in the background ignores SIGINT, and so would its children.
    heed = "import signal\nsignal.signal(signal.SIGINT, signal.default_int_handler)"
    code = f"{heed}\nimport restitution\nprint('ready', flush=True)\n{work}\nprint('done', flush=True)"
    with subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as child:
        try:
            assert child.stdout.readline() == "ready\n"
            time.sleep(0.3)
            child.send_signal(signal.SIGINT)
            out, err = child.communicate(timeout=60)
        finally:
            child.kill()
    assert child.returncode != 0 and "KeyboardInterrupt" in err and "done" not in out


def test_latex_is_what_a_notebook_can_show():
    small = restitution.Certified("-1.5e-12", "1e-14")
    assert small._repr_latex_() == "$-1.5\\cdot 10^{-12}$"
    shown = restitution.pade(1, 1, digits=4)._repr_latex_()
    assert shown == "$\\frac{1.000 - 0.4614 u}{1.000 + 0.6921 u}$"
    assert "e-" not in restitution.pade(1, 4, digits=4)._repr_latex_()
    assert restitution.closed_form("a", 3)._repr_latex_().startswith("$\\frac{7}{25} + ")


def test_sympy_has_the_digits_that_are_proved():
    sympy = pytest.importorskip("sympy")
    quotient = restitution.pade(2, 3, digits=30)
    expression = quotient.sympy()
    (u,) = expression.free_symbols
    assert abs(float(expression.subs(u, 1)) - quotient(1.0)) < 1e-15
    constants = expression.atoms(sympy.Float)
    assert {round(c._prec / 3.3219) for c in constants} == {31}
    assert quotient.sympy(sympy.Symbol("x")).free_symbols == {sympy.Symbol("x")}


def test_help_is_enough():
    public = [getattr(restitution, name) for name in restitution.__all__]
    assert all(item.__doc__ and ">>>" in item.__doc__ or isinstance(item, type) for item in public)
