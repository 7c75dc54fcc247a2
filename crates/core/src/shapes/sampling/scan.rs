//! Scans: the settings by which a shape is sampled, and the sampled cloud with its truth.

use super::{lattice, scanner, uniform};
use crate::cloud::Cloud;
use crate::shapes::nearest::mean_spacing;
use crate::shapes::random::Rng;
use crate::shapes::shape::Shape;
use crate::shapes::truth::Truth;

/// The settings of a scan: positions of the points, noise, gradient and seed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scan {
    /// The positions of the points.
    pub sampling: Sampling,
    /// The noise added to each coordinate.
    pub noise: Noise,
    /// Thinning along an axis.
    pub gradient: Option<Gradient>,
    /// The seed: the same seed gives the same bits on every machine.
    pub seed: u64,
}

/// The positions of the points of a [`Scan`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Sampling {
    /// On lattices, edges and corners included: at equal steps along each curve of the truth, and on a lattice inside
    /// each face that keeps half a step from the curves.
    Grid {
        /// Distance of neighbours, above 0, in the unit of the shape.
        step: f64,
    },
    /// Independent and uniform by area.
    Area {
        /// Number of points.
        count: usize,
    },
    /// Uniform by area, but no two closer than about 0.8 mean spacings.
    BlueNoise {
        /// Number of points.
        count: usize,
    },
    /// The view of a range scanner from around the shape: the first surface along each ray of a raster.
    Scanner {
        /// Number of views, in directions spread evenly over the sphere.
        views: u32,
        /// Distance of neighbouring rays where they pass the shape's centre, above 0, in the unit of the shape.
        pitch: f64,
        /// Distance of the eye from the centre in radii of the bounding sphere, above 1; `None`: parallel rays.
        distance: Option<f64>,
        /// Angle between ray and normal above which a ray is lost.
        grazing_deg: f64,
    },
}

/// Gaussian noise of the same standard deviation on each coordinate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Noise {
    /// No noise.
    None,
    /// Standard deviation in mean spacings of the noise-free cloud.
    Spacings(f64),
    /// Standard deviation in the unit of the shape.
    Units(f64),
}

/// Density that falls linearly along a world axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gradient {
    /// 0 for x, 1 for y, 2 for z.
    pub axis: usize,
    /// Ratio of the density at the low end to that at the high end, at least 1. Points are removed, none added.
    pub ratio: f64,
}

/// A sampled shape with its truth.
#[derive(Clone, Debug, PartialEq)]
pub struct Sampled {
    /// The cloud that a scanner would deliver.
    pub cloud: Cloud,
    /// `(N, 3)` the same points without noise.
    pub clean: Vec<[f64; 3]>,
    /// `(N)` face of the shape from which each point was taken.
    pub faces: Vec<u32>,
    /// The shape's network.
    pub truth: Truth,
    /// Mean distance to the 6 nearest neighbours in the noise-free cloud.
    pub spacing: f64,
}

impl Scan {
    /// A noise-free scan with seed 0.
    pub fn new(sampling: Sampling) -> Self {
        Self { sampling, noise: Noise::None, gradient: None, seed: 0 }
    }

    /// With noise of this standard deviation in mean spacings.
    pub fn noise(self, spacings: f64) -> Self {
        Self { noise: Noise::Spacings(spacings), ..self }
    }

    /// With the density falling along a world axis, `ratio` to 1.
    pub fn gradient(self, axis: usize, ratio: f64) -> Self {
        Self { gradient: Some(Gradient { axis, ratio }), ..self }
    }

    /// With another seed.
    pub fn seed(self, seed: u64) -> Self {
        Self { seed, ..self }
    }
}

