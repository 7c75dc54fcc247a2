//! The steps from a slab to its outlines for viewers (Kyriazis et al., sections 2 to 4).

use super::outline::Seen;

/// The steps of one slice, world frame. Contours are numbered as they were told apart, before they are cut and put in order.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SliceSteps {
    /// Index of the plane.
    pub plane: usize,
    /// The points of the slab as indices of the input, ascending.
    pub slab: Vec<u32>,
    /// The points as they were brought to the plane. With the outline `middle` those of a flat tile that lie beside each other are
    /// one.
    pub projected: Vec<Projected>,
    /// Whether each contour is closed.
    pub closed: Vec<bool>,
    /// The feature points contour by contour, in order along each; none with the outline `middle`.
    pub features: Vec<FeaturePoint>,
    /// The circles that gave feature points with the outline `voronoi`.
    pub circles: Vec<Circle>,
}

/// A point on a slicing plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Projected {
    /// Its place.
    pub at: [f64; 3],
    /// The contour to which it was assigned (the paper's figure 5); `None` near none.
    pub contour: Option<u32>,
}

/// A feature point of a contour.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FeaturePoint {
    /// Its place.
    pub at: [f64; 3],
    /// The contour.
    pub contour: u32,
    /// The round that found it: 0 for the first convex hull, or for the ends of an open contour.
    pub round: u32,
}

/// The largest empty circle of a region.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Circle {
    /// Its centre.
    pub centre: [f64; 3],
    /// Its radius.
    pub radius: f64,
    /// The contour.
    pub contour: u32,
    /// The round to whose feature points it led.
    pub round: u32,
}

impl SliceSteps {
    /// Notes a step. `to_world` takes a place on the plane to the world, where lengths are `scale` times as great.
    pub(crate) fn see(&mut self, seen: Seen, to_world: &dyn Fn([f64; 2]) -> [f64; 3], scale: f64) {
        match seen {
            Seen::Samples(samples) => {
                self.projected =
                    samples.iter().map(|s| Projected { at: to_world(s.raw), contour: None }).collect();
            }
            Seen::Bands(bands) => {
                self.closed = bands.iter().map(|b| b.chain.closed).collect();
                for (band, contour) in bands.iter().zip(0..) {
                    for mark in &band.marks {
                        self.projected[mark.source as usize].contour = Some(contour);
                    }
                }
            }
            Seen::Features(contour, band, found) => self.features.extend(found.iter().map(|f| {
                FeaturePoint { at: to_world(band.marks[f.mark].raw), contour: contour as u32, round: f.round }
            })),
            Seen::Circle(contour, circle) => self.circles.push(Circle {
                centre: to_world(circle.centre),
                radius: scale * circle.radius,
                contour: contour as u32,
                round: circle.round,
            }),
        }
    }
}
