//! An order of the unknowns in which their normal equations have a small skyline: blocks by the reverse Cuthill-McKee order (George and Liu
//! 1981, Computer Solution of Large Sparse Positive Definite Systems, section 4.3), those that meet many others last.

use super::row::Row;
use std::collections::{BTreeSet, VecDeque};

/// Blocks that meet more others than this come last.
const CROWD: usize = 24;

/// The place of each unknown, and for each place the first column of its row.
pub(super) fn order(blocks: &[(usize, usize)], count: usize, rows: &[Row]) -> (Vec<usize>, Vec<usize>) {
    let mut block_of = vec![0; count];
    for (b, &(start, len)) in blocks.iter().enumerate() {
        block_of[start..start + len].fill(b);
    }
    let mut near: Vec<BTreeSet<usize>> = vec![BTreeSet::new(); blocks.len()];
    let met: Vec<Vec<usize>> = rows
        .iter()
        .map(|row| row.terms.iter().map(|t| block_of[t.0]).collect::<BTreeSet<usize>>().into_iter().collect())
        .collect();
    for of_row in &met {
        for &a in of_row {
            near[a].extend(of_row.iter().filter(|&&b| b != a));
        }
    }
    let late: Vec<bool> = near.iter().map(|n| n.len() > CROWD).collect();
    let mut sequence = cuthill_mckee(&near, &late);
    sequence.reverse();
    sequence.extend((0..blocks.len()).filter(|&b| late[b]));
    let mut place = vec![0; count];
    let mut next = 0;
    for b in sequence {
        let (start, len) = blocks[b];
        for k in 0..len {
            place[start + k] = next;
            next += 1;
        }
    }
    let mut first: Vec<usize> = (0..count).collect();
    for of_row in &met {
        let least = of_row.iter().map(|&b| place[blocks[b].0]).min().unwrap_or(0);
        for &b in of_row {
            for k in 0..blocks[b].1 {
                let at = place[blocks[b].0 + k];
                first[at] = first[at].min(least);
            }
        }
    }
    (place, first)
}

/// The blocks that are not late, component by component from the one with fewest neighbours, ever nearest first.
fn cuthill_mckee(near: &[BTreeSet<usize>], late: &[bool]) -> Vec<usize> {
    let mut starts: Vec<usize> = (0..near.len()).filter(|&b| !late[b]).collect();
    starts.sort_by_key(|&b| (near[b].len(), b));
    let mut seen = late.to_vec();
    let mut sequence = Vec::new();
    for start in starts {
        if seen[start] {
            continue;
        }
        seen[start] = true;
        let mut queue = VecDeque::from([start]);
        while let Some(b) = queue.pop_front() {
            sequence.push(b);
            let mut next: Vec<usize> = near[b].iter().copied().filter(|&n| !seen[n]).collect();
            next.sort_by_key(|&n| (near[n].len(), n));
            for n in next {
                seen[n] = true;
                queue.push_back(n);
            }
        }
    }
    sequence
}
