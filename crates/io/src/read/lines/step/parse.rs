//! The exchange structure: instances with their parameters.

use std::collections::BTreeMap;

/// Nested lists beyond which a file is refused.
const DEEPEST: usize = 32;

/// A parameter.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Value {
    /// An instance by its number.
    Id(u64),
    Number(f64),
    Text(Vec<u8>),
    /// An enumeration, without its dots.
    Word(Vec<u8>),
    List(Vec<Value>),
    /// A value with its type.
    Typed(Vec<u8>, Vec<Value>),
    /// `$` or `*`.
    None,
}

/// A name with its parameters.
pub(super) type Record = (Vec<u8>, Vec<Value>);

/// An instance: the records that it consists of, one unless it is complex.
#[derive(Clone, Debug)]
pub(super) struct Instance {
    /// The byte at which it begins.
    pub at: usize,
    /// Name and parameters of each.
    pub records: Vec<Record>,
}

/// The byte of a fault, and what was found there.
pub(super) type Fault = (usize, String);

/// All instances by their numbers.
pub(super) fn instances(bytes: &[u8]) -> Result<BTreeMap<u64, Instance>, Fault> {
    let mut text = Text { bytes, at: 0 };
    text.find_data()?;
    let mut all = BTreeMap::new();
    loop {
        text.blank();
        let begin = text.at;
        if text.word() == b"ENDSEC" {
            return Ok(all);
        }
        text.at = begin;
        let Some(id) = text.id() else { return Err(text.fault("no instance `#N=...;`")) };
        text.expect(b'=')?;
        let records = if text.next_is(b'(') { text.complex()? } else { vec![text.record()?] };
        text.expect(b';')?;
        all.insert(id, Instance { at: begin, records });
    }
}

struct Text<'a> {
    bytes: &'a [u8],
    at: usize,
}

impl Text<'_> {
    fn fault(&self, what: &str) -> Fault {
        let rest = &self.bytes[self.at.min(self.bytes.len())..];
        let found = crate::number::shown(&rest[..rest.len().min(24)]);
        (
            self.at,
            if rest.is_empty() { format!("{what}: the file ends here") } else { format!("{what}: {found}") },
        )
    }

    /// Moves behind `DATA;`.
    fn find_data(&mut self) -> Result<(), Fault> {
        loop {
            self.blank();
            match self.bytes.get(self.at) {
                None => return Err(self.fault("no section DATA")),
                Some(b'\'') => drop(self.text()?),
                Some(byte) if byte.is_ascii_alphanumeric() => {
                    if self.word() == b"DATA" {
                        if self.next_is(b'(') {
                            self.list(0)?;
                        }
                        return self.expect(b';');
                    }
                }
                Some(_) => self.at += 1,
            }
        }
    }

    /// Passes over blanks and comments.
    fn blank(&mut self) {
        while let Some(&byte) = self.bytes.get(self.at) {
            if byte.is_ascii_whitespace() {
                self.at += 1;
            } else if self.bytes[self.at..].starts_with(b"/*") {
                let end = self.bytes[self.at + 2..].windows(2).position(|w| w == b"*/");
                self.at = end.map_or(self.bytes.len(), |end| self.at + end + 4);
            } else {
                return;
            }
        }
    }

    fn next_is(&mut self, byte: u8) -> bool {
        self.blank();
        self.bytes.get(self.at) == Some(&byte)
    }

    fn expect(&mut self, byte: u8) -> Result<(), Fault> {
        if !self.next_is(byte) {
            return Err(self.fault(&format!("no `{}`", byte as char)));
        }
        self.at += 1;
        Ok(())
    }

    /// Letters, digits, `_` and `-`; none if there are none.
    fn word(&mut self) -> &[u8] {
        let from = self.at;
        let part = |b: &u8| b.is_ascii_alphanumeric() || *b == b'_' || *b == b'-';
        self.at += self.bytes[from..].iter().take_while(|b| part(b)).count();
        &self.bytes[from..self.at]
    }

    fn id(&mut self) -> Option<u64> {
        self.blank();
        if self.bytes.get(self.at) != Some(&b'#') {
            return None;
        }
        self.at += 1;
        crate::number::integer(self.word())
    }

    /// A name with its parameters.
    fn record(&mut self) -> Result<Record, Fault> {
        self.blank();
        let name = self.word().to_ascii_uppercase();
        if name.is_empty() {
            return Err(self.fault("no name"));
        }
        Ok((name, self.list(0)?))
    }

    fn complex(&mut self) -> Result<Vec<Record>, Fault> {
        self.expect(b'(')?;
        let mut records = Vec::new();
        while !self.next_is(b')') {
            records.push(self.record()?);
        }
        self.expect(b')')?;
        Ok(records)
    }

    fn list(&mut self, depth: usize) -> Result<Vec<Value>, Fault> {
        if depth > DEEPEST {
            return Err(self.fault("lists within lists"));
        }
        self.expect(b'(')?;
        let mut values = Vec::new();
        while !self.next_is(b')') {
            if !values.is_empty() {
                self.expect(b',')?;
            }
            values.push(self.value(depth)?);
        }
        self.expect(b')')?;
        Ok(values)
    }

    fn value(&mut self, depth: usize) -> Result<Value, Fault> {
        self.blank();
        match self.bytes.get(self.at) {
            Some(b'#') => self.id().map(Value::Id).ok_or_else(|| self.fault("no number of an instance")),
            Some(b'\'') => self.text().map(Value::Text),
            Some(b'"') => {
                self.at += 1;
                let end = self.bytes[self.at..].iter().position(|&b| b == b'"');
                self.at = end.map_or(self.bytes.len(), |end| self.at + end + 1);
                Ok(Value::None)
            }
            Some(b'$' | b'*') => {
                self.at += 1;
                Ok(Value::None)
            }
            Some(b'(') => self.list(depth + 1).map(Value::List),
            Some(b'.') => {
                self.at += 1;
                let word = self.word().to_ascii_uppercase();
                self.expect(b'.')?;
                Ok(Value::Word(word))
            }
            Some(b) if b.is_ascii_alphabetic() => {
                let name = self.word().to_ascii_uppercase();
                Ok(Value::Typed(name, self.list(depth + 1)?))
            }
            _ => self.number(),
        }
    }

    fn number(&mut self) -> Result<Value, Fault> {
        let from = self.at;
        let part = |b: &u8| b.is_ascii_digit() || b"+-.eE".contains(b);
        let length = self.bytes[from..].iter().take_while(|b| part(b)).count();
        let number = crate::number::parse(&self.bytes[from..from + length]).filter(|x| x.is_finite());
        let number = number.ok_or_else(|| self.fault("no value"))?;
        self.at += length;
        Ok(Value::Number(number))
    }

    /// A text between apostrophes; two of them stand for one.
    fn text(&mut self) -> Result<Vec<u8>, Fault> {
        let (from, mut text) = (self.at, Vec::new());
        self.at += 1;
        while let Some(&byte) = self.bytes.get(self.at) {
            self.at += 1;
            if byte == b'\'' {
                if self.bytes.get(self.at) != Some(&b'\'') {
                    return Ok(text);
                }
                self.at += 1;
            }
            text.push(byte);
        }
        Err((from, "a text without an end".into()))
    }
}
