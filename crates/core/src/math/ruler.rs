//! A table over ascending numbers, by which a position among them is found in constant time.

/// A table over ascending numbers from 0 on.
#[derive(Clone, Debug, Default)]
pub(crate) struct Ruler {
    /// Number of cells in a unit.
    cells: f64,
    /// The index of the first number in or after each cell.
    starts: Vec<u32>,
}

impl Ruler {
    /// About as many cells as numbers.
    pub(crate) fn new(numbers: impl ExactSizeIterator<Item = f64>, length: f64) -> Self {
        let count = numbers.len().max(1);
        let cells = if length > 0.0 { count as f64 / length } else { 0.0 };
        let mut starts = Vec::with_capacity(count + 2);
        let last = numbers.len() as u32;
        for (i, x) in numbers.enumerate() {
            let cell = (x * cells) as usize;
            if starts.len() <= cell.min(count) {
                starts.resize(cell.min(count) + 1, i as u32);
            }
        }
        starts.resize(count + 2, last);
        Self { cells, starts }
    }

    /// The index of the first number for which `below` does not hold, as for `partition_point`; `below` must hold for all
    /// in cells before that of `x`, and for none in cells after it.
    pub(crate) fn first(&self, x: f64, below: impl Fn(usize) -> bool) -> usize {
        let cell = ((x * self.cells) as usize).min(self.starts.len() - 2);
        let (mut i, end) = (self.starts[cell] as usize, self.starts[self.starts.len() - 1] as usize);
        while i < end && below(i) {
            i += 1;
        }
        i
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_agree_with_a_search() {
        let mut numbers: Vec<f64> = (0..200u32).map(|i| f64::from(i * 7919 % 1009) / 100.0).collect();
        numbers.sort_by(f64::total_cmp);
        for length in [10.1, 3.0, 0.0] {
            let ruler = Ruler::new(numbers.iter().copied(), length);
            for x in (0..1200).map(|i| f64::from(i) / 100.0 - 0.5) {
                let wanted = numbers.partition_point(|&n| n < x);
                assert_eq!(ruler.first(x, |i| numbers[i] < x), wanted, "{x}");
            }
        }
        assert_eq!(Ruler::new(std::iter::empty(), 2.0).first(1.0, |_| true), 0);
    }
}