impl Shape {
    /// Samples the shape.
    pub fn sample(&self, scan: &Scan) -> Sampled {
        let mut rng = Rng::new(scan.seed);
        let (mut clean, mut faces) = match scan.sampling {
            Sampling::Grid { step } => lattice::grid(self, step),
            Sampling::Area { count } => uniform::by_area(self, count, &mut rng),
            Sampling::BlueNoise { count } => uniform::blue_noise(self, count, &mut rng),
            Sampling::Scanner { views, pitch, distance, grazing_deg } => {
                scanner::scan(self, &scanner::Rig { views, pitch, distance, grazing_deg }, &mut rng)
            }
        };
        if let Some(gradient) = scan.gradient {
            thin(&mut clean, &mut faces, gradient, &mut rng);
        }
        Sampled::new(clean, faces, self.network.clone(), scan.noise, &mut rng)
    }
}

impl Sampled {
    /// Measures the spacing and adds the noise.
    pub(in crate::shapes) fn new(
        clean: Vec<[f64; 3]>,
        faces: Vec<u32>,
        truth: Truth,
        noise: Noise,
        rng: &mut Rng,
    ) -> Self {
        let spacing = mean_spacing(&clean);
        let sigma = match noise {
            Noise::None => 0.0,
            Noise::Spacings(share) => share * spacing,
            Noise::Units(sigma) => sigma,
        };
        let blurred = |p: &[f64; 3]| p.map(|x| if sigma > 0.0 { x + sigma * rng.gaussian() } else { x });
        let cloud = Cloud::new(clean.iter().map(blurred).collect());
        Self { cloud, clean, faces, truth, spacing }
    }

    /// `(N)` distances of the noise-free points from the nearest curve of the truth (weak stretches left out);
    /// infinite if it has none.
    pub fn distances(&self) -> Vec<f64> {
        let index = self.truth.index(self.spacing / 4.0);
        self.clean.iter().map(|&p| index.distance(p)).collect()
    }

    /// `(N)` labels: 1 within one spacing of the truth, 2 within 1.5, 3 within 1.5 of a weak stretch alone
    /// (don't care), 0 elsewhere.
    pub fn labels(&self) -> Vec<u8> {
        let weak = self.truth.index_of_weak(self.spacing / 4.0);
        let label = |(&p, d): (&[f64; 3], f64)| match d / self.spacing {
            d if d <= 1.0 => 1,
            d if d <= 1.5 => 2,
            _ if weak.distance(p) <= 1.5 * self.spacing => 3,
            _ => 0,
        };
        self.clean.iter().zip(self.distances()).map(label).collect()
    }

    /// The same scan moved by a map that keeps distances up to the factor `scale`.
    pub fn map(&self, scale: f64, map: impl Fn([f64; 3]) -> [f64; 3]) -> Self {
        let mut moved = self.clone();
        let truth = &mut moved.truth;
        let places = truth.nodes.iter_mut().map(|n| &mut n.position);
        let places = places.chain(truth.curves.iter_mut().flat_map(|c| &mut c.points));
        let clouds = moved.cloud.positions.iter_mut().chain(&mut moved.clean);
        places.chain(clouds).for_each(|p| *p = map(*p));
        moved.spacing *= scale;
        moved
    }
}

fn thin(points: &mut Vec<[f64; 3]>, faces: &mut Vec<u32>, gradient: Gradient, rng: &mut Rng) {
    let Gradient { axis, ratio } = gradient;
    let coordinate = |p: &[f64; 3]| p[axis.min(2)];
    let low = points.iter().map(coordinate).fold(f64::INFINITY, f64::min);
    let high = points.iter().map(coordinate).fold(f64::NEG_INFINITY, f64::max);
    if low >= high {
        return;
    }
    let chance = |p: &[f64; 3]| 1.0 - (1.0 - 1.0 / ratio) * (coordinate(p) - low) / (high - low);
    let kept: Vec<bool> = points.iter().map(|p| rng.uniform() < chance(p)).collect();
    let (mut i, mut j) = (0, 0);
    points.retain(|_| (kept[i], i += 1).0);
    faces.retain(|_| (kept[j], j += 1).0);
}
