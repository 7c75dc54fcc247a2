//! All parameters, with their defaults, units and ranges in one place.
//!
//! The program's `--set key=value`, its parameter files and its help, and every other front end, read this table: a default
//! stands nowhere else. Lengths are in spacings of the cloud, angles in degrees.

pub(crate) mod section;
mod table;
mod value;

pub use table::Entry;
pub(crate) use value::choices;
pub use value::{Auto, ParamValue};

use crate::Error;
use section::{Axis, Outline, Planes, Side, Zero};
use table::sections;
use value::ABOVE_0;

sections! {
    /// Every parameter of the pipeline. `Params::default()` needs no change for any cloud.
    pub struct Params;

    /// The graph that says which points lie beside each other.
    neighbors: NeighborParams {
        /// Nearest neighbours that a point is joined with in the Riemannian graph (Gumhold 2001, section 2.1: 10 to 16).
        k: usize = 12, "points", 4.0..=64.0;
    }

    /// Surface and clutter.
    surface: SurfaceParams {
        /// Points that lie on no surface, such as leaves, stray returns and veils between surfaces, and points in excess, in rows and where
        /// noise exceeds their spacing: `leave-out` has no line follow them, `keep` treats them as surface; auto: left out, but kept by the
        /// forms as printed.
        clutter: Clutter = Clutter::Auto, "", 0.0..=0.0;
    }

    /// Gumhold's penalty functions (Gumhold 2001, section 3.1).
    penalty: PenaltyParams {
        /// `robust` measures curvature against the noise and a reference fold; `paper` is equations 4 to 9 as printed,
        /// normalised by the greatest curvature found, which a single outlier can spoil.
        form: PenaltyForm = PenaltyForm::Robust, "", 0.0..=0.0;
        /// Graph distance up to which points belong to a neighbourhood; auto: from the noise.
        hops: Auto<usize> = Auto::Auto, "edges", 1.0..=5.0;
        /// Share of the curvature penalty in the crease weight, the rest being direction (0.5 without noise, 0.2 with
        /// much); auto: from the noise.
        alpha: Auto<f64> = Auto::Auto, "", 0.0..=1.0;
        /// Curvature penalty below which a point may lie on a crease (robust form only).
        candidate: f64 = 0.75, "", 0.0..=1.0;
        /// Least open angle of a point on a border (robust form only).
        opening_deg: f64 = 72.0, "degrees", 0.0..=360.0;
        /// Chance that a point within the surface shows its open angle by accident: the less, the wider an opening must be
        /// among few neighbours (robust form only).
        opening_chance: f64 = 0.001, "", 0.000001..=0.5;
        /// Share of the open angle in the border weight.
        gamma: f64 = 0.5, "", 0.0..=1.0;
        /// Fold angle between two faces at which a crease becomes one (robust form only).
        fold_deg: f64 = 25.0, "degrees", 1.0..=120.0;
        /// Standard deviation of the noise along the surface normal; auto: estimated from the cloud.
        noise_spacings: Auto<f64> = Auto::Auto, "spacings", 0.0..=10.0;
    }

    /// The projected distance at each point's best scale (Tran 2013); the line's direction and foot follow `penalty`.
    projection: ProjectionParams {
        /// Rise of the projected distance from one neighbourhood size to the next that counts as the edge coming into
        /// sight (the paper's epsilon, section 2.3).
        jump: f64 = 2.0, "", 1.0..=1000000.0;
        /// Projected distance below which there is none to speak of, so that rounding and noise are neither a rise nor an
        /// edge; auto: from the noise.
        floor_spacings: Auto<f64> = Auto::Auto, "spacings", 0.0..=10.0;
        /// Bins of the histogram that Otsu's threshold is found on (section 2.4), over scores from 0 to 1.
        bins: usize = 256, "bins", 2.0..=4096.0;
        /// Classes that Otsu's method parts the scores into: 3 also marks points within about a spacing of an edge, where
        /// they can be told and are not most of the cloud; 2, as in the paper, those on it.
        classes: usize = 3, "classes", 2.0..=3.0;
    }

    /// Edgelets, short pieces of crease from cross-sections of the surface: ours; used by the method `auto`.
    edgelets: EdgeletParams {
        /// Noise up to which they are looked for: with more, a cross-section of points within reach does not tell narrow faces.
        noise_spacings: f64 = 0.4, "spacings", 0.0..=10.0;
        /// By how much two smooth pieces must describe a cross-section better than one.
        evidence: f64 = 9.0, "variances", 0.0..=1000000.0;
        /// Least turn from one face to the other.
        turn_deg: f64 = 22.0, "degrees", 5.0..=120.0;
        /// Distance between the points at which cross-sections are taken.
        apart_spacings: f64 = 1.0, "spacings", 0.0..=10.0;
        /// Cross-sections that must agree on a place.
        agree: usize = 3, "", 1.0..=100.0;
        /// Length that a chain of edgelets needs.
        chain_spacings: f64 = 5.0, "spacings", 0.0..=1000.0;
        /// Whether the edges at which a mesh folds by `penalty.fold_deg` are creases, where the points are sampled on its faces.
        folds: bool = true, "", 0.0..=0.0;
    }

    /// The minimum spanning graph and its pruning (Gumhold 2001, sections 3.2 and 3.3).
    spanning: SpanningParams {
        /// Edges whose penalty share exceeds this are never part of a pattern.
        tau: f64 = 1.0, "", 0.0..=2.0;
        /// Edges that a cycle needs to be kept, and twice those of a branch; auto: half the root of the number of points in the
        /// paper's form, a length of `loop_spacings` in the robust form.
        rho: Auto<usize> = Auto::Auto, "edges", 3.0..=1000000.0;
        /// Length that a cycle needs to be kept, where `rho` is auto (robust form only).
        loop_spacings: f64 = 10.0, "spacings", 1.0..=1000.0;
        /// Depth that a branch of creases needs to be kept, where `rho` is auto (robust form only); auto: 2.5 without noise, 5 from a
        /// noise of a tenth of the spacing on, which makes longer spurs.
        branch_spacings: Auto<f64> = Auto::Auto, "spacings", 0.5..=1000.0;
        /// Least ratio of the area that a cycle encloses to its length: two strands of one band are no loop (robust form only).
        openness_spacings: f64 = 0.9, "spacings", 0.0..=100.0;
        /// Whether creases are looked for.
        creases: bool = true, "", 0.0..=0.0;
        /// Whether borders are looked for.
        borders: bool = true, "", 0.0..=0.0;
    }

    /// The repair of lines after pruning, in the robust forms: ours.
    repair: RepairParams {
        /// Share of the evidence of a sharp fold that a crease must show to stay: rounds show none.
        sharp_share: f64 = 0.4, "", 0.0..=1.0;
        /// Evidence that a connected piece of creases, or a chain of edgelets, must show, since chance adds up to some twenty on noise.
        evidence: f64 = 25.0, "variances", 0.0..=1000000.0;
        /// Length that a connected piece of lines needs to stay.
        piece_spacings: f64 = 5.0, "spacings", 0.0..=1000.0;
        /// How far loose ends are led on, as a multiple of the usual gaps: up to 10 spacings for creases, 16 for borders, the
        /// less, the more the ends look aside.
        bridge_reach: f64 = 1.0, "", 0.0..=10.0;
        /// Least turn of a strip that gets a corner.
        corner_deg: f64 = 45.0, "degrees", 5.0..=85.0;
        /// Greatest length of a link between two lines that run beside each other, which is taken away.
        rung_spacings: f64 = 5.0, "spacings", 0.0..=100.0;
    }

    /// Demarsin's segmentation and graph of clusters (Demarsin et al. 2007); used by the method `segments`.
    segments: SegmentParams {
        /// `robust` segments by normals that keep to their side of a crease and closes lines by direction; `paper` is
        /// Demarsin's pipeline as printed, for clouds without noise.
        form: SegmentForm = SegmentForm::Robust, "", 0.0..=0.0;
        /// Greatest angle between the normals of adjacent points of one cluster (section 2.2); auto: 8, and with the robust
        /// form under noise up to twice that.
        angle_deg: Auto<f64> = Auto::Auto, "degrees", 0.1..=60.0;
        /// Nearest neighbours among which the one-ring is looked for (section 2.2).
        k: usize = 20, "points", 6.0..=64.0;
        /// Branches less deep are pruned (Algorithm 2, `d_max`; paper form).
        branch: usize = 5, "edges", 1.0..=1000.0;
        /// Nearest vertices that an endpoint may be linked with (section 2.7, `n`; paper form); auto: from the graph.
        connect: Auto<usize> = Auto::Auto, "vertices", 1.0..=64.0;
        /// Linked endpoints have no path as short as this (section 2.7, `d`; paper form); auto: twice `branch`.
        cycle: Auto<usize> = Auto::Auto, "edges", 1.0..=1000000.0;
        /// Fewest points of a face (robust form).
        face_points: usize = 12, "points", 1.0..=1000000.0;
        /// Score above which a point belongs to a fold and not to a face (robust form).
        fold_score: f64 = 0.5, "", 0.0..=1.0;
        /// Gaps between small clusters of one pair of faces that are closed at once (section 2.4; robust form).
        extend_spacings: f64 = 2.5, "spacings", 0.0..=100.0;
    }

    /// The recovery of creases and corners from their faces (Gumhold 2001, sections 4.1 and 4.2).
    recover: WedgeParams {
        /// Where creases and corners are laid: `none`, on the spline through the pattern (the paper's simple solution); `paper`, where the
        /// planes through the points of their faces meet; `quadric`, the same without the points nearest the edge, and with quadrics
        /// where the faces bend: nearest to the truth under noise, but not yet on narrow faces.
        wedge: WedgeForm = WedgeForm::None, "", 0.0..=0.0;
        /// Graph distance up to which points beside a crease belong to its faces (the paper's table 1: 2 to 4); auto: one more than
        /// that of the penalties.
        hops: Auto<usize> = Auto::Auto, "edges", 1.0..=8.0;
    }

    /// The curves fitted through the pattern (Gumhold 2001, section 4).
    spline: SplineParams {
        /// Length of strip for each span of the spline; auto: from the noise.
        span_spacings: Auto<f64> = Auto::Auto, "spacings", 0.5..=1000.0;
        /// Weight of the curve's own smoothness, its squared second differences, against one point.
        smoothing: f64 = 0.1, "", 0.000001..=1000.0;
        /// Greatest length of a crease that hangs on a node with nothing at its other end, and is left out.
        stub_spacings: f64 = 3.0, "spacings", 0.0..=1000.0;
        /// Distance between the points that a curve is written with.
        step_spacings: f64 = 0.5, "spacings", 0.01..=100.0;
    }

    /// Relations between the typed curves of the lines: parallel, perpendicular, coplanar, coaxial and others.
    relations: RelationParams {
        /// Whether curves and nodes are moved, within what the noise allows, so that the relations hold exactly.
        regularise: bool = false, "", 0.0..=0.0;
        /// Least probability of a relation, against chance.
        likelihood: f64 = 0.7, "", 0.5..=1.0;
    }

    /// The patches between the lines.
    patches: PatchParams {
        /// Whether the patches are found; auto: with the method `segments`.
        find: Auto<bool> = Auto::Auto, "", 0.0..=0.0;
    }

    /// Sections by slicing planes (Kyriazis et al. 2007).
    section: SectionParams {
        /// The direction across the slices. `auto`: the axis that most of the surface stands along, lies across or is turned
        /// about; of several the one along which sections change least often, then the longest. `long`: the longest principal
        /// axis. `thin`: the principal axis for which slices project thinnest.
        axis: Axis = Axis::Coordinate(2), "", 0.0..=0.0;
        /// Where the slices lie along the axis: so many, in the middles of equal parts; a step apart; at positions; or
        /// adaptive, so many parts at first, split where neighbours differ and merged where they are alike, up to the most
        /// (eight times as many unless told). Steps and positions are in the unit of the input.
        planes: Planes = Planes::Count(10), "", 0.0..=0.0;
        /// The place that given positions of slices are counted from: `origin`, that of the input; `lowest`, the lowest point along
        /// the axis; `floor`, the lowest large face across it.
        from: Zero = Zero::Origin, "", 0.0..=0.0;
        /// Thickness of a slab; auto: `reach_spacings` to either side.
        thickness: Auto<f64> = Auto::Auto, "unit of the input", ABOVE_0;
        /// Points that lie on no surface: leaves, stray returns and veils between surfaces. `leave-out`, as auto, has no contour follow
        /// them; `keep` treats them as surface.
        clutter: Clutter = Clutter::Auto, "", 0.0..=0.0;
        /// How far along the surface points are carried to the plane, from either side.
        reach_spacings: f64 = 1.5, "spacings", 0.5..=10.0;
        /// Whether points are carried to the plane along the surface, so that a slanted wall gives a thin band; else they are
        /// projected straight, as in the paper.
        carry: bool = true, "", 0.0..=0.0;
        /// Greatest length of a link between neighbouring places on a contour.
        link_spacings: f64 = 2.4, "spacings", 1.0..=10.0;
        /// Longest gap of a contour that is closed where samples lie all along it.
        bridge_spacings: f64 = 30.0, "spacings", 0.0..=1000.0;
        /// Least length of an open contour.
        stray_spacings: f64 = 4.0, "spacings", 0.0..=1000.0;
        /// How outlines are drawn: the middle of the band of points, the refined convex hull (section 3) or the largest empty
        /// circles (section 4).
        outline: Outline = Outline::Middle, "", 0.0..=0.0;
        /// Least turn at a corner of an outline drawn through the middle, to which noise adds.
        corner_deg: f64 = 25.0, "degrees", 5.0..=120.0;
        /// With `hull` and `voronoi`, the mean distance from the curve up to which the points of a region are near it (the
        /// paper's e); auto: from the thickness of the band.
        region_spacings: Auto<f64> = Auto::Auto, "spacings", 0.0..=100.0;
        /// With `voronoi`, how far empty circles may lie from the curve, as a multiple of the greatest distance of the region's
        /// points from it (section 4): small for few feature points, large for many.
        circle_bound: f64 = 1.0, "", 0.1..=100.0;
        /// Which side of a thick band closed outlines follow: its middle, the side away from what they enclose or the side
        /// towards it.
        side: Side = Side::Middle, "", 0.0..=0.0;
        /// Share of the points that the sides `out` and `in` leave beyond them.
        beyond: f64 = 0.1, "", 0.0..=0.5;
        /// Share of the surface that the axis `auto` must explain.
        axis_share: f64 = 0.4, "", 0.0..=1.0;
        /// Mean distance up to which neighbouring sections are alike, for adaptive planes; auto: from the noise.
        alike_spacings: Auto<f64> = Auto::Auto, "spacings", 0.0..=100.0;
        /// Whether lines, arcs, circles, ellipses and splines are fitted to the contours, and the stack of slices is read.
        fit: bool = false, "", 0.0..=0.0;
        /// Greatest distance of a fitted curve from its contour; auto: from the spacing and the noise.
        tolerance: Auto<f64> = Auto::Auto, "unit of the input", ABOVE_0;
        /// Mean distance up to which the outlines of neighbouring slices are the same; auto: from the noise.
        same_spacings: Auto<f64> = Auto::Auto, "spacings", 0.0..=100.0;
        /// Slices in a row that a contour may be missing from, where open ones show most of it.
        missed: usize = 6, "slices", 0.0..=1000.0;
    }
}

