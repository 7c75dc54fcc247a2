//! The reference system by GeoTIFF keys (OGC 19-008r4), which LAS holds in three records: the keys, their numbers, their text.

use super::header::{Fields, LasFrame, Record};
use crate::crs::{Crs, Measure, SURVEY_FOOT, zone};

/// Records of the keys and of their text.
const KEYS: u16 = 34735;
const TEXT: u16 = 34737;
/// Keys: what kind of system it is, its name, and the codes of the geographic system, of the projected one, of the projection.
const MODEL: u16 = 1024;
const CITATIONS: [u16; 3] = [3073, 1026, 2049];
const GEOGRAPHIC: u16 = 2048;
const PROJECTED: u16 = 3072;
const PROJECTION: u16 = 3074;
/// The unit of projected coordinates, by its code and by its metres.
const UNIT: u16 = 3076;
const UNIT_SIZE: u16 = 3077;
/// Units by their codes: metre, foot, US survey foot.
const UNITS: [(u64, f64); 3] = [(9001, 1.0), (9002, 0.3048), (9003, SURVEY_FOOT)];
/// Records of numbers.
const DOUBLES: u16 = 34736;
/// The key that tells whether coordinates are those of pixels' corners or middles, which readers ask for.
const RASTER: u16 = 1025;
/// Values of the kind, and the code that says that a system is defined by other keys.
const IS_PROJECTED: u16 = 1;
const IS_GEOGRAPHIC: u16 = 2;
const DEFINED: u16 = 32767;

/// The projected system, or else the geographic one. A projected system without a code is not taken for the geographic one
/// under it: its coordinates are no degrees.
pub(super) fn system(frame: &LasFrame) -> Crs {
    let Some(keys) = frame.find("LASF_Projection", KEYS) else { return Crs::default() };
    let number = |key: u16| entry(keys, key).filter(|e| e[1] == 0).map(|e| e[3]);
    let code = |key: u16| number(key).filter(|&code| code != DEFINED).map(u64::from);
    let name = CITATIONS.iter().find_map(|&key| text(frame, entry(keys, key)?)).unwrap_or_default();
    let size = || {
        let known = code(UNIT).and_then(|unit| UNITS.iter().find(|(code, _)| *code == unit));
        known.map(|(_, metres)| *metres).or_else(|| double(frame, entry(keys, UNIT_SIZE)?))
    };
    let stated = || size().map(|metres| Measure::Length(Some(metres)));
    if let Some(crs) = code(PROJECTED).and_then(Crs::of_code) {
        return Crs { stated: stated(), ..crs };
    }
    if number(PROJECTED).is_some() || number(MODEL) == Some(IS_PROJECTED) {
        let named = Crs::parse(&name);
        let by_zone = || zone(code(GEOGRAPHIC)?, code(PROJECTION)?);
        return Crs {
            code: named.code.or_else(by_zone),
            name: named.name,
            stated: stated(),
            ..Crs::default()
        };
    }
    let degrees = (number(MODEL) == Some(IS_GEOGRAPHIC)).then_some(Measure::Degrees);
    let crs = code(GEOGRAPHIC).and_then(Crs::of_code).unwrap_or_else(|| Crs::parse(&name));
    // Systems about the middle of the earth stand under the same key, and are no degrees.
    Crs { stated: crs.measure().or(degrees), ..crs }
}

/// The record of keys that names a system of the register.
pub(super) fn keys(code: u16, geographic: bool) -> Record {
    let (model, key) = if geographic { (IS_GEOGRAPHIC, GEOGRAPHIC) } else { (IS_PROJECTED, PROJECTED) };
    let entries = [[1, 1, 0, 3], [MODEL, 0, 1, model], [RASTER, 0, 1, 1], [key, 0, 1, code]];
    let data = entries.as_flattened().iter().flat_map(|number| number.to_le_bytes()).collect();
    Record { user: "LASF_Projection".into(), id: KEYS, data }
}

/// The number of a key.
fn double(frame: &LasFrame, [_, location, _, at]: [u16; 4]) -> Option<f64> {
    let all = frame.find("LASF_Projection", DOUBLES).filter(|_| location == DOUBLES)?;
    let value = Fields(all.get(8 * usize::from(at)..)?.first_chunk::<8>()?).number::<f64>();
    Some(value).filter(|metres| metres.is_finite() && *metres > 0.0)
}

/// A key: its number, where its value is, how many numbers that are, and the value or its place.
fn entry(keys: &[u8], key: u16) -> Option<[u16; 4]> {
    let entries = keys.chunks_exact(8).skip(1);
    let mut entries = entries.map(|entry| [0, 2, 4, 6].map(|at| Fields(&entry[at..]).number::<u16>()));
    entries.find(|entry| entry[0] == key)
}

/// The text of a key; a bar ends it.
fn text(frame: &LasFrame, [_, location, count, first]: [u16; 4]) -> Option<String> {
    let all = frame.find("LASF_Projection", TEXT).filter(|_| location == TEXT)?;
    let first = usize::from(first);
    let bytes = all.get(first..first + usize::from(count))?;
    let text = String::from_utf8_lossy(bytes);
    Some(text.split(['|', '\0']).next()?.trim().to_string()).filter(|text| !text.is_empty())
}
