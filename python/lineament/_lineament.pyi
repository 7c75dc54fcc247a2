"""The compiled part. The package alone calls it."""

from collections.abc import Callable, Sequence
from typing import Any, Final, Literal, TypedDict, final, type_check_only

import numpy as np
import numpy.typing as npt
from typing_extensions import Self

from lineament._evaluate import Truth
from lineament._network import Network, Provenance
from lineament._scan import Scan

__all__ = [
    "Cut",
    "Folds",
    "Found",
    "Las",
    "Typed",
    "VERSION",
    "clean",
    "detectors",
    "draw",
    "enrich",
    "evaluate",
    "extract",
    "graph",
    "main",
    "mark",
    "mesh",
    "parameters",
    "parameters_of",
    "png",
    "read",
    "read_mesh",
    "render",
    "sample",
    "samples",
    "section",
    "truth",
    "write_enriched",
    "write_graph",
    "write_mesh",
    "write_network",
    "write_picture",
    "write_points",
    "write_scan",
    "write_text",
]

VERSION: Final[str]

@type_check_only
class RawParameter(TypedDict):
    key: str
    default: str
    unit: str
    accepts: str
    doc: str

@type_check_only
class RawCurve(TypedDict):
    degree: int
    knots: npt.NDArray[np.float64]
    controls: npt.NDArray[np.float64]
    periodic: bool

@type_check_only
class RawTyped(TypedDict):
    typed: Typed
    kind: Literal["line", "arc", "circle", "ellipse", "b-spline"]
    start: npt.NDArray[np.float64]
    end: npt.NDArray[np.float64]
    first: int
    last: int
    deviation: float
    center: npt.NDArray[np.float64] | None
    normal: npt.NDArray[np.float64] | None
    radius: float | None
    major: npt.NDArray[np.float64] | None
    minor: float | None
    sweep_deg: float | None
    spline: RawCurve | None
    offset_sigma: float | None
    direction_sigma_deg: float | None
    radius_sigma: float | None
    normal_sigma_deg: float | None
    turn_sigma_deg: float | None
    covariance: npt.NDArray[np.float64] | None

@type_check_only
class RawNode(TypedDict):
    position: npt.NDArray[np.float64]
    kind: Literal["junction", "corner", "end", "apex"]
    degree: int
    source: int

@type_check_only
class RawStrip(TypedDict):
    kind: Literal["crease", "border", "rounded"]
    closed: bool
    start: int | None
    end: int | None
    points: npt.NDArray[np.float64]
    curve: RawCurve | None
    curves: list[RawTyped]
    sources: npt.NDArray[np.uint32]
    length: float
    deviation: float
    fold_deg: float | None
    evidence: float | None
    confidence: float
    radius: float | None
    radius_sigma: float | None

@type_check_only
class RawNetwork(TypedDict):
    nodes: list[RawNode]
    strips: list[RawStrip]

@type_check_only
class RawReport(TypedDict):
    read: int
    dropped: int
    merged: int
    points: int
    scattered: int
    stray: int
    thinned: int
    spacing: float
    noise: float
    stages: list[tuple[str, float]]
    settings: list[tuple[str, str]]
    used: list[tuple[str, str]]
    notes: list[str]

@type_check_only
class RawLoop(TypedDict):
    strips: list[tuple[int, bool]]
    closed: bool
    outer: bool

@type_check_only
class RawSurface(TypedDict):
    kind: Literal["plane", "sphere", "cylinder", "cone", "torus"]
    point: npt.NDArray[np.float64]
    axis: npt.NDArray[np.float64] | None
    radius: float | None
    minor_radius: float | None
    half_angle_deg: float | None
    residual: float
    free_form: bool

@type_check_only
class RawPatch(TypedDict):
    points: int
    area: float
    neighbors: list[int]
    loops: list[RawLoop]
    surface: RawSurface

@type_check_only
class RawSides(TypedDict):
    left: int | None
    right: int | None
    fold_deg: float | None
    convex: bool | None

