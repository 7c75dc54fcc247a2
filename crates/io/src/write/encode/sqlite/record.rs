//! Rows of SQLite as bytes: a header of types, then the values.

/// A value of a column.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::write) enum Value {
    Null,
    Integer(i64),
    Real(f64),
    Text(String),
    Blob(Vec<u8>),
}

impl Value {
    /// The number of its type, which implies its length in bytes.
    fn kind(&self) -> u64 {
        match self {
            Value::Null => 0,
            Value::Integer(_) => 6,
            Value::Real(_) => 7,
            Value::Blob(bytes) => 12 + 2 * bytes.len() as u64,
            Value::Text(text) => 13 + 2 * text.len() as u64,
        }
    }

    /// Its bytes.
    pub fn bytes(&self) -> Vec<u8> {
        match self {
            Value::Null => Vec::new(),
            Value::Integer(value) => value.to_be_bytes().into(),
            Value::Real(value) => value.to_be_bytes().into(),
            Value::Blob(bytes) => bytes.clone(),
            Value::Text(text) => text.as_bytes().into(),
        }
    }
}

/// A row.
pub(super) fn encode(row: &[Value]) -> Vec<u8> {
    let mut kinds = Vec::new();
    row.iter().for_each(|value| varint(value.kind(), &mut kinds));
    // The header counts itself: its length takes one byte up to 127.
    let length = kinds.len() + if kinds.len() < 127 { 1 } else { 2 };
    let mut bytes = Vec::new();
    varint(length as u64, &mut bytes);
    bytes.extend(kinds);
    row.iter().for_each(|value| bytes.extend(value.bytes()));
    bytes
}

/// Appends a number of one to nine bytes: seven bits a byte, the highest first; a ninth byte holds eight.
pub(super) fn varint(value: u64, out: &mut Vec<u8>) {
    if value >> 56 != 0 {
        (0..8).for_each(|i| out.push((value >> (57 - 7 * i)) as u8 | 0x80));
        out.push(value as u8);
        return;
    }
    let groups = (64 - value.leading_zeros()).div_ceil(7).max(1);
    for group in (0..groups).rev() {
        let more = if group > 0 { 0x80 } else { 0 };
        out.push((value >> (7 * group)) as u8 & 0x7f | more);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_take_the_bytes_that_the_format_says() {
        let bytes = |value| {
            let mut out = Vec::new();
            varint(value, &mut out);
            out
        };
        assert_eq!(bytes(0), [0]);
        assert_eq!(bytes(127), [0x7f]);
        assert_eq!(bytes(128), [0x81, 0]);
        assert_eq!(bytes(0x3fff), [0xff, 0x7f]);
        assert_eq!(bytes((1 << 56) - 1).len(), 8);
        assert_eq!(bytes(1 << 56), [0x80, 0xc0, 0x80, 0x80, 0x80, 0x80, 0x80, 0x80, 0]);
        assert_eq!(bytes(u64::MAX), [0xff; 9]);
    }
}
