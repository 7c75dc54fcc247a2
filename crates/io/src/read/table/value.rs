//! Fields of a table as numbers.

use crate::number;

/// A field as a number; NaN if it is empty or marks a missing value.
#[inline]
pub(super) fn value(field: &[u8], decimal_comma: bool) -> Option<f64> {
    if !decimal_comma && let Some(value) = number::parse(field) {
        return Some(value);
    }
    if decimal_comma && !field.contains(&b'.') {
        let mut text = field.to_vec();
        if let Some(comma) = text.iter().position(|&b| b == b',') {
            text[comma] = b'.';
        }
        if let Some(value) = number::parse(&text) {
            return Some(value);
        }
    }
    let missing: [&[u8]; 5] = [b"", b"na", b"n/a", b"null", b"none"];
    missing.iter().any(|word| field.eq_ignore_ascii_case(word)).then_some(f64::NAN)
}
