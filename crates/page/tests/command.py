"""The command that the tests run."""

import os
import pathlib
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[3]
COMMAND = os.environ.get("RESTITUTION", str(ROOT / "target/release/restitution"))


def restitution(*arguments):
    return subprocess.run([COMMAND, *arguments], capture_output=True, text=True, check=True).stdout
