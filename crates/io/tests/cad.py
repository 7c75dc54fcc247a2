#!/usr/bin/env python3
"""Curves and faces in CAD's own programs: cad.py FOLDER, which holds NAME.json, NAME.dxf and NAME.step of networks, NAME.sections.json
and NAME.sections.dxf of sections, and NAME.solid.step of patches. Each entity must have the type of its curve and lie within 1e-6 of
it, the drawing must need no repair, and STEP be read without a complaint; a solid is one closed shell of valid faces. Prints a
row a file; ends with 1 if one is not as it should be."""
import glob, importlib, json, math, sys
import numpy as np

NEAR = 1e-6


def faults_of(ezdxf, path):
    """A drawing's entities and what its audit says."""
    drawing = ezdxf.readfile(path)
    audit = drawing.audit()
    return list(drawing.modelspace()), [str(e.message) for e in audit.errors + audit.fixes]


def along(curve, count=33):
    """Points of a typed curve of JSON, of a network or a section, evenly along its parameter."""
    share = np.linspace(0, 1, count)[:, None]
    start, end = (np.array(curve[k], float) for k in ("from", "to"))
    if curve["type"] == "line":
        return start + share * (end - start)
    if "knots" in curve:
        return spline(curve, share[:, 0])
    centre = np.array(curve.get("center", curve.get("centre")))
    normal = np.array(curve["normal"])
    if "major" in curve:
        sweep, major = math.radians(curve["sweep_deg"]), np.array(curve["major"])
        minor = np.cross(normal, major) * curve["minor"] / np.linalg.norm(major)
        local = start - centre
        first = math.atan2(local @ minor / (minor @ minor), local @ major / (major @ major))
        angle = first + share * sweep
        return centre + np.cos(angle) * major + np.sin(angle) * minor
    first = np.array(start) - centre
    if curve["type"] == "circle":  # A network's has no first point on it.
        first = np.cross(normal, [1, 0, 0] if abs(normal[0]) < 0.9 else [0, 1, 0])
        first *= curve["radius"] / np.linalg.norm(first)
    angle = share * math.radians(curve.get("sweep_deg", 360))
    return centre + np.cos(angle) * first + np.sin(angle) * np.cross(normal, first)


