"""Builds the package with maturin, after the tools that GMP's build needs have been looked for.

GMP is built from source and needs a C compiler, make and m4. In a clone of the project what is missing is installed through
the system's package manager, or the line that `scripts/need` prints says how; a source distribution names what is missing.
"""

import os
import pathlib
import shutil
import subprocess

from maturin import *  # noqa: F401,F403
import maturin

_TOOLS = ("cargo", "cc", "make", "m4")
_NEED = pathlib.Path(__file__).resolve().parents[3] / "scripts" / "need"


def _tools():
    if _NEED.exists():
        if subprocess.run(["sh", str(_NEED), *_TOOLS]).returncode != 0:
            raise SystemExit(1)  # it has said what to do
        os.environ.setdefault("MATURIN_PEP517_ARGS", "--locked")
        return  # in a source distribution the lock file names crates that are not there
    missing = [tool for tool in _TOOLS if shutil.which(tool) is None]
    if missing:
        raise SystemExit(
            f"{', '.join(missing)} is missing: restitution is built with Rust (https://rustup.rs), and GMP, which it links to, "
            "with a C compiler, make and m4; install these with the system's package manager and try again"
        )


def build_wheel(*args, **kwargs):
    _tools()
    return maturin.build_wheel(*args, **kwargs)


def build_editable(*args, **kwargs):
    _tools()
    return maturin.build_editable(*args, **kwargs)
