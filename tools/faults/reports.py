"""Situations from public reports: each file of `reports` and its right value."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

import numpy as np
from run import Program
from shape import circle, counts, dense, kinds, lines_of, shares, tally

Row = tuple[str, str, str, bool]
"""File, what was found first, what is found now, and whether that is right."""


def rows(program: Program) -> Iterator[Row]:
    """All rows of the table of `reports/README.md`."""
    for row in (cubes, depth_maps, plates, solids, table, rooms, sections, gable, files):
        yield from row(program, program.data / "reports")


def cubes(program: Program, data: Any) -> Iterator[Row]:
    for name, first in (("g2_cube_out100.ply", "32 creases"), ("g2_cube_out400.ply", "156 creases")):
        found, _ = program.found("extract", data / name)
        yield name, first, counts(found), found is not None and tally(found) == (12, 0, 8, 0)
        cut, _ = program.found("section", data / name)
        areas = [[s["area"] for s in cut["strips"] if s["plane"] == p["plane"]] for p in cut["planes"]]
        right = all(len(a) == 1 and abs(a[0] - 1e4) < 200 for a in areas)
        closed = sum(len(a) == 1 for a in areas)
        span = [min(map(sum, areas)), max(map(sum, areas))]
        yield f"{name}, sections", "open", f"{closed} of {len(areas)} one contour, area {span[0]:.0f} to {span[1]:.0f}", right


def depth_maps(program: Program, data: Any) -> Iterator[Row]:
    found, _ = program.found("extract", data / "g1_depthcam_2pc_outliers.ply")
    yield "g1_depthcam_2pc_outliers.ply", "2,352 creases", counts(found), tally(found)[:2] == (0, 12)
    box = np.array([[-0.25, -0.15, 1.2], [0.15, -0.15, 1.2], [0.15, 0.15, 1.2], [-0.25, 0.15, 1.2]])
    for name, first in (("e4_depthcam_clean.ply", "right"), ("e4_depthcam_flying.ply", "recall .40, 65 creases")):
        found, _ = program.found("extract", data / name)
        h = found["spacing"]
        met = shares(lines_of(found, h / 5), dense(box, h / 5, True), 2 * h)[1]
        yield name, first, f"recall {met:.2f}, {counts(found)}", met >= 0.95 and tally(found)[0] <= 2


def plates(program: Program, data: Any) -> Iterator[Row]:
    frame = dense([[0, 0, 0], [60, 0, 0], [60, 40, 0], [0, 40, 0]], 0.05, True)
    for name, first in (("e5b_cmm_lines_10to1.ply", "recall .44"), ("e5c_lines_6to1.ply", "311 creases")):
        found, ran = program.found("extract", data / name)
        points = lines_of(found, 0.05)
        truth = np.vstack([frame, circle((30, 20, 0), 8)])
        met = shares(points, truth, 2 * found["spacing"])
        warned = re.search(r"\brows?\b", ran.err) is not None
        right = tally(found)[:2] == (0, 2) or warned
        yield (
            name,
            first,
            f"precision {met[0]:.2f}, recall {met[1]:.2f}, {counts(found)}, rows {'' if warned else 'not '}named",
            right,
        )


def solids(program: Program, data: Any) -> Iterator[Row]:
    wanted = {"e2_triangular_prism_random.ply": (9, 0, 6, 0), "e2_cuboid_voxel_centres.ply": (12, 0, 8, 0)}
    for (name, right), first in zip(wanted.items(), ("borders with loose ends", "one edge missing")):
        found, _ = program.found("extract", data / name)
        yield name, first, counts(found), tally(found) == right


def table(program: Program, data: Any) -> Iterator[Row]:
    found, _ = program.found("extract", data / "f3_object_on_table.ply")
    cloud = lines_of(found, found["spacing"] / 5)
    side = 200.0
    square = dense([[-side, -side, 0], [side, -side, 0], [side, side, 0], [-side, side, 0]], 0.5, True)
    h = found["spacing"]
    rings = [shares(cloud, circle((0, 0, z), 30), 2 * h)[1] for z in (0, 80)]
    border = shares(cloud, square, 20 * h)[1]
    text = f"rings {rings[0]:.2f} {rings[1]:.2f}, square {border:.2f}, {counts(found)}"
    yield "f3_object_on_table.ply", "recall .57, 40 ends", text, min(*rings, border) >= 0.95 and tally(found)[3] <= 2


def rooms(program: Program, data: Any) -> Iterator[Row]:
    found, _ = program.found("extract", data / "e9_rooms_ok.ply")
    h = found["spacing"]
    cloud = lines_of(found, h / 5)
    top = [np.ptp(cloud[:, 1]) / 2, np.mean(cloud[:, 1])]
    ends = (top[1] - top[0], top[1] + top[0])
    met = [shares(cloud, dense([[x, ends[0], 2.5], [x, ends[1], 2.5]], h / 5), h)[1] for x in (4.0, 4.1)]
    yield "e9_rooms_ok.ply", "most missing", f"recall {met[0]:.2f} and {met[1]:.2f}, {counts(found)}", min(met) >= 0.9


def sections(program: Program, data: Any) -> Iterator[Row]:
    # The pipe lies along z: slices across x are straight lines along it.
    for axis, wanted in (("x", "line"), ("z", "arc")):
        cut, _ = program.found("section", data / "s7_half_pipe.ply", "--axis", axis, "--count", "5", "--fit")
        arcs = [q for s in cut["strips"] for q in s["pieces"] if q["type"] == "arc"]
        off = [(abs(q["radius"] - 50), float(np.hypot(*across(q["centre"], axis)))) for q in arcs]
        worst = max((max(o) for o in off), default=0.0)
        text = f"{kinds(cut)}, worst {worst:.3f}"
        yield f"s7_half_pipe.ply, across {axis}", "18 lines", text, kinds(cut) == [[wanted]] * 5 and worst < 0.1
    cut, _ = program.found("section", data / "s1_open_shell.ply", "--axis", "z", "--count", "10", "--fit")
    text = f"{sum(k == ['line', 'arc', 'line'] for k in kinds(cut))} of {len(kinds(cut))} are line, arc, line; {ends_of(cut)}"
    yield "s1_open_shell.ply", "centre 1.4 off", text, all(k == ["line", "arc", "line"] for k in kinds(cut))
    cut, _ = program.found("section", data / "s3_bored_block_x.ply", "--axis", "x", "--count", "5", "--fit")
    rings = [q for s in cut["strips"] for q in s["pieces"] if q["type"] == "circle"]
    off = max((abs(v - w) for q in rings for v, w in zip((q["radius"], *q["centre"][1:]), (8, 146, 47))), default=np.inf)
    yield (
        "s3_bored_block_x.ply",
        "a circle in one of five",
        f"{len(rings)} circles, worst {off:.3f}",
        len(rings) == 5 and off < 0.1,
    )
    faces, _ = program.found("patches", data / "s3_bored_block_x.ply")
    surfaces = sorted(p["surface"]["type"] for p in faces["patches"])
    yield "s3_bored_block_x.ply, patches", "faces merge", f"{surfaces}", surfaces == ["cylinder"] + ["plane"] * 6


def across(point: Any, axis: str) -> list[float]:
    """Coordinates of a point but that along an axis."""
    return [v for v, name in zip(point, "xyz") if name != axis]


def ends_of(cut: Any) -> str:
    ends = [v for s in cut["strips"] if not s["closed"] for v in (s["points"][0][0], s["points"][-1][0])]
    return f"ends {min(ends):.2f} and {max(ends):.2f}" if ends else "no ends"


def gable(program: Program, data: Any) -> Iterator[Row]:
    axis = ("--axis=0.64279,0.76604,0", "--count", "3")
    cut, _ = program.found("section", data / "gable_heading40.ply", *axis)
    up = cut["axes"][1]
    areas = [abs(s["area"]) for s in cut["strips"]]
    text = f"up is {[round(v, 2) for v in up]}, areas {[round(a, 1) for a in areas]}"
    yield "gable_heading40.ply", "upside down", text, up[2] > 0.99 and all(abs(a - 36) < 0.5 for a in areas)


def files(program: Program, data: Any) -> Iterator[Row]:
    ran = program.run("info", str(data / "dem_grid.asc"))
    # A grid that names the corner of its first cell has that cell's middle half a cell of 2 farther.
    right = "3,000" in ran.out and "3500001" in ran.out or ran.refused
    yield "dem_grid.asc", "50 points", " ".join(ran.out.split())[:160] or ran.word, right
    _, ran = program.found("extract", data / "e8_facade_utm_float32.ply")
    step = re.search(r".*steps? of.*", ran.err)
    yield (
        "e8_facade_utm_float32.ply",
        "no word",
        step.group(0).strip() if step else "no word",
        step is not None and "0.5" in step.group(0),
    )
    ran = program.run("info", "--salvage", str(data / "pts_count_short.pts"))
    yield "pts_count_short.pts", "refused", " ".join((ran.err + ran.out).split())[:160], "2,998" in ran.err + ran.out
