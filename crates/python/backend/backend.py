"""Builds the package with maturin, after the tools that GMP's build needs have been looked for.

GMP is built from source and needs a C compiler, make and m4; what is missing is installed through the
system's package manager, or the line that `scripts/need` prints says how.
"""

import pathlib
import subprocess

from maturin import *  # noqa: F401,F403
import maturin

_NEED = pathlib.Path(__file__).resolve().parents[3] / "scripts" / "need"


def _tools():
    if _NEED.exists():
        subprocess.run(["sh", str(_NEED), "cargo", "cc", "make", "m4"], check=True)


def build_wheel(*args, **kwargs):
    _tools()
    return maturin.build_wheel(*args, **kwargs)


def build_editable(*args, **kwargs):
    _tools()
    return maturin.build_editable(*args, **kwargs)
