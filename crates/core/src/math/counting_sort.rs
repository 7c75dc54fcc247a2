//! Counting sort: sorts by small numbers in linear time.

/// Steps in a unit: numbers in the same step count as equal.
const STEPS: f64 = 1024.0;
/// Numbers above this are not told apart.
const GREATEST: usize = 16;

/// The indices of non-negative numbers, ascending by value to a thousandth; equal numbers keep their order.
pub(crate) fn ascending(numbers: &[f64]) -> Vec<u32> {
    let step = |&x: &f64| ((x * STEPS) as usize).min(GREATEST * STEPS as usize) as u32;
    let steps: Vec<u32> = numbers.iter().map(step).collect();
    dealt(&steps).0
}

/// The indices of numbers, ascending by value, where equal numbers keep their order; and `(greatest + 2)` beginning of the
/// indices of each value.
pub(crate) fn dealt(numbers: &[u32]) -> (Vec<u32>, Vec<u32>) {
    let last = numbers.iter().fold(0, |last, &x| x.max(last)) as usize;
    let mut starts = vec![0; last + 2];
    numbers.iter().for_each(|&x| starts[x as usize + 1] += 1);
    (0..=last).for_each(|x| starts[x + 1] += starts[x]);
    let (mut order, mut next) = (vec![0; numbers.len()], starts.clone());
    for (i, &x) in (0u32..).zip(numbers) {
        let place: &mut u32 = &mut next[x as usize];
        order[*place as usize] = i;
        *place += 1;
    }
    (order, starts)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn indices_come_by_value_and_equal_ones_as_they_came() {
        let numbers = [2.0, 0.0, 1e30, 0.5, 2.0, 0.002, 0.0, 2.0001];
        assert_eq!(ascending(&numbers), [1, 6, 5, 3, 0, 4, 7, 2]);
        assert!(ascending(&[]).is_empty());
    }

    #[test]
    fn values_begin_where_they_are_said_to() {
        assert_eq!(dealt(&[2, 0, 2, 3]), (vec![1, 0, 2, 3], vec![0, 1, 1, 3, 4]));
        assert_eq!(dealt(&[]), (vec![], vec![0, 0]));
    }
}
