//! Rows of a table that several threads fill, each its own part, whose coordinates stand on a grid.

use super::{Field, Grid, Table};
use crate::columns::{Endian, Number, each_column};

/// Neighbouring rows of a table: `(N, 3)` positions and the columns beside them.
pub(crate) struct Part<'a> {
    positions: &'a mut [[f64; 3]],
    columns: Vec<(usize, Box<dyn Values + 'a>)>,
    grid: Grid,
}

/// Neighbouring values of a column.
trait Values: Send {
    /// Fills values from `first` on with field `offset` of every row (`stride` bytes each).
    fn fill(&mut self, first: usize, rows: &[u8], stride: usize, offset: usize);
}

impl<T: Number> Values for &mut [T] {
    fn fill(&mut self, first: usize, rows: &[u8], stride: usize, offset: usize) {
        for (value, row) in self[first..].iter_mut().zip(rows.chunks_exact(stride)) {
            *value = T::from_bytes(&row[offset..], Endian::Little);
        }
    }
}

impl Part<'_> {
    /// Fills rows from `first` on from records of `stride` bytes.
    pub fn fill(&mut self, first: usize, records: &[u8], stride: usize, fields: &[Field]) {
        for (point, record) in self.positions[first..].iter_mut().zip(records.chunks_exact(stride)) {
            *point = self.grid.place(record);
        }
        for (index, values) in &mut self.columns {
            values.fill(first, records, stride, fields[*index].offset);
        }
    }

    /// The number of its points outside the bounds that the header states.
    pub fn outside(&self) -> usize {
        self.grid.outside
    }
}

impl Table {
    /// Gives the table so many rows of zeros, in memory that the system hands out when it is written to.
    pub fn zeros(&mut self, rows: usize) {
        self.positions = vec![[0.0; 3]; rows];
        for (_, attribute) in &mut self.columns {
            each_column!(&mut attribute.values, values => *values = vec![Default::default(); rows]);
        }
    }

    /// Keeps the first rows.
    pub fn truncate(&mut self, rows: usize) {
        self.positions.truncate(rows);
        self.level();
    }

    /// Parts of so many rows each, from row `first` on; `None` where coordinates do not stand on a grid.
    pub fn parts(&mut self, first: usize, lengths: &[usize]) -> Option<Vec<Part<'_>>> {
        let grid = Grid { outside: 0, ..self.grid.clone()? };
        let mut parts = Vec::with_capacity(lengths.len());
        for positions in split(&mut self.positions[first..], lengths) {
            parts.push(Part { positions, columns: Vec::new(), grid: grid.clone() });
        }
        for (index, attribute) in &mut self.columns {
            each_column!(&mut attribute.values, values => {
                for (part, values) in parts.iter_mut().zip(split(&mut values[first..], lengths)) {
                    part.columns.push((*index, Box::new(values)));
                }
            });
        }
        Some(parts)
    }

    /// Counts points outside the bounds that the header states.
    pub fn count_outside(&mut self, points: usize) {
        self.grid.iter_mut().for_each(|grid| grid.outside += points);
    }
}

/// Slices of so many values each, as far as there are any.
fn split<'a, T>(mut rest: &'a mut [T], lengths: &[usize]) -> impl Iterator<Item = &'a mut [T]> {
    lengths.iter().map(move |&length| {
        let length = length.min(rest.len());
        let (part, after) = std::mem::take(&mut rest).split_at_mut(length);
        rest = after;
        part
    })
}
