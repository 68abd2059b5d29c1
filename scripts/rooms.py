#!/usr/bin/env python3
"""Draws the rooms of the house as cargo sees them: `make rooms` puts the picture into docs/architecture.md.

A floor is one above the highest crate it stands on. An arrow that others imply is left out; of the command every dependency is
written out below, its own and others'. `--check` only compares.
"""

import json
import os
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs/architecture.md"
START, END = "<!-- rooms: made by scripts/rooms.py -->\n", "<!-- end of rooms -->\n"


def dependencies():
    """Each crate, by its folder, with what it depends on outside of tests, by name."""
    cargo = [os.environ.get("CARGO", "cargo"), "metadata", "--no-deps", "--offline", "--format-version=1"]
    packages = json.loads(subprocess.run(cargo, cwd=ROOT, check=True, capture_output=True).stdout)["packages"]
    folder = {package["name"]: pathlib.Path(package["manifest_path"]).parent for package in packages}
    rooms = {name: path.name for name, path in folder.items() if path.parent.name == "crates"}
    return {
        rooms[package["name"]]: {
            rooms.get(needed["name"], needed["name"]): needed["name"] in rooms
            for needed in package["dependencies"]
            if needed["kind"] is None
        }
        for package in packages
        if package["name"] in rooms
    }


def rooms(dependencies):
    """Each crate with the crates of the workspace that it depends on."""
    return {room: {name for name, ours in needed.items() if ours} for room, needed in dependencies.items()}


def floor(room, needed, above=()):
    if room in above:
        raise SystemExit(f"the crates {' -> '.join((*above, room))} depend on each other in a circle")
    return max((floor(below, needed, (*above, room)) + 1 for below in needed[room]), default=0)


def reach(room, needed):
    """All that a room stands on, directly or not."""
    return needed[room].union(*(reach(below, needed) for below in needed[room])) if needed[room] else set()


def picture():
    all_needed = dependencies()
    needed = rooms(all_needed)
    floors = {room: floor(room, needed) for room in needed}
    width = max(map(len, needed))
    lines = []
    for level in sorted(set(floors.values()), reverse=True):
        for room in sorted(room for room in needed if floors[room] == level):
            direct = needed[room]
            shown = sorted(below for below in direct if not any(below in reach(other, needed) for other in direct))
            arrow = f"─► {'  '.join(shown)}" if shown else ""
            lines.append(f"    {level}  {room:{width}}  {arrow}".rstrip())
    return "\n".join(lines) + "\n\n" + command(all_needed["cli"])


def command(needed):
    """What the command depends on directly."""
    ours, others = sorted(name for name in needed if needed[name]), sorted(name for name in needed if not needed[name])
    head = "What `cargo tree -p restitution-cli --depth 1 -e normal` lists, the libraries of the project without `restitution-`:\n\n"
    return f"{head}    libraries  {'  '.join(ours)}\n    others     {'  '.join(others)}\n"


def main():
    page = PAGE.read_text(encoding="utf-8")
    before, rest = page.split(START)
    old, after = rest.split(END)
    new = f"\n{picture()}\n"
    if "--check" in sys.argv[1:]:
        if old != new:
            raise SystemExit("the picture of the rooms in docs/architecture.md is not that of the code: run 'make rooms'")
    elif old != new:
        PAGE.write_text(before + START + new + END + after, encoding="utf-8")


if __name__ == "__main__":
    main()
