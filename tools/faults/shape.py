"""Measures of lines and sections that the right values are stated in."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt
from scipy.spatial import cKDTree

Points = npt.NDArray[np.float64]


def dense(line: Any, step: float, closed: bool = False) -> Points:
    """Points along a line, at most `step` apart, its vertices among them."""
    corners = np.asarray(line, float)
    if closed:
        corners = np.vstack([corners, corners[:1]])
    parts = [corners[:1]]
    for a, b in zip(corners[:-1], corners[1:]):
        count = max(1, int(np.ceil(np.linalg.norm(b - a) / step)))
        parts.append(a + (b - a) * (np.arange(1, count + 1) / count)[:, None])
    return np.vstack(parts)


def lines_of(network: Any, step: float, kind: str = "") -> Points:
    """Points along the strips of a network, of one kind or of all."""
    strips = [s for s in network["strips"] if kind in ("", s["kind"]) and len(s["points"]) > 1]
    return np.vstack([np.zeros((0, 3)), *(dense(s["points"], step, s["closed"]) for s in strips)])


def shares(found: Points, truth: Points, tolerance: float) -> tuple[float, float]:
    """Share of what was found that is true, and of the truth that was found, within a tolerance."""
    if not len(found) or not len(truth):
        return 0.0, 0.0
    near = cKDTree(truth).query(found)[0] <= tolerance
    met = cKDTree(found).query(truth)[0] <= tolerance
    return float(near.mean()), float(met.mean())


def f1(found: Points, truth: Points, tolerance: float) -> float:
    """Harmonic mean of both shares."""
    p, r = shares(found, truth, tolerance)
    return 2 * p * r / (p + r) if p + r else 0.0


def circle(centre: tuple[float, float, float], radius: float, count: int = 720) -> Points:
    """Points on a level circle."""
    angle = np.linspace(0, 2 * np.pi, count, endpoint=False)
    return np.asarray(centre) + radius * np.column_stack([np.cos(angle), np.sin(angle), 0 * angle])


def counts(network: Any) -> str:
    """Creases, borders, junctions and ends of a network in words."""
    if network is None:
        return "nothing"
    c, b, j, e = tally(network)
    return f"{c} creases, {b} borders, {j} junctions, {e} ends"


def tally(network: Any) -> tuple[int, int, int, int]:
    """Numbers of creases, borders, junctions and ends."""
    kinds = [s["kind"] for s in network["strips"]]
    nodes = [n["kind"] for n in network["nodes"]]
    return kinds.count("crease"), kinds.count("border"), nodes.count("junction"), nodes.count("end")


def kinds(section: Any) -> list[list[str]]:
    """The kinds of pieces of each slice."""
    planes = [p["plane"] for p in section["planes"]]
    return [[q["type"] for s in section["strips"] if s["plane"] == p for q in s["pieces"]] for p in planes]
