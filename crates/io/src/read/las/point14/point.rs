//! The base of a record of point formats 6 to 10, as 30 bytes.

/// Bytes of the base.
pub(super) const SIZE: usize = 30;

/// A record.
#[derive(Clone, Copy)]
pub(super) struct Point {
    pub place: [i32; 3],
    pub intensity: u16,
    /// The number of the return, and of how many.
    pub returns: (u8, u8),
    pub flags: u8,
    pub class: u8,
    pub user: u8,
    pub angle: i16,
    pub source: u16,
    /// Bits of the GPS time.
    pub time: i64,
}

impl Point {
    pub fn unpack(b: &[u8; SIZE]) -> Self {
        let number = |at: usize| i32::from_le_bytes([b[at], b[at + 1], b[at + 2], b[at + 3]]);
        let mut time = [0; 8];
        time.copy_from_slice(&b[22..]);
        Self {
            place: [number(0), number(4), number(8)],
            intensity: u16::from_le_bytes([b[12], b[13]]),
            returns: (b[14] & 15, b[14] >> 4),
            flags: b[15],
            class: b[16],
            user: b[17],
            angle: i16::from_le_bytes([b[18], b[19]]),
            source: u16::from_le_bytes([b[20], b[21]]),
            time: i64::from_le_bytes(time),
        }
    }

    pub fn pack(&self, out: &mut [u8]) {
        for (axis, value) in self.place.iter().enumerate() {
            out[4 * axis..4 * axis + 4].copy_from_slice(&value.to_le_bytes());
        }
        out[12..14].copy_from_slice(&self.intensity.to_le_bytes());
        out[14] = self.returns.1 << 4 | self.returns.0;
        (out[15], out[16], out[17]) = (self.flags, self.class, self.user);
        out[18..20].copy_from_slice(&self.angle.to_le_bytes());
        out[20..22].copy_from_slice(&self.source.to_le_bytes());
        out[22..SIZE].copy_from_slice(&self.time.to_le_bytes());
    }
}
