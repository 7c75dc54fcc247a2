//! Units of length, for the formats that state one.

use crate::crs;

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
}

impl Unit {
    /// All units.
    pub const ALL: [Unit; 5] = [Unit::Millimetre, Unit::Centimetre, Unit::Metre, Unit::Inch, Unit::Foot];

    /// The usual sign: `mm`, `cm`, `m`, `in` or `ft`.
    pub fn sign(self) -> &'static str {
        match self {
            Unit::Millimetre => "mm",
            Unit::Centimetre => "cm",
            Unit::Metre => "m",
            Unit::Inch => "in",
            Unit::Foot => "ft",
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

    /// The unit of a reference system whose unit is known: metres in a UTM zone.
    pub(crate) fn of_reference(reference: Option<&str>) -> Option<Unit> {
        crs::reference(reference?).filter(|&code| crs::is_utm(code)).map(|_| Unit::Metre)
    }

    /// Whether it belongs to the metric system.
    pub(crate) fn is_metric(self) -> bool {
        !matches!(self, Unit::Inch | Unit::Foot)
    }

    /// Its number in `$INSUNITS` of DXF.
    pub(crate) fn dxf(self) -> u8 {
        match self {
            Unit::Inch => 1,
            Unit::Foot => 2,
            Unit::Millimetre => 4,
            Unit::Centimetre => 5,
            Unit::Metre => 6,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn utm_zones_are_in_metres_and_degrees_in_no_length() {
        assert_eq!(Unit::of_reference(Some("EPSG:25832")), Some(Unit::Metre));
        for other in [None, Some("EPSG:4326"), Some("EPSG:2263"), Some("site")] {
            assert_eq!(Unit::of_reference(other), None, "{other:?}");
        }
    }
}
