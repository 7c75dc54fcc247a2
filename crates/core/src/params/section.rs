//! The values of sections' parameters that are more than a number.

use super::value::{ParamValue, choices};

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

/// The place on the axis that positions of slices are counted from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Zero {
    /// The origin of the input.
    Origin,
    /// The lowest point.
    Lowest,
    /// The floor: the lowest large face across the axis.
    Floor,
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

/// Most planes in one run: a guard against a step mistaken for another unit.
pub(crate) const MOST_PLANES: usize = 100_000;

impl Planes {
    /// Adaptive ones with this many parts at first, and eight times as many at most.
    pub fn adaptive(start: usize) -> Self {
        Planes::Adaptive { start, most: start.saturating_mul(MOST_PARTS) }
    }
}

choices! { Outline { Middle = "middle", Hull = "hull", Voronoi = "voronoi" } }
choices! { Zero { Origin = "origin", Lowest = "lowest", Floor = "floor" } }
choices! { Side { Middle = "mid", Outside = "out", Inside = "in" } }

impl ParamValue for Axis {
    fn parse(text: &str) -> Option<Self> {
        match text {
            "x" => Some(Axis::Coordinate(0)),
            "y" => Some(Axis::Coordinate(1)),
            "z" => Some(Axis::Coordinate(2)),
            "auto" => Some(Axis::Faces),
            "long" => Some(Axis::Principal),
            "thin" => Some(Axis::Thinnest),
            _ => numbers(text)?.try_into().ok().map(Axis::Vector),
        }
    }
    fn show(&self) -> String {
        match self {
            Axis::Coordinate(k) => ["x", "y", "z"].get(*k).map_or_else(|| k.to_string(), |x| (*x).into()),
            Axis::Vector(v) => joined(v),
            Axis::Faces => "auto".into(),
            Axis::Principal => "long".into(),
            Axis::Thinnest => "thin".into(),
        }
    }
    fn number(&self) -> Option<f64> {
        None
    }
    fn accepts(_: &std::ops::RangeInclusive<f64>) -> String {
        "x, y, z, auto, long, thin or a vector X,Y,Z such as 1,0,1".into()
    }
    fn names() -> Vec<&'static str> {
        vec!["x", "y", "z", "auto", "long", "thin"]
    }
    fn fault(&self) -> Option<&'static str> {
        match self {
            Axis::Coordinate(axis) if *axis > 2 => Some("0, 1 or 2"),
            Axis::Vector(v) if !v.iter().all(|x| x.is_finite()) || *v == [0.0; 3] => {
                Some("a finite vector that is not zero")
            }
            _ => None,
        }
    }
}

impl ParamValue for Planes {
    fn parse(text: &str) -> Option<Self> {
        let (kind, rest) = text.split_once(':')?;
        let rest = rest.trim();
        match kind.trim() {
            "at" => numbers(rest).map(Planes::At),
            "step" | "every" => rest.parse().ok().map(Planes::Every),
            "count" => rest.parse().ok().map(Planes::Count),
            "adaptive" => match rest.split_once(',') {
                Some((start, most)) => Some(Planes::Adaptive {
                    start: start.trim().parse().ok()?,
                    most: most.trim().parse().ok()?,
                }),
                None => rest.parse().ok().map(Planes::adaptive),
            },
            _ => None,
        }
    }
    fn show(&self) -> String {
        match self {
            Planes::At(at) => format!("at:{}", joined(at)),
            Planes::Every(step) => format!("step:{step:?}"),
            Planes::Count(count) => format!("count:{count}"),
            Planes::Adaptive { start, most } => format!("adaptive:{start},{most}"),
        }
    }
    fn number(&self) -> Option<f64> {
        None
    }
    fn accepts(_: &std::ops::RangeInclusive<f64>) -> String {
        "count:N, step:LENGTH, at:Z1,Z2,.. or adaptive:N,MOST, of at most 100000 slices".into()
    }
    fn fault(&self) -> Option<&'static str> {
        let count = |n: usize| match n {
            0 => Some("at least 1 slice"),
            n if n > MOST_PLANES => Some("at most 100000 slices"),
            _ => None,
        };
        match self {
            Planes::At(at) if !at.iter().all(|z| z.is_finite()) => Some("finite positions along the axis"),
            Planes::At(at) => count(at.len()),
            Planes::Every(step) if !(*step > 0.0 && step.is_finite()) => {
                Some("a distance above 0 in the unit of the input")
            }
            Planes::Every(_) => None,
            Planes::Count(n) => count(*n),
            Planes::Adaptive { start, most } => count(*start).or(count((*most).max(*start))),
        }
    }
}

/// How many times as many parts as at first adaptive slabs may become, unless told.
const MOST_PARTS: usize = 8;

/// Numbers with commas between them.
fn numbers(text: &str) -> Option<Vec<f64>> {
    text.split(',').map(|t| t.trim().parse().ok()).collect()
}

fn joined(numbers: &[f64]) -> String {
    numbers.iter().map(|x| format!("{x:?}")).collect::<Vec<_>>().join(",")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axes_are_letters_words_or_vectors() {
        assert_eq!(Axis::parse("y"), Some(Axis::Coordinate(1)));
        assert_eq!(Axis::parse("auto"), Some(Axis::Faces));
        assert_eq!(Axis::parse("long"), Some(Axis::Principal));
        assert_eq!(Axis::parse("0, -1,2.5"), Some(Axis::Vector([0.0, -1.0, 2.5])));
        for bad in ["w", "1,2", "1,2,3,4", ""] {
            assert_eq!(Axis::parse(bad), None, "{bad}");
        }
    }

    #[test]
    fn planes_read_back_as_they_print() {
        let adaptive = Planes::Adaptive { start: 5, most: 40 };
        assert_eq!(Planes::parse("adaptive:5"), Some(adaptive.clone()));
        for planes in [
            Planes::At(vec![0.1, -2.0]),
            Planes::Every(0.25),
            Planes::Count(7),
            adaptive,
            Planes::At(vec![1e300]),
        ] {
            assert_eq!(Planes::parse(&planes.show()), Some(planes));
        }
        for bad in ["7", "count", "count:x", "every:", "at:1,,2", "adaptive:1,2,3", "thin:3"] {
            assert_eq!(Planes::parse(bad), None, "{bad}");
        }
    }

    #[test]
    fn planes_that_cannot_be_are_told() {
        let bad = [
            Planes::At(vec![]),
            Planes::At(vec![f64::NAN]),
            Planes::Every(0.0),
            Planes::Every(f64::INFINITY),
            Planes::Count(0),
            Planes::Count(1_000_001),
            Planes::Adaptive { start: 4, most: 2_000_000 },
        ];
        bad.iter().for_each(|planes| assert!(planes.fault().is_some(), "{planes:?}"));
    }
}
