//! The elastic catenary between two points, after Irvine, "Cable structures" (1981), sec. 1.4, solved by nothing
//! but bisection: slow, and nothing in it can go astray.

/// A line of weight w \[N/m\] and stiffness EA \[N\] hung from the origin, s its unstretched arc length.
pub(crate) struct Catenary {
    weight: f64,
    ea: f64,
    /// Horizontal tension \[N\].
    h: f64,
    /// Vertical tension at the origin, positive where the line pulls down on it \[N\].
    v: f64,
}

impl Catenary {
    /// Of length L \[m\] with its other end at (x, z), x > 0. The weight must be positive.
    pub(crate) fn between(length: f64, weight: f64, ea: f64, x: f64, z: f64) -> Self {
        let with = |h: f64| {
            // The lower the end, the greater the vertical tension: z falls as v grows.
            let mut line = Self {
                weight,
                ea,
                h,
                v: 0.0,
            };
            line.v = bisect(-1e3 * ea, 1e3 * ea, |v| z - Self { v, ..line }.at(length).1);
            line
        };
        let log_h = bisect(-40.0, (1e3 * ea).ln(), |log_h| {
            with(log_h.exp()).at(length).0 - x
        });
        with(log_h.exp())
    }

    /// Position at s \[m\].
    pub(crate) fn at(&self, s: f64) -> (f64, f64) {
        let Self {
            weight: w,
            ea,
            h,
            v,
            ..
        } = *self;
        let below = v - w * s;
        let root = |a: f64| a.hypot(h);
        (
            h * s / ea + h / w * ((v / h).asinh() - (below / h).asinh()),
            -s / ea * (v - 0.5 * w * s) - (root(v) - root(below)) / w,
        )
    }

    /// Tension at s \[N\].
    pub(crate) fn tension(&self, s: f64) -> f64 {
        (self.v - self.weight * s).hypot(self.h)
    }
}

/// The root of a rising function.
fn bisect(mut low: f64, mut high: f64, f: impl Fn(f64) -> f64) -> f64 {
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if f(middle) < 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}