@type_check_only
class RawPatches(TypedDict):
    patches: list[RawPatch]
    sides: list[RawSides]

@type_check_only
class RawMarks(TypedDict):
    classes: npt.NDArray[np.uint8]
    scores: npt.NDArray[np.float32]
    report: RawReport

@type_check_only
class RawCleaned(TypedDict):
    surface: npt.NDArray[np.uint32]
    clutter: npt.NDArray[np.uint32]
    report: RawReport

@type_check_only
class RawTruthNode(TypedDict):
    position: npt.NDArray[np.float64]
    kind: Literal["junction", "corner", "end", "apex"]
    degree: int

@type_check_only
class RawTruthCurve(TypedDict):
    kind: Literal["crease", "border"]
    closed: bool
    start: int | None
    end: int | None
    points: npt.NDArray[np.float64]
    fold_deg: npt.NDArray[np.float64]

@type_check_only
class RawTruth(TypedDict):
    nodes: list[RawTruthNode]
    curves: list[RawTruthCurve]
    weak_below_deg: float

@type_check_only
class RawScore(TypedDict):
    at_1h: tuple[float, float, float]
    at_2h: tuple[float, float, float]
    to_truth: tuple[float, float]
    from_truth: tuple[float, float]
    loops: tuple[int, int]
    curves_found: tuple[int, int]
    junctions_hit: tuple[int, int]
    length_spacings: float

@type_check_only
class RenderOptions(TypedDict):
    view: str
    up: Sequence[float]
    width: int
    height: int
    caption: bool
    style: str
    hidden: str
    color: str
    background: str
    scale_bar: bool
    unit: str | None
    alone: bool
    seen: bool

@type_check_only
class RawMeshFile(TypedDict):
    vertices: npt.NDArray[np.float64]
    triangles: npt.NDArray[np.uint32]
    warnings: list[str]

@type_check_only
class RawPiece(TypedDict):
    kind: Literal["line", "arc", "circle", "ellipse", "spline"]
    start: npt.NDArray[np.float64]
    end: npt.NDArray[np.float64]
    worst: float
    center: npt.NDArray[np.float64] | None
    radius: float | None
    major: npt.NDArray[np.float64] | None
    minor: float | None
    sweep_deg: float | None
    curve: RawCurve | None

@type_check_only
class RawContour(TypedDict):
    points: npt.NDArray[np.float64]
    corners: list[int]
    closed: bool
    parent: int | None
    depth: int
    area: float
    length: float
    draft_deg: float | None
    steepest_deg: float
    centroid: npt.NDArray[np.float64]
    pieces: list[RawPiece]

@type_check_only
class RawSection(TypedDict):
    plane: int
    height: float
    slab: tuple[float, float] | None
    points: int
    contours: list[RawContour]
    missing: str | None

@type_check_only
class RawRun(TypedDict):
    kind: Literal["extrusion", "taper", "revolution"]
    hole: bool
    start: float
    end: float
    range_error: tuple[float, float]
    residual: float
    center: npt.NDArray[np.float64]
    contours: list[tuple[int, int]]
    radius: float | None
    greatest_radius: float | None
    angle_deg: float | None
    apex: float | None

@type_check_only
class RawMirror(TypedDict):
    point: npt.NDArray[np.float64]
    normal: npt.NDArray[np.float64]
    planes: int
    residual: float

@type_check_only
class RawRepeat(TypedDict):
    runs: list[int]
    residual: float

@type_check_only
class RawStack(TypedDict):
    runs: list[RawRun]
    mirrors: list[RawMirror]
    repeats: list[RawRepeat]

@type_check_only
class RawSections(TypedDict):
    cut: Cut
    axes: npt.NDArray[np.float64]
    counted_from: Literal["origin", "lowest", "floor"]
    zero: float
    heights: npt.NDArray[np.float64]
    spacing: float
    noise: float
    dropped: int
    merged: int
    clutter: int
    sections: list[RawSection]
    stack: RawStack

