//! Traces of strips, by which they are compared: the same line has the same trace from whichever end it is written.

use super::strip::Strip;

/// The points in one direction from one start, as bits, so that they order and compare.
pub(crate) type Trace = Vec<[u64; 3]>;

/// The least of all traces of the same line.
pub(crate) fn trace(strip: &Strip) -> Trace {
    let mut forwards: Trace = strip.points.iter().map(|p| p.map(|x| (x + 0.0).to_bits())).collect();
    if strip.closed {
        let least = (0..forwards.len()).min_by_key(|&i| forwards[i]).unwrap_or(0);
        forwards.rotate_left(least);
    }
    let mut backwards = forwards.clone();
    backwards.reverse();
    if strip.closed {
        backwards.rotate_right(1.min(forwards.len()));
    }
    forwards.min(backwards)
}
