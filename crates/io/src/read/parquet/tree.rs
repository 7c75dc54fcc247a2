//! The schema of a Parquet file, walked over before the decoder sees it: it follows groups by recursion, and keeps for every
//! column the names of all groups around it.

use super::thrift::Thrift;

/// Groups inside each other beyond which a schema is damaged.
const DEEPEST: usize = 64;
/// Field of the metadata that is the schema; fields of its elements.
const SCHEMA: i16 = 2;
const NAME: i16 = 4;
const CHILDREN: i16 = 5;
/// Types of fields: whole numbers of 32 bits, text, lists, structures.
const I32: u8 = 5;
const BINARY: u8 = 8;
const LIST: u8 = 9;
const STRUCT: u8 = 12;
/// Bytes that a name takes beside its own.
const TEXT: u64 = 48;

/// The number of bytes that the paths of all columns take, from the metadata, which must be a whole structure. The error says why
/// the schema is not valid.
pub(super) fn paths(metadata: &[u8]) -> Result<u64, String> {
    let (mut thrift, mut id, mut bytes) = (Thrift(metadata), 0, 0u64);
    let damaged = || String::from("a schema that is no tree");
    while let Some(kind) = thrift.field(&mut id).ok_or_else(damaged)? {
        if (id, kind) == (SCHEMA, LIST) {
            bytes = bytes.saturating_add(tree(&mut thrift)?);
        } else {
            thrift.pass(kind).ok_or_else(damaged)?;
        }
    }
    Ok(bytes)
}

/// Bytes of the paths of one tree, whose elements come depth first, each with the number of its children.
fn tree(thrift: &mut Thrift) -> Result<u64, String> {
    let damaged = || String::from("a schema that is no tree");
    let (count, kind) = thrift.list().filter(|list| list.1 == STRUCT).ok_or_else(damaged)?;
    // Groups that are open: children to come, and bytes of the path.
    let (mut open, mut bytes): (Vec<(u64, u64)>, u64) = (Vec::new(), 0);
    for _ in 0..count {
        let (name, children) = element(thrift).ok_or_else(damaged)?;
        let above = open.last().map_or(0, |group| group.1);
        let path = above.saturating_add(name).saturating_add(TEXT);
        bytes = bytes.saturating_add(path);
        if let Some(group) = open.last_mut() {
            group.0 -= 1;
        }
        if children > 0 {
            open.push((children, path));
        }
        while open.last().is_some_and(|group| group.0 == 0) {
            open.pop();
        }
        if open.len() > DEEPEST {
            return Err(format!("a schema of more than {DEEPEST} groups inside each other"));
        }
    }
    if open.is_empty() && kind == STRUCT { Ok(bytes) } else { Err(damaged()) }
}

/// Bytes of the name, and the number of children, of the next element.
fn element(thrift: &mut Thrift) -> Option<(u64, u64)> {
    let (mut id, mut name, mut children) = (0, 0, 0);
    while let Some(kind) = thrift.field(&mut id)? {
        match (id, kind) {
            (NAME, BINARY) => {
                name = thrift.varint()?;
                thrift.skip(name)?;
            }
            (CHILDREN, I32) => children = u64::try_from(thrift.integer()?).ok()?,
            _ => thrift.pass(kind)?,
        }
    }
    Some((name, children))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Metadata with a schema of elements, each a name and a number of children.
    fn metadata(elements: &[(usize, u8)]) -> Vec<u8> {
        let mut bytes = vec![0x29, 0xfc, 0x80 | elements.len() as u8 & 0x7f, (elements.len() >> 7) as u8];
        for &(name, children) in elements {
            bytes.extend([0x48, name as u8]);
            bytes.extend(vec![b'n'; name]);
            bytes.extend([0x15, 2 * children, 0]);
        }
        bytes.push(0);
        bytes
    }

    #[test]
    fn the_paths_of_columns_are_counted_with_the_groups_around_them() {
        let flat = metadata(&[(1, 2), (3, 0), (4, 0)]);
        assert_eq!(paths(&flat), Ok(3 * TEXT + 1 + 4 + 5 + 2 * TEXT));
        assert_eq!(paths(&metadata(&[(1, 1), (100, 2), (1, 0), (1, 0)])), Ok(1 + 101 + 102 + 102 + 9 * TEXT));
        assert!(paths(&metadata(&[(1, 2), (3, 0)])).is_err());
    }

    #[test]
    fn a_schema_of_groups_inside_each_other_is_refused_beyond_a_depth() {
        let nested = |depth: usize| metadata(&[vec![(1, 1); depth], vec![(1, 0)]].concat());
        assert!(paths(&nested(DEEPEST)).is_ok());
        assert!(paths(&nested(DEEPEST + 1)).unwrap_err().contains("inside each other"));
    }
}
