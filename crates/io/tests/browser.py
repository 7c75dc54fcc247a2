#!/usr/bin/env python3
"""Opens a.svg and a.glb of a folder in a browser and looks whether its lines are drawn where a.csv says that they are:
browser.py FOLDER, with the browser in LINEAMENT_BROWSER and a folder `node_modules` with three and gltf-validator in
LINEAMENT_NODE; what is missing is skipped, saying so. Prints a row a check; ends with 1 if one fails."""
import csv, functools, http.server, json, os, subprocess, sys, threading
import numpy as np

SIDE = 800
# CSS pixels of a millimetre; margin and longest side of a drawing in millimetres.
DOT, MARGIN, LONGEST = 96 / 25.4, 5, 200

PAGE = """<!doctype html><style>body{margin:0}canvas{display:block}</style>
<script type="importmap">{"imports":{"three":"/node_modules/three/build/three.module.js"}}</script>
<script type="module">
import * as THREE from "three";
import { GLTFLoader } from "/node_modules/three/examples/jsm/loaders/GLTFLoader.js";
const [middle, half] = [%s, %s];
const renderer = new THREE.WebGLRenderer({ preserveDrawingBuffer: true });
renderer.setSize(%d, %d);
document.body.append(renderer.domElement);
const scene = new THREE.Scene();
scene.background = new THREE.Color("white");
scene.add((await new GLTFLoader().loadAsync("/a.glb")).scene);
const camera = new THREE.OrthographicCamera(-half, half, half, -half, 1, 100);
// y is up in the file, so that a view from above looks along -y, and north is -z.
camera.position.set(middle[0], middle[2] + 50, -middle[1]);
camera.up.set(0, 0, -1);
camera.lookAt(middle[0], middle[2], -middle[1]);
renderer.render(scene, camera);
</script>"""


def strips(folder):
    """Kind and points of every strip; the first point of a loop stands at its end again."""
    found = {}
    for row in csv.DictReader(open(os.path.join(folder, "a.csv"))):
        kind, closed, points = found.setdefault(row["strip"], (row["kind"], row["closed"] == "1", []))
        points.append([float(row[axis]) for axis in "xyz"])
    return [(kind, np.array(points + points[:1] if closed else points)) for kind, closed, points in found.values()]


def samples(lines, place):
    """Pixels along every line, half a pixel apart: kind and (N, 2)."""
    for kind, points in lines:
        flat = place(points)
        parts = []
        for a, b in zip(flat[:-1], flat[1:]):
            count = max(2, int(2 * np.hypot(*(b - a))))
            parts.append(a + np.linspace(0, 1, count)[:, None] * (b - a))
        yield kind, np.concatenate(parts)


def shot(browser, url, out, width, height):
    command = [browser, "--headless", "--no-sandbox", "--hide-scrollbars", "--force-device-scale-factor=1",
               "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--virtual-time-budget=20000",
               f"--window-size={width},{height}", f"--screenshot={out}", url]
    run = subprocess.run(command, capture_output=True, text=True, timeout=180)
    if not os.path.exists(out):
        return None, run.stderr[-2000:]
    from PIL import Image
    return np.asarray(Image.open(out).convert("RGB")).astype(int), ""


def drawn(image, lines):
    """How much of the lines has ink within a pixel, and how much of the ink lies on lines; both with the right colour."""
    ink = (image < 200).any(axis=2)
    near = np.zeros_like(ink)
    hits, total = 0, 0
    for kind, pixels in lines:
        x, y = np.floor(pixels).astype(int).T
        found = np.zeros(len(x), bool)
        for dx in (-1, 0, 1):
            for dy in (-1, 0, 1):
                here = image[np.clip(y + dy, 0, image.shape[0] - 1), np.clip(x + dx, 0, image.shape[1] - 1)]
                red, blue = here[:, 0], here[:, 2]
                found |= (here.min(axis=1) < 200) & ((red > blue) if kind == "crease" else (blue > red))
        hits, total = hits + found.sum(), total + len(found)
        for dx in range(-4, 5):
            for dy in range(-4, 5):
                near[np.clip(y + dy, 0, image.shape[0] - 1), np.clip(x + dx, 0, image.shape[1] - 1)] = True
    return hits / total, (ink & near).sum() / max(1, ink.sum())


