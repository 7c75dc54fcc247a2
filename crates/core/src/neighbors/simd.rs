//! The inner loops in vector instructions: the one module of the library with `unsafe` code.
//!
//! There are two kinds of unsafe code. Functions compiled for AVX-512 or AVX2 are called: each type below can only be made by
//! `detect`, which asks the processor. Vectors are loaded from and stored to arrays, always through references to as many
//! values as a vector has.

use std::arch::x86_64::*;

use super::kernel::{self, Kernel};
use super::leaf::{Aabb, Leaf, Node, WIDTH};
use super::lists::Lists;

/// Loops with 512-bit vectors.
#[derive(Clone, Copy)]
pub(super) struct Avx512(());

/// The portable loops, compiled for 256-bit vectors.
#[derive(Clone, Copy)]
pub(super) struct Avx2(());

impl Avx512 {
    /// If this machine has them.
    pub(super) fn detect() -> Option<Self> {
        is_x86_feature_detected!("avx512f").then_some(Avx512(()))
    }
}

impl Avx2 {
    /// If this machine has them.
    pub(super) fn detect() -> Option<Self> {
        is_x86_feature_detected!("avx2").then_some(Avx2(()))
    }
}

impl Kernel for Avx512 {
    fn boxes(self, query: &Aabb, node: &Node) -> [f64; WIDTH] {
        // SAFETY: `self` exists only where AVX-512 does.
        unsafe { boxes(query, node) }
    }

    fn scan<const K: usize>(self, queries: &Leaf, leaf: &Leaf, around: &Aabb, lists: &mut Lists<K>) {
        // SAFETY: as above.
        match K {
            8 => unsafe { scan::<K, 1>(queries, leaf, around, lists) },
            16 => unsafe { scan::<K, 2>(queries, leaf, around, lists) },
            24 => unsafe { scan::<K, 3>(queries, leaf, around, lists) },
            32 => unsafe { scan::<K, 4>(queries, leaf, around, lists) },
            _ => kernel::scan(queries, leaf, around, lists),
        }
    }
}

impl Kernel for Avx2 {
    fn boxes(self, query: &Aabb, node: &Node) -> [f64; WIDTH] {
        // SAFETY: `self` exists only where AVX2 does.
        unsafe { boxes_avx2(query, node) }
    }

    fn scan<const K: usize>(self, queries: &Leaf, leaf: &Leaf, around: &Aabb, lists: &mut Lists<K>) {
        // SAFETY: as above.
        unsafe { scan_avx2(queries, leaf, around, lists) }
    }
}

#[target_feature(enable = "avx2")]
fn boxes_avx2(query: &Aabb, node: &Node) -> [f64; WIDTH] {
    kernel::boxes(query, node)
}

#[target_feature(enable = "avx2")]
fn scan_avx2<const K: usize>(queries: &Leaf, leaf: &Leaf, around: &Aabb, lists: &mut Lists<K>) {
    kernel::scan(queries, leaf, around, lists);
}

/// Two vectors for sixteen values.
type Pair = [__m512d; 2];

/// Half `h` of sixteen values.
#[inline]
#[target_feature(enable = "avx512f")]
fn load(values: &[f64; WIDTH], h: usize) -> __m512d {
    let half = &values.as_chunks::<8>().0[h];
    // SAFETY: eight f64 lie behind the reference.
    unsafe { _mm512_loadu_pd(half.as_ptr()) }
}

#[inline]
#[target_feature(enable = "avx512f")]
fn load_keys(keys: &[u64; 8]) -> __m512i {
    // SAFETY: eight u64 lie behind the reference.
    unsafe { _mm512_loadu_si512(keys.as_ptr().cast()) }
}

#[inline]
#[target_feature(enable = "avx512f")]
fn store_keys(keys: &mut [u64; 8], v: __m512i) {
    // SAFETY: eight u64 lie behind the reference.
    unsafe { _mm512_storeu_si512(keys.as_mut_ptr().cast(), v) }
}

/// Squared length of a vector whose coordinates are the entries of `d`; in the order of the portable loops and
/// without fused operations, so that the bits are the same.
#[inline]
#[target_feature(enable = "avx512f")]
fn norm2(d: [__m512d; 3]) -> __m512d {
    let [x, y, z] = d.map(|d| _mm512_mul_pd(d, d));
    _mm512_add_pd(_mm512_add_pd(x, y), z)
}

/// Squared distance of two boxes that lie between `min` and `max` on each axis.
#[inline]
#[target_feature(enable = "avx512f")]
fn gap2(min: [__m512d; 3], max: [__m512d; 3], other_min: [__m512d; 3], other_max: [__m512d; 3]) -> __m512d {
    norm2(std::array::from_fn(|a| {
        let below = _mm512_sub_pd(min[a], other_max[a]);
        let above = _mm512_sub_pd(other_min[a], max[a]);
        _mm512_max_pd(_mm512_max_pd(below, above), _mm512_setzero_pd())
    }))
}

