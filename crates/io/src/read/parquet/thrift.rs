//! Headers and metadata of Parquet: structures of Apache Thrift in its compact protocol, walked over without taking memory.

/// Structures inside each other beyond which a header is damaged.
const DEPTH: u8 = 12;
/// Stands for the field that a structure is where nothing is asked of it.
const DEEP: i16 = i16::MIN;

/// Whether bytes begin with a whole structure, in which everything that is counted takes bytes.
pub(super) fn is_structure(bytes: &[u8]) -> bool {
    Thrift(bytes).structure(0, 0, &mut |_, _, _| {}).is_some()
}

/// The remaining bytes of a structure.
pub(super) struct Thrift<'a>(pub &'a [u8]);

impl Thrift<'_> {
    fn byte(&mut self) -> Option<u8> {
        let (&byte, rest) = self.0.split_first()?;
        self.0 = rest;
        Some(byte)
    }

    pub fn skip(&mut self, count: u64) -> Option<()> {
        self.0 = self.0.get(usize::try_from(count).ok()?..)?;
        Some(())
    }

    /// An unsigned number, seven bits a byte.
    pub fn varint(&mut self) -> Option<u64> {
        let mut value = 0;
        for shift in (0..64).step_by(7) {
            let byte = self.byte()?;
            value |= u64::from(byte & 0x7f) << shift;
            if byte < 0x80 {
                return Some(value);
            }
        }
        None
    }

    /// A signed number: zigzag.
    pub fn integer(&mut self) -> Option<i64> {
        let value = self.varint()?;
        Some((value >> 1) as i64 ^ -((value & 1) as i64))
    }

    /// Walks over a structure, which is field `outer` of the one around it, handing out its whole numbers and
    /// booleans.
    pub fn structure(&mut self, depth: u8, outer: i16, found: &mut dyn FnMut(i16, i16, i64)) -> Option<()> {
        let mut id: i16 = 0;
        while let Some(kind) = self.field(&mut id)? {
            match kind {
                // Booleans: the type is the value.
                kind @ (1 | 2) => found(outer, id, i64::from(kind == 1)),
                4..=6 => found(outer, id, self.integer()?),
                kind => self.value(kind, depth, id, found)?,
            }
        }
        Some(())
    }

    /// The type of the next field of a structure, whose number follows on the last one's `id`; `Some(None)` at its end.
    pub fn field(&mut self, id: &mut i16) -> Option<Option<u8>> {
        let head = self.byte()?;
        if head == 0 {
            return Some(None);
        }
        *id = match head >> 4 {
            0 => i16::try_from(self.integer()?).ok()?,
            delta => id.checked_add(delta.into())?,
        };
        Some(Some(head & 0xf))
    }

    /// The number and the type of the elements of a list.
    pub fn list(&mut self) -> Option<(u64, u8)> {
        let head = self.byte()?;
        let count = if head >> 4 == 15 { self.varint()? } else { u64::from(head >> 4) };
        Some((count, head & 0xf))
    }

    /// Passes over a value.
    pub fn pass(&mut self, kind: u8) -> Option<()> {
        match kind {
            1 | 2 => Some(()),
            kind => self.value(kind, 1, DEEP, &mut |_, _, _| {}),
        }
    }

    /// Walks over a value of any type.
    fn value(&mut self, kind: u8, depth: u8, id: i16, found: &mut dyn FnMut(i16, i16, i64)) -> Option<()> {
        match kind {
            1..=3 => self.skip(1),
            4..=6 => self.varint().map(|_| ()),
            7 => self.skip(8),
            8 => {
                let length = self.varint()?;
                self.skip(length)
            }
            9 | 10 => {
                let (count, kind) = self.list()?;
                // The format has no list of booleans, and the decoder passes over any number of them in no bytes.
                if matches!(kind, 1 | 2) && count > 0 {
                    return None;
                }
                (0..count).try_for_each(|_| self.value(kind, depth.checked_add(1)?, DEEP, found))
            }
            // Deeper structures (statistics) have fields of their own under the same numbers.
            12 if depth < DEPTH => self.structure(depth + 1, if depth == 0 { id } else { DEEP }, found),
            _ => None,
        }
    }
}
