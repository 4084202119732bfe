//! Numbers that look random.

/// A generator of numbers between −1 and 1, the same on every machine.
pub(crate) struct Noise(pub(crate) u64);

impl Noise {
    pub(crate) fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    pub(crate) fn index(&mut self, count: usize) -> usize {
        ((self.next() + 1.0) * 0.5 * count as f64) as usize % count
    }

    pub(crate) fn between(&mut self, low: f64, high: f64) -> f64 {
        low + 0.5 * (self.next() + 1.0) * (high - low)
    }
}
