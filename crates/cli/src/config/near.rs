//! The name that was likely meant.

/// Letters from which on a name that goes on after the wrong one is taken to be meant.
const BEGUN: usize = 4;

/// The known name nearest to a wrong one: one that ends in it behind a dot, or else the shortest that goes on after it, or else one
/// that few changed letters turn into it.
pub fn nearest<'a>(wrong: &str, known: impl Iterator<Item = &'a str> + Clone) -> Option<&'a str> {
    let ends = |name: &&str| name.rsplit('.').next().is_some_and(|last| last.eq_ignore_ascii_case(wrong));
    let begun = |name: &&str| {
        let whole = name.get(..wrong.len()).is_some_and(|start| start.eq_ignore_ascii_case(wrong));
        whole && wrong.len() >= BEGUN
    };
    let begun = || known.clone().filter(begun).min_by_key(|name| name.len());
    known.clone().find(ends).or_else(begun).or_else(|| {
        let all = known.map(|name| (changes(&wrong.to_ascii_lowercase(), &name.to_ascii_lowercase()), name));
        let least = all.min_by_key(|&(changes, _)| changes)?;
        // A third of the letters, and one at least is right.
        (3 * least.0 <= wrong.len().max(3) && least.0 < wrong.len()).then_some(least.1)
    })
}

/// Letters to insert, leave out, replace or swap with the next to get from one word to another (optimal string alignment).
fn changes(a: &str, b: &str) -> usize {
    let (a, b): (Vec<char>, Vec<char>) = (a.chars().collect(), b.chars().collect());
    let mut rows: [Vec<usize>; 3] = [Vec::new(), Vec::new(), (0..=b.len()).collect()];
    for i in 1..=a.len() {
        rows.rotate_left(1);
        let mut row = vec![i];
        for j in 1..=b.len() {
            let replaced = rows[1][j - 1] + usize::from(a[i - 1] != b[j - 1]);
            let mut least = replaced.min(rows[1][j] + 1).min(row[j - 1] + 1);
            if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                least = least.min(rows[0][j - 2] + 1);
            }
            row.push(least);
        }
        rows[2] = row;
    }
    rows[2].last().copied().unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_name_is_the_one_with_the_fewest_changes() {
        let known = ["penalty.gamma", "penalty.rho", "segments.form", "spanning.rho"];
        let near = |wrong| nearest(wrong, known.into_iter());
        assert_eq!(near("gamma"), Some("penalty.gamma"));
        assert_eq!(near("penalty.gama"), Some("penalty.gamma"));
        assert_eq!(near("spaning.rho"), Some("spanning.rho"));
        assert_eq!(near("colour"), None);
        let forms = ["penalty.form", "penalty.fold_deg", "penalty.fold_deg_least"];
        assert_eq!(nearest("penalty.fold", forms.into_iter()), Some("penalty.fold_deg"));
        assert_eq!(nearest("q", ["x", "y"].into_iter()), None);
        assert_eq!(changes("penlaty", "penalty"), 1);
        assert_eq!(changes("", "abc"), 3);
    }
}
