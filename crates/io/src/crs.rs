//! Coordinate reference systems: the code of the EPSG register from well-known text (OGC 01-009 and ISO 19162), from names
//! that stand for one, what coordinates are measured in, and how outputs name it.

mod register;
mod wkt;

use crate::number::integer;
use std::ops::RangeInclusive;

pub(crate) use register::SURVEY_FOOT;

/// Codes of the register; those beyond are of private use.
const CODES: RangeInclusive<u64> = 1024..=32766;
/// A geographic system whose UTM zones have consecutive codes.
struct Zones {
    /// The beginning of the names of its zones, in small letters and digits.
    name: &'static str,
    /// The code of the geographic system.
    geographic: u64,
    /// The zones, and the code of zone 0, in the north.
    north: (RangeInclusive<u64>, u64),
    /// And in the south.
    south: Option<(RangeInclusive<u64>, u64)>,
}

/// All such systems. Other codes stand beside these series: NAD83 / Florida West is 26959, and zone 59 north of NAD83 is 3372.
const UTM: [Zones; 3] = [
    Zones { name: "wgs84", geographic: 4326, north: (1..=60, 32600), south: Some((1..=60, 32700)) },
    Zones { name: "etrs89", geographic: 4258, north: (28..=38, 25800), south: None },
    Zones { name: "nad83", geographic: 4269, north: (1..=23, 26900), south: None },
];

/// A reference system as an input states it.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Crs {
    /// The code in the EPSG register.
    pub code: Option<u64>,
    pub name: Option<String>,
    pub wkt: Option<String>,
    /// As the input states it; [`Crs::measure`] asks the register too.
    pub stated: Option<Measure>,
}

/// What the horizontal coordinates of a system are measured in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Measure {
    Degrees,
    /// A unit of length, by its metres where they are known.
    Length(Option<f64>),
}

impl Crs {
    /// From well-known text, a URN, `EPSG:` and a code, or a name.
    pub fn parse(text: &str) -> Crs {
        let text = text.trim_matches(|c: char| c == '\0' || c.is_whitespace());
        if text.is_empty() {
            return Crs::default();
        }
        if let Some(code) = reference(text) {
            return Crs { code: Some(code), ..Crs::default() };
        }
        match wkt::parse(text) {
            Some(crs) => crs,
            None => Crs { code: utm(text), name: Some(text.into()), ..Crs::default() },
        }
    }

    /// From the code that GeoTIFF keys give, if it is one of the register.
    pub fn of_code(code: u64) -> Option<Crs> {
        CODES.contains(&code).then(|| Crs { code: Some(code), ..Crs::default() })
    }

    /// Whether the input says nothing of its system.
    pub fn is_none(&self) -> bool {
        self.code.is_none() && self.name.is_none() && self.wkt.is_none()
    }

    /// What coordinates are measured in, as the input states it or by the register.
    pub fn measure(&self) -> Option<Measure> {
        self.stated.or_else(|| register::measure(self.code?))
    }

    /// `EPSG:` and the code, or the name.
    pub fn short(&self) -> Option<String> {
        self.code.map(|code| format!("EPSG:{code}")).or_else(|| self.name.clone())
    }
}

/// The UTM zone of a geographic system by its code: the zone as GeoTIFF numbers it (160zz north, 161zz south).
pub(crate) fn zone(geographic: u64, projection: u64) -> Option<u64> {
    let system = UTM.iter().find(|system| system.geographic == geographic)?;
    match projection {
        16001..=16060 => system.code(projection - 16000, false),
        16101..=16160 => system.code(projection - 16100, true),
        _ => None,
    }
}

impl Zones {
    /// The code of a zone, if it belongs to the series.
    fn code(&self, zone: u64, south: bool) -> Option<u64> {
        let (zones, zero) = if south { self.south.as_ref()? } else { &self.north };
        zones.contains(&zone).then_some(zero + zone)
    }
}

/// The member `crs` of GeoJSON: the URN of the system, or nothing that a reader could take for degrees.
pub(crate) fn member(crs: Option<&str>) -> String {
    match crs.and_then(reference) {
        Some(code) => format!(
            "\"crs\": {{\"type\": \"name\", \"properties\": {{\"name\": \"urn:ogc:def:crs:EPSG::{code}\"}}}}"
        ),
        None => "\"crs\": null".into(),
    }
}

/// The code in `EPSG:2180`, a URN or the address of a system.
pub(crate) fn reference(text: &str) -> Option<u64> {
    let lower = text.to_ascii_lowercase();
    let known = [
        "epsg:",
        "urn:ogc:def:crs:epsg:",
        "http://www.opengis.net/def/crs/epsg/",
        "https://www.opengis.net/def/crs/epsg/",
    ];
    let rest = known.iter().find_map(|start| lower.strip_prefix(start))?;
    // A version may stand before the code.
    let last = rest.rsplit([':', '/']).next()?;
    integer(last.trim().as_bytes()).filter(|code| CODES.contains(code))
}

