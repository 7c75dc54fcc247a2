"""Each point of the list of what new users stumbled over."""

from __future__ import annotations

import json
import os
import pty
import re
import subprocess
from collections.abc import Iterator
from pathlib import Path

import numpy as np
from inputs import box_faces, room, roof, write_las, write_stl
from reports import Row
from run import Program
from shape import counts, tally


def rows(program: Program) -> Iterator[Row]:
    """All points of the list, on inputs of our own."""
    folder = program.folder / "points"
    folder.mkdir(exist_ok=True)
    np.save(folder / "roof.npy", roof())
    np.save(folder / "room.npy", room())
    for part in (meshes, sections, used, choosing, telling, names, pictures):
        yield from part(program, folder)


def said(text: str, pattern: str) -> str:
    """The line in which a pattern is met."""
    return next((" ".join(x.split()) for x in text.splitlines() if re.search(pattern, x)), "not said")


def meshes(program: Program, folder: Path) -> Iterator[Row]:
    box = folder / "box.stl"
    write_stl(box, *box_faces(np.array([30.0, 20.0, 10.0])))
    found, ran = program.found("extract", box)
    line = said(ran.err, "sampled|samples")
    yield "a box as STL", "0 creases, exit 0", f"{counts(found)}; {line}", tally(found) == (12, 0, 8, 0) and line != "not said"
    found, ran = program.found("extract", box, "--samples", "5000")
    yield "--samples 5000", "none", said(ran.err, "sampled|samples"), tally(found) == (12, 0, 8, 0) and "5,000" in ran.err
    found, ran = program.found("extract", box, "--vertices")
    yield "--vertices", "none", ran.word, ran.refused or "8 points" in ran.err
    np.save(folder / "sphere.npy", (v := np.random.default_rng(1).normal(size=(4000, 3))) / np.linalg.norm(v, axis=1)[:, None])
    _, ran = program.found("extract", folder / "sphere.npy")
    line = said(ran.err, "no line|without")
    yield "a result without any line", "no word", line, line != "not said"


def sections(program: Program, folder: Path) -> Iterator[Row]:
    roof_file, room_file = str(folder / "roof.npy"), str(folder / "room.npy")
    for axis in ("x", "y", "-1,0,0", "0.6,0.8,0"):
        cut, _ = program.found("section", roof_file, f"--axis={axis}", "--count", "3")
        up = cut["axes"][1]
        yield f"z points up across {axis}", "upside down", f"up is {[round(v, 3) for v in up]}", up[2] > 0.999
    svg = folder / "plan.svg"
    program.run("section", roof_file, "--axis", "y", "--at", "5", "--millimetres", "10", "-o", str(svg))
    width = re.search(r'width="([\d.]+)mm"', svg.read_text()[:500])
    yield (
        "SVG to scale",
        "fitted",
        f"a roof of 10 at 10 mm: {width.group(0) if width else 'no mm'}",
        width is not None and float(width.group(1)) >= 100,
    )
    gpkg = folder / "plan.gpkg"
    ran = program.run("section", roof_file, "--count", "3", "-o", str(gpkg))
    yield "GeoPackage of sections", "refused", ran.word, ran.code == 0 and gpkg.read_bytes()[:6] == b"SQLite"
    cut, ran = program.found("section", room_file, "--from", "floor", "--at", "1")
    yield "--from floor", "none", f"zero {cut['zero']:.3f}, plane {cut['planes'][0]['height']:.3f}", abs(cut["zero"] - 2) < 0.02
    cut, ran = program.found("section", room_file, "--axis", "auto", "--count", "4")
    yield "automatic axes snap", "0.9998, ..", f"{cut['axes'][2]}", sorted(map(abs, cut["axes"][2])) == [0, 0, 1]
    ran = program.run("section", room_file, "--every", "2", "--at", "3", "-o", "x.json", "-v")
    every = said(ran.err, "read")
    yield "--every n reads every n-th point", "a distance", every, ran.code == 0 and f"{len(room()) // 2:,}" in ran.err


