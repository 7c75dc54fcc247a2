//! Points in groups that lie apart.

use std::collections::BTreeMap;

use super::ground::Spot;

/// The spots in groups: a group's squares of edge `step`, by `place`, touch each other. In the order of their first spots.
pub(super) fn parts(spots: &[Spot], place: impl Fn(&Spot) -> [f64; 2], step: f64) -> Vec<Vec<Spot>> {
    let square = |s: &Spot| place(s).map(|x| (x / step).floor() as i64);
    let mut squares: BTreeMap<[i64; 2], Vec<usize>> = BTreeMap::new();
    for (k, s) in spots.iter().enumerate() {
        squares.entry(square(s)).or_default().push(k);
    }
    let mut groups = Vec::new();
    for first in spots {
        let mut open = vec![square(first)];
        let mut group: Vec<usize> = Vec::new();
        while let Some([x, y]) = open.pop() {
            let Some(held) = squares.remove(&[x, y]) else { continue };
            group.extend(held);
            open.extend((0..9).map(|k| [x + k % 3 - 1, y + k / 3 - 1]));
        }
        if !group.is_empty() {
            group.sort_unstable();
            groups.push(group.into_iter().map(|k| spots[k]).collect());
        }
    }
    groups
}
