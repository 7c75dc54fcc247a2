"""Meshes of few and of many vertices in four formats, their lines beside the edges of the mesh by dihedral angle."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
from inputs import Points, box_faces
from reports import Row
from run import Program
from shape import dense, f1, lines_of

FOLD_DEG = 25.0
"""Angle between two faces from which their edge counts: the default of `penalty.fold_deg`."""
BLUNT_DEG = 12.0
"""Angle from which to `FOLD_DEG` an edge counts neither for nor against."""

Faces = np.ndarray


def rows(program: Program) -> Iterator[Row]:
    """Boxes, rings and the models by format."""
    folder = program.folder / "meshes"
    folder.mkdir(exist_ok=True)
    shapes = {
        "box": box_faces(np.array([30.0, 20.0, 10.0])),
        "slab": box_faces(np.array([100.0, 60.0, 3.0])),
        "ring": ring(20, 30, 12),
        "thin ring": ring(48, 50, 4),
        "prism": prism(6, 10, 30),
    }
    # The last four are smooth or organic: nearly all of their sharp edges are single folds between facets of two spacings.
    for name in ("fandisk.obj", "trim-star.off", "rocker-arm.obj", "screwdriver.off", "cow.obj", "brain.ply"):
        shapes[name] = load(program.data / "models" / name)
    for name, (corners, faces) in shapes.items():
        for ext in ("stl", "obj", "ply", "glb"):
            file = folder / f"mesh.{ext}"
            save(file, corners, faces)
            yield score(program, file, f"{name} as {ext.upper()}", corners, faces)


def score(program: Program, file: Path, name: str, corners: Points, faces: Faces) -> Row:
    found, ran = program.found("extract", file)
    if found is None:
        return name, "", ran.word, False
    h = found["spacing"]
    sharp, blunt = edges(corners, faces)
    truth = np.vstack([np.zeros((0, 3)), *(dense(corners[list(e)], h / 5) for e in sharp)])
    spare = np.vstack([np.zeros((0, 3)), *(dense(corners[list(e)], h / 5) for e in blunt)])
    lines = lines_of(found, h / 5)
    if len(spare) and len(lines) and len(truth):
        from scipy.spatial import cKDTree

        lines = lines[(cKDTree(truth).query(lines)[0] <= h) | (cKDTree(spare).query(lines)[0] > 2 * h)]
    value = f1(lines, truth, h)
    return (
        name,
        "0 creases",
        f"F1 {value:.3f}, {len(found['strips'])} lines, {len(sharp)} sharp edges of {len(faces)} faces",
        value >= 0.95,
    )


def ring(inner: float, outer: float, height: float, count: int = 96) -> tuple[Points, Faces]:
    """A flat ring of rectangular cross-section."""
    angle = np.linspace(0, 2 * np.pi, count, endpoint=False)
    round_ = np.column_stack([np.cos(angle), np.sin(angle)])
    corners = np.vstack(
        [np.column_stack([r * round_, np.full(count, z)]) for r, z in ((inner, 0), (outer, 0), (outer, height), (inner, height))]
    )
    k, next_ = np.arange(count), np.roll(np.arange(count), -1)
    faces = []
    for a in range(4):
        b = (a + 1) % 4
        faces += [
            np.column_stack([a * count + k, a * count + next_, b * count + next_]),
            np.column_stack([a * count + k, b * count + next_, b * count + k]),
        ]
    return corners, np.vstack(faces)


def prism(sides: int, radius: float, height: float) -> tuple[Points, Faces]:
    """A right prism over a regular polygon."""
    angle = 2 * np.pi * np.arange(sides) / sides
    round_ = radius * np.column_stack([np.cos(angle), np.sin(angle)])
    corners = np.vstack([np.column_stack([round_, np.full(sides, z)]) for z in (0, height)])
    faces = [(0, k + 1, k) for k in range(1, sides - 1)] + [(sides, sides + k, sides + k + 1) for k in range(1, sides - 1)]
    for k in range(sides):
        n = (k + 1) % sides
        faces += [(k, n, sides + n), (k, sides + n, sides + k)]
    return corners, np.array(faces)


def load(path: Path) -> tuple[Points, Faces]:
    """Vertices and triangles of a mesh, equal vertices merged."""
    import trimesh

    if b"element tristrips" in path.read_bytes()[:1000]:
        vertices, triangles = strips(path)
    else:
        mesh = trimesh.load(path, force="mesh", process=False)
        vertices, triangles = np.asarray(mesh.vertices, float), np.asarray(mesh.faces)
    corners, index = np.unique(vertices, axis=0, return_inverse=True)
    faces = index.ravel()[triangles]
    keep = (faces[:, 0] != faces[:, 1]) & (faces[:, 1] != faces[:, 2]) & (faces[:, 2] != faces[:, 0])
    return corners, faces[keep]


def strips(path: Path) -> tuple[Points, Faces]:
    """Vertices and triangles of a binary PLY of three floats a vertex and one row of strips, which trimesh does not read."""
    head, body = path.read_bytes().split(b"end_header\n", 1)
    count = int(head.split(b"element vertex ")[1].split()[0])
    vertices = np.frombuffer(body, "<f4", 3 * count).reshape(count, 3).astype(float)
    items = np.frombuffer(body, "<i4", offset=12 * count)[1:]
    faces, start = [], 0
    for end in [*np.flatnonzero(items < 0), len(items)]:
        strip = items[start:end].tolist()
        faces += [t if k % 2 == 0 else (t[1], t[0], t[2]) for k, t in enumerate(zip(strip, strip[1:], strip[2:]))]
        start = end + 1
    return vertices, np.array(faces)


def save(path: Path, corners: Points, faces: Faces) -> None:
    import trimesh

    trimesh.Trimesh(corners, faces, process=False).export(path)


def edges(corners: Points, faces: Faces) -> tuple[list[tuple[int, int]], list[tuple[int, int]]]:
    """Edges whose faces fold by `FOLD_DEG` or that bound one face alone, and those that fold by `BLUNT_DEG` to that."""
    normals = np.cross(corners[faces[:, 1]] - corners[faces[:, 0]], corners[faces[:, 2]] - corners[faces[:, 0]])
    normals /= np.maximum(np.linalg.norm(normals, axis=1), 1e-300)[:, None]
    beside: dict[tuple[int, int], list[int]] = {}
    for f, face in enumerate(faces.tolist()):
        for a, b in zip(face, face[1:] + face[:1]):
            beside.setdefault((min(a, b), max(a, b)), []).append(f)
    sharp, blunt = [], []
    for edge, around in beside.items():
        cosine = -1.0 if len(around) != 2 else float(normals[around[0]] @ normals[around[1]])
        if cosine <= np.cos(np.radians(FOLD_DEG)):
            sharp.append(edge)
        elif cosine <= np.cos(np.radians(BLUNT_DEG)):
            blunt.append(edge)
    return sharp, blunt
