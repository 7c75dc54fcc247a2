"""Whether the confidence of a line means what it says: ``python tools/reliability PROGRAM DATA [-o PLOT.png]``.

Extracts the lines of every cloud with a truth under DATA (``cad``, ``brep`` and ``scenes``) and sorts them into bins of confidence. A
line is right if four fifths of its length lie within 1.5 spacings of a true edge, sharp or weak; in scenes the spacing is that of the
place, and borders are left out, as their truth has none. Each bin shows the mean confidence of its lines, the share of them that is
right, the 95 % interval of that share (Wilson) and the share of their length near true edges. Needs NumPy and SciPy, the plot
Matplotlib."""

from __future__ import annotations

import argparse
import json
import subprocess
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import numpy as np
from scipy.spatial import cKDTree

BINS = (0.0, 0.3, 0.5, 0.7, 0.8, 0.9, 0.95, 0.99, 1.0)
NEAR = 1.5  # spacings
RIGHT = 0.8  # of the length


class Line(NamedTuple):
    """A line that was found."""

    group: str
    kind: str
    length: float
    confidence: float
    near: float


class Bin(NamedTuple):
    """Lines of about the same confidence."""

    count: int
    confidence: float
    right: float
    interval: tuple[float, float]
    near: float


def dense(points: np.ndarray, step: float) -> np.ndarray:
    """Places along a polyline, at most a step apart."""
    pieces = [points[:1]]
    for a, b in zip(points, points[1:]):
        count = max(1, int(np.ceil(np.linalg.norm(b - a) / step)))
        pieces.append(a + (b - a) * (np.arange(1, count + 1) / count)[:, None])
    return np.concatenate(pieces)


def vertices(program: str, path: Path) -> np.ndarray:
    """The points of a cloud, as the program reads them."""
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "points.npz"
        subprocess.run([program, "clean", path, "-o", out, "--label", "--quiet"], check=True)
        return np.load(out)["xyz"]


def reach(program: str, folder: Path, spacing: float, scene: bool):
    """The distance within which a place is near an edge, as a function of places."""
    if not scene:
        return lambda places: np.full(len(places), NEAR * spacing)
    points = vertices(program, folder / "cloud.ply")
    tree = cKDTree(points)
    own = tree.query(points, 7)[0][:, 1:].mean(axis=1)
    return lambda places: NEAR * np.median(own[tree.query(places, 8)[1]], axis=1)


def lines(program: str, folder: Path) -> Iterator[Line]:
    """The lines found in one cloud."""
    truth = json.loads((folder / "truth.json").read_text())
    spacing, scene = truth["spacing"], folder.parent.name == "scenes"
    edges = [dense(np.array(e["points"], float), spacing / 3) for e in truth["polylines"] if len(e["points"]) > 1]
    tree = cKDTree(np.concatenate(edges) if edges else np.full((1, 3), 1e30))
    near = reach(program, folder, spacing, scene)
    with tempfile.TemporaryDirectory() as out:
        found = Path(out) / "lines.json"
        subprocess.run([program, "extract", folder / "cloud.ply", "-o", found, "--quiet"], check=True)
        strips = json.loads(found.read_text())["strips"]
    for strip in strips:
        if scene and strip["kind"] == "border":
            continue
        points = np.array(strip["points"] + strip["points"][:1] if strip["closed"] else strip["points"], float)
        places = dense(points, spacing / 3)
        share = np.mean(tree.query(places)[0] <= near(places))
        yield Line(folder.parent.name, strip["kind"], strip["length"] / spacing, strip["confidence"], float(share))


def binned(found: list[Line]) -> list[Bin]:
    """The bins that hold lines."""
    place = np.clip(np.searchsorted(BINS, [line.confidence for line in found], side="right"), 1, len(BINS) - 1)
    bins = []
    for k in range(1, len(BINS)):
        own = [line for line, p in zip(found, place) if p == k]
        if own:
            length = np.array([line.length for line in own])
            right = float(np.mean([line.near >= RIGHT for line in own]))
            near = float((length * [line.near for line in own]).sum() / length.sum())
            mean = float(np.mean([line.confidence for line in own]))
            bins.append(Bin(len(own), mean, right, wilson(right, len(own)), near))
    return bins


def wilson(share: float, count: int, z: float = 1.96) -> tuple[float, float]:
    """The interval that holds the true share with a probability of 95 %."""
    middle = (share + z * z / (2 * count)) / (1 + z * z / count)
    half = z / (1 + z * z / count) * np.sqrt(share * (1 - share) / count + (z / (2 * count)) ** 2)
    return max(0.0, middle - half), min(1.0, middle + half)


def plot(groups: dict[str, list[Bin]], path: Path) -> None:
    """Draws the share that is right over the confidence."""
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(figsize=(6, 5))
    axes.plot([0, 1], [0, 1], color="0.7", lw=1)
    for name, bins in groups.items():
        x, y = [b.confidence for b in bins], np.array([b.right for b in bins])
        error = np.array([b.interval for b in bins]).T
        bars = np.abs(np.stack([y - error[0], error[1] - y]))
        axes.errorbar(x, y, bars, marker="o", ms=4, lw=1, capsize=2, label=f"{name} ({sum(b.count for b in bins):,} lines)")
    axes.set(xlabel="confidence", ylabel="share of lines that are right", xlim=(0, 1.02), ylim=(0, 1.02))
    axes.legend(loc="lower right", frameon=False)
    figure.tight_layout()
    figure.savefig(path, dpi=110)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("data", type=Path)
    parser.add_argument("-o", "--output", type=Path)
    args = parser.parse_args()
    folders = sorted(t.parent for name in ("cad", "brep", "scenes") for t in (args.data / name).glob("*/truth.json"))
    found = [line for folder in folders for line in lines(args.program, folder)]
    creases = [line for line in found if line.kind == "crease"]
    chosen = {"all creases": creases}
    chosen |= {name: [line for line in creases if line.group == name] for name in ("cad", "brep", "scenes")}
    chosen["borders"] = [line for line in found if line.kind == "border"]
    groups = {name: binned(own) for name, own in chosen.items() if own}
    for name, bins in groups.items():
        print(f"\n| {name} | confidence | right | 95 % | of the length |\n|---|---|---|---|---|")
        for b in bins:
            print(f"| {b.count} | {b.confidence:.2f} | {b.right:.2f} | {b.interval[0]:.2f} to {b.interval[1]:.2f} | {b.near:.2f} |")
    if args.output:
        plot(groups, args.output)


if __name__ == "__main__":
    main()
