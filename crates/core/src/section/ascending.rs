//! Sorting by a number and then by index, in one word.

/// The indices of numbers that are not negative, ascending by their values in f32, equal ones as they come.
pub(crate) fn ascending(numbers: impl Iterator<Item = f64>) -> impl Iterator<Item = u32> {
    // Such numbers order as their bits do: value and index go into one word.
    let word = |(x, i): (f64, u64)| u64::from((x as f32).to_bits()) << 32 | i;
    let mut words: Vec<u64> = numbers.zip(0..).map(word).collect();
    words.sort_unstable();
    words.into_iter().map(|word| word as u32)
}

#[cfg(test)]
mod tests {
    use super::ascending;

    #[test]
    fn indices_come_by_value_and_equal_ones_as_they_came() {
        let numbers = [2.0, 0.0, 1e30, 0.5, 2.0, 1e-30, 0.0];
        assert_eq!(ascending(numbers.into_iter()).collect::<Vec<_>>(), [1, 6, 5, 3, 0, 4, 2]);
    }
}
