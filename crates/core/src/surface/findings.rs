//! Findings of the stage `surface` in a cloud: figures, and sentences for the user.

/// Share of the points in rows, or in leaves, above which a note reports them.
const TOLD: f64 = 0.05;
/// Greatest ratio of the distances across and along rows at which lines on them are reliable.
const RELIABLE: f64 = 10.0;
/// The quantiles of the spacings between which the spread reaches.
const MOST: [f64; 2] = [0.05, 0.95];

/// The findings of the stage `surface`; lengths are in the local frame, or after `scaled` in the unit of the input.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Findings {
    /// Points on no surface that fill a volume: leaves, rubble, spray.
    pub scattered: usize,
    /// Other points on no surface: stray returns, veils between surfaces.
    pub stray: usize,
    /// Points represented by another: in rows, and where noise exceeds the spacing.
    pub thinned: usize,
    /// Points in rows.
    pub in_rows: usize,
    /// Median ratio of their distances across and along the rows.
    pub row_ratio: f64,
    /// Median of their distances across the rows.
    pub row_distance: f64,
    /// The range of spacings of nine in ten points on surfaces.
    pub spread: [f64; 2],
    /// Whether no surface was found: every point is clutter.
    pub none: bool,
}

impl Findings {
    /// The findings with lengths multiplied by `scale`.
    pub(crate) fn scaled(self, scale: f64) -> Findings {
        let spread = self.spread.map(|s| s * scale);
        Findings { row_distance: self.row_distance * scale, spread, ..self }
    }

    /// A line on the points not used, of `count` points in all; `None` if all are used.
    pub fn unused(&self, count: usize) -> Option<String> {
        let Findings { scattered, stray, thinned, .. } = self;
        let share = |some: usize| 100.0 * some as f64 / count as f64;
        let clutter = scattered + stray;
        let clutter = (clutter > 0).then(|| {
            format!(
                "{clutter} on no surface ({:.2} %; {scattered} in leaves or the like, {stray} stray)",
                share(clutter)
            )
        });
        let thinned = (*thinned > 0).then(|| format!("{thinned} in excess ({:.1} %)", share(*thinned)));
        let parts: Vec<String> = clutter.into_iter().chain(thinned).collect();
        (!parts.is_empty()).then(|| format!("not used: {}", parts.join(", ")))
    }

    /// Notes on findings that make a result doubtful, in a cloud of `count` points.
    pub(crate) fn notes(&self, count: usize) -> Vec<String> {
        let much = |some: usize| some as f64 > TOLD * count as f64;
        let share = |some: usize| 100.0 * some as f64 / count as f64;
        let mut notes = Vec::new();
        if self.none {
            notes.push("no surface was found: the points fill a volume, or scatter".into());
        }
        if much(self.scattered) {
            notes.push(format!(
                "{:.0} % of the points lie in leaves, rubble or the like",
                share(self.scattered)
            ));
        }
        if much(self.in_rows) {
            notes.push(self.rows(count));
        }
        notes
    }

    fn rows(&self, count: usize) -> String {
        let share = 100.0 * self.in_rows as f64 / count as f64;
        let advice = if self.row_ratio > RELIABLE {
            format!(
                ": lines there are not reliable; --voxel {:.3} makes the sampling even",
                0.5 * self.row_distance
            )
        } else {
            String::new()
        };
        format!("{share:.0} % of the points lie in rows {:.0}:1{advice}", self.row_ratio)
    }
}

/// The range of spacings of most points on surfaces.
pub(super) fn spread(spacing: &[f32], clutter: &[bool]) -> [f64; 2] {
    let mut some: Vec<f32> = spacing.iter().zip(clutter).filter(|&(_, &c)| !c).map(|(&s, _)| s).collect();
    let last = some.len().saturating_sub(1) as f64;
    MOST.map(|share| match some.len() {
        0 => 0.0,
        _ => f64::from(*some.select_nth_unstable_by((share * last) as usize, f32::total_cmp).1),
    })
}

#[cfg(test)]
mod tests {
    use super::Findings;

    #[test]
    fn rows_too_far_apart_are_told_with_the_voxel_that_helps_in_the_unit_of_the_input() {
        let rows = Findings { in_rows: 50, row_ratio: 12.0, row_distance: 0.5, ..Findings::default() };
        let notes = rows.scaled(4.0).notes(100);
        assert!(notes.len() == 1 && notes[0].contains("50 %") && notes[0].contains("12:1"), "{notes:?}");
        assert!(notes[0].contains("--voxel 1.000"), "{notes:?}");
        let near = Findings { row_ratio: 6.0, ..rows };
        assert!(!near.notes(100)[0].contains("--voxel"), "{:?}", near.notes(100));
        assert!(rows.notes(10_000).is_empty());
    }
}
