//! Files of other kinds, by their first bytes: what they are and what to do instead.

/// First bytes, and the advice.
const KINDS: [(&[u8], &str); 22] = [
    (b"\xff\xfe", UTF_16),
    (b"\xfe\xff", UTF_16),
    (b"II*\0", TIFF),
    (b"MM\0*", TIFF),
    (b"II+\0", TIFF),
    (b"MM\0+", TIFF),
    (b"\x89PNG", PICTURE),
    (b"\xff\xd8\xff", PICTURE),
    (b"GIF8", PICTURE),
    (
        b"\x1f\x8b",
        "it is compressed by gzip: `zcat scan.xyz.gz | lineament extract - -o lines.json` reads what it holds",
    ),
    (b"\x28\xb5\x2f\xfd", PACKED),
    (b"BZh", PACKED),
    (b"\xfd7zXZ\0", PACKED),
    (b"7z\xbc\xaf\x27\x1c", PACKED),
    (b"Rar!", PACKED),
    (b"%PDF", "it is a PDF document: points are needed"),
    (
        b"ISO-10303-21",
        "it is STEP or IFC, which hold surfaces and no points: save the part as a mesh, such as STL",
    ),
    (b"AC10", DRAWING),
    (b"AutoCAD Binary DXF", DRAWING),
    (b"SQLite format 3\0", "it is a database, such as a GeoPackage: export its points as a table or as LAS"),
    (b"<", "it is XML or HTML: save the points as a table, or the mesh as STL or OBJ"),
    (b"{", "it is JSON, such as the lines that `extract` writes: give the scan itself"),
];

const UTF_16: &str = "it looks like UTF-16 text: save it as UTF-8";
const TIFF: &str =
    "it is a TIFF image: save a raster of heights as an ESRI grid (`gdal_translate -of AAIGrid`)";
const PICTURE: &str = "it is a picture: points are needed, such as photogrammetry makes of many of them";
const PACKED: &str = "it is a packed file: unpack it";
const DRAWING: &str = "it is a drawing: export its points as a table, or its surfaces as a mesh, such as STL";

/// What to do with a file of a known kind that holds no points; `None` for any other.
pub(super) fn advice(start: &[u8]) -> Option<&'static str> {
    let text = start.strip_prefix(b"\xef\xbb\xbf").unwrap_or(start).trim_ascii_start();
    let mut words = text.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty());
    if (words.next(), words.next()) == (Some(b"0"), Some(b"SECTION")) {
        return Some(DRAWING);
    }
    KINDS
        .iter()
        .find(|(magic, _)| start.starts_with(magic) || text.starts_with(magic))
        .map(|(_, advice)| *advice)
}

#[cfg(test)]
mod tests {
    use super::advice;

    #[test]
    fn files_of_other_kinds_are_told_by_their_beginning() {
        for (start, word) in [
            (&b"\x1f\x8b\x08\0rest"[..], "zcat"),
            (b"  0\r\nSECTION\r\n  2\r\nHEADER\r\n", "drawing"),
            (b"ISO-10303-21;\nHEADER;", "STEP"),
            (b"\xef\xbb\xbf<?xml version", "XML"),
            (b"\n{\"schema\": 1}", "JSON"),
        ] {
            assert!(advice(start).is_some_and(|said| said.contains(word)), "{word}");
        }
        for start in [&b"0 0 0\n1 0 0\n"[..], b"ply\n", b"x,y,z\n", b"", b"0\n"] {
            assert_eq!(advice(start), None);
        }
    }
}
