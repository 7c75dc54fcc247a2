#!/usr/bin/env python3
"""Compares what the readers give with what laspy, pye57, plyfile, numpy, trimesh and an own PCD decoder read.

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
        return "numpy", lambda m: pcd(path)
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


def pcd(path):
    """The header and the columns by the documentation of the format, with a plain decoder of LZF."""
    data = open(path, "rb").read()
    at = data.index(b"\nDATA ") + 1
    end = data.index(b"\n", at) + 1
    header = {w[0]: w[1:] for w in (l.split() for l in data[:end].decode().splitlines()) if w and w[0][0] != "#"}
    count, kind = int(header["POINTS"][0]), header["DATA"][0]
    if kind == "ascii":
        return np.loadtxt(data[end:].decode().splitlines(), ndmin=2)[:, :3]
    types = [t.lower() + s for t, s in zip(header["TYPE"], header["SIZE"])]
    if kind == "binary":
        return np.frombuffer(data[end:], np.dtype(list(zip(header["FIELDS"], types))), count)[["x", "y", "z"]]
    packed, size = np.frombuffer(data[end:end + 8], "<u4")
    body = lzf(data[end + 8:end + 8 + packed])
    assert len(body) == size
    columns, offset = {}, 0
    for field, kind, length in zip(header["FIELDS"], types, header["SIZE"]):
        columns[field] = np.frombuffer(body, kind, count, offset)
        offset += int(length) * count
    return np.stack([columns[axis] for axis in "xyz"], 1)


def lzf(data):
    out, i = bytearray(), 0
    while i < len(data):
        control, i = data[i], i + 1
        if control < 32:
            out += data[i:i + control + 1]
            i += control + 1
            continue
        length = control >> 5
        if length == 7:
            length, i = length + data[i], i + 1
        start = len(out) - ((control & 31) << 8) - data[i] - 1
        i += 1
        for k in range(length + 2):
            out.append(out[start + k])
    return out


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
    # Decimals of an ascii PLY are kept as they are written; plyfile rounds them to the float of the header.
    if module == "plyfile" and b"format ascii" in open(path, "rb").read(64):
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
