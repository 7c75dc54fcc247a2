#!/usr/bin/env python3
"""Opens written files with the programs that users open them with: opens.py FOLDER, which holds a.dxf, a.ply, a.glb, a.vtp,
a.geojson, a.gpkg, a.obj and a.svg of one network, or points.las, .laz, .ply, .npz, .parquet, .pcd, .csv and .npy of one cloud
with points.f64, its coordinates. Prints a row a file; ends with 1 if one is not as it should be."""
import importlib, json, os, sys
import numpy as np
import xml.etree.ElementTree as tree


def dxf(ezdxf, path):
    drawing = ezdxf.readfile(path)
    audit = drawing.audit()
    lines = drawing.modelspace().query("POLYLINE")
    return not audit.errors and not audit.fixes and len(lines) == 2, f"{len(lines)} polylines, {len(audit.errors)} errors"


def ply(plyfile, path):
    data = plyfile.PlyData.read(path)
    return len(data["edge"]) == 66, f"{len(data['vertex'])} vertices, {len(data['edge'])} edges"


def glb(trimesh, path):
    scene = trimesh.load(path)
    low, high = scene.bounds
    # y is up in the file: x, z and -y of the input.
    good = abs(low[0] - 665186.25) < 1e-3 and abs(high[1] - 241.5) < 1e-3
    return good, f"{len(scene.geometry)} meshes from {low} to {high}"


def vtp(pyvista, path):
    mesh = pyvista.read(path)
    return mesh.n_lines == 2 and mesh.points.dtype == "float64", f"{mesh.n_points} points, {mesh.n_lines} lines"


def geojson(fiona, path):
    with fiona.open(path) as layer:
        features = list(layer)
    first = features[0]["geometry"]["coordinates"][0]
    return len(features) == 4 and first == (665187.25, 5648349.875, 241.5), f"{len(features)} features from {first}"


def obj(trimesh, path):
    lines = trimesh.load(path)
    text = open(path).read()
    return text.count("\nl ") == 2, f"{type(lines).__name__}"


def svg(_, path):
    root = tree.parse(path).getroot()
    return len(root.findall(".//{*}path")) == 2, f"{root.get('width')} by {root.get('height')}"


def gpkg(fiona, path):
    layers = {name: list(fiona.open(path, layer=name)) for name in fiona.listlayers(path)}
    first = layers["lines"][0]
    loop = layers["lines"][1]["geometry"]["coordinates"]
    good = (len(layers["lines"]), len(layers["nodes"]), len(loop)) == (2, 2, 65) and loop[0] == loop[-1]
    good &= first["geometry"]["coordinates"][0] == (665187.25, 5648349.875, 241.5) and first["properties"]["kind"] == "crease"
    return good, f"{[(name, len(rows)) for name, rows in layers.items()]}"


def database(sqlite3, path):
    db = sqlite3.connect(path)
    faults = db.execute("PRAGMA integrity_check").fetchall() + db.execute("PRAGMA foreign_key_check").fetchall()
    found = db.execute("SELECT table_name FROM gpkg_contents WHERE identifier = 'nodes'").fetchall()
    return faults == [("ok",)] and found == [("nodes",)], f"{faults}"


def same(rows, path):
    """Whether coordinates are those that were written, and how far they are off; LAS has a grid."""
    written = np.fromfile(os.path.join(os.path.dirname(path), "points.f64"), "<f8").reshape(-1, 3)
    rows = np.asarray(rows, float)
    grid = 1e-6 if path.endswith(("las", "laz")) else 0
    return rows.shape == written.shape and np.abs(rows - written).max() <= grid, f"{len(rows)} points"


def las(laspy, path):
    file = laspy.read(path)
    good, text = same(file.xyz, path)
    return good and set(np.unique(file["class"])) == {0, 1, 2, 3} and file["intensity"][5] == 5, text


def points_ply(plyfile, path):
    vertex = plyfile.PlyData.read(path)["vertex"]
    return same(np.stack([vertex[a] for a in "xyz"], 1), path)


def pcd(pypcd4, path):
    cloud = pypcd4.PointCloud.from_path(path)
    good, text = same(cloud.numpy(("x", "y", "z")), path)
    return good and cloud.numpy(("intensity",))[5] == 5, f"{text}, {cloud.fields}"


def npz(numpy, path):
    file = numpy.load(path)
    good, text = same(file["xyz"], path)
    return good and file["class"].dtype == "u1" and file["intensity"][5] == 5, f"{text}, {file.files}"


def parquet(pyarrow, path):
    table = pyarrow.read_table(path)
    good, text = same(np.stack([table[a].to_numpy() for a in "xyz"], 1), path)
    return good and str(table.schema.field("class").type) == "uint8", f"{text}, {table.column_names}"


def csv(numpy, path):
    return same(numpy.genfromtxt(path, delimiter=",", names=True)[["x", "y", "z"]].tolist(), path)


def classes(numpy, path):
    return numpy.load(path).max() == 3, "classes"


CHECKS = [("a.dxf", "ezdxf", dxf), ("a.ply", "plyfile", ply), ("a.glb", "trimesh", glb), ("a.vtp", "pyvista", vtp),
          ("a.geojson", "fiona", geojson), ("a.gpkg", "fiona", gpkg), ("a.gpkg", "sqlite3", database),
          ("a.obj", "trimesh", obj), ("a.svg", "json", svg), ("points.las", "laspy", las), ("points.laz", "laspy", las),
          ("points.ply", "plyfile", points_ply), ("points.pcd", "pypcd4", pcd), ("points.npz", "numpy", npz),
          ("points.parquet", "pyarrow.parquet", parquet), ("points.csv", "numpy", csv), ("points.npy", "numpy", classes)]


def main():
    good = True
    for name, module, check in CHECKS:
        path = os.path.join(sys.argv[1], name)
        if not os.path.exists(path):
            continue
        try:
            module = importlib.import_module(module)
        except ImportError:
            print(f"skip {name}: {module} is not installed")
            continue
        ok, text = check(module, path)
        print(f"{'ok  ' if ok else 'BAD '} {name} in {module.__name__}: {text}")
        good &= bool(ok)
    sys.exit(not good)


main()
