//! The measure: a detector's output, with penalties, score, class and normal of every point.

use crate::error::Error;
use crate::math::vec3::dot;
use crate::resolution::Resolution;

/// The output of a detector: one row for each point, canonical order, local frame.
///
/// Any detector can feed any linker. A linker for lines reads the two [`Penalties`]; a viewer reads `score` and `class`.
#[derive(Clone, Debug, Default)]
pub struct Measure {
    /// `(N)` sampling density `mu`: average distance to the direct neighbours in the neighbour graph (Gumhold 2001, equation 1),
    /// in the unit of the local frame.
    pub density: Vec<f32>,
    /// `(N)` evidence of a feature, 0 smooth to 1 certain.
    pub score: Vec<f32>,
    /// `(N)` class of each point, from a detector with a classification of its own.
    pub class: Option<Vec<Class>>,
    /// `(N, 3)` unit normals without orientation; patches need them.
    pub normal: Vec<[f32; 3]>,
    /// Penalties against lying on a crease.
    pub crease: Penalties,
    /// Penalties against lying on a border.
    pub border: Penalties,
    /// Short pieces of crease, found across the points rather than at them; empty from a detector that judges points alone.
    pub edgelets: Vec<Edgelet>,
    /// Short pieces of the design edges of blends.
    pub blends: Vec<Edgelet>,
    /// Places at which a cross-section shows one smooth face alone; empty from such a detector.
    pub flat: Vec<[f64; 3]>,
}

/// A short piece of crease: where two smooth pieces of a cross-section of the surface meet, local frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Edgelet {
    /// Its place.
    pub place: [f64; 3],
    /// The point of the cloud nearest to it.
    pub point: u32,
    /// Unit direction of the crease, of either sign.
    pub along: [f64; 3],
    /// Unit directions of both faces away from the crease.
    pub arms: [[f64; 3]; 2],
    /// Spacing of the cloud there.
    pub spacing: f64,
    /// Standard deviation of the place across the crease.
    pub deviation: f64,
    /// Twice the log likelihood ratio of two smooth pieces against one.
    pub evidence: f64,
    /// Length along the crease of the points that it rests on: edgelets nearer to each other share points.
    pub reach: f64,
    /// Radius of the round between the faces, whose design edge this is; 0 where they meet.
    pub radius: f64,
}

impl Edgelet {
    /// The turn from one face to the other, radians: 0 where they are one plane.
    pub fn turn(&self) -> f64 {
        let [a, b] = self.arms;
        (-dot(a, b).clamp(-1.0, 1.0)).acos()
    }

    /// The distance from the design edge to where the round touches the faces.
    pub fn tangent(&self) -> f64 {
        self.radius * (0.5 * self.turn()).tan()
    }
}

/// The penalties of the candidates, the points that may lie on one kind of line. Only candidates can enter a pattern.
#[derive(Clone, Debug, Default)]
pub struct Penalties {
    /// `(M)` point index of each candidate, ascending.
    pub points: Vec<u32>,
    /// `(M)` penalty in `[0, 1]` independent of direction: Gumhold's curvature penalty for creases, open angle for borders.
    pub scalar: Vec<f32>,
    /// `(M, 3)` vector penalty, in the sense of `direction`.
    pub vector: Vec<[f32; 3]>,
    /// `(M)` upper bound of the vector penalty; it is low at corners, where no direction is preferred.
    pub corner: Vec<f32>,
    /// `(M, 3)` foot of each candidate, its estimated place on the line; its own position where there is no estimate.
    pub foot: Vec<[f64; 3]>,
    /// `(M)` evidence of the cross-section; `None` where none was taken: at borders, at corners, and by a detector without this
    /// test.
    pub evidence: Vec<Option<Evidence>>,
    /// How `vector` acts on an edge.
    pub direction: Direction,
    /// Share of `scalar` in the weight of an edge (Gumhold's `alpha` or `gamma`); the rest is that of the vector penalty.
    pub share: f64,
}

/// How a vector penalty weighs an edge.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Direction {
    /// As printed in Gumhold 2001: the penalty is the part of the vector along the unit edge.
    #[default]
    Along,
    /// The vector is the line's direction times its certainty; the penalty is the distance by which the edge leaves it, in
    /// spacings.
    Across,
}

/// The class of a point.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
#[repr(u8)]
pub enum Class {
    /// On no line.
    #[default]
    Smooth = 0,
    /// On a crease.
    Crease = 1,
    /// On a border.
    Border = 2,
    /// At a place where lines meet, end or turn.
    Corner = 3,
    /// On no surface: leaves, stray returns, veils between surfaces.
    Clutter = 4,
}

impl Measure {
    /// The measure of `count` points on no surface.
    pub(crate) fn of_clutter(count: usize, resolution: Resolution) -> Measure {
        Measure {
            density: vec![resolution.spacing as f32; count],
            score: vec![0.0; count],
            class: Some(vec![Class::Clutter; count]),
            ..Measure::default()
        }
    }

    /// Checks that the rows are those of `count` points. Normals may be absent unless `with_normals`.
    ///
    /// # Errors
    /// [`Error::Measure`] with the first column, or candidate, at fault.
    pub(crate) fn check(&self, count: usize, with_normals: bool) -> Result<(), Error> {
        let class = self.class.as_ref().map_or(count, Vec::len);
        let normal = if self.normal.is_empty() && !with_normals { count } else { self.normal.len() };
        let columns = [
            ("density", self.density.len()),
            ("score", self.score.len()),
            ("normal", normal),
            ("class", class),
        ];
        if let Some((name, rows)) = columns.into_iter().find(|(_, rows)| *rows != count) {
            return Err(Error::Measure { fault: format!("`{name}` has {rows} rows for {count} points") });
        }
        for (name, column) in [("density", &self.density), ("score", &self.score)] {
            if let Some(i) = column.iter().position(|x| !x.is_finite()) {
                return Err(Error::Measure { fault: format!("`{name}` of point {i} is not finite") });
            }
        }
        self.crease.check("crease", count)?;
        self.border.check("border", count)
    }
}

