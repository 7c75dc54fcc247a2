//! Coordinates that lie on steps far coarser than the points lie apart: digits were lost before the file was written, as in
//! 32-bit numbers at map coordinates.

use lineament::Cloud;

/// Points that are looked at, spread over the cloud.
const SAMPLE: usize = 100_000;
/// Steps in use below which they may be faces of a part.
const LEAST_LEVELS: usize = 5;
/// Points a step above which the coordinate may be any number.
const POINTS: usize = 10;
/// Spacings that a step is at least. Points on a grid, or in rows, have steps of a few.
const SPACINGS: f64 = 4.0;
/// Share of a step that a level may lie beside a whole number of them.
const ROUNDING: f64 = 1e-3;

/// A sentence for each axis whose coordinates lie on coarse steps.
pub(super) fn warnings(cloud: &Cloud) -> Vec<String> {
    let stride = cloud.len().div_ceil(SAMPLE).max(1);
    let finite = |p: &&[f64; 3]| p.iter().all(|c| c.is_finite());
    let sample: Vec<[f64; 3]> = cloud.positions.iter().step_by(stride).filter(finite).copied().collect();
    let levels = [0, 1, 2].map(|axis| levels(&sample, axis));
    let mut extents = levels.each_ref().map(|levels| match levels.as_slice() {
        [first, .., last] => last - first,
        _ => 0.0,
    });
    extents.sort_by(|a, b| b.total_cmp(a));
    // As if the points lay evenly on the largest side of their box: a surface of other form has more area.
    let spacing = (extents[0] * extents[1] / cloud.len().max(1) as f64).sqrt();
    let found = ["x", "y", "z"].into_iter().zip(&levels).filter_map(|(axis, levels)| {
        let step = step(levels).filter(|_| levels.len() * POINTS <= sample.len())?;
        let coarse = spacing > 0.0 && step > SPACINGS * spacing;
        coarse.then(|| {
            format!(
                "{axis} lies on steps of {step}, coarser than the points lie apart (about {spacing:.2e}): digits were lost, \
                 perhaps in 32-bit numbers; shift the coordinates before they are stored in such"
            )
        })
    });
    found.collect()
}

/// The distinct coordinates on an axis, in order.
fn levels(sample: &[[f64; 3]], axis: usize) -> Vec<f64> {
    let mut levels: Vec<f64> = sample.iter().map(|p| p[axis]).collect();
    levels.sort_unstable_by(f64::total_cmp);
    levels.dedup();
    levels
}

/// The least distance of neighbouring levels, if every other one is a multiple of it.
fn step(levels: &[f64]) -> Option<f64> {
    let gaps = || levels.windows(2).map(|pair| pair[1] - pair[0]);
    let step = gaps().fold(f64::INFINITY, f64::min);
    let whole = |gap: f64| (gap / step - (gap / step).round()).abs() < ROUNDING;
    (levels.len() >= LEAST_LEVELS && step > 0.0 && gaps().all(whole)).then_some(step)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A slanted wall of 200 by 100 points, half a hundredth apart, at `offset`, through `store`.
    fn wall(offset: f64, store: impl Fn(f64) -> f64) -> Cloud {
        let point = |i: u32| {
            let (along, up) = (f64::from(i % 200) * 0.0517, f64::from(i / 200) * 0.0493);
            [offset + 0.6 * along, offset + 0.8 * along, up].map(&store)
        };
        Cloud { positions: (0..20_000).map(point).collect(), attributes: Vec::new() }
    }

    #[test]
    fn single_precision_at_map_coordinates_is_a_warning_with_its_step() {
        let lost = warnings(&wall(5_648_000.0, |c| f64::from(c as f32)));
        assert_eq!(lost.len(), 2, "{lost:?}");
        assert!(lost[1].starts_with("y lies on steps of 0.5,"), "{lost:?}");
        assert!(warnings(&wall(5_648_000.0, |c| c)).is_empty());
        assert!(warnings(&wall(100.0, |c| f64::from(c as f32))).is_empty());
    }

    #[test]
    fn grids_and_faces_of_parts_are_none() {
        let grid = |i: u32| [f64::from(i % 100), f64::from(i / 100), f64::from(i % 7) * 0.1];
        let cloud = |point: &dyn Fn(u32) -> [f64; 3]| Cloud {
            positions: (0..10_000).map(point).collect(),
            attributes: Vec::new(),
        };
        assert!(warnings(&cloud(&grid)).is_empty());
        let stair = |i: u32| [f64::from(i % 100) * 0.01, f64::from(i / 100) * 0.01, f64::from(i / 2500)];
        assert!(warnings(&cloud(&stair)).is_empty());
    }
}
