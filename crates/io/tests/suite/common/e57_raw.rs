//! An E57 file from its parts, so that they need not fit each other.

/// Bytes of a page, and of them those without the checksum.
const PAGE: usize = 1024;
const DATA: usize = 1020;
/// Bytes of the header of the file, where the section of points begins, and of the header of that.
const HEADER: usize = 48;
const SECTION: usize = 32;

/// A field of integers from `min` to `max` times a tenth.
pub fn scaled(name: &str, min: i64, max: i64) -> String {
    format!("<{name} type=\"ScaledInteger\" minimum=\"{min}\" maximum=\"{max}\" scale=\"0.1\"/>")
}

/// A packet of values: the bytes of a stream each.
pub fn packet(streams: &[&[u8]]) -> Vec<u8> {
    let mut body = (streams.len() as u16).to_le_bytes().to_vec();
    streams.iter().for_each(|stream| body.extend((stream.len() as u16).to_le_bytes()));
    body.extend(streams.concat());
    body.resize((body.len() + 4).next_multiple_of(4) - 4, 0);
    let length = (body.len() + 3) as u16;
    [&[1, 0], length.to_le_bytes().as_slice(), &body].concat()
}

/// A file of `scans` scans that share one section of packets, each said to hold `records` points. `more` stands in the XML.
pub fn file(prototype: &str, records: u64, packets: &[Vec<u8>], scans: usize, more: &str) -> Vec<u8> {
    let packets = packets.concat();
    let scan = format!(
        "<vectorChild type=\"Structure\"><points type=\"CompressedVector\" fileOffset=\"{HEADER}\" \
         recordCount=\"{records}\"><prototype type=\"Structure\">{prototype}</prototype></points></vectorChild>"
    );
    let xml = format!(
        "<?xml version=\"1.0\"?><e57Root type=\"Structure\"><formatName type=\"String\">ASTM E57 3D Imaging Data File\
         </formatName><guid type=\"String\">g</guid><versionMajor type=\"Integer\">1</versionMajor>\
         <versionMinor type=\"Integer\">0</versionMinor><data3D type=\"Vector\">{}</data3D>{more}</e57Root>",
        scan.repeat(scans)
    );
    let xml_at = HEADER + SECTION + packets.len();
    let pages = (xml_at + xml.len()).div_ceil(DATA);
    let numbers = |numbers: &[u64]| numbers.iter().flat_map(|n| n.to_le_bytes()).collect::<Vec<u8>>();
    let mut bytes = b"ASTM-E57\x01\0\0\0\0\0\0\0".to_vec();
    bytes.extend(numbers(&[(pages * PAGE) as u64, physical(xml_at), xml.len() as u64, PAGE as u64]));
    bytes.extend([1, 0, 0, 0, 0, 0, 0, 0]);
    bytes.extend(numbers(&[(SECTION + packets.len()) as u64, physical(HEADER + SECTION), 0]));
    bytes.extend(packets);
    bytes.extend(xml.into_bytes());
    bytes.resize(pages * DATA, b' ');
    bytes.chunks(DATA).flat_map(|data| [data, &crc32c(data).to_be_bytes()].concat()).collect()
}

/// Where a byte of the stream stands in the file.
fn physical(at: usize) -> u64 {
    (at / DATA * PAGE + at % DATA) as u64
}

/// CRC-32C, a bit at a time.
fn crc32c(bytes: &[u8]) -> u32 {
    let step = |sum: u32| if sum & 1 == 1 { 0x82f6_3b78 ^ (sum >> 1) } else { sum >> 1 };
    let byte = |sum: u32, byte: &u8| (0..8).fold(sum ^ u32::from(*byte), |sum, _| step(sum));
    !bytes.iter().fold(u32::MAX, byte)
}
