//! Loops that all threads share. Everything that the library runs in parallel, apart from sorts, runs here.
//!
//! A loop is cut into blocks whose bounds depend on its length alone, and the results of the blocks are put together in their
//! order, so that they are those of a serial loop whatever the number of threads. The library that shares out the work, rayon,
//! meets the blocks of every loop as one type: its code is compiled once and not again for each loop, which would make a third
//! of all code.

use rayon::prelude::*;
use std::ops::Range;
use std::sync::{Mutex, MutexGuard, PoisonError};

/// Least items of a block where one takes about a microsecond, such as a look at the neighbours of a point: to hand out less, and
/// to wake a thread for it, costs more than it gains.
pub(crate) const QUICK: usize = 1024;
/// Least items of a block where one takes tens of microseconds.
pub(crate) const SLOW: usize = 64;
/// The same where one is a task by itself, such as a strip, a slice or a block of points.
pub(crate) const TASK: usize = 1;

/// Blocks of a loop, as long as they are no larger than [`QUICK`]: enough for threads to finish together where items differ in
/// cost.
const BLOCKS: usize = 512;

/// The results of `of(i)` for all `i` below `count`, in their order; `least` items make a block.
#[inline]
pub(crate) fn map<T: Send>(count: usize, least: usize, of: impl Fn(usize) -> T + Sync) -> Vec<T> {
    blocks(count, least, &|range, out| {
        out.reserve_exact(range.len());
        range.for_each(|i| out.push(of(i)));
    })
}

/// The results of `of(scratch, i)` for all `i` below `count`, in their order. The scratch comes as an earlier call, for any other
/// `i`, has left it.
#[inline]
pub(crate) fn map_with<S: Default + Send, T: Send>(
    count: usize,
    least: usize,
    of: impl Fn(&mut S, usize) -> T + Sync,
) -> Vec<T> {
    flat_map_with(count, least, |scratch, i, out| out.push(of(scratch, i)))
}

/// What `of(i, out)` appends for all `i` below `count`, in their order.
#[inline]
pub(crate) fn flat_map<T: Send>(
    count: usize,
    least: usize,
    of: impl Fn(usize, &mut Vec<T>) + Sync,
) -> Vec<T> {
    blocks(count, least, &|range, out| range.for_each(|i| of(i, out)))
}

/// What `of(scratch, i, out)` appends for all `i` below `count`, in their order; scratch as in [`map_with`].
#[inline]
pub(crate) fn flat_map_with<S: Default + Send, T: Send>(
    count: usize,
    least: usize,
    of: impl Fn(&mut S, usize, &mut Vec<T>) + Sync,
) -> Vec<T> {
    let spare: Mutex<Vec<S>> = Mutex::new(Vec::new());
    blocks(count, least, &|range, out| {
        let mut scratch = lock(&spare).pop().unwrap_or_default();
        range.for_each(|i| of(&mut scratch, i, out));
        lock(&spare).push(scratch);
    })
}

/// The results of `of(i, item)` for all items, such as parts of a slice to be filled, in their order.
#[inline]
pub(crate) fn each<I: Send, T: Send>(
    items: impl Iterator<Item = I>,
    of: impl Fn(usize, I) -> T + Sync,
) -> Vec<T> {
    let items: Vec<Mutex<Option<I>>> = items.map(|item| Mutex::new(Some(item))).collect();
    flat_map(items.len(), TASK, |i, out| {
        let item = lock(&items[i]).take();
        out.extend(item.map(|item| of(i, item)));
    })
}

/// `count` copies of a value, written by all threads: the first touch of new memory costs most.
pub(crate) fn filled<T: Clone + Send + Sync>(count: usize, value: &T) -> Vec<T> {
    (0..count).into_par_iter().map(|_| value.clone()).collect()
}

/// What `fill` appends block by block, in the order of the blocks.
fn blocks<T: Send>(count: usize, least: usize, fill: &(dyn Fn(Range<usize>, &mut Vec<T>) + Sync)) -> Vec<T> {
    let size = (count / BLOCKS).clamp(least, QUICK);
    let filled: Vec<Mutex<Vec<T>>> = (0..count.div_ceil(size)).map(|_| Mutex::new(Vec::new())).collect();
    share(filled.len(), &|b| {
        let range = b * size..count.min((b + 1) * size);
        let mut out = Vec::new();
        fill(range, &mut out);
        *lock(&filled[b]) = out;
    });
    let mut all = Vec::with_capacity(filled.iter().map(|block| lock(block).len()).sum());
    for block in filled {
        all.append(&mut lock(&block));
    }
    all
}

/// Calls `work` with every number below `count`, each once, on any thread.
fn share(count: usize, work: &(dyn Fn(usize) + Sync)) {
    match count {
        1 => work(0),
        _ => (0..count).into_par_iter().with_max_len(1).for_each(work),
    }
}

/// A lock is held to move one value only; a panic elsewhere goes on to the caller of the loop.
fn lock<T>(slot: &Mutex<T>) -> MutexGuard<'_, T> {
    slot.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_are_those_of_a_serial_loop_in_blocks_of_any_number_and_size() {
        for count in [0, 1, 2, 511, 512, 1023, 1024, 5000, 1_000_003] {
            for least in [TASK, SLOW, QUICK] {
                let squares = map(count, least, |i| i * i);
                assert!(squares.into_iter().eq((0..count).map(|i| i * i)), "{count}");
            }
            let some = |i: usize| i % 3..i % 5;
            let serial = (0..count).flat_map(some);
            assert!(flat_map(count, SLOW, |i, out| out.extend(some(i))).into_iter().eq(serial), "{count}");
        }
    }

    #[test]
    fn scratch_is_handed_on_and_taken_by_one_at_a_time() {
        let calls = map_with(40_000, TASK, |calls: &mut usize, _| {
            *calls += 1;
            *calls
        });
        // Each thread has one scratch, which counts on.
        let threads = calls.iter().filter(|&&c| c == 1).count();
        assert!((1..=rayon::current_num_threads()).contains(&threads), "{threads}");
    }

    #[test]
    fn items_are_consumed_in_their_places() {
        let mut squares = vec![0; 10_000];
        let lengths = each(squares.chunks_mut(7), |c, chunk| {
            chunk.iter_mut().zip(7 * c..).for_each(|(square, i)| *square = i * i);
            chunk.len()
        });
        assert!(squares.into_iter().eq((0..10_000).map(|i| i * i)));
        assert_eq!((lengths.len(), lengths[0], lengths[1428]), (1429, 7, 4));
    }

    #[test]
    #[should_panic(expected = "at 77")]
    fn a_panic_reaches_the_caller() {
        map(1000, TASK, |i| assert!(i != 77, "at {i}"));
    }

    #[test]
    fn loops_run_inside_of_loops() {
        let sums = map(100, TASK, |i| map(i, TASK, |j| j).into_iter().sum::<usize>());
        assert!(sums.into_iter().eq((0..100).map(|i| i * (i + 1) / 2 - i)));
    }
}