#[target_feature(enable = "avx512f")]
fn boxes(query: &Aabb, node: &Node) -> [f64; WIDTH] {
    let mut out = [0.0; WIDTH];
    let (min, max) = (query.min.map(|x| _mm512_set1_pd(x)), query.max.map(|x| _mm512_set1_pd(x)));
    for h in 0..2 {
        let (low, high) =
            ([0, 1, 2].map(|a| load(&node.min[a], h)), [0, 1, 2].map(|a| load(&node.max[a], h)));
        let d = gap2(low, high, min, max);
        let half = &mut out.as_chunks_mut::<8>().0[h];
        // SAFETY: eight f64 lie behind the reference.
        unsafe { _mm512_storeu_pd(half.as_mut_ptr(), d) };
    }
    out
}

/// The queries for which a box can hold a neighbour, one bit each.
#[inline]
#[target_feature(enable = "avx512f")]
fn asking(queries: &Leaf, around: &Aabb, bounds: &[f64; WIDTH]) -> u32 {
    let (min, max) = (around.min.map(|x| _mm512_set1_pd(x)), around.max.map(|x| _mm512_set1_pd(x)));
    let half = |h: usize| {
        let at = [0, 1, 2].map(|a| load(&queries.at[a], h));
        u32::from(_mm512_cmp_pd_mask::<_CMP_LE_OQ>(gap2(min, max, at, at), load(bounds, h)))
    };
    half(0) | half(1) << 8
}

#[target_feature(enable = "avx512f")]
fn scan<const K: usize, const R: usize>(queries: &Leaf, leaf: &Leaf, around: &Aabb, lists: &mut Lists<K>) {
    let mut asking = asking(queries, around, &lists.bounds);
    if asking == 0 {
        return;
    }
    let at: [Pair; 3] = [0, 1, 2].map(|a| [load(&leaf.at[a], 0), load(&leaf.at[a], 1)]);
    // SAFETY: sixteen u32 lie behind the reference.
    let ids = unsafe { _mm512_loadu_si512(leaf.id.as_ptr().cast()) };
    let ids = [_mm512_castsi512_si256(ids), _mm512_extracti64x4_epi64::<1>(ids)];
    let ids = ids.map(|half| _mm512_cvtepu32_epi64(half));
    let own = std::ptr::eq(queries, leaf);
    let high = _mm512_set1_epi64(0xffff_ffff_0000_0000_u64 as i64);
    let mut keys = [[0u64; 8]; 2];
    while asking != 0 {
        let q = asking.trailing_zeros() as usize % WIDTH;
        asking &= asking - 1;
        let query = [0, 1, 2].map(|a| _mm512_set1_pd(queries.at[a][q]));
        let bound = _mm512_set1_pd(lists.bounds[q]);
        let mut near = 0u32;
        for h in 0..2 {
            let d = norm2(std::array::from_fn(|a| _mm512_sub_pd(at[a][h], query[a])));
            near |= u32::from(_mm512_cmp_pd_mask::<_CMP_LE_OQ>(d, bound)) << (8 * h);
            // (d & high) | id
            store_keys(&mut keys[h], _mm512_ternarylogic_epi64::<0xea>(_mm512_castpd_si512(d), high, ids[h]));
        }
        near &= !(u32::from(own) << q);
        if near != 0 {
            take::<K, R>(&keys, near, &mut lists.keys[q]);
            lists.tighten(q);
        }
    }
}

/// Inserts those of sixteen candidates that have a bit in `near` into a list.
#[inline]
#[target_feature(enable = "avx512f")]
fn take<const K: usize, const R: usize>(keys: &[[u64; 8]; 2], mut near: u32, list: &mut [u64; K]) {
    let list: &mut [[u64; 8]] = list.as_chunks_mut::<8>().0;
    let mut held: [__m512i; R] = std::array::from_fn(|r| load_keys(&list[r]));
    while near != 0 {
        let i = near.trailing_zeros() as usize % WIDTH;
        near &= near - 1;
        insert(&mut held, _mm512_set1_epi64(keys.as_flattened()[i] as i64));
    }
    list.iter_mut().zip(held).for_each(|(keys, held)| store_keys(keys, held));
}

/// Inserts into a sorted list and drops its last entry: each place takes the lesser of itself and the greater of the previous
/// place and the key.
#[inline]
#[target_feature(enable = "avx512f")]
fn insert<const R: usize>(list: &mut [__m512i; R], key: __m512i) {
    let mut before = _mm512_setzero_si512();
    for held in list {
        let shifted = _mm512_alignr_epi64::<7>(*held, before);
        before = *held;
        *held = _mm512_min_epu64(*held, _mm512_max_epu64(shifted, key));
    }
}
