//! Divides a block of points into leaves like a k-d tree, by integers of its own coarse grid.
//!
//! Each point is packed into one word: its cell along the current axis, then its place in the block. Selection among words is
//! fast, and with cells of 2^-22 of the block leaves are as compact as with exact coordinates.

use super::leaf::{Aabb, BLOCK, Leaf, WIDTH};

/// Number of bits for a place in a block.
const PLACE_BITS: u32 = BLOCK.ilog2();
/// Cells along the longest side of a block.
const CELLS: u32 = 1 << (u32::BITS - PLACE_BITS);

/// The cells of the points of a block along the three axes; the fourth number is not used. Cells have 22 bits, which `f32`
/// holds exactly, and every processor compares four of those at once.
type Cells = [[f32; 4]; BLOCK];

/// Divides at most [`BLOCK`] points, of which the first has the index `first`, into leaves, all but the last full. Ties fall
/// to the lower index.
pub(super) fn leaves(points: &[[f64; 3]], first: u32, leaves: &mut [Leaf], boxes: &mut [Aabb]) {
    let cells = cells(points);
    let mut words: Vec<u32> = (0..points.len() as u32).collect();
    halve(&cells, &mut words, leaves.len());
    for ((words, leaf), around) in words.chunks(WIDTH).zip(leaves).zip(boxes) {
        let places = words.iter().map(|&word| place(word));
        *around = leaf.fill(places.map(|p| (first + p as u32, points[p])));
    }
}

fn cells(points: &[[f64; 3]]) -> Cells {
    let around = points.iter().fold(Aabb::EMPTY, |b, &p| b.join(&Aabb { min: p, max: p }));
    let longest = (0..3).map(|a| around.max[a] - around.min[a]).fold(0.0, f64::max);
    let per_length = if longest > 0.0 { f64::from(CELLS - 1) / longest } else { 0.0 };
    let cell =
        |p: &[f64; 3], a: usize| (((p[a] - around.min[a]) * per_length) as i32).min(CELLS as i32 - 1) as f32;
    let mut cells = [[0.0; 4]; BLOCK];
    for (cells, p) in cells.iter_mut().zip(points) {
        *cells = [cell(p, 0), cell(p, 1), cell(p, 2), 0.0];
    }
    cells
}

fn place(word: u32) -> usize {
    word as usize % BLOCK
}

/// Halves the points along the longest side of their box until each half is a leaf.
fn halve(cells: &Cells, words: &mut [u32], leaves: usize) {
    if words.len() <= WIDTH {
        return;
    }
    let axis = longest(cells, words);
    let word = |place: usize| (cells[place][axis] as u32) << PLACE_BITS | place as u32;
    words.iter_mut().for_each(|w| *w = word(place(*w)));
    let half = leaves.next_power_of_two() / 2;
    words.select_nth_unstable(half * WIDTH);
    let (low, high) = words.split_at_mut(half * WIDTH);
    halve(cells, low, half);
    halve(cells, high, leaves - half);
}

/// The axis of the greatest extent, the first among equals.
fn longest(cells: &Cells, words: &[u32]) -> usize {
    let (mut low, mut high) = ([f32::INFINITY; 4], [f32::NEG_INFINITY; 4]);
    for word in words {
        let cell = &cells[place(*word)];
        for a in 0..4 {
            low[a] = if cell[a] < low[a] { cell[a] } else { low[a] };
            high[a] = if cell[a] > high[a] { cell[a] } else { high[a] };
        }
    }
    let side = |a: usize| high[a] - low[a];
    (1..3).fold(0, |best, a| if side(a) > side(best) { a } else { best })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The leaves of a block with their boxes.
    fn split(points: &[[f64; 3]]) -> (Vec<Leaf>, Vec<Aabb>) {
        let count = points.len().div_ceil(WIDTH);
        let (mut split, mut boxes) = (vec![Leaf::EMPTY; count], vec![Aabb::EMPTY; count]);
        leaves(points, 100, &mut split, &mut boxes);
        (split, boxes)
    }

    #[test]
    fn every_point_is_in_one_leaf_and_in_its_box() {
        for count in [1, 16, 17, 500, BLOCK] {
            let point = |i: usize| [(i * 7919 % 1009) as f64, (i * 104_729 % 997) as f64, (i % 7) as f64];
            let points: Vec<[f64; 3]> = (0..count).map(point).collect();
            let (leaves, boxes) = split(&points);
            let mut seen = vec![0; count];
            for (k, (leaf, around)) in leaves.iter().zip(&boxes).enumerate() {
                assert!(leaf.len() == WIDTH || k + 1 == leaves.len());
                for (id, p) in leaf.points() {
                    assert_eq!(p, points[id as usize - 100]);
                    assert!((0..3).all(|a| around.min[a] <= p[a] && p[a] <= around.max[a]));
                    seen[id as usize - 100] += 1;
                }
            }
            assert!(seen.iter().all(|&n| n == 1), "{count}");
        }
    }

    #[test]
    fn leaves_of_a_square_are_compact() {
        let points: Vec<[f64; 3]> = (0..BLOCK).map(|i| [(i % 32) as f64, (i / 32) as f64, 0.0]).collect();
        for around in split(&points).1 {
            assert_eq!([0, 1].map(|a| around.max[a] - around.min[a]), [3.0, 3.0]);
        }
    }

    #[test]
    fn points_without_distance_and_tiny_or_huge_ones_do_no_harm() {
        for scale in [0.0, 1e-320, 1e150] {
            let points: Vec<[f64; 3]> = (0..40).map(|i| [f64::from(i) * scale, 0.0, scale]).collect();
            assert_eq!(split(&points).0.iter().map(Leaf::len).sum::<usize>(), 40);
        }
    }
}
