//! Random numbers that are the same bits on every machine.
//!
//! xoshiro256++ seeded by splitmix64 (Blackman and Vigna, "Scrambled linear pseudorandom number generators", 2021).
//! Everything below is integer arithmetic, IEEE basic operations, square roots and the series of `turns`: no function
//! of the platform's mathematical library, whose last bits differ from one system to the next.

use super::turns::{ln, sin_cos};

/// A seeded stream of random numbers.
#[derive(Clone, Debug)]
pub struct Rng {
    state: [u64; 4],
}

impl Rng {
    /// The stream of a seed. Any seed will do, 0 included.
    pub fn new(seed: u64) -> Self {
        let mut word = seed;
        Self { state: [(); 4].map(|()| splitmix(&mut word)) }
    }

    /// 64 random bits.
    pub fn next_u64(&mut self) -> u64 {
        let s = &mut self.state;
        let result = s[0].wrapping_add(s[3]).rotate_left(23).wrapping_add(s[0]);
        let t = s[1] << 17;
        s[2] ^= s[0];
        s[3] ^= s[1];
        s[1] ^= s[2];
        s[0] ^= s[3];
        s[2] ^= t;
        s[3] = s[3].rotate_left(45);
        result
    }

    /// Uniform in `[0, 1)`, a multiple of 2^-53.
    pub fn uniform(&mut self) -> f64 {
        (self.next_u64() >> 11) as f64 * (1.0 / 9_007_199_254_740_992.0)
    }

    /// Uniform in `[low, high)`.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.uniform()
    }

    /// A normal deviate of mean 0 and standard deviation 1 (Box and Muller; the second of the pair is not used, so
    /// that each call takes the same two numbers of the stream).
    pub fn gaussian(&mut self) -> f64 {
        let length = (-2.0 * ln(1.0 - self.uniform())).sqrt();
        length * sin_cos(self.uniform())[1]
    }

    /// Uniform in `0..n` (0 for `n` = 0), by multiplication; the bias is below n / 2^64.
    pub fn below(&mut self, n: u64) -> u64 {
        ((u128::from(self.next_u64()) * u128::from(n)) >> 64) as u64
    }
}

fn splitmix(word: &mut u64) -> u64 {
    *word = word.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let mut z = *word;
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn splitmix_gives_the_published_first_numbers() {
        let mut word = 1_234_567;
        let first = [(); 3].map(|()| splitmix(&mut word));
        assert_eq!(first, [6_457_827_717_110_365_317, 3_203_168_211_198_807_973, 9_817_491_932_198_370_423]);
    }

    #[test]
    fn xoshiro_follows_its_reference_from_a_known_state() {
        let mut rng = Rng { state: [1, 2, 3, 4] };
        let first = [(); 4].map(|()| rng.next_u64());
        assert_eq!(first, [41_943_041, 58_720_359, 3_588_806_011_781_223, 3_591_011_842_654_386]);
    }

    #[test]
    fn uniform_and_normal_deviates_have_their_moments() {
        let mut rng = Rng::new(7);
        let n = 200_000;
        let uniform: Vec<f64> = (0..n).map(|_| rng.uniform()).collect();
        let normal: Vec<f64> = (0..n).map(|_| rng.gaussian()).collect();
        let mean = |v: &[f64], f: fn(f64) -> f64| v.iter().map(|&x| f(x)).sum::<f64>() / n as f64;
        assert!(uniform.iter().all(|x| (0.0..1.0).contains(x)));
        assert!((mean(&uniform, |x| x) - 0.5).abs() < 0.003);
        assert!(mean(&normal, |x| x).abs() < 0.01);
        assert!((mean(&normal, |x| x * x) - 1.0).abs() < 0.015);
        assert!((mean(&normal, |x| x * x * x * x) - 3.0).abs() < 0.12);
    }

    #[test]
    fn below_reaches_each_number_and_none_beyond() {
        let mut rng = Rng::new(0);
        let mut seen = [0; 5];
        for _ in 0..5000 {
            seen[rng.below(5) as usize] += 1;
        }
        assert!(seen.iter().all(|&c| (800..1200).contains(&c)), "{seen:?}");
    }
}
