//! Which points each slab holds (section 2).

use crate::parallel;

/// The members of each slab, ascending: lists one after the other, and where each begins.
pub(crate) struct Slabs {
    starts: Vec<usize>,
    indices: Vec<u32>,
}

impl Slabs {
    /// Sorts `count` members by the heights that they span into the slabs that reach `half` to either side of ascending `planes`;
    /// slabs may overlap.
    pub(crate) fn of(
        count: usize,
        span: impl Fn(usize) -> (f64, f64) + Sync,
        planes: &[f64],
        half: f64,
    ) -> Self {
        let ranges = parallel::map(count, parallel::QUICK, |i| {
            let (low, high) = span(i);
            let first = planes.partition_point(|&z| z < low - half);
            (first, planes[first..].iter().take_while(|&&z| z <= high + half).count())
        });
        let mut starts = vec![0usize; planes.len() + 1];
        for &(first, count) in &ranges {
            starts[first + 1..first + 1 + count].iter_mut().for_each(|s| *s += 1);
        }
        for k in 0..planes.len() {
            starts[k + 1] += starts[k];
        }
        let mut next = starts.clone();
        let mut indices = vec![0u32; starts[planes.len()]];
        for (i, (first, count)) in ranges.into_iter().enumerate() {
            for slot in &mut next[first..first + count] {
                indices[*slot] = i as u32;
                *slot += 1;
            }
        }
        Self { starts, indices }
    }

    /// The members of one slab.
    pub(crate) fn of_plane(&self, plane: usize) -> &[u32] {
        &self.indices[self.starts[plane]..self.starts[plane + 1]]
    }

    /// The members of any slab, out of `count`, ascending, each once.
    pub(crate) fn union(&self, count: usize) -> Vec<u32> {
        let mut inside = vec![false; count];
        self.indices.iter().for_each(|&i| inside[i as usize] = true);
        (0..count as u32).filter(|&i| inside[i as usize]).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slabs_hold_what_comes_within_their_half_thickness() {
        let span = |i: usize| ((i * 37 % 100) as f64 / 10.0, (i * 37 % 100 + i % 3) as f64 / 10.0);
        let planes = [-3.0, 2.0, 2.5, 9.0];
        let slabs = Slabs::of(100, span, &planes, 1.0);
        for (plane, z) in planes.iter().enumerate() {
            let near = |&i: &u32| span(i as usize).0 <= z + 1.0 && span(i as usize).1 >= z - 1.0;
            assert_eq!(slabs.of_plane(plane), (0..100).filter(near).collect::<Vec<u32>>());
        }
    }
}
