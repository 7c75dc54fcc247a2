//! PTX, Leica's text format of organised scans: for each scan its columns and rows, the scanner's position and axes, a
//! transformation, and a line a cell. Points are transformed into the common frame; cells without a return, which are
//! written as `0 0 0`, are left out and counted.

use super::{Decoded, ReadOptions};
use crate::columns::narrowed;
use crate::error::Error;
use crate::number::{integer, parse, shown, tokens};
use crate::source::Source;
use lineament::Attribute;

/// The columns after x, y and z.
const NAMES: [&str; 4] = ["intensity", "red", "green", "blue"];

/// The rows of a scan's transformation.
type Transform = [[f64; 4]; 4];

/// Whether text begins as this format does: two counts, four lines of three numbers, four of four.
pub(crate) fn begins(start: &[u8]) -> bool {
    let mut lines = start.split(|&b| b == b'\n').filter(|line| !line.trim_ascii().is_empty());
    [1, 1, 3, 3, 3, 3, 4, 4, 4, 4].iter().enumerate().all(|(index, &count)| {
        let Some(line) = lines.next() else { return false };
        let whole = index >= 2 || integer(line.trim_ascii()).is_some();
        whole && tokens(line).count() == count && tokens(line).all(|word| parse(word).is_some())
    })
}

/// Reads all scans.
pub(super) fn read(source: &mut Source, options: &ReadOptions) -> Result<Decoded, Error> {
    source.detect_terminator()?;
    let mut out = Decoded::default();
    let mut columns: Vec<Vec<f64>> = Vec::new();
    let (mut empty, mut scans) = (0u64, 0u64);
    while let Some(first) = next(source)? {
        scans += 1;
        let Some((cells, transform)) = header(source, &first)? else {
            out.cut(source, options, "lines of a scan's header", 10, 1)?;
            break;
        };
        if options.scan.is_some_and(|wanted| wanted as u64 != scans) {
            let read = pass(source, cells)?;
            if read < cells {
                out.cut(source, options, &format!("cells of scan {scans}"), cells, read)?;
                break;
            }
            continue;
        }
        let read = cells_of(source, options, cells, &transform, &mut out, &mut columns, &mut empty)?;
        if read < cells {
            out.cut(source, options, &format!("cells of scan {scans}"), cells, read)?;
            break;
        }
    }
    if let Some(wanted) = options.scan.filter(|&wanted| wanted as u64 > scans) {
        let found = format!("there is no scan {wanted} of {scans}");
        return Err(source.malformed_line(found, "scans are numbered from 1"));
    }
    out.warnings.extend(source.open_end().filter(|_| out.missing.is_none()));
    if empty > 0 {
        out.ignored.push(format!("{empty} cells without a return"));
    }
    let named = NAMES.iter().zip(columns).filter(|(_, values)| values.len() == out.cloud.len());
    out.cloud.attributes =
        named.map(|(name, values)| Attribute { name: (*name).into(), values: narrowed(values) }).collect();
    Ok(out)
}

/// Passes over the cells of a scan; gives how many there were.
fn pass(source: &mut Source, cells: u64) -> Result<u64, Error> {
    for cell in 0..cells {
        if next(source)?.is_none() {
            return Ok(cell);
        }
    }
    Ok(cells)
}

/// The next line that is not blank.
fn next(source: &mut Source) -> Result<Option<Vec<u8>>, Error> {
    while let Some(line) = source.line()? {
        if !line.trim_ascii().is_empty() {
            return Ok(Some(line.to_vec()));
        }
    }
    Ok(None)
}

/// Numbers of a line, of which there must be `count`.
fn numbers<const N: usize>(source: &Source, line: &[u8]) -> Result<[f64; N], Error> {
    let mut values = [0.0; N];
    let words: Vec<&[u8]> = tokens(line).collect();
    if words.len() != N {
        return Err(source.malformed_line(
            format!("{} numbers in the header of a scan", words.len()),
            format!("expected {N}"),
        ));
    }
    for (value, word) in values.iter_mut().zip(words) {
        *value = parse(word).ok_or_else(|| source.malformed_line(shown(word), "expected a number"))?;
    }
    Ok(values)
}

/// Cells and transformation of a scan whose first line is given; `None` if the input ends in its header.
fn header(source: &mut Source, first: &[u8]) -> Result<Option<(u64, Transform)>, Error> {
    let count = |source: &Source, line: &[u8]| {
        let fault = || {
            source.malformed_line(
                format!("a scan begins with {}", shown(line)),
                "expected its number of columns, then of rows",
            )
        };
        integer(line.trim_ascii()).ok_or_else(fault)
    };
    let columns = count(source, first)?;
    let Some(second) = next(source)? else { return Ok(None) };
    let rows = count(source, &second)?;
    for _ in 0..4 {
        let Some(line) = next(source)? else { return Ok(None) };
        numbers::<3>(source, &line)?;
    }
    let mut transform = [[0.0; 4]; 4];
    for row in &mut transform {
        let Some(line) = next(source)? else { return Ok(None) };
        *row = numbers(source, &line)?;
    }
    Ok(Some((columns.saturating_mul(rows), transform)))
}

/// Reads the cells of a scan; gives how many there were.
fn cells_of(
    source: &mut Source,
    options: &ReadOptions,
    cells: u64,
    transform: &Transform,
    out: &mut Decoded,
    columns: &mut Vec<Vec<f64>>,
    empty: &mut u64,
) -> Result<u64, Error> {
    let mut values = [0.0; 7];
    for cell in 0..cells {
        let Some(line) = next(source)? else { return Ok(cell) };
        let mut count = 0;
        for word in tokens(&line) {
            let value = parse(word).filter(|_| count < 7);
            values[count.min(6)] = value.ok_or_else(|| {
                source.malformed_line(
                    format!("number {} of cell {cell} is {}", count + 1, shown(word)),
                    "expected x y z intensity [r g b]",
                )
            })?;
            count += 1;
        }
        if count < 3 {
            if options.salvage && source.peek(1)?.is_empty() {
                return Ok(cell);
            }
            return Err(source.malformed_line(
                format!("{count} numbers in cell {cell}"),
                "expected x y z intensity [r g b]",
            ));
        }
        if values[..3] == [0.0; 3] {
            *empty += 1;
            continue;
        }
        out.cloud.positions.push(transformed([values[0], values[1], values[2]], transform));
        if options.attributes {
            columns.resize_with(columns.len().max(count - 3), Vec::new);
            columns.iter_mut().zip(&values[3..count]).for_each(|(column, &value)| column.push(value));
        }
    }
    Ok(cells)
}

/// The format multiplies row vectors from the left: the last row is the translation.
fn transformed(p: [f64; 3], m: &Transform) -> [f64; 3] {
    [0, 1, 2].map(|axis| p[0] * m[0][axis] + p[1] * m[1][axis] + p[2] * m[2][axis] + m[3][axis])
}
