"""Exact and certified numbers against reference digits and other systems."""

import signal
import subprocess
import sys
import textwrap
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


def test_progress_is_told():
    seen = []
    restitution.coefficients("C", 12, digits=20, progress=lambda done, total: seen.append((done, total)))
    assert seen[-1] == (12, 12)


def test_ctrl_c_interrupts():
    code = textwrap.dedent(
        """
        import restitution
        print("ready", flush=True)
        restitution.coefficients("C", 2000, digits=2000)
        """
    )
    work = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    assert work.stdout.readline() == "ready\n"
    time.sleep(0.3)
    work.send_signal(signal.SIGINT)
    _, err = work.communicate(timeout=60)
    assert work.returncode != 0 and "KeyboardInterrupt" in err


def test_help_is_enough():
    public = [getattr(restitution, name) for name in restitution.__all__]
    assert all(item.__doc__ and ">>>" in item.__doc__ or isinstance(item, type) for item in public)
