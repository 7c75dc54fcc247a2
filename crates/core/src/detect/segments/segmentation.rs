//! Clusters of points, and region growing (Demarsin et al. 2007, section 2.2).

use crate::math::union_find::UnionFind;
use crate::math::vec3::{distance, dot};
use crate::neighbors::Neighbors;

/// The clusters of a cloud.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Segmentation {
    /// `(N)` cluster of each point; clusters are numbered by their first point.
    pub label: Vec<u32>,
    /// `(C)` points of each cluster.
    pub size: Vec<u32>,
    /// `(C)` whether the cluster is a face rather than a piece of a sharp edge.
    pub large: Vec<bool>,
}

impl Segmentation {
    /// Grows clusters over `rings` while normals differ by no more than `angle` radians. Large clusters are those of more
    /// points than the mean (section 2.3) and of at least `least` points.
    ///
    /// Points for which `sharp` holds are not joined: each is a small cluster of its own.
    pub fn grow(
        rings: &Neighbors,
        normals: &[[f32; 3]],
        angle: f64,
        least: u32,
        sharp: impl Fn(usize) -> bool,
    ) -> Segmentation {
        let cosine = angle.cos();
        let mut sets = UnionFind::new(normals.len());
        let smooth: Vec<bool> = (0..normals.len()).map(|i| !sharp(i)).collect();
        for i in (0..normals.len()).filter(|&i| smooth[i]) {
            for &j in rings.of(i).iter().filter(|&&j| smooth[j as usize]) {
                if dot(normals[i].map(f64::from), normals[j as usize].map(f64::from)).abs() >= cosine {
                    sets.union(i as u32, j);
                }
            }
        }
        let roots: Vec<u32> = (0..normals.len() as u32).map(|i| sets.find(i)).collect();
        Self::numbered(&roots, least)
    }

    /// Takes small clusters with points farther than `reach` from their first point apart: each point becomes its own cluster.
    ///
    /// With perfectly aligned points all normals along a straight edge are the same, so that the whole edge is one cluster, which
    /// its centre cannot represent. Scans do not have such edges.
    pub fn take_apart(self, points: &[[f64; 3]], reach: f64) -> Segmentation {
        let mut first = vec![u32::MAX; self.size.len()];
        let mut wide = vec![false; self.size.len()];
        for (i, &c) in self.label.iter().enumerate().filter(|(_, c)| !self.large[**c as usize]) {
            let start = &mut first[c as usize];
            *start = (*start).min(i as u32);
            wide[c as usize] |= distance(points[*start as usize], points[i]) > reach;
        }
        let root = |(i, &c): (usize, &u32)| if wide[c as usize] { i as u32 } else { c + points.len() as u32 };
        let roots: Vec<u32> = self.label.iter().enumerate().map(root).collect();
        let large: Vec<bool> = self.label.iter().map(|&c| self.large[c as usize]).collect();
        let mut apart = Self::numbered(&roots, 1);
        apart.label.iter().zip(large).for_each(|(&c, l)| apart.large[c as usize] = l);
        apart
    }

    /// Clusters from a representative of each point's set.
    fn numbered(roots: &[u32], least: u32) -> Segmentation {
        let mut number = vec![u32::MAX; roots.iter().max().map_or(0, |&r| r as usize + 1)];
        let (mut label, mut size) = (Vec::with_capacity(roots.len()), Vec::new());
        for &root in roots {
            let slot = &mut number[root as usize];
            if *slot == u32::MAX {
                *slot = size.len() as u32;
                size.push(0);
            }
            size[*slot as usize] += 1;
            label.push(*slot);
        }
        let mean = roots.len() as f64 / size.len().max(1) as f64;
        // A single cluster is of mean size itself: the whole surface is one face.
        let one = size.len() == 1;
        let large = size.iter().map(|&s| (f64::from(s) > mean || one) && s >= least).collect();
        Segmentation { label, size, large }
    }

    /// `(N)` one for the points of small clusters, which lie along sharp edges, zero for the others.
    pub fn score(&self) -> Vec<f32> {
        self.label.iter().map(|&c| if self.large[c as usize] { 0.0 } else { 1.0 }).collect()
    }

    /// The number of large clusters.
    pub fn large_count(&self) -> usize {
        self.large.iter().filter(|&&l| l).count()
    }

    /// The number of small clusters.
    pub fn small_count(&self) -> usize {
        self.size.iter().zip(&self.large).filter(|(s, large)| **s > 0 && !**large).count()
    }

    /// Mean number of points of the small clusters; zero if there are none.
    pub fn mean_small(&self) -> f64 {
        let points: u32 = self.size.iter().zip(&self.large).filter(|(_, l)| !**l).map(|(s, _)| s).sum();
        f64::from(points) / self.small_count().max(1) as f64
    }
}
