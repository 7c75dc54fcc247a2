"""Inputs that broke a promise: each file of `attack` by each command, and the right value of each."""

from __future__ import annotations

import re
import shutil
from collections.abc import Iterator
from pathlib import Path

import numpy as np
from reports import Row
from run import Program, Ran

COMMANDS = {
    "info": [],
    "extract": ["-o", "{out}.json"],
    "extract segments": ["--method", "segments", "-o", "{out}.json"],
    "patches": ["-o", "{out}.json"],
    "classify": ["-o", "{out}.ply"],
    "clean": ["-o", "{out}.ply"],
    "section": ["--fit", "-o", "{out}.json", "-o", "{out}.svg"],
    "render": ["--size", "400x300", "-o", "{out}.png"],
}
"""Commands that every file is given to; a second word is a label."""


def rows(program: Program) -> Iterator[Row]:
    """All rows of the table of `attack/README.md`, then every file by every command, then batches."""
    data = program.data / "attack"
    yield from single(program, data)
    yield from chosen(program, data)
    yield from sweep(program, data)
    yield from batches(program, data)


def told(ran: Ran, right: bool) -> tuple[str, bool]:
    """What a run showed, in words, and whether that is right."""
    return f"{ran.fault or ran.word}; {ran.seconds:.2f} s, {ran.memory:.0f} MB", right and not ran.fault


def points_read(ran: Ran) -> int:
    """The number of points that `info` tells; -1 without one."""
    told_by = re.search(r"^points\s+([\d,]+)", ran.out, re.M)
    return int(told_by.group(1).replace(",", "")) if told_by else -1


def single(program: Program, data: Path) -> Iterator[Row]:
    """Files that `info` alone shows to be right."""
    info = {
        "e57_constant.e57": ("abort", lambda r: r.refused or points_read(r) == 1),
        "e57_unbalanced_first.e57": ("called damaged", lambda r: points_read(r) == 3),
        "pq_deep.parquet": ("stack overflow", lambda r: r.refused),
        "pq_shared_small.parquet": ("13 s", lambda r: r.refused or points_read(r) >= 0),
        "pq_empty_page.parquet": ("ended early", lambda r: points_read(r) == 0 or r.refused and "early" not in r.err),
        "gltf_mesh_instances.gltf": ("899 MB", lambda r: r.memory < 72 + 8 * 0.131),
        "npz_overlap_bomb.npz": ("30 s", lambda r: r.refused),
        "pcd_long_name_10000.pcd": ("1.7 GB", lambda r: r.refused and r.memory < 100),
        "two_vertex.ply": ("a part in silence", lambda r: r.refused or "note" in r.err + r.out or "warning" in r.err + r.out),
        "more_rows.ply": ("a part in silence", lambda r: r.refused or "note" in r.err + r.out or "warning" in r.err + r.out),
        "more.off": ("a part in silence", lambda r: r.refused or "note" in r.err + r.out or "warning" in r.err + r.out),
        "denormal40k.npy": ("6 s", lambda r: r.refused),
    }
    for name, (first, right) in info.items():
        ran = program.run("info", str(data / name))
        yield (f"{name}, info", first, *told(ran, right(ran)))


def chosen(program: Program, data: Path) -> Iterator[Row]:
    """Files that were found by another command."""
    out = str(program.folder / "o")
    runs = [
        ("same_names.ply", "43 s", ["classify", "-o", out + ".ply"], lambda r: r.code == 0),
        (
            "gauss40k_f4.npy",
            "8 s, 2,457 creases",
            ["extract", "-o", out + ".json"],
            lambda r: "no surface" in r.err and "0 creases" in r.err,
        ),
        ("plate49.npy", "6 s", ["section", "--fit", "--at", "0.1,0.2,0.3,0.4", "-o", out + ".json"], lambda r: r.code == 0),
        ("loggrid20k.npy", "26 s, 2.6 GB", ["extract", "--method", "segments", "-o", out + ".json"], lambda r: r.code in (0, 4)),
        ("gf_1_3160.npy", "NaN in the drawing", ["section", "-o", out + ".svg"], lambda r: r.refused),
        (
            "box500.npy",
            "panic",
            ["render", "--network", str(data / "network_1e308.json"), "-o", out + ".png"],
            lambda r: r.refused,
        ),
    ]
    # The file lies at the origin; the row is of coordinates of 1e7.
    np.save(program.folder / "voxel7.npy", np.load(data / "voxel.npy") + 1e7)
    runs.append(
        (
            str(program.folder / "voxel7.npy"),
            "all points merged",
            ["extract", "--voxel", "1e-12", "-o", out + ".json"],
            lambda r: r.refused,
        )
    )
    for name, first, args, right in runs:
        ran = program.run(args[0], str(data / name), *args[1:])
        yield (f"{Path(name).name}, {args[0]}", first, *told(ran, right(ran)))


def sweep(program: Program, data: Path) -> Iterator[Row]:
    """Every file by every command: no crash, nothing longer than the limit, a word where it is refused."""
    for file in sorted(data.iterdir()):
        if file.suffix == ".md":
            continue
        faults, slowest = [], (0.0, "")
        for label, args in COMMANDS.items():
            filled = [a.format(out=program.folder / "sweep") for a in args]
            ran = program.run(label.split()[0], str(file), *filled)
            slowest = max(slowest, (ran.seconds, label))
            if ran.fault or ran.code and not ran.err.strip():
                faults.append(f"{label}: {ran.fault or 'no word'}")
        text = "; ".join(faults) or f"no fault; slowest {slowest[1]}, {slowest[0]:.2f} s"
        yield f"{file.name}, {len(COMMANDS)} commands", "", text, not faults


def batches(program: Program, data: Path) -> Iterator[Row]:
    """A batch of 99 good files and one of these: 99 results, exit 1."""
    good, out = program.folder / "good", program.folder / "lines"
    good.mkdir(exist_ok=True)
    rng = np.random.default_rng(1)
    u, v = 10 * rng.random((2, 400))
    roof = np.column_stack([u, v, np.abs(u - 5)])
    for k in range(99):
        np.save(good / f"good{k:02}.npy", roof + [0, 0, k])
    for bad in sorted(data.iterdir()):
        if bad.suffix == ".md":
            continue
        shutil.rmtree(out, ignore_errors=True)
        files = sorted(str(p) for p in good.iterdir())
        ran = program.run(
            "extract", *files[:50], str(bad), *files[50:], "-o", str(out) + "/", "-o", str(out) + "/{stem}.json", "-q"
        )
        results = len(list(out.glob("good*.json"))) if out.exists() else 0
        whole = len(list(out.glob("*.json"))) - 2 * 99 if out.exists() else 0
        # Files that are no fault for this command have a result of their own.
        wanted = 0 if whole > 0 else 1
        right = results == 2 * 99 and ran.code == wanted
        yield f"99 good files and {bad.name}", "", f"{results // 2} results, exit {ran.code}", right
