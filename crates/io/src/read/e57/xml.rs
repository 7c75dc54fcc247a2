//! Limits of the XML of an E57 file: the nodes that the parser makes in memory, and the attributes and names that it compares
//! pairwise, are counted before it is parsed.

use memchr::memmem;

/// Bytes in memory, at worst, for a tag (an element and the text behind it, while their list grows), and for an attribute.
const TAG: u64 = 512;
const ATTRIBUTE: u64 = 256;
/// Attributes of one element: the parser compares each with each.
const MOST_ATTRIBUTES: u64 = 256;
/// Namespaces of a file: every element may repeat those around it.
const MOST_NAMESPACES: usize = 256;

/// Bytes that the parsed document may take; the error says what there is too much of.
pub(super) fn needed(text: &[u8]) -> Result<u64, String> {
    let namespaces = memmem::find_iter(text, b"xmlns").count();
    if namespaces > MOST_NAMESPACES {
        return Err(format!("XML of {namespaces} namespaces"));
    }
    let (mut tags, mut attributes, mut rest) = (0u64, 0u64, text);
    while let Some(start) = memchr::memchr(b'<', rest) {
        rest = &rest[start..];
        tags += 1;
        let (inside, length) = tag(rest);
        if inside > MOST_ATTRIBUTES {
            return Err(format!("an XML element of {inside} attributes"));
        }
        attributes += inside;
        rest = &rest[length..];
    }
    Ok(tags * TAG + attributes * ATTRIBUTE + 3 * text.len() as u64)
}

/// Attributes and bytes of what begins with `<`: a tag, a comment, or text that is not parsed.
fn tag(text: &[u8]) -> (u64, usize) {
    for (open, close) in [(b"<!--" as &[u8], b"-->" as &[u8]), (b"<![CDATA[", b"]]>"), (b"<?", b"?>")] {
        if text.starts_with(open) {
            let end = memmem::find(&text[open.len()..], close);
            return (0, end.map_or(text.len(), |end| open.len() + end + close.len()));
        }
    }
    let (mut attributes, mut quote) = (0, None);
    for (at, &byte) in text.iter().enumerate() {
        match (quote, byte) {
            (Some(open), close) if open == close => quote = None,
            (Some(_), _) => {}
            (None, b'"' | b'\'') => quote = Some(byte),
            (None, b'=') => attributes += 1,
            (None, b'>') => return (attributes, at + 1),
            _ => {}
        }
    }
    (attributes, text.len())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tags_and_attributes_are_counted_whatever_stands_in_quotes_and_comments() {
        let text = b"<?xml version='1.0'?><a b='>' c=\"<'\"><!-- <x y='> --><d/><![CDATA[<e f=''>]]></a>";
        assert_eq!(needed(text).unwrap(), 6 * TAG + 2 * ATTRIBUTE + 3 * text.len() as u64);
        let many = [b"<a ".as_slice(), b"b='>' ".repeat(300).as_slice(), b"/>"].concat();
        assert!(needed(&many).unwrap_err().contains("300 attributes"));
        assert!(needed(&b"<a xmlns='u'>".repeat(300)).unwrap_err().contains("300 namespaces"));
    }
}
