//! Decimal numbers from bytes, correctly rounded.

/// Powers of ten that f64 holds exactly.
const EXACT_POWERS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18,
    1e19, 1e20, 1e21, 1e22,
];

/// The nearest f64 to a decimal number with a point; also `nan`, `inf` and the spellings of the Microsoft C library
/// for them. `None` if the bytes are not one whole number. Leading `+` is allowed, surrounding space is not.
///
/// Up to 19 digits with a small exponent take the exact fast path (Clinger 1990: digits and power of ten are both
/// exact in f64, so that one operation rounds once); all else goes through the standard library.
pub(crate) fn parse(bytes: &[u8]) -> Option<f64> {
    fast(bytes).or_else(|| slow(bytes))
}

fn fast(bytes: &[u8]) -> Option<f64> {
    let (negative, digits) = match bytes.first()? {
        b'-' => (true, &bytes[1..]),
        b'+' => (false, &bytes[1..]),
        _ => (false, bytes),
    };
    let (mut mantissa, mut count, mut fraction, mut point) = (0u64, 0usize, 0i32, false);
    let mut rest: &[u8] = &[];
    for (i, &byte) in digits.iter().enumerate() {
        let digit = byte.wrapping_sub(b'0');
        if digit < 10 {
            mantissa = mantissa.wrapping_mul(10).wrapping_add(u64::from(digit));
            count += 1;
            fraction += i32::from(point);
        } else if byte == b'.' && !point {
            point = true;
        } else {
            rest = &digits[i..];
            break;
        }
    }
    if count == 0 || count > 19 || mantissa > 1 << 53 {
        return None;
    }
    let exponent = exponent(rest)? - fraction;
    let size = exponent.unsigned_abs() as usize;
    let power = *EXACT_POWERS.get(size)?;
    let value = if exponent < 0 { mantissa as f64 / power } else { mantissa as f64 * power };
    Some(if negative { -value } else { value })
}

/// The exponent that `rest` spells (`e-5`), 0 if there is nothing.
fn exponent(rest: &[u8]) -> Option<i32> {
    let Some((&mark, rest)) = rest.split_first() else { return Some(0) };
    if mark | 0x20 != b'e' || rest.len() > 4 {
        return None;
    }
    let (negative, digits) = match rest.first()? {
        b'-' => (true, &rest[1..]),
        b'+' => (false, &rest[1..]),
        _ => (false, rest),
    };
    let value = integer(digits)? as i32;
    Some(if negative { -value } else { value })
}

fn slow(bytes: &[u8]) -> Option<f64> {
    let text = std::str::from_utf8(bytes).ok()?;
    if let Ok(value) = text.parse::<f64>() {
        return Some(value);
    }
    let lower = text.to_ascii_lowercase();
    let bare = lower.trim_start_matches(['-', '+']);
    if bare.starts_with("1.#inf") {
        return Some(if lower.starts_with('-') { f64::NEG_INFINITY } else { f64::INFINITY });
    }
    let nan = bare.starts_with("nan(") || bare.starts_with("1.#qnan") || bare.starts_with("1.#ind");
    nan.then_some(f64::NAN)
}

/// An unsigned decimal integer of digits alone; `None` for other text, or if it does not fit.
pub(crate) fn integer(bytes: &[u8]) -> Option<u64> {
    if bytes.is_empty() {
        return None;
    }
    bytes.iter().try_fold(0u64, |value, &byte| {
        let digit = byte.wrapping_sub(b'0');
        if digit > 9 {
            return None;
        }
        value.checked_mul(10)?.checked_add(u64::from(digit))
    })
}

/// The next token of a line whose tokens are separated by blanks, and the rest of the line.
#[inline]
pub(crate) fn token(line: &[u8]) -> Option<(&[u8], &[u8])> {
    let start = line.iter().position(|&b| !is_blank(b))?;
    let line = &line[start..];
    let end = line.iter().position(|&b| is_blank(b)).unwrap_or(line.len());
    Some(line.split_at(end))
}

/// All tokens of a line whose tokens are separated by blanks.
pub(crate) fn tokens(mut line: &[u8]) -> impl Iterator<Item = &[u8]> {
    std::iter::from_fn(move || {
        let (token, rest) = token(line)?;
        line = rest;
        Some(token)
    })
}

/// Space, tab or carriage return.
#[inline]
pub(crate) fn is_blank(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t' | b'\r')
}

/// Bytes as text: UTF-8, or else Latin-1, in which every byte is a sign.
pub(crate) fn text(bytes: &[u8]) -> String {
    match std::str::from_utf8(bytes) {
        Ok(text) => text.into(),
        Err(_) => bytes.iter().map(|&byte| char::from(byte)).collect(),
    }
}

/// At most 40 bytes of a token as text for a message, unprintable ones escaped.
pub(crate) fn shown(bytes: &[u8]) -> String {
    let short = &bytes[..bytes.len().min(40)];
    let more = if bytes.len() > 40 { "..." } else { "" };
    format!("`{}{more}`", short.escape_ascii())
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn odd_spellings_are_numbers() {
        for (text, value) in
            [("+1.5", 1.5), (".5", 0.5), ("5.", 5.0), ("-0", -0.0), ("1E3", 1e3), ("1e+02", 100.0)]
        {
            assert_eq!(parse(text.as_bytes()).map(f64::to_bits), Some(f64::to_bits(value)), "{text}");
        }
        for text in ["nan", "-NaN", "-nan(ind)", "1.#QNAN", "-1.#IND"] {
            assert!(parse(text.as_bytes()).is_some_and(f64::is_nan), "{text}");
        }
        assert_eq!(parse(b"-1.#INF"), Some(f64::NEG_INFINITY));
    }

    #[test]
    fn what_is_no_number_is_refused() {
        for text in ["", "-", ".", "e5", "1,5", "1.2.3", "0x10", "1e", "1e5x", "12a", "1 2", "--1"] {
            assert_eq!(parse(text.as_bytes()), None, "{text}");
        }
    }

    proptest! {
        #[test]
        fn printed_numbers_come_back_bit_for_bit(bits in any::<u64>()) {
            let value = f64::from_bits(bits);
            prop_assume!(value.is_finite());
            prop_assert_eq!(parse(format!("{value:?}").as_bytes()).map(f64::to_bits), Some(bits));
            prop_assert_eq!(parse(format!("{value:e}").as_bytes()).map(f64::to_bits), Some(bits));
        }

        #[test]
        fn short_decimals_agree_with_the_standard_library(text in "[-+]?[0-9]{1,12}(\\.[0-9]{0,9})?([eE][-+]?[0-9]{1,2})?") {
            prop_assert_eq!(parse(text.as_bytes()).map(f64::to_bits), text.parse::<f64>().ok().map(f64::to_bits));
        }
    }
}
