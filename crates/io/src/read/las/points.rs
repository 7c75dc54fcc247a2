//! The dimensions of LAS points: where each lies in a record, by point format, and the extra bytes.

use super::header::{Fields, Header, LasFrame, RECORD_LENGTHS};
use super::records::text;
use crate::columns::Scalar;
use crate::error::Error;
use crate::read::rows::{Field, Table};
use crate::source::Source;
use lineament::Column;

/// A dimension of the points.
#[derive(Debug)]
pub(crate) struct Dimension {
    pub name: String,
    pub field: Field,
    /// For parts of a byte: how far up they begin, and the ones that mask them.
    pub bits: Option<(u32, u8)>,
    /// For extra bytes that are stored as integers: value = stored * scale + offset.
    scaled: Option<(f64, f64)>,
}

impl Dimension {
    fn new(name: &str, offset: usize, kind: Scalar) -> Self {
        Self { name: name.into(), field: Field { offset, kind }, bits: None, scaled: None }
    }

    fn bits(name: &str, offset: usize, shift: u32, count: u32) -> Self {
        Self { bits: Some((shift, ((1u32 << count) - 1) as u8)), ..Self::new(name, offset, Scalar::U8) }
    }
}

/// The dimensions of a record, x, y and z first.
pub(super) fn dimensions(
    source: &Source,
    header: &Header,
    frame: &LasFrame,
) -> Result<Vec<Dimension>, Error> {
    let of = Dimension::new;
    let mut all = vec![of("x", 0, Scalar::I32), of("y", 4, Scalar::I32), of("z", 8, Scalar::I32)];
    all.extend(standard(header.format).map(|(_, dimensions)| dimensions).unwrap_or_default());
    extra(source, header, frame, &mut all)?;
    Ok(all)
}

/// Bytes of a record of a point format without extra bytes, and its dimensions but for x, y and z; `None` if there is
/// no such format.
pub(crate) fn standard(format: u8) -> Option<(usize, Vec<Dimension>)> {
    let length = *RECORD_LENGTHS.get(usize::from(format))?;
    let of = Dimension::new;
    let mut all = vec![of("intensity", 12, Scalar::U16)];
    // The optional dimensions follow those of the base.
    let (bits, whole, mut at) =
        if format < 6 { (LEGACY_BITS, LEGACY, 20) } else { (CURRENT_BITS, CURRENT, 30) };
    all.extend(bits.iter().map(|&(name, offset, shift, count)| Dimension::bits(name, offset, shift, count)));
    all.extend(whole.iter().map(|&(name, offset, kind)| Dimension::new(name, offset, kind)));
    if matches!(format, 1 | 3 | 4 | 5) {
        all.push(of("gps_time", at, Scalar::F64));
        at += 8;
    }
    if matches!(format, 2 | 3 | 5 | 7 | 8 | 10) {
        for (i, name) in ["red", "green", "blue"].into_iter().enumerate() {
            all.push(of(name, at + 2 * i, Scalar::U16));
        }
        at += 6;
    }
    if matches!(format, 8 | 10) {
        all.push(of("nir", at, Scalar::U16));
    }
    Some((length, all))
}

/// Dimensions of whole numbers: name, offset, type.
type Whole = &'static [(&'static str, usize, Scalar)];
/// Dimensions of some bits of a byte: name, offset of the byte, first bit, number of bits.
type Bits = &'static [(&'static str, usize, u32, u32)];

/// Formats 0 to 5.
const LEGACY_BITS: Bits = &[
    ("return_number", 14, 0, 3),
    ("number_of_returns", 14, 3, 3),
    ("scan_direction_flag", 14, 6, 1),
    ("edge_of_flight_line", 14, 7, 1),
    ("classification", 15, 0, 5),
    ("synthetic", 15, 5, 1),
    ("key_point", 15, 6, 1),
    ("withheld", 15, 7, 1),
];
const LEGACY: Whole = &[
    ("scan_angle_rank", 16, Scalar::I8),
    ("user_data", 17, Scalar::U8),
    ("point_source_id", 18, Scalar::U16),
];

