"""What `restitution closed-form` prints for other programs runs there: in mpmath, in sympy, and in LaTeX if it is installed."""

import os
import shutil
import subprocess
import sys
from decimal import Decimal
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
COMMAND = os.environ.get("RESTITUTION", str(ROOT / "target/release/restitution"))
REQUESTS = [("a", 3, 30), ("a", 6, 40), ("C", 4, 50), ("C", 7, 20), ("h", 12, 25)]


def restitution(*words):
    return subprocess.run([COMMAND, *map(str, words)], capture_output=True, text=True, check=True).stdout


def coefficient(quantity, order, digits, law):
    """The value of `table` and its radius."""
    rows = restitution("table", "--quantity", quantity, "--order", order, "--digits", digits, "--law", law, "--format", "csv")
    k, value, radius = rows.splitlines()[-1].split(",")
    assert int(k) == order
    return Decimal(value), Decimal(radius)


@pytest.mark.parametrize("form", ["python", "sympy"])
@pytest.mark.parametrize("law", ["3/2,1/2", "5/2,3/4"])
@pytest.mark.parametrize(("quantity", "order", "digits"), REQUESTS)
def test_programs_give_the_digits_of_table(quantity, order, digits, law, form, tmp_path):
    request = ("closed-form", "--quantity", quantity, "--order", order, "--digits", digits, "--law", law)
    program = tmp_path / "form.py"
    program.write_text(restitution(*request, "--format", form))
    printed = subprocess.run([sys.executable, program], capture_output=True, text=True, check=True).stdout
    value, radius = coefficient(quantity, order, digits, law)
    last = Decimal(1).scaleb(value.adjusted() - digits + 1)
    assert abs(Decimal(printed.strip()) - value) <= last + radius, (printed, value)


@pytest.mark.skipif(shutil.which("pdflatex") is None, reason="pdflatex is not installed: make test-latex installs it")
@pytest.mark.parametrize(("quantity", "order", "digits"), [*REQUESTS, ("a", 12, 20), ("C", 2, 1000)])
def test_latex_compiles(quantity, order, digits, tmp_path):
    form = restitution("closed-form", "--quantity", quantity, "--order", order, "--digits", digits, "--format", "latex")
    (tmp_path / "form.tex").write_text(f"\\documentclass{{article}}\n\\begin{{document}}\n{form}\\end{{document}}\n")
    done = subprocess.run(
        ["pdflatex", "-interaction=nonstopmode", "-halt-on-error", "form.tex"], cwd=tmp_path, capture_output=True, text=True
    )
    assert done.returncode == 0, done.stdout[-2000:]
    assert (tmp_path / "form.pdf").exists()
