//! Sections and their contours.

use super::contour::chain::Chain;
use super::curves::{self, Datum, Piece, Shape, nest};
use super::frame::SliceFrame;
use super::outline::Drawn;
use crate::curve::{BSpline, Ellipse, polygon};
use crate::math::vec2::distance;
use crate::params::Auto;
use crate::params::section::Zero;

/// Fewest points of a slab in which a curve is sought.
pub(crate) const FEWEST_POINTS: usize = 4;

/// All sections of a cloud.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Sections {
    /// Directions of the slices in the world.
    pub frame: SliceFrame,
    /// The place that positions were counted from, and where it lies along the axis, world unit. Without a floor it is the lowest point.
    pub zero: (Zero, f64),
    /// Position of each plane along the axis, world unit, in the order asked for.
    pub heights: Vec<f64>,
    /// Median spacing of the cloud, world unit.
    pub spacing: f64,
    /// Estimated standard deviation of the points from the surface, in spacings.
    pub noise: f64,
    /// Points with a coordinate that is not finite, which are left out.
    pub dropped: usize,
    /// Points that repeat another one exactly, which are left out.
    pub merged: usize,
    /// Points on no surface, which are left out.
    pub clutter: usize,
    /// One for each plane, in that order.
    pub sections: Vec<Section>,
}

/// The curves in one plane.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Section {
    /// Index of the plane.
    pub plane: usize,
    /// Its position along the axis, world unit.
    pub height: f64,
    /// The part of the axis that the section stands for, world unit: neighbouring ones share their bounds, so that
    /// nothing is left out between them. `None` for planes at given positions.
    pub slab: Option<[f64; 2]>,
    /// Number of points of the cloud in the slab.
    pub points: usize,
    /// The curves, longest first.
    pub contours: Vec<Contour>,
    /// Why there is no curve; `None` where there is one.
    pub missing: Option<Missing>,
}

/// Why a section has no curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Missing {
    /// No point lies in the slab.
    Empty,
    /// So few points lie in the slab that they show no curve.
    TooFewPoints(usize),
    /// This many points lie in the slab, but no surface crosses the plane there that could be followed: the points
    /// lie on a face along the plane, on a straight line, or scattered.
    NoCurve(usize),
}

/// One curve of a section.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Contour {
    /// `(M, 3)` f64, world frame, in order; the first is not repeated at the end of a closed contour. Outer contours
    /// run counter-clockwise seen against the axis, holes clockwise.
    pub points: Vec<[f64; 3]>,
    /// Ascending indices of those points that are corners.
    pub corners: Vec<usize>,
    /// Whether the last point leads back to the first.
    pub closed: bool,
    /// The contour of the same section that closely surrounds this one.
    pub parent: Option<usize>,
    /// Number of contours around this one: even for an outer one, odd for a hole.
    pub depth: usize,
    /// Enclosed area, square world units: positive for outer contours, negative for holes, 0 for open ones.
    pub area: f64,
    /// Length, world unit.
    pub length: f64,
    /// Median angle between the wall and the axis, degrees, positive where the contour grows along the axis; `None`
    /// for open contours.
    pub draft_deg: Option<f64>,
    /// The angle between the wall and the axis, degrees, that nine tenths of the contour stay under, of either sign.
    pub steepest_deg: f64,
    /// Centroid of the enclosed area, of the line for an open contour; world frame.
    pub centroid: [f64; 3],
    /// The contour as lines, arcs, circles, ellipses and splines, end to end; empty unless asked for.
    pub pieces: Vec<CurvePiece>,
}

/// One curve of a contour.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct CurvePiece {
    /// Its kind with its parameters.
    pub shape: CurveShape,
    /// First point, world frame.
    pub from: [f64; 3],
    /// Last point, world frame; the first point again for a circle.
    pub to: [f64; 3],
    /// Greatest distance of a point of the contour from it, world unit.
    pub worst: f64,
}

/// Kinds of curves.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum CurveShape {
    /// Straight from end to end.
    Line,
    /// About a centre.
    Arc {
        /// World frame.
        centre: [f64; 3],
        /// World unit.
        radius: f64,
        /// Angle swept, degrees, positive counter-clockwise seen against the axis.
        sweep_deg: f64,
    },
    /// A whole circle.
    Circle {
        /// World frame.
        centre: [f64; 3],
        /// World unit.
        radius: f64,
    },
    /// An ellipse, or part of one.
    Ellipse {
        /// World frame, its normal the axis of the sections.
        ellipse: Ellipse,
        /// Change of its parameter, degrees, positive counter-clockwise seen against the axis; a full turn of a whole one.
        sweep_deg: f64,
    },
    /// A cubic B-spline.
    Spline(BSpline),
}

impl CurveShape {
    /// The name in files: `line`, `arc`, `circle`, `ellipse` or `spline`.
    pub fn name(&self) -> &'static str {
        match self {
            CurveShape::Line => "line",
            CurveShape::Arc { .. } => "arc",
            CurveShape::Circle { .. } => "circle",
            CurveShape::Ellipse { .. } => "ellipse",
            CurveShape::Spline(_) => "spline",
        }
    }
}

impl Missing {
    /// The reason in words.
    pub fn reason(self) -> String {
        match self {
            Missing::Empty => "no point lies in the slab".into(),
            Missing::TooFewPoints(n) => format!("{n} points in the slab are too few for a curve"),
            Missing::NoCurve(n) => {
                format!("no surface can be followed across the plane among {n} points of the slab")
            }
        }
    }
}

