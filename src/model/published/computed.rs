//! A computed number that is held against a published one, by itself or against another.

/// A computed number with its errors.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ComputedNumber {
    /// The number.
    pub value: f64,
    /// Its estimated error; absent where none is estimated.
    pub error: Option<f64>,
    /// The parts of that by time step and by mesh.
    parts: [Option<f64>; 2],
}

impl ComputedNumber {
    /// A number with this error, which by time step and by mesh has these parts.
    #[must_use]
    pub const fn new(value: f64, error: Option<f64>, parts: [Option<f64>; 2]) -> Self {
        Self {
            value,
            error,
            parts,
        }
    }

    /// What it is more than another.
    #[must_use]
    pub fn change_from(&self, before: &Self) -> Self {
        let both = |a: Option<f64>, b: Option<f64>| a.zip(b).map(|(a, b)| a + b);
        self.against(before, self.value - before.value, &both)
    }

    /// Its ratio to another. Two variants computed on one mesh by one method have similar errors, most of which cancel: the greater of
    /// both relative errors is taken.
    #[must_use]
    pub fn ratio_to(&self, other: &Self) -> Self {
        let ratio = self.value / other.value;
        let both = |a: Option<f64>, b: Option<f64>| {
            let (a, b) = a.zip(b)?;
            Some(ratio.abs() * (a / self.value.abs()).max(b / other.value.abs()))
        };
        self.against(other, ratio, &both)
    }

    fn against(
        &self,
        other: &Self,
        value: f64,
        both: &dyn Fn(Option<f64>, Option<f64>) -> Option<f64>,
    ) -> Self {
        let [time, mesh] = [0, 1].map(|part| both(self.parts[part], other.parts[part]));
        let error = match (time, mesh) {
            (None, None) => None,
            (time, mesh) => Some(time.unwrap_or(0.0) + mesh.unwrap_or(0.0)),
        };
        Self::new(value, error, [time, mesh])
    }
}