/// Formats 6 to 10.
const CURRENT_BITS: Bits = &[
    ("return_number", 14, 0, 4),
    ("number_of_returns", 14, 4, 4),
    ("synthetic", 15, 0, 1),
    ("key_point", 15, 1, 1),
    ("withheld", 15, 2, 1),
    ("overlap", 15, 3, 1),
    ("scanner_channel", 15, 4, 2),
    ("scan_direction_flag", 15, 6, 1),
    ("edge_of_flight_line", 15, 7, 1),
];
const CURRENT: Whole = &[
    ("classification", 16, Scalar::U8),
    ("user_data", 17, Scalar::U8),
    ("scan_angle", 18, Scalar::I16),
    ("point_source_id", 20, Scalar::U16),
    ("gps_time", 22, Scalar::F64),
];

/// Bytes of one description of extra bytes.
const DESCRIPTION: usize = 192;

/// Extra bytes by their descriptions; undescribed ones stay a column a byte.
fn extra(source: &Source, header: &Header, frame: &LasFrame, all: &mut Vec<Dimension>) -> Result<(), Error> {
    let mut at = header.standard_length();
    for described in frame.find("LASF_Spec", 4).unwrap_or(&[]).chunks_exact(DESCRIPTION) {
        let (kind, options) = (described[2], described[3]);
        let name = text(&described[4..36]);
        let (base, count) = match kind {
            0 => (Scalar::U8, usize::from(options)),
            1..=30 => (TYPES[usize::from((kind - 1) % 10)], usize::from((kind - 1) / 10 + 1)),
            _ => {
                return Err(
                    source.malformed(format!("extra bytes `{name}` of type {kind}"), "types 0 to 30 exist")
                );
            }
        };
        for item in 0..count {
            let name = if count == 1 { name.clone() } else { format!("{name}_{item}") };
            let number = |at: usize| Fields(&described[at + 8 * item.min(2)..]).number::<f64>();
            let scaled = (kind > 0 && options & 0b1_1000 != 0).then(|| {
                let scale = if options & 0b1000 != 0 { number(112) } else { 1.0 };
                (scale, if options & 0b1_0000 != 0 { number(136) } else { 0.0 })
            });
            all.push(Dimension { scaled, ..Dimension::new(&name, at, base) });
            at += base.size();
        }
        if at > header.record_length {
            let found =
                format!("extra bytes `{name}` end at byte {at} of records of {}", header.record_length);
            return Err(
                source.malformed(found, "the description of the extra bytes does not fit the records")
            );
        }
    }
    for (index, offset) in (at..header.record_length).enumerate() {
        all.push(Dimension::new(&format!("extra_byte_{index}"), offset, Scalar::U8));
    }
    Ok(())
}

const TYPES: [Scalar; 10] = [
    Scalar::U8,
    Scalar::I8,
    Scalar::U16,
    Scalar::I16,
    Scalar::U32,
    Scalar::I32,
    Scalar::U64,
    Scalar::I64,
    Scalar::F32,
    Scalar::F64,
];

/// Takes packed bits apart, and applies the scales of extra bytes.
pub(super) fn finish(table: &mut Table, dimensions: &[Dimension]) {
    for (index, attribute) in &mut table.columns {
        let Dimension { bits, scaled, .. } = &dimensions[*index];
        if let (Some((shift, mask)), Column::U8(values)) = (bits, &mut attribute.values) {
            values.iter_mut().for_each(|value| *value = (*value >> shift) & mask);
        }
        if let Some((scale, offset)) = scaled {
            let stored = (0..attribute.values.len()).map(|i| crate::columns::get(&attribute.values, i));
            attribute.values = Column::F64(stored.map(|value| value * scale + offset).collect());
        }
    }
}
