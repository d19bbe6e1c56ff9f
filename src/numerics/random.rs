//! Pseudo-random numbers that are the same on every machine and for any number of threads.

use rand_xoshiro::SplitMix64;
use rand_xoshiro::rand_core::{Rng, SeedableRng};

/// Uniform numbers from the generator SplitMix64 (Steele, Lea and Flood, OOPSLA 2014), in independent streams of a seed.
///
/// The generator works on integers only, so the same seed gives the same numbers everywhere; a sea record made from them
/// also passes through the machine's logarithm and cosine, which may differ in the last digit from one machine to another.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Random(SplitMix64);

/// The odd integer nearest to 2^64 over the golden ratio: SplitMix64's increment.
const GOLDEN_GAMMA: u64 = 0x9e37_79b9_7f4a_7c15;

impl Random {
    /// One stream of a seed; different streams of a seed are independent of one another.
    #[must_use]
    pub fn new(seed: u64, stream: u64) -> Self {
        // A mixed seed keeps neighbouring streams from being the same numbers one step apart.
        let start = mixed(seed);
        let state = mixed(start ^ stream.wrapping_mul(GOLDEN_GAMMA));
        Self(SplitMix64::seed_from_u64(state))
    }

    /// The next number, uniform on the open interval from 0 to 1: the middle of one of 2^52 equal parts.
    pub fn uniform(&mut self) -> f64 {
        const PARTS: f64 = (1_u64 << 52) as f64;
        ((self.0.next_u64() >> 12) as f64 + 0.5) / PARTS
    }

    /// Uniform between two numbers.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.uniform()
    }

    /// A power of ten whose exponent is uniform between two numbers.
    pub fn power(&mut self, low: f64, high: f64) -> f64 {
        10_f64.powf(self.between(low, high))
    }

    /// Whether something happens that happens with this share of chances \[-\].
    pub fn chance(&mut self, share: f64) -> bool {
        self.uniform() < share
    }

    /// A whole number from `low` to `high`, both among them: a small range.
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "small and not negative"
    )]
    pub fn whole(&mut self, low: usize, high: usize) -> usize {
        let span = (high - low + 1) as f64;
        low + ((self.uniform() * span) as usize).min(high - low)
    }
}

/// The first output of the generator started at a seed.
fn mixed(seed: u64) -> u64 {
    SplitMix64::seed_from_u64(seed).next_u64()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_generator_is_splitmix64() {
        // Reference values for seed 1234567, as published with the generator's test vectors.
        let mut generator = SplitMix64::seed_from_u64(1_234_567);
        let three = [(); 3].map(|()| generator.next_u64());
        assert_eq!(
            three,
            [
                6_457_827_717_110_365_317,
                3_203_168_211_198_807_973,
                9_817_491_932_198_370_423
            ]
        );
    }

    /// Records of irregular seas in published results depend on these bits.
    #[test]
    fn the_numbers_of_a_seed_never_change() {
        let mut random = Random::new(1, 0);
        let bits = [(); 2].map(|()| random.uniform().to_bits());
        assert_eq!(bits, [0x3fe6_3140_5e8d_b1b1, 0x3fef_18b6_c590_7ee1]);
    }

    #[test]
    fn uniform_and_different_by_stream() {
        let mut random = Random::new(1, 0);
        let sum: f64 = (0..10_000).map(|_| random.uniform()).sum();
        assert!((sum / 1e4 - 0.5).abs() < 4.0 / (12e4_f64).sqrt());
        assert_eq!(Random::new(7, 3), Random::new(7, 3));
        assert_ne!(Random::new(7, 3).uniform(), Random::new(7, 4).uniform());
        assert_ne!(Random::new(7, 3).uniform(), Random::new(8, 3).uniform());
    }
}