/// What becomes of points that lie on no surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Clutter {
    /// Left out by the robust forms, kept by the forms as printed.
    Auto,
    /// They are classified, and no line follows them.
    LeaveOut,
    /// They are treated as surface.
    Keep,
}

value::choices! { Clutter { Auto = "auto", LeaveOut = "leave-out", Keep = "keep" } }

/// Which form of Gumhold's penalties is used.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PenaltyForm {
    /// Measured against noise and a reference fold: no global maximum.
    Robust,
    /// Equations 4 to 9 as printed.
    Paper,
}

value::choices! { PenaltyForm { Robust = "robust", Paper = "paper" } }

/// Where creases and corners are laid.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WedgeForm {
    /// On the spline through the pattern.
    None,
    /// Where two planes meet, as printed.
    Paper,
    /// Where two surfaces meet, planes or quadrics, fitted without the points nearest the edge.
    Quadric,
}

value::choices! { WedgeForm { None = "none", Paper = "paper", Quadric = "quadric" } }

/// The detection method that runs, under the name of its paper's idea.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// Ours: the robust form of `penalty`, and chains of edgelets from cross-sections.
    Auto,
    /// Gumhold 2001: penalties and the minimum spanning graph.
    Penalty,
    /// Tran 2013: projected distance at the best scale, points above Otsu's threshold.
    Projection,
    /// Demarsin et al. 2007: first-order segmentation and the closed graph of its clusters.
    Segments,
}

value::choices! {
    Method {
        Auto = "auto",
        Penalty = "penalty" | "gumhold", Projection = "projection" | "tran", Segments = "segments" | "demarsin" }
}

/// Which form of Demarsin's pipeline is used.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SegmentForm {
    /// Steady under noise.
    Robust,
    /// As printed.
    Paper,
}

value::choices! { SegmentForm { Robust = "robust", Paper = "paper" } }
