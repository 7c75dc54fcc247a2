"""Types of the keyword arguments. Made by ``make_keywords.py`` from the table of parameters."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal, TypedDict


class Parameters(TypedDict, total=False):
    """Parameters of the lines, the classes and the patches."""

    method: Literal["auto", "penalty", "gumhold", "projection", "tran", "segments", "demarsin"]
    """The method that finds the lines. (one of auto penalty (gumhold) projection (tran) segments (demarsin); default
    auto)"""
    neighbors_k: int
    """Nearest neighbours that a point is joined with in the Riemannian graph (Gumhold 2001, section 2.1: 10 to 16).
    (points; a whole number from 4 to 64; default 12)"""
    surface_clutter: Literal["auto", "leave-out", "keep"]
    """Points that lie on no surface, such as leaves, stray returns and veils between surfaces, and points in excess, in
    rows and where noise exceeds their spacing: `leave-out` has no line follow them, `keep` treats them as surface;
    auto: left out, but kept by the forms as printed. (one of auto leave-out keep; default auto)"""
    penalty_form: Literal["robust", "paper"]
    """`robust` measures curvature against the noise and a reference fold; `paper` is equations 4 to 9 as printed,
    normalised by the greatest curvature found, which a single outlier can spoil. (one of robust paper; default
    robust)"""
    penalty_hops: int | Literal["auto"]
    """Graph distance up to which points belong to a neighbourhood; auto: from the noise. (edges; auto or a whole number
    from 1 to 5; default auto)"""
    penalty_alpha: float | Literal["auto"]
    """Share of the curvature penalty in the crease weight, the rest being direction (0.5 without noise, 0.2 with much);
    auto: from the noise. (auto or a number from 0 to 1; default auto)"""
    penalty_candidate: float
    """Curvature penalty below which a point may lie on a crease (robust form only). (a number from 0 to 1; default
    0.75)"""
    penalty_opening_deg: float
    """Least open angle of a point on a border (robust form only). (degrees; a number from 0 to 360; default 72.0)"""
    penalty_opening_chance: float
    """Chance that a point within the surface shows its open angle by accident: the less, the wider an opening must be
    among few neighbours (robust form only). (a number from 0.000001 to 0.5; default 0.001)"""
    penalty_gamma: float
    """Share of the open angle in the border weight. (a number from 0 to 1; default 0.5)"""
    penalty_fold_deg: float
    """Fold angle between two faces at which a crease becomes one (robust form only). (degrees; a number from 1 to 120;
    default 25.0)"""
    penalty_noise_spacings: float | Literal["auto"]
    """Standard deviation of the noise along the surface normal; auto: estimated from the cloud. (spacings; auto or a
    number from 0 to 10; default auto)"""
    projection_jump: float
    """Rise of the projected distance from one neighbourhood size to the next that counts as the edge coming into sight
    (the paper's epsilon, section 2.3). (a number from 1 to 1000000; default 2.0)"""
    projection_floor_spacings: float | Literal["auto"]
    """Projected distance below which there is none to speak of, so that rounding and noise are neither a rise nor an
    edge; auto: from the noise. (spacings; auto or a number from 0 to 10; default auto)"""
    projection_bins: int
    """Bins of the histogram that Otsu's threshold is found on (section 2.4), over scores from 0 to 1. (bins; a whole
    number from 2 to 4096; default 256)"""
    projection_classes: int
    """Classes that Otsu's method parts the scores into: 3 also marks points within about a spacing of an edge, where
    they can be told and are not most of the cloud; 2, as in the paper, those on it. (classes; a whole number from 2 to
    3; default 3)"""
    edgelets_noise_spacings: float
    """Noise up to which they are looked for: with more, a cross-section of points within reach does not tell narrow
    faces. (spacings; a number from 0 to 10; default 0.4)"""
    edgelets_evidence: float
    """By how much two smooth pieces must describe a cross-section better than one. (variances; a number from 0 to
    1000000; default 9.0)"""
    edgelets_turn_deg: float
    """Least turn from one face to the other. (degrees; a number from 5 to 120; default 22.0)"""
    edgelets_apart_spacings: float
    """Distance between the points at which cross-sections are taken. (spacings; a number from 0 to 10; default 1.0)"""
    edgelets_agree: int
    """Cross-sections that must agree on a place. (a whole number from 1 to 100; default 3)"""
    edgelets_chain_spacings: float
    """Length that a chain of edgelets needs. (spacings; a number from 0 to 1000; default 5.0)"""
    edgelets_folds: bool
    """Whether the edges at which a mesh folds by `penalty.fold_deg` are creases, where the points are sampled on its
    faces. (true or false; default True)"""
    spanning_tau: float
    """Edges whose penalty share exceeds this are never part of a pattern. (a number from 0 to 2; default 1.0)"""
    spanning_rho: int | Literal["auto"]
    """Edges that a cycle needs to be kept, and twice those of a branch; auto: half the root of the number of points in
    the paper's form, a length of `loop_spacings` in the robust form. (edges; auto or a whole number from 3 to 1000000;
    default auto)"""
    spanning_loop_spacings: float
    """Length that a cycle needs to be kept, where `rho` is auto (robust form only). (spacings; a number from 1 to 1000;
    default 10.0)"""
    spanning_branch_spacings: float | Literal["auto"]
    """Depth that a branch of creases needs to be kept, where `rho` is auto (robust form only); auto: 2.5 without noise,
    5 from a noise of a tenth of the spacing on, which makes longer spurs. (spacings; auto or a number from 0.5 to 1000;
    default auto)"""
    spanning_openness_spacings: float
    """Least ratio of the area that a cycle encloses to its length: two strands of one band are no loop (robust form
    only). (spacings; a number from 0 to 100; default 0.9)"""
    spanning_creases: bool
    """Whether creases are looked for. (true or false; default True)"""
    spanning_borders: bool
    """Whether borders are looked for. (true or false; default True)"""
    repair_sharp_share: float
    """Share of the evidence of a sharp fold that a crease must show to stay: rounds show none. (a number from 0 to 1;
    default 0.4)"""
    repair_evidence: float
    """Evidence that a connected piece of creases, or a chain of edgelets, must show, since chance adds up to some
    twenty on noise. (variances; a number from 0 to 1000000; default 25.0)"""
    repair_piece_spacings: float
    """Length that a connected piece of lines needs to stay. (spacings; a number from 0 to 1000; default 5.0)"""
    repair_bridge_reach: float
    """How far loose ends are led on, as a multiple of the usual gaps: up to 10 spacings for creases, 16 for borders,
    the less, the more the ends look aside. (a number from 0 to 10; default 1.0)"""
    repair_corner_deg: float
    """Least turn of a strip that gets a corner. (degrees; a number from 5 to 85; default 45.0)"""
    repair_rung_spacings: float
    """Greatest length of a link between two lines that run beside each other, which is taken away. (spacings; a number
    from 0 to 100; default 5.0)"""
    segments_form: Literal["robust", "paper"]
    """`robust` segments by normals that keep to their side of a crease and closes lines by direction; `paper` is
    Demarsin's pipeline as printed, for clouds without noise. (one of robust paper; default robust)"""
    segments_angle_deg: float | Literal["auto"]
    """Greatest angle between the normals of adjacent points of one cluster (section 2.2); auto: 8, and with the robust
    form under noise up to twice that. (degrees; auto or a number from 0.1 to 60; default auto)"""
    segments_k: int
    """Nearest neighbours among which the one-ring is looked for (section 2.2). (points; a whole number from 6 to 64;
    default 20)"""
    segments_branch: int
    """Branches less deep are pruned (Algorithm 2, `d_max`; paper form). (edges; a whole number from 1 to 1000; default
    5)"""
    segments_connect: int | Literal["auto"]
    """Nearest vertices that an endpoint may be linked with (section 2.7, `n`; paper form); auto: from the graph.
    (vertices; auto or a whole number from 1 to 64; default auto)"""
    segments_cycle: int | Literal["auto"]
    """Linked endpoints have no path as short as this (section 2.7, `d`; paper form); auto: twice `branch`. (edges; auto
    or a whole number from 1 to 1000000; default auto)"""
    segments_face_points: int
    """Fewest points of a face (robust form). (points; a whole number from 1 to 1000000; default 12)"""
    segments_fold_score: float
    """Score above which a point belongs to a fold and not to a face (robust form). (a number from 0 to 1; default
    0.5)"""
    segments_extend_spacings: float
    """Gaps between small clusters of one pair of faces that are closed at once (section 2.4; robust form). (spacings; a
    number from 0 to 100; default 2.5)"""
    recover_wedge: Literal["none", "paper", "quadric"]
    """Where creases and corners are laid: `none`, on the spline through the pattern (the paper's simple solution);
    `paper`, where the planes through the points of their faces meet; `quadric`, the same without the points nearest the
    edge, and with quadrics where the faces bend: nearest to the truth under noise, but not yet on narrow faces. (one of
    none paper quadric; default none)"""
    recover_hops: int | Literal["auto"]
    """Graph distance up to which points beside a crease belong to its faces (the paper's table 1: 2 to 4); auto: one
    more than that of the penalties. (edges; auto or a whole number from 1 to 8; default auto)"""
    spline_span_spacings: float | Literal["auto"]
    """Length of strip for each span of the spline; auto: from the noise. (spacings; auto or a number from 0.5 to 1000;
    default auto)"""
    spline_smoothing: float
    """Weight of the curve's own smoothness, its squared second differences, against one point. (a number from 0.000001
    to 1000; default 0.1)"""
    spline_stub_spacings: float
    """Greatest length of a crease that hangs on a node with nothing at its other end, and is left out. (spacings; a
    number from 0 to 1000; default 3.0)"""
    spline_step_spacings: float
    """Distance between the points that a curve is written with. (spacings; a number from 0.01 to 100; default 0.5)"""
    relations_regularise: bool
    """Whether curves and nodes are moved, within what the noise allows, so that the relations hold exactly. (true or
    false; default False)"""
    relations_likelihood: float
    """Least probability of a relation, against chance. (a number from 0.5 to 1; default 0.7)"""
    patches_find: bool | Literal["auto"]
    """Whether the patches are found; auto: with the method `segments`. (auto or true or false; default auto)"""

class SectionParameters(TypedDict, total=False):
    """Parameters of sections, without `section_` before their names."""

    axis: str | float | Sequence[float]
    """The direction across the slices. `auto`: the axis that most of the surface stands along, lies across or is turned
    about; of several the one along which sections change least often, then the longest. `long`: the longest principal
    axis. `thin`: the principal axis for which slices project thinnest. (x, y, z, auto, long, thin or a vector X,Y,Z
    such as 1,0,1; default z)"""
    planes: str | float | Sequence[float]
    """Where the slices lie along the axis: so many, in the middles of equal parts; a step apart; at positions; or
    adaptive, so many parts at first, split where neighbours differ and merged where they are alike, up to the most
    (eight times as many unless told). Steps and positions are in the unit of the input. (count:N, step:LENGTH,
    at:Z1,Z2,.. or adaptive:N,MOST, of at most 100000 slices; default count:10)"""
    from_: Literal["origin", "lowest", "floor"]
    """The place that given positions of slices are counted from: `origin`, that of the input; `lowest`, the lowest
    point along the axis; `floor`, the lowest large face across it. (one of origin lowest floor; default origin)"""
    thickness: float | Literal["auto"]
    """Thickness of a slab; auto: `reach_spacings` to either side. (unit of the input; auto or a number above 0; default
    auto)"""
    clutter: Literal["auto", "leave-out", "keep"]
    """Points that lie on no surface: leaves, stray returns and veils between surfaces. `leave-out`, as auto, has no
    contour follow them; `keep` treats them as surface. (one of auto leave-out keep; default auto)"""
    reach_spacings: float
    """How far along the surface points are carried to the plane, from either side. (spacings; a number from 0.5 to 10;
    default 1.5)"""
    carry: bool
    """Whether points are carried to the plane along the surface, so that a slanted wall gives a thin band; else they
    are projected straight, as in the paper. (true or false; default True)"""
    link_spacings: float
    """Greatest length of a link between neighbouring places on a contour. (spacings; a number from 1 to 10; default
    2.4)"""
    bridge_spacings: float
    """Longest gap of a contour that is closed where samples lie all along it. (spacings; a number from 0 to 1000;
    default 30.0)"""
    stray_spacings: float
    """Least length of an open contour. (spacings; a number from 0 to 1000; default 4.0)"""
    outline: Literal["middle", "hull", "voronoi"]
    """How outlines are drawn: the middle of the band of points, the refined convex hull (section 3) or the largest
    empty circles (section 4). (one of middle hull voronoi; default middle)"""
    corner_deg: float
    """Least turn at a corner of an outline drawn through the middle, to which noise adds. (degrees; a number from 5 to
    120; default 25.0)"""
    region_spacings: float | Literal["auto"]
    """With `hull` and `voronoi`, the mean distance from the curve up to which the points of a region are near it (the
    paper's e); auto: from the thickness of the band. (spacings; auto or a number from 0 to 100; default auto)"""
    circle_bound: float
    """With `voronoi`, how far empty circles may lie from the curve, as a multiple of the greatest distance of the
    region's points from it (section 4): small for few feature points, large for many. (a number from 0.1 to 100;
    default 1.0)"""
    side: Literal["mid", "out", "in"]
    """Which side of a thick band closed outlines follow: its middle, the side away from what they enclose or the side
    towards it. (one of mid out in; default mid)"""
    beyond: float
    """Share of the points that the sides `out` and `in` leave beyond them. (a number from 0 to 0.5; default 0.1)"""
    axis_share: float
    """Share of the surface that the axis `auto` must explain. (a number from 0 to 1; default 0.4)"""
    alike_spacings: float | Literal["auto"]
    """Mean distance up to which neighbouring sections are alike, for adaptive planes; auto: from the noise. (spacings;
    auto or a number from 0 to 100; default auto)"""
    fit: bool
    """Whether lines, arcs, circles, ellipses and splines are fitted to the contours, and the stack of slices is read.
    (true or false; default False)"""
    tolerance: float | Literal["auto"]
    """Greatest distance of a fitted curve from its contour; auto: from the spacing and the noise. (unit of the input;
    auto or a number above 0; default auto)"""
    same_spacings: float | Literal["auto"]
    """Mean distance up to which the outlines of neighbouring slices are the same; auto: from the noise. (spacings; auto
    or a number from 0 to 100; default auto)"""
    missed: int
    """Slices in a row that a contour may be missing from, where open ones show most of it. (slices; a whole number from
    0 to 1000; default 6)"""
