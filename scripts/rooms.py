#!/usr/bin/env python3
"""Draws the rooms of the house from the crates' manifests: `make rooms` puts the picture into docs/architecture.md.

A floor is one above the highest crate it stands on. An arrow that others imply is left out. `--check` only compares.
"""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs/architecture.md"
START, END = "<!-- rooms: made by scripts/rooms.py -->\n", "<!-- end of rooms -->\n"


def rooms():
    """Each crate, by its folder, with the crates of the workspace that it depends on."""
    manifests = {path.parent.name: path.read_text(encoding="utf-8") for path in ROOT.glob("crates/*/Cargo.toml")}
    names = {re.search(r'^name = "(.*)"', text, re.M)[1]: folder for folder, text in manifests.items()}
    needed = {}
    for folder, text in manifests.items():
        section = re.search(r"^\[dependencies\]\n(.*?)(?=^\[|\Z)", text, re.M | re.S)
        found = re.findall(r"^([\w-]+)[ .=]", section[1] if section else "", re.M)
        needed[folder] = {names[name] for name in found if name in names}
    return needed


def floor(room, needed, above=()):
    if room in above:
        raise SystemExit(f"the crates {' -> '.join((*above, room))} depend on each other in a circle")
    return max((floor(below, needed, (*above, room)) + 1 for below in needed[room]), default=0)


def reach(room, needed):
    """All that a room stands on, directly or not."""
    return needed[room].union(*(reach(below, needed) for below in needed[room])) if needed[room] else set()


def picture():
    needed = rooms()
    floors = {room: floor(room, needed) for room in needed}
    width = max(map(len, needed))
    lines = []
    for level in sorted(set(floors.values()), reverse=True):
        for room in sorted(room for room in needed if floors[room] == level):
            direct = needed[room]
            shown = sorted(below for below in direct if not any(below in reach(other, needed) for other in direct))
            arrow = f"─► {'  '.join(shown)}" if shown else ""
            lines.append(f"    {level}  {room:{width}}  {arrow}".rstrip())
    return "\n".join(lines) + "\n"


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
