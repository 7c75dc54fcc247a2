//! The assignment of least cost between two sets, by shortest augmenting paths (Jonker and Volgenant, 1987).

/// For each row the column it is assigned to, so that the sum of the costs is least. `cost` gives finite numbers for
/// `rows <= columns`; the time is the square of the rows times the columns.
pub(super) fn assign(rows: usize, columns: usize, cost: impl Fn(usize, usize) -> f64) -> Vec<usize> {
    // Index 0 of columns stands for none, as the row being placed begins there.
    let (mut u, mut v) = (vec![0.0; rows + 1], vec![0.0; columns + 1]);
    let mut owner = vec![0; columns + 1];
    for row in 1..=rows {
        owner[0] = row;
        let (mut least, mut from) = (vec![f64::INFINITY; columns + 1], vec![0; columns + 1]);
        let mut done = vec![false; columns + 1];
        let mut at = 0;
        while owner[at] != 0 {
            done[at] = true;
            let (here, mut step, mut next) = (owner[at], f64::INFINITY, 0);
            for column in (1..=columns).filter(|&c| !done[c]) {
                let reduced = cost(here - 1, column - 1) - u[here] - v[column];
                if reduced < least[column] {
                    (least[column], from[column]) = (reduced, at);
                }
                if least[column] < step {
                    (step, next) = (least[column], column);
                }
            }
            for column in 0..=columns {
                if done[column] {
                    u[owner[column]] += step;
                    v[column] -= step;
                } else {
                    least[column] -= step;
                }
            }
            at = next;
        }
        while at != 0 {
            owner[at] = owner[from[at]];
            at = from[at];
        }
    }
    let mut assigned = vec![0; rows];
    (1..=columns).filter(|&c| owner[c] > 0).for_each(|c| assigned[owner[c] - 1] = c - 1);
    assigned
}

#[cfg(test)]
mod tests {
    use super::assign;
    use crate::shapes::Rng;

    /// The least cost of all assignments of the rows from `row` on.
    fn least(costs: &[Vec<f64>], row: usize, taken: &mut Vec<bool>) -> f64 {
        let Some(here) = costs.get(row) else { return 0.0 };
        let mut best = f64::INFINITY;
        for (column, cost) in here.iter().enumerate() {
            if !std::mem::replace(&mut taken[column], true) {
                best = best.min(cost + least(costs, row + 1, taken));
                taken[column] = false;
            }
        }
        best
    }

    #[test]
    fn no_assignment_costs_less() {
        let mut rng = Rng::new(7);
        for (rows, columns) in [(1, 1), (3, 3), (5, 5), (4, 6), (2, 7)] {
            for _ in 0..20 {
                let row = |rng: &mut Rng| (0..columns).map(|_| (rng.uniform() * 8.0).floor()).collect();
                let costs: Vec<Vec<f64>> = (0..rows).map(|_| row(&mut rng)).collect();
                let found = assign(rows, columns, |r, c| costs[r][c]);
                let mut taken = found.clone();
                taken.sort_unstable();
                taken.dedup();
                assert_eq!(taken.len(), rows, "{found:?}");
                let sum: f64 = found.iter().enumerate().map(|(r, &c)| costs[r][c]).sum();
                assert_eq!(sum, least(&costs, 0, &mut vec![false; columns]));
            }
        }
    }
}
