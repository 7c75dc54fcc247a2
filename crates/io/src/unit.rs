//! Units of length, for the formats that state one.

use crate::crs::{self, Crs, Measure, SURVEY_FOOT};

/// The unit that coordinates are in. It is stated; nothing is scaled by it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit {
    /// A thousandth of a metre.
    Millimetre,
    /// A hundredth of a metre.
    Centimetre,
    /// The metre.
    Metre,
    /// The inch of 25.4 millimetres.
    Inch,
    /// The foot of 12 inches.
    Foot,
    /// The US survey foot of 1200/3937 metres.
    SurveyFoot,
}

/// Share of a unit by which others of its name may differ: as many digits as well-known text gives, and fewer than tell both feet apart.
const SAME: f64 = 1e-7;

impl Unit {
    /// All units.
    pub const ALL: [Unit; 6] =
        [Unit::Millimetre, Unit::Centimetre, Unit::Metre, Unit::Inch, Unit::Foot, Unit::SurveyFoot];

    /// The usual sign: `mm`, `cm`, `m`, `in`, `ft` or `us-ft`.
    pub fn sign(self) -> &'static str {
        match self {
            Unit::Millimetre => "mm",
            Unit::Centimetre => "cm",
            Unit::Metre => "m",
            Unit::Inch => "in",
            Unit::Foot => "ft",
            Unit::SurveyFoot => "us-ft",
        }
    }

    /// The unit of a sign, in any case.
    ///
    /// ```
    /// assert_eq!(lineament_io::Unit::parse("MM"), Some(lineament_io::Unit::Millimetre));
    /// assert_eq!(lineament_io::Unit::parse("miles"), None);
    /// ```
    pub fn parse(text: &str) -> Option<Unit> {
        Self::ALL.into_iter().find(|unit| unit.sign().eq_ignore_ascii_case(text))
    }

    /// Its length in metres.
    pub(crate) fn metres(self) -> f64 {
        match self {
            Unit::Millimetre => 1e-3,
            Unit::Centimetre => 1e-2,
            Unit::Metre => 1.0,
            Unit::Inch => 0.0254,
            Unit::Foot => 0.3048,
            Unit::SurveyFoot => SURVEY_FOOT,
        }
    }

    /// The unit of the coordinates of a system, where they are lengths in one of these.
    pub(crate) fn of_system(crs: &Crs) -> Option<Unit> {
        let Some(Measure::Length(Some(metres))) = crs.measure() else { return None };
        Self::ALL.into_iter().find(|unit| (metres / unit.metres() - 1.0).abs() < SAME)
    }

    /// The unit of a system by its definition in well-known text, or else by `EPSG:` and its code.
    pub(crate) fn of_stated(reference: Option<&str>, wkt: Option<&str>) -> Option<Unit> {
        let defined = || Self::of_system(&Crs::parse(wkt?));
        let named = || Self::of_system(&Crs::of_code(crs::reference(reference?)?)?);
        defined().or_else(named)
    }

    /// Whether it belongs to the metric system.
    pub(crate) fn is_metric(self) -> bool {
        matches!(self, Unit::Millimetre | Unit::Centimetre | Unit::Metre)
    }

    /// Its number in `$INSUNITS` of DXF.
    pub(crate) fn dxf(self) -> u8 {
        match self {
            Unit::Inch => 1,
            Unit::Foot => 2,
            Unit::Millimetre => 4,
            Unit::Centimetre => 5,
            Unit::Metre => 6,
            Unit::SurveyFoot => 21,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_unit_of_a_code_is_that_of_the_register() {
        for metric in
            ["EPSG:25832", "EPSG:31467", "EPSG:2056", "EPSG:2154", "EPSG:28992", "EPSG:4647", "EPSG:5555"]
        {
            assert_eq!(Unit::of_stated(Some(metric), None), Some(Unit::Metre), "{metric}");
        }
        assert_eq!(Unit::of_stated(Some("EPSG:2263"), None), Some(Unit::SurveyFoot));
        assert_eq!(Unit::of_stated(Some("EPSG:2222"), None), Some(Unit::Foot));
        for other in [None, Some("EPSG:4326"), Some("EPSG:2314"), Some("site")] {
            assert_eq!(Unit::of_stated(other, None), None, "{other:?}");
        }
    }

    #[test]
    fn the_unit_of_well_known_text_is_that_of_its_horizontal_system() {
        let of = |text: &str| Unit::of_system(&Crs::parse(text));
        let geographic =
            "GEOGCS[\"g\",DATUM[\"d\",SPHEROID[\"s\",6378137,298.3]],UNIT[\"degree\",0.0174532925199433]]";
        assert_eq!(of(&format!("PROJCS[\"site\",{geographic},UNIT[\"metre\",1]]")), Some(Unit::Metre));
        assert_eq!(
            of(&format!("PROJCS[\"site\",{geographic},UNIT[\"Foot_US\",0.3048006096012192]]")),
            Some(Unit::SurveyFoot)
        );
        let compound = format!(
            "COMPD_CS[\"c\",PROJCS[\"site\",{geographic},UNIT[\"foot\",0.3048]],VERT_CS[\"v\",UNIT[\"metre\",1]]]"
        );
        assert_eq!(of(&compound), Some(Unit::Foot));
        let second = "PROJCRS[\"c\",BASEGEOGCRS[\"d\",ANGLEUNIT[\"degree\",0.0174532925199433]],CS[Cartesian,2],\
            AXIS[\"e\",east,LENGTHUNIT[\"metre\",1]],AXIS[\"n\",north,LENGTHUNIT[\"metre\",1]]]";
        assert_eq!(of(second), Some(Unit::Metre));
        assert_eq!(of(geographic), None);
        assert_eq!(Crs::parse(geographic).measure(), Some(Measure::Degrees));
        let geocentric = "GEODCRS[\"x\",DATUM[\"d\"],CS[Cartesian,3],LENGTHUNIT[\"metre\",1]]";
        assert_eq!(of(geocentric), Some(Unit::Metre));
    }
}
