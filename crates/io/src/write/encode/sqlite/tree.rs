//! The b-trees of SQLite: leaves filled one after the other, then the levels above them.

use super::record::varint;
use std::io;

/// Bytes of a page.
pub(super) const PAGE: usize = 4096;
/// Kinds of pages.
const TABLE_LEAF: u8 = 13;
const TABLE_INNER: u8 = 5;
const INDEX_LEAF: u8 = 10;
/// The most bytes of a row that stand in a leaf of a table; of longer ones at least the second.
const MOST: usize = PAGE - 35;
const LEAST: usize = (PAGE - 12) * 32 / 255 - 23;
/// The most bytes of a row of an index that stand in its leaf.
const MOST_OF_INDEX: usize = (PAGE - 12) * 64 / 255 - 23;

/// The pages after the first.
#[derive(Default)]
pub(super) struct Pages(Vec<u8>);

/// A page being filled: cells, and the bytes that they take with their places.
struct Filling {
    kind: u8,
    /// Bytes before the page's own header, which the first page has.
    before: usize,
    cells: Vec<Vec<u8>>,
    used: usize,
}

impl Filling {
    fn new(kind: u8, before: usize) -> Self {
        let head = if kind == TABLE_INNER { 12 } else { 8 };
        Self { kind, before, cells: Vec::new(), used: before + head }
    }

    fn fits(&self, cell: &[u8]) -> bool {
        self.used + 2 + cell.len() <= PAGE
    }

    fn add(&mut self, cell: Vec<u8>) {
        self.used += 2 + cell.len();
        self.cells.push(cell);
    }

    /// The bytes of the page; `right` is the last child of an inner one.
    fn bytes(&self, right: Option<u32>) -> Vec<u8> {
        let mut page = vec![0; PAGE];
        let mut end = PAGE;
        let mut places = Vec::new();
        for cell in &self.cells {
            end -= cell.len();
            page[end..end + cell.len()].copy_from_slice(cell);
            places.extend((end as u16).to_be_bytes());
        }
        let mut head = vec![self.kind, 0, 0];
        head.extend((self.cells.len() as u16).to_be_bytes());
        head.extend((end as u16).to_be_bytes());
        head.push(0);
        head.extend(right.into_iter().flat_map(u32::to_be_bytes));
        head.extend(places);
        page[self.before..self.before + head.len()].copy_from_slice(&head);
        page
    }
}

fn full() -> io::Error {
    io::Error::other("the database does not fit the format: too many pages, or too long a schema")
}

impl Pages {
    /// Appends a page; gives its number, the first of the file being 1.
    fn push(&mut self, page: &[u8]) -> io::Result<u32> {
        self.0.extend_from_slice(page);
        u32::try_from(self.0.len() / PAGE + 1).map_err(|_| full())
    }

    /// Writes a table; gives the number of its root.
    pub fn table(&mut self, rows: impl Iterator<Item = (i64, Vec<u8>)>) -> io::Result<u32> {
        let mut children: Vec<(u32, i64)> = Vec::new();
        let mut leaf = Filling::new(TABLE_LEAF, 0);
        let mut last = 0;
        for (id, row) in rows {
            let cell = self.cell(id, &row)?;
            if !leaf.fits(&cell) {
                children.push((self.push(&leaf.bytes(None))?, last));
                leaf = Filling::new(TABLE_LEAF, 0);
            }
            leaf.add(cell);
            last = id;
        }
        children.push((self.push(&leaf.bytes(None))?, last));
        while children.len() > 1 {
            children = self.level(&children)?;
        }
        children.first().map(|child| child.0).ok_or_else(full)
    }

    /// Writes the level above these children, each with the greatest id in it.
    fn level(&mut self, children: &[(u32, i64)]) -> io::Result<Vec<(u32, i64)>> {
        let mut above = Vec::new();
        let mut page = Filling::new(TABLE_INNER, 0);
        for (index, &(child, id)) in children.iter().enumerate() {
            let mut cell = child.to_be_bytes().to_vec();
            varint(id as u64, &mut cell);
            // No inner page has one child alone: the last two stay together.
            let ends = !page.fits(&[0; 13]) && index + 2 < children.len() || index + 1 == children.len();
            if ends {
                above.push((self.push(&page.bytes(Some(child)))?, id));
                page = Filling::new(TABLE_INNER, 0);
            } else {
                page.add(cell);
            }
        }
        Ok(above)
    }

    /// A row as a cell of a leaf. The rest of a long row goes to pages of its own.
    fn cell(&mut self, id: i64, row: &[u8]) -> io::Result<Vec<u8>> {
        let mut cell = Vec::new();
        varint(row.len() as u64, &mut cell);
        varint(id as u64, &mut cell);
        if row.len() <= MOST {
            cell.extend_from_slice(row);
            return Ok(cell);
        }
        let some = LEAST + (row.len() - LEAST) % (PAGE - 4);
        let (here, rest) = row.split_at(if some <= MOST { some } else { LEAST });
        cell.extend_from_slice(here);
        let mut next = 0;
        let parts: Vec<&[u8]> = rest.chunks(PAGE - 4).collect();
        for part in parts.iter().rev() {
            let mut page = u32::to_be_bytes(next).to_vec();
            page.extend_from_slice(part);
            page.resize(PAGE, 0);
            next = self.push(&page)?;
        }
        cell.extend(next.to_be_bytes());
        Ok(cell)
    }

    /// Writes an index of few rows; gives the number of its page.
    pub fn index(&mut self, rows: Vec<Vec<u8>>) -> io::Result<u32> {
        let mut leaf = Filling::new(INDEX_LEAF, 0);
        for row in rows {
            let mut cell = Vec::new();
            varint(row.len() as u64, &mut cell);
            if row.len() > MOST_OF_INDEX || !leaf.fits(&[cell.as_slice(), &row].concat()) {
                return Err(full());
            }
            cell.extend(row);
            leaf.add(cell);
        }
        self.push(&leaf.bytes(None))
    }

    /// The whole file: the first page, which holds these rows after a header, then all others.
    pub fn first(self, header: usize, rows: impl Iterator<Item = (i64, Vec<u8>)>) -> io::Result<Vec<u8>> {
        let mut leaf = Filling::new(TABLE_LEAF, header);
        for (id, row) in rows {
            let mut cell = Vec::new();
            varint(row.len() as u64, &mut cell);
            varint(id as u64, &mut cell);
            cell.extend(row);
            if !leaf.fits(&cell) {
                return Err(full());
            }
            leaf.add(cell);
        }
        Ok([leaf.bytes(None), self.0].concat())
    }
}
