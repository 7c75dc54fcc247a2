//! Lines of DXF as text: LINE, ARC, CIRCLE, ELLIPSE, SPLINE, LWPOLYLINE and POLYLINE of the section ENTITIES. Blocks are not inserted;
//! what is passed over is counted by its type. Layers whose name holds `border` are borders.

mod entity;
mod group;

use super::LineFile;
use crate::error::{Error, Place};
use crate::number::shown;
use crate::source::Source;
use entity::Entity;
use group::Group;
use std::collections::BTreeMap;

/// Entities that hold no line by their nature.
const SILENT: [&[u8]; 4] = [b"POINT", b"TEXT", b"MTEXT", b"SEQEND"];

/// Whether a text begins as DXF does: with a section, or with a comment.
pub(super) fn begins(text: &[u8]) -> bool {
    let mut words = text.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty());
    match words.next() {
        Some(b"0") => words.next() == Some(b"SECTION"),
        Some(b"999") => true,
        _ => false,
    }
}

/// Reads the entities.
pub(super) fn read(source: &mut Source) -> Result<LineFile, Error> {
    source.detect_terminator()?;
    let (mut out, mut others) = (LineFile::new("DXF"), BTreeMap::<String, usize>::new());
    let (mut reader, mut inside, mut ended) = (Groups { source, line: 0 }, false, false);
    let mut open: Option<Entity> = None;
    while let Some(group) = reader.next()? {
        if group.code == 0 {
            if let Some(entity) = open.take() {
                open = finish(entity, &group, &mut out, &mut others).map_err(|e| reader.fault(e))?;
                if open.is_some() {
                    continue;
                }
            }
            match group.value.as_slice() {
                b"ENDSEC" => inside = false,
                b"EOF" => {
                    ended = true;
                    break;
                }
                _ if inside => open = Some(Entity::new(group)),
                _ => {}
            }
        } else if let Some(entity) = &mut open {
            entity.push(group);
        } else if group.code == 2 && group.value == b"ENTITIES" {
            inside = true;
        }
    }
    if !ended {
        let place = Place::Line(reader.line);
        return Err(reader.source.fault(place, "the drawing ends without `EOF`", "get it anew: it was cut"));
    }
    out.ignored = others.iter().map(|(name, count)| format!("{count} entities {name}")).collect();
    Ok(out)
}

/// Takes an entity whose groups are all there, as the next begins; gives it back where that is part of it.
fn finish(
    mut entity: Entity,
    next: &Group,
    out: &mut LineFile,
    others: &mut BTreeMap<String, usize>,
) -> Result<Option<Entity>, (u64, String)> {
    if entity.is_polyline() && [b"VERTEX" as &[u8], b"SEQEND"].contains(&next.value.as_slice()) {
        if next.value == b"VERTEX" {
            entity.begin_vertex();
            return Ok(Some(entity));
        }
        entity.end_vertices();
    }
    match entity.curves()? {
        Some(curves) => {
            for (points, typed) in curves {
                out.curve(super::kind_of(entity.layer()), points, typed);
            }
        }
        None if SILENT.contains(&entity.name()) => {}
        None => *others.entry(String::from_utf8_lossy(entity.name()).into_owned()).or_default() += 1,
    }
    Ok(None)
}

/// The groups of a drawing, one after the other.
struct Groups<'a> {
    source: &'a mut Source,
    line: u64,
}

impl Groups<'_> {
    fn next(&mut self) -> Result<Option<Group>, Error> {
        let Some(code) = self.source.line()? else { return Ok(None) };
        self.line += 1;
        let code = code.trim_ascii().to_vec();
        let number = std::str::from_utf8(&code).ok().and_then(|text| text.parse().ok());
        let Some(number) = number else {
            // Blank lines at the end are no group.
            if code.is_empty() && self.source.peek(1)?.is_empty() {
                return Ok(None);
            }
            return Err(self.fault((self.line, format!("the group code `{}`", shown(&code)))));
        };
        let Some(value) = self.source.line()? else {
            return Err(self.fault((self.line, format!("the group {number} has no value"))));
        };
        let value = value.trim_ascii().to_vec();
        self.line += 1;
        Ok(Some(Group { code: number, value, line: self.line }))
    }

    fn fault(&self, (line, found): (u64, String)) -> Error {
        self.source.fault(Place::Line(line), found, "expected a drawing in DXF as text")
    }
}
