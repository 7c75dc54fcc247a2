//! Morton order of points, as deep as their coordinates differ, and the spacing that the order tells.

/// Bits an axis in one code.
pub(crate) const BITS: u32 = 21;
/// Levels of cells that share a bucket when points are sorted.
pub(super) const BUCKET_LEVELS: u32 = 4;
/// Codes a point can have, each refining the cell of the one before. Past them positions are compared.
pub(super) const DEPTHS: u32 = 24;
/// Levels of cells below the root.
pub(crate) const LEVELS: usize = (BITS * DEPTHS) as usize;
/// How many neighbours in the order first differ at a level: `[l]` counts pairs that share a cell at level `l`
/// but not at `l + 1`.
pub(crate) type Levels = [usize; LEVELS + 1];

/// Whether all three coordinates are finite.
pub(crate) fn finite(p: &[f64; 3]) -> bool {
    p.iter().all(|x| x.is_finite())
}

/// The coordinates of a cell by its code, of no more than [`BITS`] levels.
pub(crate) fn cell(code: u64) -> [u32; 3] {
    [code >> 2, code >> 1, code].map(gathered)
}

/// A cube at the least corner whose side is a power of two, halved level by level.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Grid {
    /// World coordinates of the least corner.
    pub(crate) offset: [f64; 3],
    /// Binary exponent of the cube's side.
    exponent: i32,
    /// From the distance from the corner to cells of the first code.
    to_cell: f64,
}

impl Grid {
    /// The cube at `offset` that holds all within `extent` of it.
    pub(crate) fn new(offset: [f64; 3], extent: f64) -> Grid {
        // Clamped so that powers of two stay normal numbers: a cloud smaller than 2^-1000 has coarser cells.
        let exponent = (exponent_of(extent) + 1).clamp(-1000, 1000);
        Grid { offset, exponent, to_cell: power_of_two(BITS as i32 - exponent) }
    }

    /// The same cells for points that are given from the least corner.
    pub(crate) fn at_corner(&self) -> Grid {
        Grid { offset: [0.0; 3], ..*self }
    }

    /// The vector from the least corner, without negative zeros.
    #[inline]
    pub(crate) fn relative(&self, p: [f64; 3]) -> [f64; 3] {
        std::array::from_fn(|a| (p[a] - self.offset[a]) + 0.0)
    }

    /// The code at a depth of a point by its vector from the least corner: cells of `21 * (depth + 1)` levels. Every step is exact.
    #[inline]
    pub(crate) fn code(&self, relative: [f64; 3], depth: u32) -> u64 {
        let mut x = relative.map(|x| x * self.to_cell);
        for _ in 0..depth {
            x = x.map(|x| (x - x.floor()) * f64::from(1u32 << BITS));
        }
        // Cells have 21 bits, and processors turn into signed integers fastest.
        let [x, y, z] = x.map(|x| spread(x as i32 as u64));
        x << 2 | y << 1 | z
    }

    /// The upper `3 * BUCKET_LEVELS` bits of a point's first code.
    #[inline]
    pub(super) fn bucket(&self, relative: [f64; 3]) -> usize {
        let [x, y, z] = relative.map(|x| (x * self.to_cell) as i32 as usize >> (BITS - BUCKET_LEVELS));
        let spread = |x: usize| SPREAD[x & (SPREAD.len() - 1)] as usize;
        spread(x) << 2 | spread(y) << 1 | spread(z)
    }

    /// The side of a cell at a level.
    pub(crate) fn side(&self, level: u32) -> f64 {
        power_of_two((self.exponent - level as i32).max(-1022))
    }

    /// A power of two near the mean spacing: half the side of the finest cells that hold two or more points on
    /// average. On a curve, a surface and in a volume alike that is within a factor of two; only integers are
    /// compared, so that every machine agrees.
    pub(crate) fn spacing(&self, levels: &Levels) -> f64 {
        let count = 1 + levels[..LEVELS].iter().sum::<usize>();
        let mut cells = 1;
        let mut level = 0;
        for (l, parted) in levels.iter().enumerate().take(LEVELS) {
            cells += parted;
            if 2 * cells > count {
                break;
            }
            level = l as i32 + 1;
        }
        if count < 2 { 1.0 } else { power_of_two((self.exponent - level - 1).max(-1000)) }
    }
}

/// The greatest `e` with `2^e <= x`; that of the least normal number for anything smaller.
fn exponent_of(x: f64) -> i32 {
    ((x.to_bits() >> 52) as i32).max(1) - 1023
}

/// `2^e` for a normal result.
fn power_of_two(e: i32) -> f64 {
    f64::from_bits(((e + 1023) as u64) << 52)
}

/// Bits with two zeros between them, for buckets.
const SPREAD: [u16; 1 << BUCKET_LEVELS] = {
    let mut spread = [0; 1 << BUCKET_LEVELS];
    let mut x = 0;
    while x < spread.len() {
        spread[x] = self::spread(x as u64) as u16;
        x += 1;
    }
    spread
};

/// Puts two zeros between the lowest 21 bits.
const fn spread(x: u64) -> u64 {
    let x = x & 0x1f_ffff;
    let x = (x | x << 32) & 0x001f_0000_0000_ffff;
    let x = (x | x << 16) & 0x001f_0000_ff00_00ff;
    let x = (x | x << 8) & 0x100f_00f0_0f00_f00f;
    let x = (x | x << 4) & 0x10c3_0c30_c30c_30c3;
    (x | x << 2) & 0x1249_2492_4924_9249
}

/// Undoes [`spread`].
const fn gathered(x: u64) -> u32 {
    let x = x & 0x1249_2492_4924_9249;
    let x = (x ^ x >> 2) & 0x10c3_0c30_c30c_30c3;
    let x = (x ^ x >> 4) & 0x100f_00f0_0f00_f00f;
    let x = (x ^ x >> 8) & 0x001f_0000_ff00_00ff;
    let x = (x ^ x >> 16) & 0x001f_0000_0000_ffff;
    ((x ^ x >> 32) & 0x1f_ffff) as u32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cell_has_the_coordinates_of_its_code() {
        for x in [0, 1, 5, 0x15_5555, 0x1f_ffff] {
            assert_eq!(cell(spread(x) << 2 | spread(7) << 1 | spread(0x10_0001)), [x as u32, 7, 0x10_0001]);
        }
    }

    #[test]
    fn a_bucket_is_the_upper_bits_of_the_code() {
        let grid = Grid::new([0.0; 3], 100.0);
        for i in 0..2000_u32 {
            let point = [7919, 104_729, 1_299_709].map(|prime| f64::from(i * prime % 100_003) / 1000.1);
            let upper = grid.code(point, 0) >> (3 * (BITS - BUCKET_LEVELS));
            assert_eq!(grid.bucket(point) as u64, upper, "{point:?}");
        }
    }
}
