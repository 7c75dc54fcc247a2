"""Feature lines from point clouds: creases, borders, corners and sections as ordered curves.

>>> import lineament
>>> found = lineament.extract(points)                           # (N, 3) points of any kind
>>> [strip.points for strip in found.network.strips]            # (M, 3) each
>>> found.write("part.dxf")

No parameter needs to be set. Lines are in the frame and unit of the points; parameters that are lengths are in spacings of the
cloud, angles in degrees. ``python -m lineament`` is the program.
"""

from __future__ import annotations

from lineament._errors import (
    CloudError,
    InputError,
    InputNotFoundError,
    InternalError,
    LineamentError,
    OutputError,
    ParameterError,
)
from lineament._classify import Classification, classify
from lineament._clean import Cleaned, clean
from lineament._enrich import Enriched, enrich
from lineament._evaluate import Distances, Found, Hits, Score, Truth, TruthCurve, TruthNode, evaluate, truth
from lineament._extraction import Extraction, Progress, extract, patches
from lineament._graph import Graph, graph
from lineament._lineament import VERSION as __version__
from lineament._curves import BSpline, Curve
from lineament._mesh import Mesh, mesh
from lineament._network import Network, Node, Provenance, Strip
from lineament._parameters import Parameter, ParamsLike, parameters
from lineament._patches import Loop, Patch, Patches, Sides, Surface
from lineament._points import PointsLike
from lineament._relations import Regularised, Relation
from lineament._render import Picture, render
from lineament._report import PointClass, Report
from lineament._samples import sample, samples
from lineament._scan import Scan, read
from lineament._section import Contour, Piece, Section, Sections, section
from lineament._stack import Mirror, Repeat, Run, Stack
from lineament._write import write

__all__ = [
    "BSpline",
    "Classification",
    "Cleaned",
    "CloudError",
    "Contour",
    "Curve",
    "Distances",
    "Enriched",
    "Extraction",
    "Found",
    "Graph",
    "Hits",
    "InputError",
    "InputNotFoundError",
    "InternalError",
    "LineamentError",
    "Loop",
    "Mesh",
    "Mirror",
    "Network",
    "Node",
    "OutputError",
    "Parameter",
    "ParameterError",
    "ParamsLike",
    "Patch",
    "Patches",
    "Picture",
    "Piece",
    "PointClass",
    "PointsLike",
    "Progress",
    "Provenance",
    "Regularised",
    "Relation",
    "Repeat",
    "Report",
    "Run",
    "Scan",
    "Score",
    "Section",
    "Sections",
    "Sides",
    "Stack",
    "Strip",
    "Surface",
    "Truth",
    "TruthCurve",
    "TruthNode",
    "__version__",
    "classify",
    "clean",
    "enrich",
    "evaluate",
    "extract",
    "graph",
    "mesh",
    "parameters",
    "patches",
    "read",
    "render",
    "sample",
    "samples",
    "section",
    "truth",
    "write",
]
