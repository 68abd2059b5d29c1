"""The package gives the numbers of the Rust crate, bit by bit."""

import pathlib
import random
import shutil
import struct
import subprocess

import numpy as np
import pytest
import restitution

ROOT = pathlib.Path(__file__).resolve().parents[3]
ENDS = ("zero-compression", "zero-force")


def arguments():
    """Random bit patterns, plain values, pieces' edges, and what is special."""
    generator = random.Random(1999)
    patterns = (struct.unpack("<d", generator.randbytes(8))[0] for _ in range(2000))
    plain = [generator.uniform(0, 8) for _ in range(2000)] + [10 ** generator.uniform(-12, 4) for _ in range(2000)]
    edges = [k / 64 for k in range(1, 64 * 16)]
    edges += [np.nextafter(edge, to) for edge in edges for to in (0.0, np.inf)]
    special = [0.0, -0.0, 5e-324, -5e-324, np.inf, -np.inf, np.nan, 1.0, 1.7976931348623157e308]
    return np.array([*patterns, *plain, *edges, *special])


@pytest.fixture(scope="module")
def rust():
    if shutil.which("cargo") is None:
        pytest.skip("cargo is not on the path, and only it can run the Rust side")
    command = ["cargo", "run", "--release", "--quiet", "--locked", "--package", "restitution", "--example", "what_is_epsilon"]
    words = "\n".join(repr(float(u)) for u in arguments())
    out = subprocess.run(command, cwd=ROOT, input=words, capture_output=True, text=True, check=True).stdout
    return np.array([[float(word) for word in line.split()] for line in out.splitlines()])


def same(one, other):
    return np.array_equal(one.view(np.uint64)[~np.isnan(one)], other.view(np.uint64)[~np.isnan(one)]) and np.array_equal(
        np.isnan(one), np.isnan(other)
    )


@pytest.mark.parametrize("column, end", [(1, "zero-compression"), (3, "zero-force")])
def test_epsilon_and_loss_have_the_bits_of_the_crate(rust, column, end):
    u = arguments()
    single = np.array([restitution.epsilon(float(x), end) for x in u])
    assert same(restitution.epsilon(u, end), single)
    assert same(np.array([restitution.loss(float(x), end) for x in u]), restitution.loss(u, end))
    assert same(single, np.ascontiguousarray(rust[:, column]))
    assert same(restitution.loss(u, end), np.ascontiguousarray(rust[:, column + 1]))


@pytest.mark.parametrize("end", ENDS)
def test_the_inverse_leads_back(end):
    epsilon = np.linspace(0.001, 0.999, 1001)
    back = restitution.epsilon(restitution.u_of_epsilon(epsilon, end), end)
    # |d ln eps/d ln u| <= 5 times the error of the inverse, and the rounding of eps itself
    assert np.max(np.abs(back / epsilon - 1)) < 5 * 2e-15


def test_mpmath_agrees_where_it_integrates_the_energy_form():
    """de/dq = -b sqrt(e - q^(5/3)) from the turning point, both signs of the damping (section 5 of the theory)."""
    import mpmath

    mpmath.mp.dps = 25
    for kappa in (0.05, 0.4):

        def energy(b):
            # q = 1 - t^2 takes the square root out of the turning point
            def slope(t, e):
                q = 1 - t * t
                return [2 * t * b * mpmath.sqrt(abs(e[0] - q ** (mpmath.mpf(5) / 3)))]

            start = mpmath.mpf("0.001")
            series = 1 + b * 2 / mpmath.mpf(3) * start**3 * mpmath.sqrt(mpmath.mpf(5) / 3)
            return mpmath.odefun(slope, start, [series], tol=mpmath.mpf(10) ** -14)(1)[0]

        b = 2 * mpmath.sqrt(5) / 3 * kappa
        after, before = energy(-b), energy(b)
        velocity = mpmath.sqrt(mpmath.mpf(4) / 5 * before)
        u = kappa * velocity ** (mpmath.mpf(1) / 5)
        epsilon = mpmath.sqrt(after / before)
        assert abs(restitution.epsilon(float(u)) / epsilon - 1) < 1e-5