@type_check_only
class ReadOptions(TypedDict):
    bounds: list[list[float]] | None
    every: int | None
    voxel: float | None
    classes: list[int]
    returns: str | None
    scan: int | None
    format: str | None
    vertices: bool
    samples: int | None
    memory: int | None
    salvage: bool
    attributes: bool
    hash: bool

@type_check_only
class RawScan(TypedDict):
    points: npt.NDArray[np.float64]
    attributes: list[tuple[str, npt.NDArray[Any]]]
    format: str
    ignored: list[str]
    warnings: list[str]
    missing: str | None
    beside: list[str]
    crs: str | None
    epsg: int | None
    crs_wkt: str | None
    las: Las | None
    sha256: str | None
    sampled: tuple[int, float] | None
    folds: Folds | None
    bytes: int

@type_check_only
class RawRelation(TypedDict):
    kind: Literal["parallel", "perpendicular", "coplanar", "coaxial", "concentric", "equal-radius", "tangent", "symmetric"]
    members: list[tuple[int, int]]
    others: list[tuple[int, int]]
    likelihood: float
    deviation: float | None
    deviation_deg: float | None
    direction: npt.NDArray[np.float64] | None
    point: npt.NDArray[np.float64] | None
    radius: float | None
    imposed: bool

@type_check_only
class RawRegularised(TypedDict):
    nodes: npt.NDArray[np.float64]
    curves: list[npt.NDArray[np.float64]]
    released: list[tuple[int, int]]

@type_check_only
class RawExtraction(TypedDict):
    found: Found
    network: RawNetwork
    classes: npt.NDArray[np.uint8]
    scores: npt.NDArray[np.float32]
    clutter: npt.NDArray[np.uint32]
    labels: npt.NDArray[np.int32] | None
    patches: RawPatches | None
    relations: list[RawRelation]
    regularised: RawRegularised | None
    report: RawReport

@type_check_only
class RawGraph(TypedDict):
    extraction: RawExtraction
    edges: npt.NDArray[np.uint32]
    cut: npt.NDArray[np.uint32]

@type_check_only
class RawEnriched(TypedDict):
    extraction: RawExtraction
    points: npt.NDArray[np.float64]
    kinds: npt.NDArray[np.uint8]
    sources: npt.NDArray[np.uint32]

@type_check_only
class RawMesh(TypedDict):
    extraction: RawExtraction
    vertices: npt.NDArray[np.float64]
    kinds: npt.NDArray[np.uint8]
    triangles: npt.NDArray[np.uint32]
    open_edges: int

@final
class Found:
    def __new__(cls, state: bytes) -> Self: ...
    def __getnewargs__(self) -> tuple[bytes]: ...
    def write(
        self,
        path: str,
        scan: Scan,
        provenance: Provenance,
        marks: tuple[npt.NDArray[np.uint8], npt.NDArray[np.int32] | None],
        drawing: tuple[str, float | None, str | None],
    ) -> None: ...
    def write_patches(
        self,
        path: str,
        scan: Scan,
        provenance: Provenance,
        labels: npt.NDArray[np.int32],
        classes: npt.NDArray[np.uint8],
        unit: str | None,
    ) -> None: ...

@final
class Cut:
    def __new__(cls, state: bytes) -> Self: ...
    def __getnewargs__(self) -> tuple[bytes]: ...
    def write(
        self, path: str, scan: Scan, provenance: Provenance, millimetres: float | None, unit: str | None
    ) -> None: ...

@final
class Las:
    def __new__(cls, state: bytes) -> Self: ...
    def __getnewargs__(self) -> tuple[bytes]: ...

@final
class Folds:
    def __new__(cls, state: bytes) -> Self: ...
    def __getnewargs__(self) -> tuple[bytes]: ...
    def __len__(self) -> int: ...

@final
class Typed:
    def __new__(cls, state: bytes) -> Self: ...
    def __getnewargs__(self) -> tuple[bytes]: ...