def used(program: Program, folder: Path) -> Iterator[Row]:
    first, _ = program.found("extract", folder / "roof.npy", "--set", "penalty.gamma=0.4")
    (folder / "used.json").write_text(json.dumps(first))
    again, ran = program.found("extract", folder / "roof.npy", "--params", str(folder / "used.json"))
    same = again is not None and again == first
    yield (
        "parameters in JSON, taken back",
        "quotes in quotes",
        f"{first['parameters']['method']!r}, equal {same}",
        same and "auto" not in list(first["parameters"].values())[1:],
    )
    out = folder / "roof.geojson"
    program.run("extract", str(folder / "roof.npy"), "-o", str(out))
    lines = [f["properties"] for f in json.loads(out.read_text())["features"] if f["geometry"]["type"] == "LineString"]
    right = all("fold_deg" in p for p in lines) and all("fold_deg" in s for s in first["strips"])
    yield "fold_deg in JSON and GeoJSON", "GeoPackage only", f"{[p.get('fold_deg') for p in lines][:2]}", right
    stages = folder / "stages"
    program.run("extract", str(folder / "room.npy"), "--method", "segments", "--stages", str(stages), "-o", "x.json")
    yield "stages.json counts what its PLY holds", "other counts", *stage_counts(stages)


def stage_counts(folder: Path) -> tuple[str, bool]:
    """Each stage of edges beside the edges of its file."""
    told = (folder / "stages.json").read_text()
    numbers = set(map(int, re.findall(r"\b\d+\b", told)))
    held = {
        p.name: int(m.group(1))
        for p in sorted(folder.glob("*.ply"))
        if (m := re.search(rb"element edge (\d+)", p.read_bytes()[:2000]))
    }
    return f"{held}", bool(held) and all(n in numbers for n in held.values())


def choosing(program: Program, folder: Path) -> Iterator[Row]:
    las = folder / "roof.las"
    write_las(las, roof())
    for args, left in (
        (["--class", "2"], 1500),
        (["--class", "2,6"], 3000),
        (["--returns", "last"], 1500),
        (["--returns", "only"], 0),
    ):
        ran = program.run("info", str(las), *args)
        right = f"{left:,}" in ran.out if left else ran.refused
        yield " ".join(args), "none", said(ran.out, "^points") if left else ran.word, right
    whole, _ = program.found("extract", folder / "room.npy")
    for args, keep in (
        (["--min-length", "3.5"], lambda s: s["length"] >= 3.5),
        (["--min-confidence", "0.9"], lambda s: s["confidence"] >= 0.9),
    ):
        some, _ = program.found("extract", folder / "room.npy", *args)
        wanted = sum(map(keep, whole["strips"]))
        yield " ".join(args), "none", f"{len(some['strips'])} of {len(whole['strips'])} lines", len(some["strips"]) == wanted
    points = roof(6000)
    np.save(folder / "holed.npy", points[np.hypot(points[:, 0] - 2.5, points[:, 1] - 5) > 1])
    some, _ = program.found("extract", folder / "holed.npy", "--min-hole", "10")
    all_, _ = program.found("extract", folder / "holed.npy")
    yield "--min-hole", "none", f"{tally(all_)[1]} borders, {tally(some)[1]} with it", tally(some)[1] == tally(all_)[1] - 1


