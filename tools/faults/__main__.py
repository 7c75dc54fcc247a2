"""Reruns what new users stumbled over and what broke under attack, and prints each row as it was found, as it is now, and whether that
is right: ``python tools/faults PROGRAM DATA [PART ...]``.

DATA is the folder of the evaluation data, with ``reports``, ``attack`` and ``models``; parts are ``reports``, ``attack``, ``points``,
``without``, ``systems`` and ``meshes``, all without any. Needs NumPy, SciPy and Matplotlib; ``systems`` also fiona, pyproj, laspy (with
lazrs) and pye57, ``points`` laspy and pyproj, ``meshes`` trimesh. The exit code is 1 if a row is not right."""

from __future__ import annotations

import importlib
import sys
import tempfile
from pathlib import Path

from run import Program

PARTS = ("reports", "attack", "points", "without", "systems", "meshes")


def main(path: str, data: str, parts: list[str]) -> int:
    wrong = 0
    with tempfile.TemporaryDirectory() as folder:
        program = Program(path, Path(data).resolve(strict=True), Path(folder))
        print("| input | found first | now | right |\n|---|---|---|---|")
        for part in parts or PARTS:
            for name, first, now, right in importlib.import_module(part).rows(program):
                wrong += not right
                print(f"| {name} | {first} | {now.replace('|', '/')} | {'yes' if right else '**no**'} |", flush=True)
    print(f"\n{wrong} rows are not right", file=sys.stderr)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2], sys.argv[3:]))
