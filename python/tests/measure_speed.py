"""CPU time and memory of ``extract`` from Python beside those of the program, in turn, on a million points: ``measure_speed.py PROGRAM
[ROUNDS]``. Both are to be of the profile ``release``."""

from __future__ import annotations

import os
import sys
import tempfile
from pathlib import Path

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]

ALONE = "import sys, numpy as np, lineament; np.load(sys.argv[1])"
EXTRACT = "import sys, numpy as np, lineament; lineament.extract(np.load(sys.argv[1])).write(sys.argv[2])"


def block(count: int) -> Array:
    """Points on a cube of edge 2 with a bore through it, with noise of a quarter of their spacing, in random order."""
    rng = np.random.default_rng(1)
    u, v = 2.0 * rng.random((2, 2 * count))
    side = rng.integers(0, 8, 2 * count)
    around = np.pi * u
    wall = np.column_stack([1.0 + 0.4 * np.cos(around), 1.0 + 0.4 * np.sin(around), v])
    points = np.where((side >= 6)[:, None], wall, 0.0)
    for face in range(6):
        axis, level = face // 2, 2.0 * (face % 2)
        points[side == face] = np.insert(np.column_stack([u, v])[side == face], axis, level, axis=1)
    in_bore = (side == 4) | (side == 5)
    kept = points[~(in_bore & (np.hypot(points[:, 0] - 1.0, points[:, 1] - 1.0) < 0.4))][:count]
    spacing = np.sqrt(29.0 / count)
    return np.ascontiguousarray(kept + rng.normal(0.0, 0.25 * spacing, kept.shape))


def run(*command: str) -> tuple[float, float]:
    """Seconds of the processor, and greatest memory in MiB."""
    _, status, usage = os.wait4(os.posix_spawn(command[0], command, os.environ), 0)
    if status != 0:
        raise SystemExit(f"{command[0]} failed")
    return usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def main(program: str, rounds: int) -> None:
    with tempfile.TemporaryDirectory() as folder:
        cloud, lines = str(Path(folder) / "cloud.npy"), str(Path(folder) / "lines.json")
        # Of a process that has held much memory, children are said to have held as much.
        run(sys.executable, __file__, "--cloud", cloud)
        for _ in range(rounds):
            theirs, their_memory = run(program, "extract", "--quiet", cloud, "-o", lines)
            ours, our_memory = run(sys.executable, "-c", EXTRACT, cloud, lines)
            alone, alone_memory = run(sys.executable, "-c", ALONE, cloud)
            print(f"program {theirs:.2f} s, {their_memory:.0f} MiB; Python {ours:.2f} s, {our_memory:.0f} MiB, of which")
            print(f"interpreter, NumPy and array {alone:.2f} s, {alone_memory:.0f} MiB; ratio {ours / theirs:.3f}")


if __name__ == "__main__":
    if sys.argv[1] == "--cloud":
        np.save(sys.argv[2], block(1_000_000))
    else:
        main(sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 3)
