//! The bytes that accessors point into: the binary part of the file, text in base64, or another file beside it.

use super::document::{Document, View};
use crate::error::{Error, Place};
use crate::read::{ReadOptions, limit};
use crate::source::Source;
use base64::Engine;
use base64::alphabet::STANDARD;
use base64::engine::{DecodePaddingMode, GeneralPurpose, GeneralPurposeConfig};
use percent_encoding::percent_decode_str;
use std::path::{Component, Path, PathBuf};

/// Base64 whose end may be padded or not.
const BASE64: GeneralPurpose = GeneralPurpose::new(
    &STANDARD,
    GeneralPurposeConfig::new().with_decode_padding_mode(DecodePaddingMode::Indifferent),
);

/// The buffers of a document, each read when it is first needed.
pub(super) struct Buffers<'a> {
    source: &'a Source,
    document: &'a Document<'a>,
    read: Vec<Option<Vec<u8>>>,
    /// Bytes that came from other files, and these.
    beside: u64,
    files: Vec<PathBuf>,
}

impl<'a> Buffers<'a> {
    /// None but the binary part, which is the first buffer.
    pub fn new(source: &'a Source, document: &'a Document<'a>, binary: Option<Vec<u8>>) -> Self {
        let mut read = vec![None; document.buffers.len().max(1)];
        if document.buffers.first().is_none_or(|first| first.uri.is_none()) {
            read[0] = binary;
        }
        Self { source, document, read, beside: 0, files: Vec::new() }
    }

    /// Files that were read.
    pub fn files(self) -> Vec<PathBuf> {
        self.files
    }

    /// Bytes that vertices may take in memory, beside the buffers and `others`: files beside the input count as part of it.
    pub fn room(&self, options: &ReadOptions, others: usize) -> u64 {
        let more = if options.memory.is_some() { 0 } else { limit::FACTOR * self.beside };
        let held = self.read.iter().flatten().map(Vec::len).sum::<usize>() + others;
        limit::bound(self.source, options).saturating_add(more).saturating_sub(held as u64)
    }

    /// Reads the buffers of some views; [`Buffers::bytes`] reports those that do not exist.
    pub fn load(&mut self, views: impl Iterator<Item = usize>) -> Result<(), Error> {
        for view in views.filter_map(|view| self.document.buffer_views.get(view)) {
            let uri = self.document.buffers.get(view.buffer).and_then(|buffer| buffer.uri.as_deref());
            let (Some(slot), Some(uri)) = (self.read.get_mut(view.buffer), uri) else { continue };
            if slot.is_none() {
                *slot = Some(match uri.strip_prefix("data:") {
                    Some(data) => decoded(self.source, view.buffer, data)?,
                    None => {
                        let (path, bytes) = beside(self.source, uri)?;
                        self.files.push(path);
                        self.beside += bytes.len() as u64;
                        bytes
                    }
                });
            }
        }
        Ok(())
    }

    /// A view and `count` bytes of it from a place.
    pub fn bytes(&self, index: usize, from: u64, count: u64) -> Result<&[u8], String> {
        let view = self.view(index)?;
        let buffer = self.read.get(view.buffer).and_then(Option::as_deref);
        let buffer = buffer.ok_or_else(|| format!("is in buffer {}, which has no bytes", view.buffer))?;
        let inside = from.checked_add(count).is_some_and(|end| end <= view.byte_length);
        let start = view.byte_offset.checked_add(from).and_then(|start| usize::try_from(start).ok());
        let found = start.zip(usize::try_from(count).ok()).filter(|_| inside);
        found.and_then(|(start, count)| buffer.get(start..start.checked_add(count)?)).ok_or_else(|| {
            let View { byte_length, byte_offset, .. } = view;
            let there = buffer.len();
            format!(
                "needs {count} bytes from byte {from} of a view of {byte_length} at byte {byte_offset} of {there}"
            )
        })
    }

    /// A view by its index.
    pub fn view(&self, index: usize) -> Result<&View, String> {
        let view = self.document.buffer_views.get(index);
        view.ok_or_else(|| format!("is in view {index}, which does not exist"))
    }
}

/// The content of a data URI without its `data:`.
fn decoded(source: &Source, buffer: usize, data: &str) -> Result<Vec<u8>, Error> {
    let fault = |what: &str| {
        let found = format!("buffer {buffer}: a data URI {what}");
        source.fault(Place::Byte(0), found, "expected `data:...;base64,` and whole base64")
    };
    let (kind, text) = data.split_once(',').ok_or_else(|| fault("without a comma"))?;
    if !kind.ends_with(";base64") {
        return Err(fault("that is not in base64"));
    }
    BASE64.decode(text).map_err(|error| fault(&format!("in which the base64 has an {error}").to_lowercase()))
}

/// A file in the folder of the input, or below it, and its bytes.
fn beside(source: &Source, uri: &str) -> Result<(PathBuf, Vec<u8>), Error> {
    let refused = |what: &str| {
        let found = format!("the buffer in {}, {what}", crate::number::shown(uri.as_bytes()));
        source.fault(Place::Byte(0), found, "put the file beside the input, or pack both into one GLB")
    };
    let name = percent_decode_str(uri).decode_utf8().map_err(|_| refused("which is no text"))?;
    let path = PathBuf::from(name.as_ref());
    let below = path.components().all(|part| matches!(part, Component::Normal(_) | Component::CurDir));
    if uri.contains(':') || !below || path.as_os_str().is_empty() {
        return Err(refused("which is not below the folder of the input"));
    }
    let input = source.path().ok_or_else(|| refused("which a stream has no folder for"))?;
    let path = input.parent().unwrap_or(Path::new("")).join(path);
    if std::fs::metadata(&path).is_ok_and(|meta| !meta.is_file()) {
        return Err(refused("which is no regular file"));
    }
    let bytes = std::fs::read(&path).map_err(|error| refused(&format!("which cannot be read ({error})")))?;
    Ok((path, bytes))
}
