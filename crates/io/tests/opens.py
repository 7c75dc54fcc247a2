#!/usr/bin/env python3
"""Opens written networks with the programs that users open them with: opens.py FOLDER, which holds a.dxf, a.ply, a.glb,
a.vtp, a.geojson, a.obj and a.svg, all of one network. Prints a row a file; ends with 1 if one is not as it should be."""
import importlib, json, os, sys
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


CHECKS = [("dxf", "ezdxf", dxf), ("ply", "plyfile", ply), ("glb", "trimesh", glb), ("vtp", "pyvista", vtp),
          ("geojson", "fiona", geojson), ("obj", "trimesh", obj), ("svg", "json", svg)]


def main():
    good = True
    for extension, module, check in CHECKS:
        try:
            module = importlib.import_module(module)
        except ImportError:
            print(f"skip a.{extension}: {module} is not installed")
            continue
        ok, text = check(module, os.path.join(sys.argv[1], "a." + extension))
        print(f"{'ok  ' if ok else 'BAD '} a.{extension} in {module.__name__}: {text}")
        good &= ok
    sys.exit(not good)


main()
