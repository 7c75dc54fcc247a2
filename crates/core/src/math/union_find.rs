//! Disjoint sets with path halving and union by size.

/// A partition of `0..n` into disjoint sets.
#[derive(Clone, Debug)]
pub struct UnionFind {
    parent: Vec<u32>,
    size: Vec<u32>,
}

impl UnionFind {
    /// `n` sets of one element each.
    pub fn new(n: usize) -> Self {
        Self { parent: (0..n as u32).collect(), size: vec![1; n] }
    }

    /// The representative of the set that holds `x`.
    pub fn find(&mut self, mut x: u32) -> u32 {
        while self.parent[x as usize] != x {
            let grandparent = self.parent[self.parent[x as usize] as usize];
            self.parent[x as usize] = grandparent;
            x = grandparent;
        }
        x
    }

    /// The number of elements in the set that holds `x`.
    pub fn size(&mut self, x: u32) -> u32 {
        let representative = self.find(x);
        self.size[representative as usize]
    }

    /// Joins the sets of `a` and `b`; false if they were one already, as when an edge between them closes a cycle.
    pub fn union(&mut self, a: u32, b: u32) -> bool {
        let (a, b) = (self.find(a), self.find(b));
        if a == b {
            return false;
        }
        let (big, small) = if self.size[a as usize] >= self.size[b as usize] { (a, b) } else { (b, a) };
        self.parent[small as usize] = big;
        self.size[big as usize] += self.size[small as usize];
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn joined_elements_share_a_representative_and_others_do_not() {
        let mut sets = UnionFind::new(6);
        assert!(sets.union(0, 1) && sets.union(2, 3) && sets.union(1, 3));
        assert!(!sets.union(0, 2));
        assert_eq!(sets.find(0), sets.find(3));
        assert_eq!((sets.size(0), sets.size(4)), (4, 1));
        assert_ne!(sets.find(0), sets.find(4));
        assert_ne!(sets.find(4), sets.find(5));
    }
}
