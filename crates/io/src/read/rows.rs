//! The columns that rows of a file go into, and the decoding of rows of fixed size.

mod parts;

pub(crate) use parts::Part;

use crate::columns::{Endian, SHARED, Scalar, Stored, append_as, append_points, push, truncate};
use crate::error::Error;
use crate::read::Decoded;
use crate::source::Source;
use lineament::{Attribute, Cloud};

/// Bytes decoded at a time: they stay in the second-level cache while every column takes its part.
const CHUNK: usize = 1 << 17;
/// Bytes of rows from which on more are decoded at a time, so that threads can share them.
const MANY: u64 = 1 << 24;

/// The place of a number in a row.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Field {
    pub offset: usize,
    pub kind: Scalar,
}

/// Coordinates that are stored as integers: `integer * scale + offset`.
#[derive(Clone)]
pub(crate) struct Grid {
    pub scale: [f64; 3],
    pub offset: [f64; 3],
    /// Least and greatest coordinates that the header states, and how many points lie outside them.
    pub bounds: [[f64; 3]; 2],
    pub outside: usize,
}

impl Grid {
    /// The point at the start of a row: three little endian integers.
    fn place(&mut self, row: &[u8]) -> [f64; 3] {
        let stored = |axis: usize| i32::from_bytes(&row[4 * axis..], Endian::Little);
        let point = std::array::from_fn(|a| f64::from(stored(a)) * self.scale[a] + self.offset[a]);
        let [low, high] = &self.bounds;
        self.outside += usize::from(!(0..3).all(|a| point[a] >= low[a] && point[a] <= high[a]));
        point
    }
}

/// Growing columns.
pub(crate) struct Table {
    pub positions: Vec<[f64; 3]>,
    /// Field index of x, y and z.
    pub axes: [usize; 3],
    /// Field index and column of every attribute.
    pub columns: Vec<(usize, Attribute)>,
    /// The grid of the coordinates, if they are on one; they are then the first fields of a row.
    pub grid: Option<Grid>,
}

impl Table {
    /// Empty columns with room for `room` rows.
    pub fn new(axes: [usize; 3], attributes: Vec<(usize, String, Scalar)>, room: usize) -> Self {
        let column = |(index, name, kind): (usize, String, Scalar)| {
            (index, Attribute { name, values: kind.column(room) })
        };
        Self {
            positions: Vec::with_capacity(room),
            axes,
            columns: attributes.into_iter().map(column).collect(),
            grid: None,
        }
    }

    /// Makes room for `rows` more rows.
    pub fn reserve(&mut self, rows: usize) {
        self.positions.reserve_exact(rows);
        for (_, attribute) in &mut self.columns {
            crate::columns::each_column!(&mut attribute.values, values => values.reserve_exact(rows));
        }
    }

    /// Bytes that a row takes in memory.
    pub fn row_bytes(&self) -> usize {
        24 + self.columns.iter().map(|(_, a)| Scalar::of(&a.values).size()).sum::<usize>()
    }

    /// Appends one row from its values, indexed by field. The field whose type cannot hold its value is the error.
    pub fn push(&mut self, values: &[f64]) -> Result<(), usize> {
        for (index, attribute) in &mut self.columns {
            if !push(&mut attribute.values, values[*index]) {
                return Err(*index);
            }
        }
        self.positions.push(self.axes.map(|i| values[i]));
        Ok(())
    }

    /// Drops the values of an unfinished row.
    pub fn level(&mut self) {
        for (_, attribute) in &mut self.columns {
            truncate(&mut attribute.values, self.positions.len());
        }
    }

    /// Appends the whole rows of `bytes`, `stride` bytes each.
    pub fn append(&mut self, bytes: &[u8], stride: usize, fields: &[Field], endian: Endian) {
        if let Some(grid) = &mut self.grid {
            self.positions.extend(bytes.chunks_exact(stride).map(|row| grid.place(row)));
        } else if let [x, y, z] = self.axes.map(|axis| fields[axis])
            && [x.kind, y.kind] == [z.kind; 2]
        {
            let offsets = [x.offset, y.offset, z.offset];
            append_points(&mut self.positions, bytes, stride, (x.kind, offsets), endian);
        } else {
            let first = self.positions.len();
            self.positions.resize(first + bytes.len() / stride, [0.0; 3]);
            for (axis, &index) in self.axes.iter().enumerate() {
                let Field { offset, kind } = fields[index];
                kind.fill_axis(bytes, stride, offset, endian, &mut self.positions[first..], axis);
            }
        }
        for (index, attribute) in &mut self.columns {
            let Field { offset, kind } = fields[*index];
            append_as(kind, &mut attribute.values, bytes, stride, offset, endian);
        }
    }

    /// Reads up to `count` rows of `stride` bytes from the source; gives how many were there whole.
    pub fn read(
        &mut self,
        source: &mut Source,
        count: u64,
        stride: usize,
        fields: &[Field],
        endian: Endian,
    ) -> Result<u64, Error> {
        let mut done = 0;
        let many = count.saturating_mul(stride as u64) > MANY;
        let chunk = if many { 2 * SHARED } else { CHUNK };
        while done < count {
            let here = source.peek(stride.max(chunk))?;
            let rows = ((here.len() / stride) as u64).min(count - done) as usize;
            if rows == 0 {
                break;
            }
            self.append(&here[..rows * stride], stride, fields, endian);
            source.consume(rows * stride);
            done += rows as u64;
        }
        Ok(done)
    }

    /// The finished cloud.
    pub fn into_cloud(self) -> Cloud {
        let attributes = self.columns.into_iter().map(|(_, attribute)| attribute).collect();
        Cloud { positions: self.positions, attributes }
    }
}

/// Rows to make room for: the announced number, up to the number that the bytes of the input can hold.
pub(crate) fn room(source: &Source, announced: u64, least_bytes: u64) -> usize {
    let possible = source.remaining().map_or(1 << 16, |bytes| bytes / least_bytes.max(1));
    announced.min(possible) as usize
}

/// Refuses rows of text behind those that the header announces as `announced`: a part would be read in silence.
pub(crate) fn no_more_rows(source: &mut Source, announced: &str) -> Result<(), Error> {
    while let Some(line) = source.line()? {
        if crate::number::token(line).is_some() {
            let found = format!("more rows than the {announced} of the header");
            let advice = "the header and the rows do not agree; the file is damaged";
            return Err(source.malformed_line(found, advice));
        }
    }
    Ok(())
}

/// Says how many bytes stand behind the last `unit` that the header announces: a warning, if they would do for one more.
pub(crate) fn note_extra(extra: u64, row: u64, unit: &str, out: &mut Decoded) {
    let what = format!("{extra} bytes after the last {unit} that the header announces");
    if extra >= row.max(1) {
        out.warnings.push(what);
    } else if extra > 0 {
        out.ignored.push(what);
    }
}