def spline(curve, share):
    degree, knots, controls = curve["degree"], curve["knots"], [np.array(c) for c in curve["controls"]]
    if curve.get("periodic"):
        period, count = knots[-1] - knots[0], len(controls)
        knots = [knots[i % count] + period * (i // count) for i in range(-degree, count + degree + 1)]
        controls = controls[-degree:] + controls
    points = []
    for t in knots[degree] + share * (knots[len(controls)] - knots[degree]):
        span = max(i for i in range(degree, len(controls)) if knots[i] <= t)
        at = [controls[i] for i in range(span - degree, span + 1)]
        for r in range(1, degree + 1):  # De Boor.
            for i in range(degree, r - 1, -1):
                left, right = knots[span - degree + i], knots[span + 1 + i - r]
                a = (t - left) / (right - left)
                at[i] = (1 - a) * at[i - 1] + a * at[i]
        points.append(at[degree])
    return np.array(points)


def drawn(ezdxf, entity):
    """The type of an entity as JSON names it, and points along it."""
    kind, share = entity.dxftype(), np.linspace(0, 1, 33)
    if kind == "LINE":
        a, b = (np.array(p) for p in (entity.dxf.start, entity.dxf.end))
        return "line", a + share[:, None] * (b - a)
    if kind in ("ARC", "CIRCLE"):
        first, last = (0, 360) if kind == "CIRCLE" else (entity.dxf.start_angle, entity.dxf.end_angle)
        angles = first + share * ((last - first) % 360 or 360)
        return kind.lower(), np.array([tuple(v) for v in entity.vertices(angles)])
    if kind == "ELLIPSE":
        first, last = entity.dxf.start_param, entity.dxf.end_param
        last = first + ((last - first) % math.tau or math.tau)
        return "ellipse", np.array([tuple(v) for v in entity.vertices(first + share * (last - first))])
    if kind == "SPLINE":
        tool = entity.construction_tool()
        low, high = entity.knots[entity.dxf.degree], entity.knots[len(entity.control_points)]
        return "spline", np.array([tuple(v) for v in tool.points(low + share * (high - low))])
    return kind, np.zeros((1, 3))


def apart(points, curve):
    """Distance of an entity from a typed curve, in either direction; a circle or a whole ellipse may begin anywhere."""
    wanted = along(curve)
    if curve["type"] == "circle":
        centre, normal = (np.array(curve[k]) for k in ("center", "normal"))
        aside = (points - centre) @ normal
        return max(np.abs(aside).max(), np.abs(np.linalg.norm(points - centre, axis=1) - curve["radius"]).max())
    if "major" in curve and curve["sweep_deg"] == 360:
        centre, normal, major = (np.array(curve[k]) for k in ("center", "normal", "major"))
        size = np.linalg.norm(major)
        across = np.cross(normal, major) / size
        radius = np.hypot((points - centre) @ major / size**2, (points - centre) @ across / curve["minor"])
        return max(np.abs((points - centre) @ normal).max(), size * np.abs(radius - 1).max())
    return min(np.abs(points - wanted).max(), np.abs(points[::-1] - wanted).max())


def compare(entities, curves, ezdxf):
    """How many entities have another type than their curve, and the greatest distance of the others."""
    wrong, worst = abs(len(entities) - len(curves)), 0.0
    for entity, curve in zip(entities, curves):
        kind, points = drawn(ezdxf, entity)
        if curve.get("sweep_deg") == 360 and curve["type"] == "arc":  # From a node back to it.
            curve = dict(curve, type="circle")
        if kind != curve["type"].replace("b-spline", "spline"):
            wrong += 1
        else:
            worst = max(worst, apart(points, curve))
    return wrong, worst


def network(ezdxf, path):
    entities, faults = faults_of(ezdxf, path)
    root = json.load(open(path.replace(".dxf", ".json")))
    curves = [(s, c) for s in root["strips"] for c in s["curves"]]
    layers = [s["kind"].upper() for s, _ in curves] + [n["kind"].upper() for n in root["nodes"]]
    lines = entities[: len(entities) - len(root["nodes"])]
    wrong, worst = compare(lines, [c for _, c in curves], ezdxf)
    wrong += [e.dxf.layer for e in entities] != layers
    return not faults and not wrong and worst < NEAR, text(lines, wrong, worst, faults)


def sections(ezdxf, path):
    """Polylines are taken apart to the lines and arcs that they join; those of a contour must follow each other round it."""
    entities, faults = faults_of(ezdxf, path)
    root = json.load(open(path.replace(".dxf", ".json")))
    parts = [e for e in entities if e.dxftype() != "TEXT"]
    by_layer = {}
    for part in parts:
        pieces = list(part.virtual_entities()) if part.dxftype() == "LWPOLYLINE" else [part]
        by_layer.setdefault(part.dxf.layer, []).extend(pieces)
    wrong, worst = 0, 0.0
    for plane in root["planes"]:
        wanted = [dict(p, normal=root["axes"][2]) for s in root["strips"] if s["plane"] == plane["plane"] for p in s["pieces"]]
        found = [drawn(ezdxf, e) for e in by_layer.get(f"SLICE_{plane['plane']:04}", [])]
        wrong += abs(len(found) - len(wanted))
        for curve in wanted:
            curve = dict(curve, center=curve.get("centre"))
            same = [apart(points, curve) for kind, points in found if kind == curve["type"] and len(points) > 1]
            wrong += not same
            worst = max([worst] + ([min(same)] if same else []))
    closed = sum(e.closed for e in parts if e.dxftype() == "LWPOLYLINE")
    rings = sum(s["closed"] and all(p["type"] in ("line", "arc") for p in s["pieces"]) for s in root["strips"])
    return not faults and not wrong and worst < NEAR and closed == rings, text(parts, wrong, worst, faults)


def text(entities, wrong, worst, faults):
    kinds = [e.dxftype() for e in entities]
    counts = ", ".join(f"{kinds.count(k)} {k}" for k in sorted(set(kinds)))
    return f"{counts}; {wrong} of another type, at most {worst:.1e} apart; audit: {faults or 'clean'}"


def read_step(path):
    """The shape of a file as Open CASCADE reads it, and what it says of it."""
    from OCP import IFSelect, STEPControl
    reader = STEPControl.STEPControl_Reader()
    if reader.ReadFile(path) != IFSelect.IFSelect_RetDone or not reader.TransferRoots():
        return None, ["it is not read"]
    session = reader.WS()
    said = []
    for checks in (session.ModelCheckList(False), session.TransferReader().LastCheckList()):
        checks.Start()
        while checks.More():
            check = checks.Value()
            said += [check.CFail(i + 1) for i in range(check.NbFails())] + [check.CWarning(i + 1) for i in range(check.NbWarnings())]
            checks.Next()
    return reader.OneShape(), said


def parts(shape, kind):
    """The parts of a shape of a kind, each once."""
    from OCP import TopAbs, TopExp, TopoDS
    explorer = TopExp.TopExp_Explorer(shape, getattr(TopAbs, f"TopAbs_{kind.upper()}"))
    found = []
    while explorer.More():
        part = getattr(TopoDS.TopoDS, kind.capitalize())(explorer.Current())
        if not any(part.IsSame(other) for other in found):
            found.append(part)
        explorer.Next()
    return found


def wireframe(_, path):
    from OCP import BRepAdaptor
    shape, said = read_step(path)
    curves = [c for s in json.load(open(path.replace(".step", ".json")))["strips"] for c in s["curves"]]
    names = {"Line": ("line",), "Circle": ("arc", "circle"), "Ellipse": ("ellipse",), "BSplineCurve": ("b-spline",)}
    wrong, worst = 0, 0.0
    edges = parts(shape, "edge")
    for edge, curve in zip(edges, curves):
        adaptor = BRepAdaptor.BRepAdaptor_Curve(edge)
        kind = str(adaptor.GetType()).split("GeomAbs_")[-1]
        if curve["type"] not in names.get(kind, ()):
            wrong += 1
            continue
        low, high = adaptor.FirstParameter(), adaptor.LastParameter()
        places = [adaptor.Value(low + (high - low) * k / 32) for k in range(33)]
        points = np.array([(p.X(), p.Y(), p.Z()) for p in places])
        if kind == "Circle" and curve.get("sweep_deg", 360) == 360:
            curve = dict(curve, type="circle")
        worst = max(worst, apart(points, curve))
    wrong += abs(len(edges) - len(curves))
    good = not said and not wrong and worst < NEAR
    return good, f"{len(edges)} curves; {wrong} of another type, at most {worst:.1e} apart; said: {said or 'nothing'}"


def solid(_, path):
    from OCP import BRep, BRepCheck, BRepGProp, GProp
    shape, said = read_step(path)
    faces, shells, solids = (parts(shape, kind) for kind in ("face", "shell", "solid"))
    valid = BRepCheck.BRepCheck_Analyzer(shape).IsValid()
    closed = [BRep.BRep_Tool.IsClosed_s(shell) for shell in shells]
    properties = GProp.GProp_GProps()
    BRepGProp.BRepGProp.VolumeProperties_s(shape, properties)
    volume = properties.Mass()
    gap = max((BRep.BRep_Tool.Tolerance_s(edge) for edge in parts(shape, "edge")), default=0.0)
    good = not said and valid and closed == [True] and len(solids) == 1 and volume > 0
    return good, (f"{len(faces)} faces, {'valid' if valid else 'not valid'}; shells closed: {closed}; volume {volume:.6g}; gaps up to "
                  f"{gap:.1e}; said: {said or 'nothing'}")


CHECKS = [("*.dxf", "ezdxf"), ("*.step", "OCP")]


def check_of(path):
    if path.endswith(".step"):
        return solid if ".solid." in path else wireframe
    return sections if ".sections." in path else network


def main():
    good = True
    for pattern, module in CHECKS:
        try:
            module = importlib.import_module(module)
        except ImportError:
            print(f"skip {pattern}: {module} is not installed")
            continue
        for path in sorted(glob.glob(f"{sys.argv[1]}/{pattern}")):
            ok, row = check_of(path)(module, path)
            print(f"{'ok  ' if ok else 'BAD '} {path.split('/')[-1]} in {module.__name__}: {row}")
            good &= bool(ok)
    sys.exit(not good)


main()
