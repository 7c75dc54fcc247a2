//! Ready scans by name, for the program's first run, the documentation and the tests.

use super::parts::*;
use super::sampling::{Sampled, Sampling, Scan};
use super::shape::Shape;

/// The default sample, which shows most: see [`samples`].
pub const DEFAULT_SAMPLE: &str = "bracket";

/// A ready scan of a shape.
#[derive(Clone, Copy, Debug)]
pub struct Sample {
    /// The name by which it is asked for.
    pub name: &'static str,
    /// One line of description for a list.
    pub description: &'static str,
    /// Makes the scan with a seed.
    pub make: fn(seed: u64) -> Sampled,
}

/// All samples, the default one first.
pub fn samples() -> &'static [Sample] {
    SAMPLES
}

/// The sample of this name.
pub fn sample(name: &str) -> Option<&'static Sample> {
    SAMPLES.iter().find(|s| s.name == name)
}

const SAMPLES: &[Sample] = &[
    Sample {
        name: "bracket",
        description: "L-bracket with a bore and a boss, scanned from 12 sides with noise of 0.1 spacings",
        make: |seed| bracket().sample(&scanner(12, 0.072, seed).noise(0.1)),
    },
    Sample {
        name: "random-cube",
        description: "Gumhold's random cube: 10,000 points between cubes of edge 1.6 and 2",
        make: |seed| random_cube(seed, 10_000),
    },
    Sample {
        name: "cube-386",
        description: "cube on a grid of 9 by 9 points a face, 386 in all, 92 on edges; the same for each seed",
        make: |_| cube_386(),
    },
    // No cube has a grid of 15,206 points: with m steps an edge it has 6 m^2 + 2.
    Sample {
        name: "cube-15206",
        description: "cube of 15,206 evenly spread points, the size of Demarsin's",
        make: |seed| even(&cube(1.0), 15_206, seed),
    },
    Sample {
        name: "cylinders",
        description: "two closed cylinders of unlike radii joined crosswise, 26,846 points",
        make: |seed| even(&cylinders(1.0, 0.6), 26_846, seed),
    },
    Sample {
        name: "equal-cylinders",
        description: "two closed cylinders of one radius: creases that fade out where they cross",
        make: |seed| even(&cylinders(1.0, 1.0), 26_846, seed),
    },
    Sample {
        name: "pipe-cross",
        description: "two pipes joined crosswise: ten smooth regions between loops, 26,846 points",
        make: |seed| even(&pipe_cross(), 26_846, seed),
    },
    Sample {
        name: "brick",
        description: "Demarsin's brick: five cylinders on an open box, 41,432 points, noise of 0.06 spacings",
        make: |seed| brick().sample(&Scan::new(Sampling::BlueNoise { count: 41_432 }).noise(0.06).seed(seed)),
    },
    Sample {
        name: "wedge",
        description: "block with a roof that folds by 40 degrees",
        make: |seed| even(&wedge(40.0), 20_000, seed),
    },
    Sample {
        name: "box",
        description: "box of 4 by 3 by 2, three times as dense at one end as at the other",
        make: |seed| {
            let scan = Scan::new(Sampling::BlueNoise { count: 30_000 }).gradient(0, 3.0).seed(seed);
            cuboid([4.0, 3.0, 2.0]).sample(&scan)
        },
    },
    Sample {
        name: "tapered-block",
        description: "block with slanted sides",
        make: |seed| even(&tapered_block(), 20_000, seed),
    },
    Sample {
        name: "star-prism",
        description: "prism over a star of five points",
        make: |seed| even(&star_prism(5), 20_000, seed),
    },
    Sample {
        name: "stepped-shaft",
        description: "turned shaft with a collar, a groove and a chamfer",
        make: |seed| even(&stepped_shaft(), 40_000, seed),
    },
    Sample {
        name: "sheet",
        description: "flat sheet with a round hole: borders only",
        make: |seed| even(&sheet_with_hole(), 15_000, seed),
    },
    Sample {
        name: "bent-sheet",
        description: "sheet bent by 60 degrees: a crease from border to border",
        make: |seed| even(&bent_sheet(60.0), 15_000, seed),
    },
    Sample {
        name: "tube",
        description: "open cylinder: two border loops",
        make: |seed| even(&tube(), 15_000, seed),
    },
    Sample {
        name: "cone",
        description: "cone on a disc: one circle and an apex",
        make: |seed| even(&cone(1.0, 2.0), 15_000, seed),
    },
    Sample {
        name: "sphere",
        description: "sphere with noise of 0.25 spacings: no feature at all",
        make: |seed| {
            sphere(1.0).sample(&Scan::new(Sampling::BlueNoise { count: 20_000 }).noise(0.25).seed(seed))
        },
    },
    Sample {
        name: "torus",
        description: "torus: no feature at all",
        make: |seed| even(&torus(1.0, 0.4), 20_000, seed),
    },
];

fn even(shape: &Shape, count: usize, seed: u64) -> Sampled {
    shape.sample(&Scan::new(Sampling::BlueNoise { count }).seed(seed))
}

fn scanner(views: u32, pitch: f64, seed: u64) -> Scan {
    Scan::new(Sampling::Scanner { views, pitch, distance: Some(4.0), grazing_deg: 80.0 }).seed(seed)
}