def extract(
    points: npt.NDArray[np.float64],
    settings: Sequence[tuple[str, str]],
    progress: Callable[[str, float], object] | None = None,
    folds: Folds | None = None,
) -> RawExtraction: ...
def graph(
    points: npt.NDArray[np.float64],
    settings: Sequence[tuple[str, str]],
    kind: str,
    progress: Callable[[str, float], object] | None = None,
    folds: Folds | None = None,
) -> RawGraph: ...
def enrich(
    points: npt.NDArray[np.float64],
    settings: Sequence[tuple[str, str]],
    step: float,
    progress: Callable[[str, float], object] | None = None,
    folds: Folds | None = None,
) -> RawEnriched: ...
def mesh(
    points: npt.NDArray[np.float64],
    settings: Sequence[tuple[str, str]],
    step: float | None,
    lines: bool,
    progress: Callable[[str, float], object] | None = None,
    folds: Folds | None = None,
) -> RawMesh: ...
def write_graph(
    path: str,
    scan: Scan,
    provenance: Provenance,
    edges: npt.NDArray[np.uint32],
    cut: npt.NDArray[np.uint32],
    all: bool,
) -> None: ...
def write_enriched(
    path: str,
    scan: Scan,
    classes: npt.NDArray[np.uint8],
    added: tuple[npt.NDArray[np.float64], npt.NDArray[np.uint8], npt.NDArray[np.uint32]],
    only: bool,
) -> None: ...
def write_mesh(
    path: str,
    inputs: Sequence[str],
    vertices: npt.NDArray[np.float64],
    kinds: npt.NDArray[np.uint8],
    triangles: npt.NDArray[np.uint32],
) -> None: ...
def sample(name: str, seed: int) -> npt.NDArray[np.float64] | None: ...
def samples() -> list[tuple[str, str]]: ...
def section(
    points: npt.NDArray[np.float64],
    settings: Sequence[tuple[str, str]],
    progress: Callable[[str, float], object] | None = None,
) -> RawSections: ...
def clean(
    points: npt.NDArray[np.float64],
    settings: Sequence[tuple[str, str]],
    progress: Callable[[str, float], object] | None = None,
) -> RawCleaned: ...
def write_scan(path: str, scan: Scan, clutter: npt.NDArray[np.uint32] | None) -> None: ...
def render(
    points: npt.NDArray[np.float64],
    network: Network | None,
    mesh: tuple[npt.NDArray[np.float64], npt.NDArray[np.uint32]] | None,
    tints: npt.NDArray[Any] | None,
    options: RenderOptions,
) -> tuple[npt.NDArray[np.uint8], str | None]: ...
def read_mesh(path: str) -> RawMeshFile: ...
def png(picture: npt.NDArray[np.uint8]) -> bytes: ...
def write_picture(path: str, inputs: Sequence[str], picture: npt.NDArray[np.uint8]) -> None: ...
def write_text(path: str, inputs: Sequence[str], text: str) -> None: ...
def truth(name: str, seed: int) -> RawTruth | None: ...
def evaluate(network: Network, truth: Truth | str, spacing: float) -> RawScore: ...
def detectors() -> list[str]: ...
def mark(
    points: npt.NDArray[np.float64],
    settings: Sequence[tuple[str, str]],
    detector: str,
    progress: Callable[[str, float], object] | None = None,
) -> RawMarks: ...
def read(path: str, options: ReadOptions) -> RawScan: ...
def write_points(
    path: str,
    scan: Scan,
    classes: npt.NDArray[np.uint8],
    scores: npt.NDArray[np.float32],
    network: Network | None,
) -> None: ...
def parameters() -> list[RawParameter]: ...
def parameters_of(path: str) -> list[tuple[str, str]]: ...
def write_network(
    path: str,
    inputs: Sequence[str],
    network: Network,
    provenance: Provenance,
    drawing: tuple[str, float | None, str | None],
) -> None: ...
def draw(network: Network, provenance: Provenance, view: str, millimetres: float | None) -> str: ...
def main(words: Sequence[str]) -> int: ...