/// Orients, nests and measures outlines, and fits curves if there is a `tolerance`, within it if it is given; all still in the slice frame, with a
/// third coordinate of 0.
pub(crate) fn contours(drawn: Vec<Drawn>, tolerance: Option<Auto<f64>>) -> Vec<Contour> {
    let flat: Vec<(Vec<[f64; 2]>, bool)> = drawn.iter().map(|d| (d.chain.points(), d.chain.closed)).collect();
    let parents = nest::parents(&flat);
    let depth = |mut i: usize| {
        let mut depth = 0;
        while let Some(parent) = parents[i] {
            (i, depth) = (parent, depth + 1);
        }
        depth
    };
    let depths: Vec<usize> = (0..parents.len()).map(depth).collect();
    let contour = |(i, drawn): (usize, Drawn)| contour(drawn, parents[i], depths[i], tolerance);
    drawn.into_iter().enumerate().map(contour).collect()
}

fn contour(drawn: Drawn, parent: Option<usize>, depth: usize, tolerance: Option<Auto<f64>>) -> Contour {
    let Drawn { mut chain, growth, mut data } = drawn;
    let wanted = if depth.is_multiple_of(2) { 1.0 } else { -1.0 };
    let extent = polygon::measure(&chain.points(), chain.closed);
    let (turn, mut area) = (extent.area, extent.area);
    if turn * wanted < 0.0 {
        reversed(&mut data, &chain);
        chain.vertices.reverse();
        area = -area;
    }
    let flat = chain.points();
    let pieces = tolerance.map_or(Vec::new(), |t| curves::fit(&chain, &data, t.given()));
    let corners = chain.vertices.iter().enumerate().filter(|(_, v)| v.corner).map(|(k, _)| k).collect();
    Contour {
        points: flat.iter().map(|&p| lift(p)).collect(),
        corners,
        closed: chain.closed,
        parent,
        depth,
        area,
        length: extent.length,
        // Right of a counter-clockwise contour is outside.
        draft_deg: chain
            .closed
            .then(|| growth.middle.atan().to_degrees() * if turn < 0.0 { -1.0 } else { 1.0 }),
        steepest_deg: growth.most.atan().to_degrees(),
        centroid: lift(extent.centroid),
        pieces: pieces.into_iter().map(piece).collect(),
    }
}

/// The data of a contour that runs the other way.
fn reversed(data: &mut [Datum], chain: &Chain) {
    let length = chain.length();
    let ends = [chain.vertices.first(), chain.vertices.last()].map(|v| v.map_or([0.0; 2], |v| v.at));
    let last = if chain.closed { length - distance(ends[0], ends[1]) } else { length };
    let turned = |arc: f64| if arc <= last { last - arc } else { last - arc + length };
    data.iter_mut().for_each(|d| d.arc = turned(d.arc));
    data.reverse();
    data.sort_by(|a, b| a.arc.total_cmp(&b.arc));
}

fn lift(p: [f64; 2]) -> [f64; 3] {
    [p[0], p[1], 0.0]
}

fn piece(piece: Piece) -> CurvePiece {
    let shape = match piece.shape {
        Shape::Line => CurveShape::Line,
        Shape::Arc { centre, radius, sweep } => {
            CurveShape::Arc { centre: lift(centre), radius, sweep_deg: sweep.to_degrees() }
        }
        Shape::Circle { centre, radius } => CurveShape::Circle { centre: lift(centre), radius },
        Shape::Ellipse { ellipse, sweep } => {
            CurveShape::Ellipse { ellipse: Ellipse::of_plane(&ellipse, lift), sweep_deg: sweep.to_degrees() }
        }
        Shape::Free(spline) => CurveShape::Spline(spline.mapped(lift, 1.0)),
    };
    CurvePiece { shape, from: lift(piece.from), to: lift(piece.to), worst: piece.worst }
}

impl Contour {
    /// Brings a contour from the slice frame to the world.
    pub(crate) fn place(&mut self, to_world: &impl Fn([f64; 2]) -> [f64; 3], scale: f64) {
        let move_place = |p: [f64; 3]| to_world([p[0], p[1]]);
        let move_to = |p: &mut [f64; 3]| *p = move_place(*p);
        self.points.iter_mut().for_each(move_to);
        move_to(&mut self.centroid);
        self.area *= scale * scale;
        self.length *= scale;
        for piece in &mut self.pieces {
            move_to(&mut piece.from);
            move_to(&mut piece.to);
            piece.worst *= scale;
            match &mut piece.shape {
                CurveShape::Line => {}
                CurveShape::Arc { centre, radius, .. } | CurveShape::Circle { centre, radius } => {
                    move_to(centre);
                    *radius *= scale;
                }
                CurveShape::Ellipse { ellipse, .. } => *ellipse = ellipse.carried(move_place),
                CurveShape::Spline(spline) => {
                    spline.controls.iter_mut().for_each(move_to);
                    spline.knots.iter_mut().for_each(|k| *k *= scale);
                }
            }
        }
    }
}

impl Sections {
    /// Contours of all sections with the index of their plane, planes in order.
    pub fn contours(&self) -> impl Iterator<Item = (usize, &Contour)> {
        self.sections.iter().flat_map(|s| s.contours.iter().map(move |c| (s.plane, c)))
    }
}