impl Penalties {
    fn check(&self, kind: &str, count: usize) -> Result<(), Error> {
        let fault = |what: String| Err(Error::Measure { fault: format!("`{kind}`: {what}") });
        let rows = self.points.len();
        let columns =
            [self.scalar.len(), self.vector.len(), self.corner.len(), self.foot.len(), self.evidence.len()];
        if let Some(length) = columns.into_iter().find(|length| *length != rows) {
            return fault(format!("a column of {length} rows for {rows} candidates"));
        }
        if let Some(pair) = self.points.windows(2).find(|pair| pair[0] >= pair[1]) {
            return fault(format!("candidate {} follows candidate {}", pair[1], pair[0]));
        }
        if let Some(last) = self.points.last().filter(|&&last| last as usize >= count) {
            return fault(format!("candidate {last} of {count} points"));
        }
        if !(0.0..=1.0).contains(&self.share) {
            return fault(format!("a share of {}, which is not between 0 and 1", self.share));
        }
        let odd = |&i: &usize| {
            let vector = self.vector[i].iter().chain([&self.corner[i]]).all(|x| x.is_finite());
            !vector || !self.foot[i].iter().all(|x| x.is_finite())
        };
        if let Some(i) = (0..rows).find(odd) {
            return fault(format!("candidate {} has a value that is not finite", self.points[i]));
        }
        match (0..rows).find(|&i| !(0.0..=1.0).contains(&self.scalar[i])) {
            Some(i) => {
                let (point, scalar) = (self.points[i], self.scalar[i]);
                fault(format!("candidate {point} has a penalty of {scalar}, which is not between 0 and 1"))
            }
            None => Ok(()),
        }
    }

    /// Penalties without any candidate.
    pub(crate) fn new(share: f64, direction: Direction) -> Self {
        Self { share, direction, ..Self::default() }
    }

    /// Appends a candidate.
    pub fn push(&mut self, point: u32, row: Row) {
        self.points.push(point);
        self.scalar.push(row.scalar);
        self.vector.push(row.vector);
        self.corner.push(row.corner);
        self.foot.push(row.foot);
        self.evidence.push(row.evidence);
    }

    /// The penalties of one candidate.
    pub(crate) fn row(&self, c: usize) -> Row {
        Row {
            scalar: self.scalar[c],
            vector: self.vector[c],
            corner: self.corner[c],
            foot: self.foot[c],
            evidence: self.evidence[c],
        }
    }

    /// The number of candidates.
    pub fn len(&self) -> usize {
        self.points.len()
    }

    /// Whether there is no candidate.
    pub fn is_empty(&self) -> bool {
        self.points.is_empty()
    }
}

/// The penalties of one candidate, as in [`Penalties`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Row {
    /// Penalty in `[0, 1]` independent of direction.
    pub scalar: f32,
    /// Vector penalty.
    pub vector: [f32; 3],
    /// Upper bound of the vector penalty.
    pub corner: f32,
    /// Estimated place of the point on the line.
    pub foot: [f64; 3],
    /// Evidence of the cross-section.
    pub evidence: Option<Evidence>,
}

/// The evidence of the cross-section of a crease candidate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Evidence {
    /// Evidence that the line is sharp, in variances of the noise; negative values indicate a smooth surface.
    pub sharp: f32,
    /// The evidence expected of a sharp fold of the measured angle without noise.
    pub expected: f32,
    /// Angle between the faces, radians, never negative.
    pub fold: f32,
}

#[cfg(test)]
mod tests {
    use super::*;

    type Spoil = fn(&mut Measure);

    fn measure() -> Measure {
        let mut crease = Penalties::new(0.5, Direction::Across);
        let row = Row { scalar: 0.5, vector: [0.0; 3], corner: 1.0, foot: [0.0; 3], evidence: None };
        crease.push(1, row);
        let border = Penalties::new(0.5, Direction::Across);
        Measure { density: vec![1.0; 2], score: vec![0.0; 2], crease, border, ..Measure::default() }
    }

    #[test]
    fn values_that_are_not_finite_or_out_of_range_are_refused() {
        assert!(measure().check(2, false).is_ok());
        let faults: [(&str, Spoil); 8] = [
            ("`score` of point 1 is not finite", |m| m.score[1] = f32::NAN),
            ("`density` of point 0 is not finite", |m| m.density[0] = f32::INFINITY),
            ("candidate 1 has a value that is not finite", |m| m.crease.vector[0][2] = f32::NAN),
            ("candidate 1 has a value that is not finite", |m| m.crease.corner[0] = f32::NAN),
            ("candidate 1 has a value that is not finite", |m| m.crease.foot[0][0] = f64::NAN),
            ("candidate 1 has a penalty of -0.1", |m| m.crease.scalar[0] = -0.1),
            ("candidate 1 has a penalty of NaN", |m| m.crease.scalar[0] = f32::NAN),
            ("`border`: a share of NaN", |m| m.border.share = f64::NAN),
        ];
        for (said, spoil) in faults {
            let mut spoilt = measure();
            spoil(&mut spoilt);
            let message = spoilt.check(2, false).unwrap_err().to_string();
            assert!(message.contains(said), "{said}: {message}");
        }
    }
}
