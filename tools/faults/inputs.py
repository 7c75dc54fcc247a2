"""Small inputs of our own: sheets, a box as a mesh, scans in LAS."""

from __future__ import annotations

import struct
from pathlib import Path

import numpy as np
import numpy.typing as npt

Points = npt.NDArray[np.float64]


def roof(count: int = 3000, seed: int = 1) -> Points:
    """A gabled roof of 10 by 10 whose ridge lies at x 5 and z 5 and whose eaves at z 0."""
    u, v = 10 * np.random.default_rng(seed).random((2, count))
    return np.column_stack([u, v, 5 - np.abs(u - 5)])


def room(seed: int = 1) -> Points:
    """A floor at z 2 with a box of 4 by 3 by 2 on it, standing at x 3 and y 3."""
    rng = np.random.default_rng(seed)
    u, v = rng.random((2, 12000))
    floor = np.column_stack([10 * u, 10 * v, 2 + 0 * u])
    inside = (floor[:, 0] > 3) & (floor[:, 0] < 7) & (floor[:, 1] > 3) & (floor[:, 1] < 6)
    top = floor + [0, 0, 2]
    walls = []
    for axis, level, long in ((0, 3.0, 3.0), (0, 7.0, 3.0), (1, 3.0, 4.0), (1, 6.0, 4.0)):
        s, t = rng.random((2, int(120 * long * 2)))
        wall = np.column_stack([3 + long * s, 2 + 2 * t])
        walls.append(np.insert(wall, axis, level, axis=1))
    return np.vstack([floor[~inside], top[inside], *walls])


def box_faces(size: Points) -> tuple[Points, npt.NDArray[np.int64]]:
    """Corners and triangles of a box."""
    corners = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float) * size
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    return corners, np.array([t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))])


def write_stl(path: Path, corners: Points, faces: npt.NDArray[np.int64]) -> None:
    """Binary STL."""
    with open(path, "wb") as file:
        file.write(b"box".ljust(80) + struct.pack("<I", len(faces)))
        for face in faces:
            file.write(struct.pack("<12fH", 0, 0, 0, *corners[face].ravel(), 0))


def write_xyz(path: Path, points: Points) -> None:
    """A table of three columns."""
    np.savetxt(path, points, "%.6f")


def write_las(path: Path, points: Points, version: str = "1.2", format: int = 3, crs: str = "") -> None:
    """LAS with classes 2 and 6 in turn and two returns; the system as WKT from version 1.4 on, else as GeoTIFF keys."""
    import laspy
    import pyproj

    header = laspy.LasHeader(version=version, point_format=format)
    header.scales, header.offsets = [0.001] * 3, points.min(0)
    if crs:
        header.add_crs(pyproj.CRS(crs))
    las = laspy.LasData(header)
    las.x, las.y, las.z = points.T
    las.classification = np.where(np.arange(len(points)) % 2 == 0, 2, 6)
    las.return_number, las.number_of_returns = 1 + np.arange(len(points)) % 2, np.full(len(points), 2)
    las.write(str(path))
