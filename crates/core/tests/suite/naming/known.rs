//! Features as they are known of a part.

/// What a feature is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// With its radius if round.
    Extrusion(Option<f64>),
    /// With its apex, and its radius at the low end if round.
    Taper(f64, Option<f64>),
    /// With its greatest radius.
    Revolution(f64),
}

/// A feature that a part has along an axis.
#[derive(Clone, Debug)]
pub struct Known {
    pub kind: Kind,
    pub hole: bool,
    pub from: f64,
    pub to: f64,
    /// Whether it need not be named: too short, or a matter of taste.
    pub optional: bool,
}

impl Known {
    /// The feature along the axis (1), or against it (-1).
    pub fn along(&self, way: f64) -> Known {
        if way > 0.0 {
            return self.clone();
        }
        let kind = match self.kind {
            Kind::Taper(apex, radius) => {
                let at = |r: f64| r * (apex - self.to) / (apex - self.from);
                Kind::Taper(-apex, radius.map(at))
            }
            other => other,
        };
        Known { kind, from: -self.to, to: -self.from, ..self.clone() }
    }
}

/// A part seen along one axis.
pub struct View {
    pub axis: usize,
    pub features: Vec<Known>,
    /// Groups of equal runs.
    pub repeats: usize,
}

pub fn known(kind: Kind, from: f64, to: f64) -> Known {
    Known { kind, hole: false, from, to, optional: false }
}

pub fn hole(kind: Kind, from: f64, to: f64) -> Known {
    Known { hole: true, ..known(kind, from, to) }
}

pub fn maybe(known: Known) -> Known {
    Known { optional: true, ..known }
}

pub fn view(axis: usize, features: Vec<Known>) -> View {
    View { axis, features, repeats: 0 }
}

/// An extrusion that is not round.
pub const PLAIN: Kind = Kind::Extrusion(None);

pub fn round(radius: f64) -> Kind {
    Kind::Extrusion(Some(radius))
}
