#!/usr/bin/env python3
"""Compares what the readers give with what laspy, pye57, plyfile, pypcd4, numpy and trimesh read.

    compare.py POSITIONS FILE...

POSITIONS is the example program `positions`. Prints a row a file and ends with 1 if one differs. Files whose rival is not
installed are skipped, saying so.
"""
import importlib, os, subprocess, sys, tempfile
import numpy as np


def rows(path):
    """x, y and z of every point, as the rival reads them, and the rival's name; None if it is not installed."""
    name = path.lower()
    with open(path, "rb") as file:
        start = file.read(32)
    if name.endswith((".las", ".laz")):
        return "laspy", lambda m: np.asarray(m.read(path).xyz)
    if name.endswith(".e57"):
        return "pye57", e57(path)
    if name.endswith(".ply"):
        return "plyfile", lambda m: np.stack([m.PlyData.read(path)["vertex"][a] for a in "xyz"], 1)
    if name.endswith(".pcd"):
        return "pypcd4", lambda m: m.PointCloud.from_path(path).numpy(("x", "y", "z"))
    if name.endswith((".obj", ".off", ".stl")):
        return "trimesh", lambda m: m.load(path, process=False, maintain_order=True).vertices
    if name.endswith(".npy"):
        return "numpy", lambda m: m.load(path)[:, :3]
    if start.startswith(b"[Expe"):
        return "numpy", lambda m: expe(path)
    return "numpy", lambda m: m.loadtxt(path)[:, :3]


def e57(path):
    def read(module):
        file = module.E57(path)
        scans = []
        for index in range(file.scan_count):
            scan = file.read_scan(index, ignore_missing_fields=True, transform=True)
            scans.append(np.stack([scan["cartesian" + axis] for axis in "XYZ"], 1))
        return np.concatenate(scans)
    return read


def expe(path):
    data = open(path, "rb").read()
    header, body = data.split(b"\ndata\n", 1)
    lines = [line.split() for line in header.decode().splitlines()[1:]]
    sizes = [int(words[2]) for words in lines if words[0] == "property"]
    return np.frombuffer(body, np.uint8).reshape(-1, sum(sizes))[:, :12].copy().view("<f4")


def compare(program, path):
    with tempfile.TemporaryDirectory() as folder:
        out = os.path.join(folder, "positions.f64")
        run = subprocess.run([program, path, "--to", out], capture_output=True, text=True)
        if run.returncode:
            return f"refused: {run.stderr.strip()}", False
        ours = np.fromfile(out, "<f8").reshape(-1, 3)
    module, read = rows(path)
    try:
        theirs = np.asarray(read(importlib.import_module(module)), float).reshape(-1, 3)
    except ImportError:
        return f"skipped: {module} is not installed", True
    if len(ours) != len(theirs):
        return f"{len(ours)} points, {module} {len(theirs)}", False
    difference = np.nanmax(np.abs(ours - theirs)) if len(ours) else 0.0
    same = np.array_equal(ours, theirs, equal_nan=True)
    # A scale and an offset may be applied in another order: a rounding of the last digit.
    close = same or np.allclose(ours, theirs, rtol=4e-16, atol=1e-12, equal_nan=True)
    # Decimals in text are kept as they are written; plyfile and pypcd4 round them to the float of the header.
    with open(path, "rb") as file:
        start = file.read(1 << 10)
    text = b"format ascii" in start or b"DATA ascii" in start
    if module in ("plyfile", "pypcd4") and text:
        close = np.array_equal(ours.astype("<f4"), theirs.astype("<f4"), equal_nan=True)
    return f"{len(ours)} points as {module}, " + ("every bit" if same else f"to {difference:.1e}"), close


def main():
    program, files = sys.argv[1], sys.argv[2:]
    good = True
    for path in files:
        text, ok = compare(program, path)
        print(f"{'ok  ' if ok else 'DIFF'} {os.path.basename(os.path.dirname(path))}/{os.path.basename(path)}: {text}")
        good &= ok
    sys.exit(not good)


main()
