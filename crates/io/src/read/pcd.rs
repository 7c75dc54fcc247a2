//! PCD, the format of the Point Cloud Library, versions 0.5 to 0.7: ascii, binary and binary_compressed, organised
//! or not. The points of an organised cloud come row by row, those without a return as NaN.

mod body;
mod header;
mod lzf;

use super::rows::{self, Table, room};
use super::{Decoded, ReadOptions, limit};
use crate::columns::Endian;
use crate::error::Error;
use crate::source::Source;
use header::{Data, Header};
use lineament::{Attribute, Column};

/// Reads a PCD input from its first byte.
pub(super) fn read(source: &mut Source, options: &ReadOptions) -> Result<Decoded, Error> {
    let header = header::parse(source, options)?;
    let mut out = Decoded { ignored: header.notes(), ..Decoded::default() };
    let axes = header.axes(source)?;
    let attributes: Vec<_> = header
        .columns()
        .filter(|(index, ..)| options.attributes && !axes.contains(index))
        .map(|(index, name, kind)| (index, name.to_string(), kind))
        .collect();
    let row_bytes = 24 + attributes.iter().map(|(_, _, kind)| kind.size()).sum::<usize>();
    let room = match header.data {
        Data::Ascii => room(source, header.points, 2 * header.fields.len() as u64),
        Data::Binary => room(source, header.points, header.stride() as u64),
        Data::Compressed => {
            limit::check(source, options, header.points, row_bytes)?;
            header.points as usize
        }
    };
    let mut table = Table::new(axes, attributes, if header.data == Data::Compressed { 0 } else { room });
    let mut extra = 0;
    let rows = match header.data {
        Data::Ascii => body::ascii(source, &header, &mut table, options.salvage)?,
        Data::Binary => {
            let fields: Vec<_> = header.fields.iter().map(|field| field.place).collect();
            table.read(source, header.points, header.stride(), &fields, Endian::Little)?
        }
        Data::Compressed => body::compressed(source, &header, &mut table, room, &mut extra)?,
    };
    out.cloud = table.into_cloud();
    if rows < header.points {
        out.cut(source, options, "points", header.points, rows)?;
    }
    out.cloud.attributes = out.cloud.attributes.into_iter().flat_map(colours).collect();
    note_rest(source, &header, extra, &mut out)?;
    Ok(out)
}

/// The library packs colours into the bits of one number, often a float; here they are three columns.
fn colours(attribute: Attribute) -> Vec<Attribute> {
    let packed: Vec<u32> = match (attribute.name.as_str(), &attribute.values) {
        ("rgb" | "rgba", Column::F32(values)) => values.iter().map(|v| v.to_bits()).collect(),
        ("rgb" | "rgba", Column::U32(values)) => values.clone(),
        ("rgb" | "rgba", Column::I32(values)) => values.iter().map(|&v| v as u32).collect(),
        _ => return vec![attribute],
    };
    let channel = |name: &str, shift: u32| {
        let values = packed.iter().map(|bits| (bits >> shift) as u8).collect();
        Attribute { name: name.into(), values: Column::U8(values) }
    };
    let mut channels = vec![channel("red", 16), channel("green", 8), channel("blue", 0)];
    if attribute.name == "rgba" {
        channels.push(channel("alpha", 24));
    }
    channels
}

fn note_rest(source: &mut Source, header: &Header, extra: u64, out: &mut Decoded) -> Result<(), Error> {
    if out.missing.is_some() {
        return Ok(());
    }
    if header.data == Data::Ascii {
        rows::no_more_rows(source, &format!("{} points", header.points))?;
        out.warnings.extend(source.open_end());
        return Ok(());
    }
    let extra = extra + source.drain()?;
    rows::note_extra(extra, header.stride() as u64, "point", out);
    Ok(())
}
