//! The median that LAZ guesses a step with: of the last steps, of which a new one takes the place of the greatest or
//! the least in turn, so that it follows the numbers.

/// Five steps in order.
#[derive(Clone, Copy)]
pub(super) struct Median {
    values: [i32; 5],
    /// Whether the greatest goes next.
    high: bool,
}

impl Median {
    pub(super) fn new() -> Self {
        Self { values: [0; 5], high: true }
    }

    #[inline]
    pub(super) fn get(&self) -> i32 {
        self.values[2]
    }

    /// Puts a step in. The end that loses one changes only if the step lands on its own side of the median.
    #[inline]
    pub(super) fn add(&mut self, value: i32) {
        let v = &mut self.values;
        if self.high {
            let at = v[..4].iter().take_while(|&&other| value >= other).count();
            self.high = value < v[2];
            v.copy_within(at..4, at + 1);
            v[at] = value;
        } else {
            let at = 4 - v[1..].iter().rev().take_while(|&&other| other >= value).count();
            self.high = v[2] >= value;
            v.copy_within(1..=at, 0);
            v[at] = value;
        }
    }
}