def verdict(name, image, fault, lines):
    if image is None:
        return False, f"{name}: no picture: {fault}"
    covered, clean = drawn(image, lines)
    return covered > .97 and clean > .99, f"{name}: {covered:.1%} of the lines drawn, {clean:.1%} of the ink on them"


def svg(folder, browser, lines):
    every = np.concatenate([points for _, points in lines])
    low, high = every.min(0), every.max(0)
    scale = LONGEST / (high - low)[:2].max()
    place = lambda p: DOT * (MARGIN + scale * np.stack([p[:, 0] - low[0], high[1] - p[:, 1]], 1))
    url = "file://" + os.path.abspath(os.path.join(folder, "a.svg"))
    image, fault = shot(browser, url, os.path.join(folder, "svg.png"), SIDE + 20, SIDE + 20)
    return verdict("a.svg", image, fault, list(samples(lines, place)))


class Server(http.server.SimpleHTTPRequestHandler):
    modules = None

    def translate_path(self, path):
        root = self.modules if path.startswith("/node_modules/") else self.directory
        return os.path.join(root, path.split("?")[0].lstrip("/"))

    def log_message(self, *_):
        pass


def glb(folder, browser, modules, lines):
    every = np.concatenate([points for _, points in lines])
    low, high = every.min(0), every.max(0)
    middle, half = (low + high) / 2, .55 * (high - low)[:2].max()
    with open(os.path.join(folder, "page.html"), "w") as page:
        page.write(PAGE % (json.dumps(middle.tolist()), half, SIDE, SIDE))
    Server.modules = modules
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Server, directory=folder))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    url = f"http://127.0.0.1:{server.server_port}/page.html"
    image, fault = shot(browser, url, os.path.join(folder, "glb.png"), SIDE, SIDE + 100)
    server.shutdown()
    place = lambda p: SIDE / 2 * (1 + np.stack([p[:, 0] - middle[0], middle[1] - p[:, 1]], 1) / half)
    image = None if image is None else image[:SIDE]
    return verdict("a.glb in three.js", image, fault, list(samples(lines, place)))


def valid(folder, modules):
    """Whether the validator of the format finds no fault."""
    script = """const v = require('gltf-validator'), fs = require('fs');
v.validateBytes(new Uint8Array(fs.readFileSync(process.argv[1]))).then(r => console.log(JSON.stringify(r.issues)))"""
    good, texts = True, []
    for name in ("a.glb", "empty.glb"):
        run = subprocess.run(["node", "-e", script, os.path.join(folder, name)], capture_output=True, text=True,
                             env=dict(os.environ, NODE_PATH=modules))
        if run.returncode:
            return False, f"gltf-validator: {run.stderr[-500:]}"
        issues = json.loads(run.stdout)
        good &= issues["numErrors"] == 0 and issues["numWarnings"] == 0
        texts.append(f"{name} {issues['numErrors']} errors, {issues['numWarnings']} warnings")
        texts += [f"{m['code']} at {m.get('pointer')}" for m in issues["messages"] if m["severity"] < 2]
    return good, "gltf-validator: " + "; ".join(texts)


def main():
    folder = sys.argv[1]
    browser, root = os.environ.get("LINEAMENT_BROWSER"), os.environ.get("LINEAMENT_NODE")
    modules = root and os.path.abspath(root)
    lines = strips(folder)
    checks = []
    if browser:
        checks.append(svg(folder, browser, lines))
    else:
        print("skip a.svg and a.glb in a browser: there is none")
    if browser and root:
        checks.append(glb(folder, browser, os.path.dirname(modules), lines))
    if root:
        checks.append(valid(folder, modules))
    else:
        print("skip three.js and gltf-validator: npm cannot install them")
    for good, text in checks:
        print(f"{'ok  ' if good else 'BAD '} {text}")
    sys.exit(not all(good for good, _ in checks))


main()
