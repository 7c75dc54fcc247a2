//! The greatest of numbers that only fall: a tournament whose matches are played again up to the first that ends as before.
//!
//! Where the numbers of neighbours in space stand side by side, a fall among them touches a few matches that lie together in memory;
//! a heap of as many millions reaches across all of it.

/// A number in the place of one that is out: less than any other.
const OUT: f64 = f64::NEG_INFINITY;

/// Numbers, and the winner of every match between them.
pub(crate) struct Tournament {
    numbers: Vec<f64>,
    /// The winners: match 1 is the final, `k` is played by the winners of `2 k` and `2 k + 1`. The last half are the numbers themselves and
    /// not stored.
    winners: Vec<u32>,
}

impl Tournament {
    /// Of at least one number; each more than minus infinity.
    pub(crate) fn new(numbers: Vec<f64>) -> Self {
        let mut all = Self { winners: vec![0; numbers.len().next_power_of_two()], numbers };
        (1..all.winners.len()).rev().for_each(|k| all.winners[k] = all.winner(k));
        all
    }

    /// The place of the greatest, of equal ones the first; `None` once all are out.
    pub(crate) fn first(&self) -> Option<usize> {
        let first = self.winners.get(1).map_or(0, |&w| w as usize);
        (*self.numbers.get(first)? > OUT).then_some(first)
    }

    /// Whether a number is out.
    pub(crate) fn is_out(&self, at: usize) -> bool {
        self.numbers[at] == OUT
    }

    /// Lowers a number.
    pub(crate) fn lower(&mut self, at: usize, by: f64) {
        self.numbers[at] -= by;
        self.play(at);
    }

    /// Takes a number out.
    pub(crate) fn take_out(&mut self, at: usize) {
        self.numbers[at] = OUT;
        self.play(at);
    }

    /// The winner of a match: the first of equals.
    fn winner(&self, k: usize) -> u32 {
        let players = self.winners.len();
        let side = |k: usize| if k < players { self.winners[k] as usize } else { k - players };
        let [a, b] = [side(2 * k), side(2 * k + 1)];
        // Beyond the last number nobody plays.
        let wins = b < self.numbers.len() && self.numbers[b] > self.numbers[a];
        (if wins { b } else { a }) as u32
    }

    /// Plays the matches again that a number has won, as it has become less: where it has not won, nothing changes.
    fn play(&mut self, at: usize) {
        let mut k = (at + self.winners.len()) / 2;
        while k > 0 && self.winners[k] as usize == at {
            self.winners[k] = self.winner(k);
            k /= 2;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::uniform::uniform;

    #[test]
    fn the_greatest_comes_first_whatever_fell_before() {
        for count in [1, 2, 3, 64, 65, 1000] {
            let mut random = uniform(count as u64);
            // Few values, so that there are equals.
            let mut plain: Vec<f64> = (0..count).map(|_| (8.0 * random()).floor()).collect();
            let mut tournament = Tournament::new(plain.clone());
            for _ in 0..count {
                let of_equals = |a: &usize, b: &usize| plain[*a].total_cmp(&plain[*b]).then(b.cmp(a));
                let first = (0..count).filter(|&i| !tournament.is_out(i)).max_by(of_equals);
                assert_eq!(tournament.first(), first);
                tournament.take_out(first.unwrap());
                for _ in 0..3 {
                    let (at, by) = ((count as f64 * random()) as usize, (4.0 * random()).floor());
                    tournament.lower(at, by);
                    plain[at] -= by;
                }
            }
            assert_eq!(tournament.first(), None);
        }
    }
}
