//! Points as small discs.

use super::camera::Camera;

/// A point with the disc that stands for its piece of the surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surfel {
    /// World frame.
    pub position: [f64; 3],
    /// Unit normal, either sign; zero where none is known, and the disc then faces the eye.
    pub normal: [f32; 3],
    /// Radius that closes the gaps to the neighbours, in the unit of the points.
    pub radius: f32,
}

impl Surfel {
    /// The surfel as `camera` sees it.
    pub(super) fn project(&self, camera: &Camera) -> Projected {
        let [x, y, z] = camera.rotate(self.normal.map(f64::from)).map(|x| x as f32);
        let normal = match z {
            z if z > 0.0 => [x, y, z],
            z if z < 0.0 => [-x, -y, -z],
            _ if x == 0.0 && y == 0.0 => [0.0, 0.0, 1.0],
            _ => [x, y, 0.0],
        };
        let radius = (f64::from(self.radius) * camera.scale) as f32;
        Projected { at: camera.project(self.position), normal, radius }
    }
}

/// A surfel on the picture, in pixels.
#[derive(Clone, Copy, Debug)]
pub(super) struct Projected {
    /// x to the right, y down, depth towards the eye.
    pub at: [f32; 3],
    /// Unit normal in the axes of the picture (y up), turned to the eye.
    pub normal: [f32; 3],
    /// Pixels.
    pub radius: f32,
}

/// How much a disc may be tilted before it is drawn as if it were less: keeps it from becoming a needle.
const LEAST_FACING: f32 = 0.15;

impl Projected {
    /// Change of depth a pixel to the right and a pixel down on the disc.
    pub fn slope(&self) -> [f32; 2] {
        let facing = self.normal[2].max(LEAST_FACING);
        [-self.normal[0] / facing, self.normal[1] / facing]
    }
}
