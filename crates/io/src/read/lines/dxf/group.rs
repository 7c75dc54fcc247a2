//! Groups, of which drawings consist.

use crate::number::{parse, shown};

/// The line of a fault, and what was found there.
pub(super) type Fault = (u64, String);

/// A group: its code, its value, and the line that the value stands in.
pub(super) struct Group {
    pub code: i32,
    pub value: Vec<u8>,
    pub line: u64,
}

/// The number of a group.
pub(super) fn number(group: &Group) -> Result<f64, Fault> {
    let value = parse(&group.value).filter(|x| x.is_finite());
    value.ok_or_else(|| (group.line, format!("group {} is {}", group.code, shown(&group.value))))
}
