//! Transformations of nodes.

use super::document::Node;

/// Columns of a transformation: the images of the axes, then of the origin.
pub(super) type Transform = [[f64; 3]; 4];

pub(super) const IDENTITY: Transform = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0; 3]];

/// The transformation of points by a node and those above it.
pub(super) fn of(node: &Node, above: &Transform) -> Transform {
    let own: Transform = match &node.matrix {
        Some(m) => [0, 4, 8, 12].map(|column| [m[column], m[column + 1], m[column + 2]]),
        None => {
            let scale = node.scale.unwrap_or([1.0; 3]);
            let axes = rotation(node.rotation.unwrap_or([0.0, 0.0, 0.0, 1.0]));
            let scaled = |i: usize| axes[i].map(|c| c * scale[i]);
            [scaled(0), scaled(1), scaled(2), node.translation.unwrap_or([0.0; 3])]
        }
    };
    let linear: Transform = [above[0], above[1], above[2], [0.0; 3]];
    [apply(&linear, own[0]), apply(&linear, own[1]), apply(&linear, own[2]), apply(above, own[3])]
}

pub(super) fn apply(t: &Transform, p: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|axis| t[0][axis] * p[0] + t[1][axis] * p[1] + t[2][axis] * p[2] + t[3][axis])
}

/// The images of the axes under a rotation by the quaternion x, y, z, w.
fn rotation([x, y, z, w]: [f64; 4]) -> [[f64; 3]; 3] {
    [
        [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y + z * w), 2.0 * (x * z - y * w)],
        [2.0 * (x * y - z * w), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z + x * w)],
        [2.0 * (x * z + y * w), 2.0 * (y * z - x * w), 1.0 - 2.0 * (x * x + y * y)],
    ]
}
