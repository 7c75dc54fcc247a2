//! Variable length records of LAS, the coordinate reference system among them.

use super::geo;
use super::header::{Fields, Header, LasFrame, Record};
use crate::crs::{Crs, Measure};
use crate::error::Error;
use crate::source::Source;

/// Bytes before the content of a record.
const RECORD_HEADER: usize = 54;
/// The record of the system in well-known text.
pub(crate) const WKT: u16 = 2112;
/// Bytes before the content of an extended record.
const EXTENDED_HEADER: usize = 60;

/// Reads the records between the header and the points.
pub(super) fn read(source: &mut Source, header: &Header) -> Result<LasFrame, Error> {
    let mut frame = LasFrame {
        minor: header.minor,
        scale: header.scale,
        offset: header.offset,
        point_format: header.format,
        encoding: header.encoding,
        created: header.created,
        records: Vec::new(),
    };
    let gap = header.header_size;
    if source.skip(gap)? < gap {
        return Err(source.ends_early("bytes of the header", gap, 0));
    }
    for index in 0..header.records {
        match record(source, header)? {
            Some(record) => frame.records.push(record),
            None => {
                let found =
                    format!("variable length record {index} of {} reaches into the points", header.records);
                return Err(source.malformed(found, "the header is damaged"));
            }
        }
    }
    Ok(frame)
}

/// The next record, or `None` if it does not fit before the points.
fn record(source: &mut Source, header: &Header) -> Result<Option<Record>, Error> {
    let room = header.points_at.saturating_sub(source.offset()) as usize;
    let start = source.peek(RECORD_HEADER)?;
    if room < RECORD_HEADER || start.len() < RECORD_HEADER {
        return Ok(None);
    }
    let length = usize::from(Fields(&start[20..]).number::<u16>());
    let id = Fields(&start[18..]).number();
    let user = text(&start[2..18]);
    if room < RECORD_HEADER + length {
        return Ok(None);
    }
    let here = source.peek(RECORD_HEADER + length)?;
    let Some(data) = here.get(RECORD_HEADER..RECORD_HEADER + length).map(<[u8]>::to_vec) else {
        return Ok(None);
    };
    source.consume(RECORD_HEADER + length);
    Ok(Some(Record { user, id, data }))
}

/// Reads the extended records, which come behind the points: those that say where on earth the points lie, as far as they
/// fit a record of an output. `take` gives so many bytes from a place, or `None` where the input ends before. Gives how many
/// records were left out, and how many are not there.
pub(super) fn extended(
    header: &Header,
    records: &mut Vec<Record>,
    mut take: impl FnMut(u64, usize) -> Result<Option<Vec<u8>>, Error>,
) -> Result<(u32, u32), Error> {
    let (mut at, count) = header.extended;
    let mut others = 0;
    for index in 0..count {
        let Some(start) = take(at, EXTENDED_HEADER)? else { return Ok((others, count - index)) };
        let (user, id) = (text(&start[2..18]), Fields(&start[18..]).number());
        let length: u64 = Fields(&start[20..]).number();
        let content = at.saturating_add(EXTENDED_HEADER as u64);
        at = content.saturating_add(length);
        let mut record = Record { user, id, data: Vec::new() };
        if !record.is_projection() || length > u64::from(u16::MAX) {
            others += 1;
            continue;
        }
        let Some(data) = take(content, length as usize)? else { return Ok((others, count - index)) };
        record.data = data;
        records.push(record);
    }
    Ok((others, 0))
}

/// Text up to its first zero.
pub(super) fn text(bytes: &[u8]) -> String {
    let end = bytes.iter().position(|&b| b == 0).unwrap_or(bytes.len());
    String::from_utf8_lossy(&bytes[..end]).trim().into()
}

impl Record {
    /// Whether it belongs to the reference system.
    pub fn is_projection(&self) -> bool {
        self.user == "LASF_Projection"
    }
}

impl LasFrame {
    /// For LAS outputs of an input of another format: only its reference system, by its definition or else its code in the EPSG
    /// register. Scale, offset and point format are the writer's choice.
    pub fn of_system(epsg: Option<u32>, wkt: Option<&str>) -> Option<LasFrame> {
        let mut frame = LasFrame { minor: 4, ..LasFrame::default() };
        match (wkt, epsg) {
            (Some(wkt), _) => frame.define(wkt),
            (None, Some(code)) => frame.place(code),
            (None, None) => return None,
        }
        Some(frame)
    }

    /// Gives the points another system, by its definition in well-known text.
    pub(crate) fn define(&mut self, wkt: &str) {
        self.records.retain(|record| !record.is_projection());
        let data = [wkt.as_bytes(), &[0]].concat();
        self.records.push(Record { user: "LASF_Projection".into(), id: WKT, data });
    }

    /// Gives the points another system, by its code in the EPSG register.
    pub(crate) fn place(&mut self, epsg: u32) {
        let degrees = Crs::of_code(epsg.into()).and_then(|crs| crs.measure()) == Some(Measure::Degrees);
        self.records.retain(|record| !record.is_projection());
        // Codes of the register have 16 bits.
        self.records.extend(u16::try_from(epsg).ok().map(|code| geo::keys(code, degrees)));
    }

    /// Whether it tells how coordinates are stored, and not only where the points lie.
    pub fn is_stored(&self) -> bool {
        self.scale.iter().all(|scale| *scale != 0.0)
    }

    /// The content of the record with this user and number.
    pub(super) fn find(&self, user: &str, id: u16) -> Option<&[u8]> {
        self.records.iter().find(|r| r.user == user && r.id == id).map(|r| r.data.as_slice())
    }

    /// The coordinate reference system: its name in well-known text, or `EPSG:` and the code of its geo keys.
    pub fn crs(&self) -> Option<String> {
        let crs = self.system();
        crs.name.clone().or_else(|| crs.short())
    }

    /// The code of the coordinate reference system in the EPSG register, by its well-known text or its geo keys.
    pub fn epsg(&self) -> Option<u32> {
        self.system().code.and_then(|code| code.try_into().ok())
    }

    pub(crate) fn system(&self) -> Crs {
        let Some(wkt) = self.wkt() else { return geo::system(self) };
        let crs = Crs::parse(&wkt);
        // Text without a code, as ESRI writes it, does not outweigh keys that have one.
        Crs { code: crs.code.or_else(|| geo::system(self).code), ..crs }
    }

    /// The definition of the coordinate reference system in well-known text.
    pub fn wkt(&self) -> Option<String> {
        self.find("LASF_Projection", WKT).map(text).filter(|wkt| !wkt.is_empty())
    }
}
