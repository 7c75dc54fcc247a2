//! Parquet: any schema, row groups, columns and pages, in thrift's compact form.

use super::{Number, or};
use arbitrary::Arbitrary;

#[derive(Arbitrary, Debug)]
struct Element {
    name: u8,
    kind: Option<u8>,
    repetition: u8,
    children: Option<Number>,
}

#[derive(Arbitrary, Debug)]
struct Page {
    kind: u8,
    values: Number,
    unpacked: Option<Number>,
    packed: Option<Number>,
    encoding: u8,
    body: Vec<u8>,
}

#[derive(Arbitrary, Debug)]
struct Column {
    path: u8,
    kind: u8,
    codec: u8,
    values: Option<Number>,
    pages: Vec<Page>,
    /// Other numbers than the pages have: the place of the first, and the bytes of all.
    stated: [Option<Number>; 2],
    /// The column takes the pages of the one before.
    shared: bool,
}

/// The parts of a file.
#[derive(Arbitrary, Debug)]
pub struct Parquet {
    rows: Number,
    children: Option<Number>,
    elements: Vec<Element>,
    groups: Vec<(Number, Vec<Column>)>,
}

/// Numbers of the types of thrift's compact form.
const I32: u8 = 5;
const I64: u8 = 6;
const TEXT: u8 = 8;
const LIST: u8 = 9;
const STRUCT: u8 = 12;

/// A structure as it is written, with the number of its last field.
#[derive(Default)]
struct Thrift(Vec<u8>, u8);

impl Thrift {
    fn varint(mut self, mut number: u64) -> Self {
        while number > 127 {
            self.0.push(number as u8 | 128);
            number >>= 7;
        }
        self.0.push(number as u8);
        self
    }

    fn zigzag(self, number: u64) -> Self {
        self.varint(number << 1 ^ ((number as i64) >> 63) as u64)
    }

    /// The head of a field: how much farther than the last, and its type.
    fn field(mut self, id: u8, kind: u8) -> Self {
        self.0.push((id - self.1) << 4 | kind);
        self.1 = id;
        self
    }

    fn number(self, id: u8, kind: u8, number: u64) -> Self {
        self.field(id, kind).zigzag(number)
    }

    fn bytes(mut self, bytes: &[u8]) -> Self {
        self = self.varint(bytes.len() as u64);
        self.0.extend(bytes);
        self
    }

    fn list(mut self, id: u8, kind: u8, items: Vec<Vec<u8>>) -> Self {
        self = self.field(id, LIST);
        self.0.push(0xf0 | kind);
        self = self.varint(items.len() as u64);
        self.0.extend(items.concat());
        self
    }

    fn structure(mut self, id: u8, body: Vec<u8>) -> Self {
        self = self.field(id, STRUCT);
        self.0.extend(body);
        self
    }

    fn end(mut self) -> Vec<u8> {
        self.0.push(0);
        self.0
    }
}

fn name(name: u8) -> Vec<u8> {
    [b"x", b"y", b"z", b"n"][usize::from(name % 4)].to_vec()
}

impl Parquet {
    /// The file.
    pub fn bytes(&self) -> Vec<u8> {
        let mut file = b"PAR1".to_vec();
        let mut before = (4, 0);
        let groups = self.groups.iter().map(|(rows, columns)| {
            let columns: Vec<Vec<u8>> =
                columns.iter().map(|column| column.write(&mut file, &mut before)).collect();
            Thrift::default().list(1, STRUCT, columns).number(2, I64, 0).number(3, I64, rows.0).end()
        });
        let groups: Vec<Vec<u8>> = groups.collect();
        let root = Thrift::default().field(4, TEXT).bytes(b"m").number(
            5,
            I32,
            or(self.children, self.elements.len()),
        );
        let schema = std::iter::once(root.end()).chain(self.elements.iter().map(Element::write)).collect();
        let metadata =
            Thrift::default().number(1, I32, 1).list(2, STRUCT, schema).number(3, I64, self.rows.0);
        let metadata = metadata.list(4, STRUCT, groups).end();
        file.extend(&metadata);
        file.extend((metadata.len() as u32).to_le_bytes());
        file.extend(b"PAR1");
        file
    }
}

impl Element {
    fn write(&self) -> Vec<u8> {
        let mut element = Thrift::default();
        if let Some(kind) = self.kind {
            element = element.number(1, I32, u64::from(kind % 8));
        }
        element =
            element.number(3, I32, u64::from(self.repetition % 3)).field(4, TEXT).bytes(&name(self.name));
        if let Some(children) = self.children {
            element = element.number(5, I32, children.0);
        }
        element.end()
    }
}

impl Column {
    /// Writes the pages; gives the description of the chunk.
    fn write(&self, file: &mut Vec<u8>, before: &mut (usize, usize)) -> Vec<u8> {
        if !self.shared {
            let first = file.len();
            self.pages.iter().for_each(|page| file.extend(page.write()));
            *before = (first, file.len() - first);
        }
        let values: u64 = self.pages.iter().fold(0, |sum, page| sum.wrapping_add(page.values.0));
        let number = |text: u8| Thrift::default().zigzag(u64::from(text)).0;
        let path = Thrift::default().bytes(&name(self.path)).0;
        let size = or(self.stated[1], before.1);
        let metadata = Thrift::default()
            .number(1, I32, u64::from(self.kind % 8))
            .list(2, I32, vec![number(0), number(3)])
            .list(3, TEXT, vec![path])
            .number(4, I32, u64::from(self.codec % 8))
            .number(5, I64, self.values.map_or(values, |n| n.0))
            .number(6, I64, size)
            .number(7, I64, size)
            .number(9, I64, or(self.stated[0], before.0));
        Thrift::default().number(2, I64, 0).structure(3, metadata.end()).end()
    }
}

impl Page {
    fn write(&self) -> Vec<u8> {
        let size = self.body.len();
        let header = Thrift::default()
            .number(1, I32, [0, 2, 3][usize::from(self.kind % 3)])
            .number(2, I32, or(self.unpacked, size))
            .number(3, I32, or(self.packed, size));
        let values = Thrift::default().number(1, I32, self.values.0);
        let encoding = u64::from(self.encoding % 10);
        let mut bytes = match self.kind % 3 {
            0 => {
                header.structure(5, values.number(2, I32, encoding).number(3, I32, 3).number(4, I32, 3).end())
            }
            1 => header.structure(7, values.number(2, I32, encoding).end()),
            _ => {
                let rows = values.number(2, I32, 0).number(3, I32, self.values.0).number(4, I32, encoding);
                header.structure(8, rows.number(5, I32, 0).number(6, I32, 0).end())
            }
        }
        .end();
        bytes.extend(&self.body);
        bytes
    }
}
