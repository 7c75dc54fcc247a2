//! Well-known text of reference systems (OGC 01-009, ISO 19162): elements in brackets, the code of the outer system, and the unit of
//! its horizontal coordinates.

use super::{CODES, Crs, Measure, utm};
use crate::number::{integer, parse as number};

/// Elements that are no system themselves but hold one first.
const AROUND: [&str; 4] = ["BOUNDCRS", "SOURCECRS", "COMPD_CS", "COMPOUNDCRS"];
/// Geographic systems; the two others may be geocentric.
const GEOGRAPHIC: [&str; 5] = ["GEOGCS", "GEOGCRS", "GEOGRAPHICCRS", "GEODCRS", "GEODETICCRS"];
/// Elements of units of length.
const UNITS: [&str; 2] = ["LENGTHUNIT", "UNIT"];

/// The system that a text defines; `None` if it is no well-known text.
pub(super) fn parse(text: &str) -> Option<Crs> {
    let element = Element::parse(text, 0).filter(|element| !element.children.is_empty())?;
    Some(Crs {
        code: element.code(0),
        name: element.name().map(String::from),
        wkt: Some(text.into()),
        stated: element.measure(0),
    })
}

/// An element of well-known text: `KEYWORD[...]`.
struct Element<'a> {
    keyword: &'a str,
    children: Vec<Part<'a>>,
}

enum Part<'a> {
    Element(Element<'a>),
    /// Text in quotes, a number or a word.
    Value(&'a str),
}

/// Elements inside each other beyond which text is none.
const DEEPEST: usize = 16;

impl<'a> Element<'a> {
    fn parse(text: &'a str, depth: usize) -> Option<Element<'a>> {
        let open = text.find(['[', '('])?;
        let inner = text[open + 1..].trim_end().strip_suffix([']', ')'])?;
        let keyword = text[..open].trim();
        if depth > DEEPEST || !keyword.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'_') {
            return None;
        }
        let part = |part: &'a str| match Element::parse(part, depth + 1) {
            Some(element) if !part.starts_with('"') => Part::Element(element),
            _ => Part::Value(part.trim_matches('"')),
        };
        Some(Element { keyword, children: split(inner).map(part).collect() })
    }

    fn name(&self) -> Option<&'a str> {
        match self.children.first() {
            Some(Part::Value(name)) => Some(name),
            Some(Part::Element(element)) => element.name(),
            None => None,
        }
    }

    fn elements(&self) -> impl Iterator<Item = &Element<'a>> {
        self.children.iter().filter_map(|part| if let Part::Element(e) = part { Some(e) } else { None })
    }

    fn is(&self, keywords: &[&str]) -> bool {
        keywords.iter().any(|keyword| self.keyword.eq_ignore_ascii_case(keyword))
    }

    /// What coordinates are measured in: of a compound system those of the horizontal one.
    fn measure(&self, depth: usize) -> Option<Measure> {
        if self.is(&AROUND) {
            return self.elements().next().filter(|_| depth < DEEPEST)?.measure(depth + 1);
        }
        let cartesian =
            |e: &Element| e.is(&["CS"]) && e.name().is_some_and(|n| n.eq_ignore_ascii_case("Cartesian"));
        if self.is(&GEOGRAPHIC) && !self.elements().any(cartesian) {
            return Some(Measure::Degrees);
        }
        // Text of 2019 has units in the axes where these differ.
        let in_axes = self.elements().filter(|e| e.is(&["AXIS"])).flat_map(Element::elements);
        let unit = self.elements().chain(in_axes).find(|e| e.is(&UNITS))?;
        let Some(Part::Value(metres)) = unit.children.get(1) else { return None };
        Some(Measure::Length(Some(number(metres.as_bytes()).filter(|metres| *metres > 0.0)?)))
    }

    /// The code of this system, or of the first one in it where it is none itself: of a compound one the horizontal system.
    fn code(&self, depth: usize) -> Option<u64> {
        let own =
            self.elements().find(|e| ["AUTHORITY", "ID"].iter().any(|k| e.keyword.eq_ignore_ascii_case(k)));
        let code = own.and_then(|own| match own.children.as_slice() {
            [Part::Value(register), Part::Value(code), ..] if register.eq_ignore_ascii_case("EPSG") => {
                integer(code.as_bytes())
            }
            _ => None,
        });
        let inner =
            || self.elements().next().filter(|_| self.is(&AROUND) && depth < DEEPEST)?.code(depth + 1);
        let named = || self.name().and_then(utm);
        code.filter(|code| CODES.contains(code)).or_else(inner).or_else(named)
    }
}

/// The parts between commas, those in quotes and in brackets apart.
fn split(text: &str) -> impl Iterator<Item = &str> {
    let (mut depth, mut quoted) = (0i32, false);
    text.split(move |c: char| {
        match c {
            '"' => quoted = !quoted,
            '[' | '(' if !quoted => depth += 1,
            ']' | ')' if !quoted => depth -= 1,
            _ => {}
        }
        c == ',' && !quoted && depth == 0
    })
    .map(str::trim)
}
