"""How much of the sections of scans runs through the air: ``python tools/sections PROGRAM DATA [FILE ...]``.

Cuts every scene under DATA at five heights, and every FILE, and prints the share of the contours' length that lies farther than two
spacings of the place from the points on surfaces: by the scenes' own labels, elsewhere all points but those that the program takes for
clutter. Needs NumPy and SciPy."""

from __future__ import annotations

import argparse
import json
import subprocess
import tempfile
from pathlib import Path

import numpy as np
from scipy.spatial import cKDTree

HEIGHTS = (0.1, 0.3, 0.5, 0.7, 0.9)
FAR = 2.0  # spacings
CLUTTER = 4


def surface(program: str, path: Path, folder: Path) -> np.ndarray:
    """The points of a cloud that lie on surfaces: by its labels, else as the program says."""
    out = folder / "points.npz"
    subprocess.run([program, "clean", path, "-o", out, "--label", "--quiet"], check=True)
    cloud, labels = np.load(out), path.parent / "clutter.u8"
    clutter = np.fromfile(labels, np.uint8) > 0 if labels.exists() else cloud["class"] == CLUTTER
    return cloud["xyz"][~clutter]


def places(strip: dict, step: float) -> np.ndarray:
    """Places along a contour, at most a step apart."""
    row = np.array(strip["points"] + strip["points"][:1] if strip["closed"] else strip["points"], float)
    counts = [max(1, int(np.ceil(np.linalg.norm(b - a) / step))) for a, b in zip(row, row[1:])]
    pieces = [a + (b - a) * (np.arange(n) / n)[:, None] for a, b, n in zip(row, row[1:], counts)]
    return np.concatenate(pieces)


def row(program: str, path: Path, folder: Path) -> str:
    """The row of one cloud."""
    ground = surface(program, path, folder)
    tree = cKDTree(ground)
    spacing = tree.query(ground, 7)[0][:, 1:].mean(axis=1)
    low, high = np.quantile(ground[:, 2], [0.001, 0.999])
    heights = ",".join(f"{low + share * (high - low):.6f}" for share in HEIGHTS)
    cut = folder / "cut.json"
    subprocess.run([program, "section", path, "-o", cut, "--axis", "z", f"--at={heights}", "--quiet"], check=True)
    found = json.loads(cut.read_text())
    step = float(np.median(spacing)) / 2
    along = np.concatenate([places(s, step) for s in found["strips"]] or [np.zeros((0, 3))])
    if not len(along):
        return "no contour |"
    distance, nearest = tree.query(along, 8)
    share = np.mean(distance[:, 0] > FAR * np.median(spacing[nearest], axis=1))
    closed = sum(s["closed"] for s in found["strips"])
    return f"{100 * share:.2f} % | {len(found['strips'])} contours, {closed} closed"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("data", type=Path)
    parser.add_argument("files", type=Path, nargs="*")
    args = parser.parse_args()
    print("| cloud | farther than 2 spacings from the surface | |\n|---|---|---|")
    with tempfile.TemporaryDirectory() as folder:
        for path in [*sorted(args.data.glob("scenes/*/cloud.ply")), *args.files]:
            name = path.parent.name if path.name == "cloud.ply" else path.name
            print(f"| {name} | {row(args.program, path, Path(folder))} |", flush=True)


if __name__ == "__main__":
    main()