/// The code of a horizontal system of the EPSG register that `EPSG:25832`, `25832` or a URN names; `None` if there is no such system.
///
/// ```
/// assert_eq!(lineament_io::reference_code("EPSG:25832"), Some(25832));
/// assert_eq!(lineament_io::reference_code("EPSG:99999"), None);
/// ```
pub fn reference_code(text: &str) -> Option<u32> {
    let text = text.trim();
    let code = reference(text).or_else(|| integer(text.as_bytes()))?;
    register::measure(code)?;
    code.try_into().ok()
}

/// The code of a UTM zone by the name of its system, as OGC and ESRI spell it.
fn utm(name: &str) -> Option<u64> {
    let plain: String =
        name.chars().filter(char::is_ascii_alphanumeric).collect::<String>().to_ascii_lowercase();
    let plain = plain
        .replacen("wgs1984", "wgs84", 1)
        .replacen("etrs1989", "etrs89", 1)
        .replacen("nad1983", "nad83", 1);
    let (start, zone) = plain.split_once("utmzone")?;
    let system = UTM.iter().find(|system| system.name == start)?;
    let number = integer(zone.strip_suffix(['n', 's'])?.as_bytes())?;
    system.code(number, zone.ends_with('s'))
}

#[cfg(test)]
mod tests {
    use super::*;

    const CS92: &str = "PROJCS[\"ETRF2000-PL / CS92\",GEOGCS[\"ETRF2000-PL\",DATUM[\"x, y[1]\",SPHEROID[\"GRS 1980\",6378137,\
        298.257222101,AUTHORITY[\"EPSG\",\"7019\"]]],AUTHORITY[\"EPSG\",\"9702\"]],UNIT[\"metre\",1],AUTHORITY[\"EPSG\",\"2180\"]]";

    #[test]
    fn the_code_is_that_of_the_outer_system() {
        let crs = Crs::parse(CS92);
        assert_eq!((crs.code, crs.name.as_deref()), (Some(2180), Some("ETRF2000-PL / CS92")));
        let compound = format!("COMPD_CS[\"a + b\",{CS92},VERT_CS[\"b\",AUTHORITY[\"EPSG\",\"5773\"]]]");
        assert_eq!(Crs::parse(&compound).code, Some(2180));
        let own = compound.replace("]]]", "]],AUTHORITY[\"EPSG\",\"9656\"]]");
        assert_eq!(Crs::parse(&own).code, Some(9656));
        let second = "PROJCRS[\"c\",BASEGEOGCRS[\"d\",ID[\"EPSG\",4258]],CONVERSION[\"e\",ID[\"EPSG\",16032]],ID[\"EPSG\",25832]]";
        assert_eq!(Crs::parse(second).code, Some(25832));
        let bound = format!("BOUNDCRS[SOURCECRS[{second}],TARGETCRS[GEOGCRS[\"f\",ID[\"EPSG\",4326]]]]");
        assert_eq!(Crs::parse(&bound).code, Some(25832));
    }

    #[test]
    fn text_without_a_code_has_none_but_for_utm_zones() {
        assert_eq!(
            Crs::parse("PROJCS[\"site\",GEOGCS[\"g\",AUTHORITY[\"EPSG\",\"4326\"]],UNIT[\"m\",1]]").code,
            None
        );
        assert_eq!(Crs::parse("LOCAL_CS[\"site\"]").short().as_deref(), Some("site"));
        for (name, code) in [
            ("WGS_1984_UTM_Zone_33N", 32633),
            ("WGS 84 / UTM zone 19S", 32719),
            ("ETRS89 / UTM zone 32N", 25832),
            ("NAD_1983_UTM_Zone_10N", 26910),
        ] {
            assert_eq!(Crs::parse(&format!("PROJCS[\"{name}\",UNIT[\"m\",1]]")).code, Some(code), "{name}");
        }
        assert_eq!(zone(4258, 16032), Some(25832));
        assert_eq!(zone(4258, 16132), None);
        for (name, keys) in [
            ("NAD83 / UTM zone 59N", (4269, 16059)),
            ("NAD83 / UTM zone 24N", (4269, 16024)),
            ("ETRS89 / UTM zone 27N", (4258, 16027)),
            ("ETRS89 / UTM zone 39N", (4258, 16039)),
            ("WGS 84 / UTM zone 61N", (4326, 16061)),
        ] {
            assert_eq!((utm(name), zone(keys.0, keys.1)), (None, None), "{name}");
        }
        assert_eq!((utm("NAD83 / UTM zone 23N"), zone(4326, 16160)), (Some(26923), Some(32760)));
    }

    #[test]
    fn references_to_the_register_are_codes() {
        for text in [
            "EPSG:25832",
            "urn:ogc:def:crs:EPSG::25832",
            "urn:ogc:def:crs:EPSG:9.1:25832",
            "http://www.opengis.net/def/crs/EPSG/0/25832",
        ] {
            assert_eq!(reference(text), Some(25832), "{text}");
        }
        for text in ["EPSG:", "EPSG:99999", "ESRI:102100", "25832"] {
            assert_eq!(reference(text), None, "{text}");
        }
        assert_eq!(member(Some("site")), "\"crs\": null");
    }
}
