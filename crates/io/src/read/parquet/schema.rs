//! The choice of columns of a Parquet file, and their types.

use crate::columns::Scalar;
use crate::error::{Error, Place};
use crate::read::table::{find_axes, known};
use crate::read::{Decoded, ReadOptions};
use crate::source::Source;
use ::parquet::basic::{ConvertedType, LogicalType, Type as Physical};
use ::parquet::schema::types::{ColumnDescriptor, SchemaDescriptor};
use lineament::Column;

/// A column that is read.
pub(super) struct Wanted {
    /// Its index among the leaves of the schema.
    pub index: usize,
    pub name: String,
    /// x, y or z as 0, 1 or 2.
    pub axis: Option<usize>,
    /// The definition level of values that are not null.
    pub level: i16,
    /// The type in the file; integers with nulls become doubles.
    pub kind: Scalar,
    pub values: Column,
}

impl Wanted {
    /// Bytes of a value in memory; nulls make integers wider.
    pub fn bytes(&self) -> usize {
        if self.level > 0 && self.kind.is_integer() { 8 } else { self.kind.size() }
    }

    /// Empties the column, and gives it room for so many values and no more.
    pub fn reserve(&mut self, rows: usize) {
        self.values = Scalar::of(&self.values).column(rows);
    }
}

/// The columns to read; the others are noted.
pub(super) fn wanted(
    source: &Source,
    schema: &SchemaDescriptor,
    options: &ReadOptions,
    out: &mut Decoded,
) -> Result<Vec<Wanted>, Error> {
    let columns: Vec<(usize, &ColumnDescriptor, Scalar)> = (0..schema.num_columns())
        .filter_map(|index| {
            let column = &schema.columns()[index];
            let kind = kind(column);
            if kind.is_none() {
                out.ignored.push(format!("column `{}`: no flat column of numbers", column.path().string()));
            }
            kind.map(|kind| (index, column.as_ref(), kind))
        })
        .collect();
    let names: Vec<String> = columns.iter().map(|(_, column, _)| column.name().to_string()).collect();
    let Some([x, y, z]) = find_axes(&names) else {
        let found = match names.as_slice() {
            [] => format!("no flat column of numbers among {}", schema.num_columns()),
            _ => format!("columns of numbers called {}", names.join(", ")),
        };
        return Err(source.fault(
            Place::Byte(0),
            found,
            format!("no three of them are coordinates: {}", known()),
        ));
    };
    let axis_of = |column: usize| [x, y, z].iter().position(|&a| a == column);
    let kept = columns.into_iter().zip(names).enumerate();
    let kept = kept.filter(|(column, _)| options.attributes || axis_of(*column).is_some());
    Ok(kept
        .map(|(column, ((index, descriptor, kind), name))| Wanted {
            index,
            name,
            axis: axis_of(column),
            level: descriptor.max_def_level(),
            kind,
            values: kind.column(0),
        })
        .collect())
}

/// The type of a flat column of numbers; `None` for every other.
fn kind(column: &ColumnDescriptor) -> Option<Scalar> {
    if column.max_rep_level() > 0 || column.path().parts().len() > 1 {
        return None;
    }
    if matches!(column.converted_type(), ConvertedType::DECIMAL) {
        return None;
    }
    let stated = match (column.converted_type(), column.logical_type_ref()) {
        (_, Some(LogicalType::Decimal { .. })) => return None,
        (_, Some(LogicalType::Integer(integer))) => Some((integer.bit_width, integer.is_signed)),
        (ConvertedType::INT_8, _) => Some((8, true)),
        (ConvertedType::UINT_8, _) => Some((8, false)),
        (ConvertedType::INT_16, _) => Some((16, true)),
        (ConvertedType::UINT_16, _) => Some((16, false)),
        (ConvertedType::UINT_32, _) => Some((32, false)),
        (ConvertedType::UINT_64, _) => Some((64, false)),
        _ => None,
    };
    match (column.physical_type(), stated) {
        (Physical::BOOLEAN, _) => Some(Scalar::U8),
        (Physical::INT32, Some((8, true))) => Some(Scalar::I8),
        (Physical::INT32, Some((8, false))) => Some(Scalar::U8),
        (Physical::INT32, Some((16, true))) => Some(Scalar::I16),
        (Physical::INT32, Some((16, false))) => Some(Scalar::U16),
        (Physical::INT32, Some((_, false))) => Some(Scalar::U32),
        (Physical::INT32, _) => Some(Scalar::I32),
        (Physical::INT64, Some((_, false))) => Some(Scalar::U64),
        (Physical::INT64, _) => Some(Scalar::I64),
        (Physical::FLOAT, _) => Some(Scalar::F32),
        (Physical::DOUBLE, _) => Some(Scalar::F64),
        _ => None,
    }
}