def telling(program: Program, folder: Path) -> Iterator[Row]:
    las = folder / "place.las"
    write_las(las, roof() + [500000, 5000000, 100], "1.4", 6, "EPSG:25833")
    ran = program.run("info", str(las))
    text = " ".join(ran.out.split())
    blank = [x for x in ran.out.splitlines() if re.fullmatch(r"\S+\s*", x)]
    yield "info of LAS", "no version, EPSG", text[:150], all(x in text for x in ("1.4", "25833")) and not blank
    npy = str(folder / "roof.npy")
    for name, args, right in (
        ("--scan without scans", ["--scan", "2"], lambda r: r.refused and "scan" in r.err),
        ("--bounds without points", ["--bounds", "90,90,90,91,91,91"], lambda r: r.refused and "90" in r.err),
        ("--voxel that leaves eight", ["--voxel", "6"], lambda r: "6" in said(r.err, "voxel")),
    ):
        ran = program.run("extract", npy, *args, "-o", "x.json")
        yield name, "no word", said(ran.err, "voxel|scan|error"), right(ran)
    ran = program.run("section", "--sample", "list")
    yield "section --sample list", "asks for -o", ran.out[:60].replace("\n", " "), ran.code == 0 and "bracket" in ran.out
    np.save(folder / "many.npy", np.random.default_rng(2).permutation(np.vstack([roof(300_000, s) for s in range(3)])))
    text = on_terminal([program.path, "extract", str(folder / "many.npy"), "-o", str(folder / "x.json")])
    share = re.findall(r"\d+ ?%[^\r\n\x1b]*", text)
    yield "progress with share and time left", "none", "; ".join(share[-2:]), any("left" in s for s in share)


def on_terminal(command: list[str]) -> str:
    """All that a command says to a terminal."""
    ours, theirs = pty.openpty()
    process = subprocess.Popen(command, stderr=theirs, stdout=theirs, stdin=subprocess.DEVNULL)
    os.close(theirs)
    parts = []
    while True:
        try:
            part = os.read(ours, 65536)
        except OSError:
            break
        if not part:
            break
        parts.append(part)
    process.wait()
    os.close(ours)
    return b"".join(parts).decode(errors="replace")


def names(program: Program, folder: Path) -> Iterator[Row]:
    npy = str(folder / "roof.npy")
    asked: list[tuple[str, list[str], str]] = [
        ("a parameter with a slip", ["extract", npy, "--set", "penalty.gama=0.4"], "penalty.gamma"),
        ("a method with a slip", ["extract", npy, "--method", "penalt"], "penalty"),
        ("a command with a slip", ["extrct", npy], "extract"),
        ("a file in place of a command", [npy], "extract"),
        ("an option with a slip", ["extract", npy, "--outptu", "x.json"], "--output"),
        ("a sample with a slip", ["extract", "--sample", "braket", "-o", "x.json"], "bracket"),
        ("an unknown extension", ["extract", npy, "-o", "x.dfx"], "dxf"),
    ]
    for name, args, word in asked:
        ran = program.run(*args)
        line = said(ran.err, f"{re.escape(word)}")
        yield name, "no help", re.sub(r"/\S*/", "", line)[:120], ran.code in (2, 4) and word in ran.err
    help_ = program.run("extract", "--help").out
    headings = re.findall(r"^(\w[\w ]+):$", help_, re.M)
    yield "options under headings", "one list", ", ".join(headings), {"Reading", "Parameters", "Running"} <= set(headings)


def pictures(program: Program, folder: Path) -> Iterator[Row]:
    import matplotlib.image

    views = []
    for method in ("auto", "penalty"):
        out = folder / f"{method}.png"
        program.run("render", str(folder / "room.npy"), "--method", method, "--no-caption", "--size", "400x300", "-o", str(out))
        views.append(matplotlib.image.imread(out)[..., :3])
    # Lines may differ; the surface behind them is the same in nearly every pixel of the same view.
    same = float((np.abs(views[0] - views[1]).max(axis=2) < 0.02).mean())
    yield "the same view whatever the method", "another view", f"{same:.3f} of the pixels equal", same > 0.95
    ran = program.run("render", str(folder / "room.npy"), "--up", "auto", "-o", str(folder / "up.png"))
    yield "render --up auto", "none", ran.word, ran.code == 0
