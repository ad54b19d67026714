//! Random numbers that are the same in every run.

/// Splitmix64 (Steele, Lea, Flood 2014) from a seed.
pub struct Random(pub u64);

impl Random {
    pub fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A whole number from 0 to `count` − 1.
    pub fn below(&mut self, count: usize) -> usize {
        (self.next() % count as u64) as usize
    }

    /// From 0 to 1.
    pub fn unit(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// From `low` to `high`.
    #[allow(dead_code, reason = "the example speed_vs_error needs no such number")]
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// From −`bound` to `bound`.
    pub fn within(&mut self, bound: f64) -> f64 {
        bound * (2.0 * self.unit() - 1.0)
    }

    /// A place with coordinates from −1 to 1.
    pub fn place(&mut self) -> [f64; 2] {
        [self.within(1.0), self.within(1.0)]
    }

    /// In radians, from −π to π.
    pub fn angle(&mut self) -> f64 {
        self.within(std::f64::consts::PI)
    }
}
