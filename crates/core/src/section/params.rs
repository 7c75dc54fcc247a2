//! What can be asked of a section, with units, ranges and defaults.

use crate::error::Error;

/// The direction across the slices.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Axis {
    /// Along x, y or z: 0, 1 or 2.
    Coordinate(usize),
    /// Along any vector that is not zero; its length does not count.
    Vector([f64; 3]),
    /// The axis that most of the surface stands along, lies across or is turned about; of several that are as good the one
    /// along which sections change least often, then the longest. Where the faces show none, as [`Axis::Principal`].
    Faces,
    /// The principal axis along which the points extend furthest.
    Principal,
    /// That principal axis along which the slices project thinnest: walls stand steepest on the planes.
    Thinnest,
}

/// Where the slices lie along the axis.
#[derive(Clone, Debug, PartialEq)]
pub enum Planes {
    /// At these coordinates along the axis, in the unit of the input, in any order.
    At(Vec<f64>),
    /// A given distance apart, in the unit of the input, centred on the cloud's extent.
    Every(f64),
    /// This many, in the middles of as many equal parts of the cloud's extent, so that their slabs leave nothing out.
    Count(usize),
    /// Equal parts at first, then split where neighbouring sections differ and merged where they are alike.
    Adaptive {
        /// Parts at first.
        start: usize,
        /// Parts at most.
        most: usize,
    },
}

/// How feature points are taken from a band of points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outline {
    /// Ours: the middle of the band by local regression, with corners where two straight continuations meet.
    Middle,
    /// The refined convex hull of section 3.
    Hull,
    /// The largest empty circles of section 4.
    Voronoi,
}

/// Which side of a thick band the outline follows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// The least-squares middle.
    Middle,
    /// The side away from what a closed contour encloses.
    Outside,
    /// The side towards it.
    Inside,
}

/// Parameters of [`section`](crate::section::section). Lengths are in the unit of the input, or in local spacings
/// where the name says so.
#[derive(Clone, Debug, PartialEq)]
pub struct SectionParams {
    /// Across the slices; z unless given.
    pub axis: Axis,
    /// Where the slices lie; 10 unless given.
    pub planes: Planes,
    /// Thickness of a slab in the unit of the input, above 0; `None`: `reach_spacings` to either side.
    pub thickness: Option<f64>,
    /// How far along the surface points are carried to the plane from either side, in local spacings: 0.5 to 10.
    pub reach_spacings: f64,
    /// Whether points are carried along the local surface; else they are projected straight, as in the paper.
    pub carry: bool,
    /// How the curve is taken from the band.
    pub outline: Outline,
    /// Which side of the band it follows.
    pub side: Side,
    /// Bound on the distance of Voronoi vertices from the curve, as a multiple of the greatest distance of the
    /// region's points from it: small for few feature points, large for many. 0.1 to 100.
    pub circle_bound: f64,
    /// Whether lines, arcs, circles and splines are fitted to the contours.
    pub fit: bool,
    /// Greatest distance of a fitted curve from its contour, in the unit of the input, above 0; `None`: from the
    /// spacing and the noise.
    pub tolerance: Option<f64>,
}

impl Default for SectionParams {
    fn default() -> Self {
        Self {
            axis: Axis::Coordinate(2),
            planes: Planes::Count(10),
            thickness: None,
            reach_spacings: 1.5,
            carry: true,
            outline: Outline::Middle,
            side: Side::Middle,
            circle_bound: 1.0,
            fit: false,
            tolerance: None,
        }
    }
}

/// Most planes in one run: a guard against a step mistaken for another unit.
pub(crate) const MOST_PLANES: usize = 1_000_000;

impl SectionParams {
    /// Refuses values outside their ranges.
    ///
    /// # Errors
    /// [`Error::Parameter`] with the key, the value and what is accepted.
    pub fn check(&self) -> Result<(), Error> {
        self.check_axis()?;
        self.check_planes()?;
        let above = |key: &str, value: Option<f64>| match value {
            Some(v) if !(v > 0.0 && v.is_finite()) => {
                refuse(key, v, "a length above 0 in the unit of the input")
            }
            _ => Ok(()),
        };
        above("section.thickness", self.thickness)?;
        above("section.tolerance", self.tolerance)?;
        within("section.reach_spacings", self.reach_spacings, 0.5, 10.0)?;
        within("section.circle_bound", self.circle_bound, 0.1, 100.0)
    }

    fn check_axis(&self) -> Result<(), Error> {
        match self.axis {
            Axis::Coordinate(axis) if axis > 2 => refuse("section.axis", axis, "0, 1 or 2"),
            Axis::Vector(v) if !v.iter().all(|x| x.is_finite()) || v == [0.0; 3] => {
                refuse("section.axis", format!("{v:?}"), "a finite vector that is not zero")
            }
            _ => Ok(()),
        }
    }

    fn check_planes(&self) -> Result<(), Error> {
        let count = |n: usize| match n {
            0 => refuse("section.count", n, "at least 1 slice"),
            n if n > MOST_PLANES => refuse("section.count", n, "at most 1000000 slices"),
            _ => Ok(()),
        };
        match &self.planes {
            Planes::At(at) => match at.iter().find(|z| !z.is_finite()) {
                Some(&z) => refuse("section.at", z, "finite positions along the axis"),
                None => count(at.len()),
            },
            Planes::Every(step) if !(*step > 0.0 && step.is_finite()) => {
                refuse("section.every", *step, "a distance above 0 in the unit of the input")
            }
            Planes::Every(_) => Ok(()),
            Planes::Count(n) => count(*n),
            Planes::Adaptive { start, most } => count(*start).and_then(|()| count((*most).max(*start))),
        }
    }
}

fn within(key: &str, value: f64, low: f64, high: f64) -> Result<(), Error> {
    if (low..=high).contains(&value) { Ok(()) } else { refuse(key, value, &format!("from {low} to {high}")) }
}

pub(crate) fn refuse<T>(key: &str, value: impl ToString, expected: &str) -> Result<T, Error> {
    Err(Error::Parameter { key: key.into(), value: value.to_string(), expected: expected.into() })
}
