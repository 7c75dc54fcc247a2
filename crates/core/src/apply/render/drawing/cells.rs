//! The places of several views on one sheet.

/// A part of a sheet, in pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::apply::render) struct Cell {
    /// Its upper left corner.
    pub corner: [usize; 2],
    /// Its width and height.
    pub size: [usize; 2],
}

/// Cells of one size, row by row from the upper left corner: so many columns that their shorter side is longest.
pub(in crate::apply::render) fn cells(count: usize, width: usize, height: usize) -> Vec<Cell> {
    let size = |columns: usize| [width / columns, height / count.div_ceil(columns)];
    let shorter = |columns: &usize| size(*columns).into_iter().min();
    // Of equals the last one counts: a row rather than a column.
    let columns = (1..=count).max_by_key(shorter).unwrap_or(1);
    let [w, h] = size(columns).map(|side| side.max(1));
    (0..count).map(|i| Cell { corner: [i % columns * w, i / columns * h], size: [w, h] }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_fill_the_sheet_in_rows() {
        let corners = |n, w, h| cells(n, w, h).iter().map(|c| c.corner).collect::<Vec<_>>();
        assert_eq!(cells(1, 160, 120), [Cell { corner: [0, 0], size: [160, 120] }]);
        assert_eq!(corners(4, 160, 120), [[0, 0], [80, 0], [0, 60], [80, 60]]);
        assert_eq!(corners(2, 160, 120), [[0, 0], [80, 0]]);
        assert_eq!(corners(2, 120, 300), [[0, 0], [0, 150]]);
    }
}
