//! Outlines of lines and arcs in the plane, as a draughtsman gives them: what sections of a part should come out as.

use super::turns::sin_cos;

/// One edge of an [`Outline`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Edge {
    /// Straight from one point to the other.
    Line([[f64; 2]; 2]),
    /// Part of a circle, or all of it.
    Arc {
        /// The centre of the circle.
        centre: [f64; 2],
        /// Its radius.
        radius: f64,
        /// The direction in which it begins, seen from the centre, in turns from x towards y.
        from: f64,
        /// The angle that it goes from there, in turns, positive to the left.
        sweep: f64,
    },
}

/// Edges end to end. It is closed where the last one ends at the beginning of the first.
pub type Outline = Vec<Edge>;

impl Edge {
    /// The point at a share of the edge, from 0 to 1.
    pub fn at(&self, share: f64) -> [f64; 2] {
        match *self {
            Edge::Line([a, b]) => [0, 1].map(|k| a[k] + share * (b[k] - a[k])),
            Edge::Arc { centre, radius, from, sweep } => {
                let way = sin_cos(from + share * sweep);
                [0, 1].map(|k| centre[k] + radius * way[k])
            }
        }
    }

    /// Its unit direction at one end: 0 or 1.
    pub(crate) fn way(&self, end: f64) -> [f64; 2] {
        match *self {
            Edge::Line([a, b]) => {
                let d = [b[0] - a[0], b[1] - a[1]];
                let length = (d[0] * d[0] + d[1] * d[1]).sqrt();
                d.map(|x| x / length)
            }
            Edge::Arc { from, sweep, .. } => {
                let [c, s] = sin_cos(from + end * sweep);
                [-s, c].map(|x| x * sweep.signum())
            }
        }
    }
}

/// The corners in order, joined by lines; `closed`: back to the first.
pub fn polygon(corners: &[[f64; 2]], closed: bool) -> Outline {
    let mut edges: Outline = corners.windows(2).map(|w| Edge::Line([w[0], w[1]])).collect();
    if let (true, Some(&last), Some(&first)) = (closed, corners.last(), corners.first()) {
        edges.push(Edge::Line([last, first]));
    }
    edges
}

/// A whole circle.
pub fn ring(centre: [f64; 2], radius: f64) -> Outline {
    vec![Edge::Arc { centre, radius, from: 0.0, sweep: 1.0 }]
}

/// A slot about the origin, along x: two lines and two half circles, `length` over all.
pub fn slot(length: f64, width: f64) -> Outline {
    let (x, radius) = (0.5 * (length - width), 0.5 * width);
    let end = |x: f64, from| Edge::Arc { centre: [x, 0.0], radius, from, sweep: 0.5 };
    vec![
        Edge::Line([[-x, -radius], [x, -radius]]),
        end(x, -0.25),
        Edge::Line([[x, radius], [-x, radius]]),
        end(-x, 0.25),
    ]
}

/// A rectangle about the origin whose corners are rounded with a radius.
pub fn rounded_rectangle([width, height]: [f64; 2], radius: f64) -> Outline {
    let (x, y) = (0.5 * width - radius, 0.5 * height - radius);
    let arc = |x, y, from| Edge::Arc { centre: [x, y], radius, from, sweep: 0.25 };
    vec![
        Edge::Line([[-x, -y - radius], [x, -y - radius]]),
        arc(x, -y, -0.25),
        Edge::Line([[x + radius, -y], [x + radius, y]]),
        arc(x, y, 0.0),
        Edge::Line([[x, y + radius], [-x, y + radius]]),
        arc(-x, y, 0.25),
        Edge::Line([[-x - radius, y], [-x - radius, -y]]),
        arc(-x, -y, 0.5),
    ]
}

/// A wheel of this many teeth about the origin: arcs of two radii about it, each over a quarter of the pitch and more, and straight flanks.
pub fn gear(teeth: u32, [root, tip]: [f64; 2]) -> Outline {
    let pitch = 1.0 / f64::from(teeth);
    let arc = |radius, from, sweep| Edge::Arc { centre: [0.0; 2], radius, from, sweep };
    let tooth = |k: u32| {
        let start = f64::from(k) * pitch;
        let (low, high) = (arc(root, start, 0.4 * pitch), arc(tip, start + 0.5 * pitch, 0.4 * pitch));
        let next = arc(root, start + pitch, 0.4 * pitch);
        [low, Edge::Line([low.at(1.0), high.at(0.0)]), high, Edge::Line([high.at(1.0), next.at(0.0)])]
    };
    (0..teeth).flat_map(tooth).collect()
}
