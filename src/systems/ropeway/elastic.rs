//! The elastic rope with the cargo on it, by the closed form for several sections with a body between them
//! ([`statics::catenary`](crate::statics::catenary)).

use super::model::{Ropeway, SetBy};
use super::unloaded::{SpanGeometry, UnloadedRope};
use super::{RopewayError, roots};
use crate::statics::catenary::{CatenaryLine, EndOffset, SectionProperties, Solution};

/// Greatest strain: ropes break below it.
pub const MOST_STRAIN: f64 = 0.05;

/// A cargo nearer to a support than this fraction of the span hangs on the support.
pub const AT_SUPPORT: f64 = 1e-6;

/// The elastic rope between its ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ElasticRope {
    /// Distances between the ends.
    pub geometry: SpanGeometry,
    /// Weight per unstretched length \[N/m\].
    pub weight_n_per_m: f64,
    /// Axial stiffness EA \[N\].
    pub ea_n: f64,
    /// Weight of the cargo \[N\].
    pub cargo_n: f64,
}

/// What carries the cargo.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Carrier {
    /// The rope.
    Rope,
    /// The platform.
    Platform,
    /// The ship.
    Ship,
}

/// Equilibrium of the rope with the cargo.
#[derive(Debug, Clone, PartialEq)]
pub struct RopeEquilibrium {
    /// The closed form.
    pub solution: Solution,
    /// What carries the cargo.
    pub carrier: Carrier,
    /// Unstretched length of the rope between the ends \[m\].
    pub length_m: f64,
    /// Unstretched length from end A to the cargo \[m\].
    pub arc_m: f64,
    /// Position of the cargo relative to end A, x and z \[m\].
    pub cargo_m: (f64, f64),
    /// Its depth below the straight line between the ends \[m\].
    pub sag_m: f64,
}

impl RopeEquilibrium {
    /// Tension at the platform \[N\].
    #[must_use]
    pub fn platform_n(&self) -> f64 {
        self.solution.tension_a_n()
    }

    /// Tension at the ship \[N\].
    #[must_use]
    pub fn ship_n(&self) -> f64 {
        self.solution.tension_b_n()
    }
}

impl ElasticRope {
    /// The elastic rope of a ropeway.
    #[must_use]
    pub fn of_ropeway(ropeway: &Ropeway) -> Self {
        Self {
            geometry: SpanGeometry {
                span_m: ropeway.about.span_m,
                rise_m: ropeway.rise_m(),
            },
            weight_n_per_m: ropeway.weight_n_per_m(),
            ea_n: ropeway.ea_n(),
            cargo_n: ropeway.cargo_n(),
        }
    }

    /// The same with end B moved \[m\].
    #[must_use]
    pub fn moved(&self, x_m: f64, z_m: f64) -> Self {
        let geometry = SpanGeometry {
            span_m: self.geometry.span_m + x_m,
            rise_m: self.geometry.rise_m + z_m,
        };
        Self { geometry, ..*self }
    }

    /// The rope without cargo.
    ///
    /// # Errors
    /// Those of the closed form; [`RopewayError::Overstretched`].
    pub fn unloaded(&self, length_m: f64) -> Result<Solution, RopewayError> {
        self.solve(&[self.section(length_m)])
    }

    /// The rope with the cargo at an unstretched length from end A; at either end the support carries it.
    ///
    /// # Errors
    /// Those of the closed form; [`RopewayError::Overstretched`].
    pub fn with_cargo_at(
        &self,
        length_m: f64,
        arc_m: f64,
    ) -> Result<RopeEquilibrium, RopewayError> {
        let close = AT_SUPPORT * length_m;
        let (carrier, solution) = if arc_m <= close {
            (Carrier::Platform, self.unloaded(length_m)?)
        } else if arc_m >= length_m - close {
            (Carrier::Ship, self.unloaded(length_m)?)
        } else {
            let before = SectionProperties {
                clump_n: self.cargo_n,
                ..self.section(arc_m)
            };
            let parts = [before, self.section(length_m - arc_m)];
            (Carrier::Rope, self.solve(&parts)?)
        };
        let arc_m = match carrier {
            Carrier::Rope => arc_m,
            Carrier::Platform => 0.0,
            Carrier::Ship => length_m,
        };
        let cargo = solution.at(arc_m);
        Ok(RopeEquilibrium {
            sag_m: self.geometry.line_m(cargo.x_m) - cargo.z_m,
            cargo_m: (cargo.x_m, cargo.z_m),
            solution,
            carrier,
            length_m,
            arc_m,
        })
    }

    /// The rope of this unstretched length with the cargo hauled to this fraction of the span, from 0 at end A to 1.
    ///
    /// # Errors
    /// As [`ElasticRope::with_cargo_at`].
    pub fn with_cargo(
        &self,
        length_m: f64,
        position: f64,
    ) -> Result<RopeEquilibrium, RopewayError> {
        let x = position * self.geometry.span_m;
        if position <= AT_SUPPORT {
            return self.with_cargo_at(length_m, 0.0);
        }
        if position >= 1.0 - AT_SUPPORT {
            return self.with_cargo_at(length_m, length_m);
        }
        let close = 2.0 * AT_SUPPORT * length_m;
        let off = |arc: f64| Ok(self.with_cargo_at(length_m, arc)?.cargo_m.0 - x);
        let what = "no position of the cargo on this rope";
        let arc = roots::root((close, length_m - close), what, off)?;
        self.with_cargo_at(length_m, arc)
    }

    /// Unstretched length for a sag of the unloaded rope below the straight line between its ends at mid-span \[m\].
    ///
    /// # Errors
    /// As [`ElasticRope::unloaded`].
    pub fn length_for_unloaded_sag(&self, sag_m: f64) -> Result<f64, RopewayError> {
        let stretched =
            UnloadedRope::with_sag(self.geometry, self.weight_n_per_m, sag_m)?.length_m();
        let off = |length: f64| Ok(self.unloaded_sag(length)? - sag_m);
        let low = stretched / (1.0 + 0.99 * MOST_STRAIN);
        roots::root(
            (low, stretched * 1.000_001),
            "no length gives this sag",
            off,
        )
    }

    /// Unstretched length for a horizontal tension of the unloaded rope \[m\].
    ///
    /// # Errors
    /// As [`ElasticRope::unloaded`].
    pub fn length_for_unloaded_horizontal(&self, horizontal_n: f64) -> Result<f64, RopewayError> {
        let rope = UnloadedRope::with_horizontal_tension(
            self.geometry,
            self.weight_n_per_m,
            horizontal_n,
        )?;
        let stretched = rope.length_m();
        let off = |length: f64| Ok(self.unloaded(length)?.h_b_n - horizontal_n);
        let low = stretched / (1.0 + 0.99 * MOST_STRAIN);
        roots::root(
            (low, stretched * 1.000_001),
            "no length gives this horizontal tension",
            off,
        )
    }

    /// Unstretched length for a sag at mid-span with the cargo there \[m\].
    ///
    /// # Errors
    /// As [`ElasticRope::with_cargo`].
    pub fn length_for_loaded_sag(&self, sag_m: f64) -> Result<f64, RopewayError> {
        let half = 0.5 * self.geometry.span_m;
        let depth = self.geometry.line_m(half) - sag_m;
        let straight = half.hypot(depth) + half.hypot(self.geometry.rise_m - depth);
        let off = |length: f64| Ok(self.with_cargo(length, 0.5)?.sag_m - sag_m);
        let low = straight / (1.0 + 0.99 * MOST_STRAIN);
        let mut high = straight * 1.001;
        for _ in 0..60 {
            if off(high)? > 0.0 {
                break;
            }
            high += 2.0 * (high - straight);
        }
        roots::root((low, high), "no length gives this sag", off)
    }

    /// Unstretched length for a tension at the ship, the shorter of two where the tension has a minimum over the length.
    /// `rest` gives the equilibrium of a length.
    ///
    /// # Errors
    /// [`RopewayError::TooLittleTension`] where the tension is below that minimum; those of `rest`.
    pub fn length_for_tension(
        &self,
        tension_n: f64,
        rest: impl Fn(f64) -> Result<RopeEquilibrium, RopewayError>,
    ) -> Result<f64, RopewayError> {
        let chord = self.geometry.chord_m();
        let ship = |length: f64| Ok::<_, RopewayError>(rest(length)?.ship_n());
        // Stretched straight, the rope alone carries more than this tension.
        let taut = chord / (1.0 + (1.5 * tension_n / self.ea_n).min(0.98 * MOST_STRAIN));
        if ship(taut)? < tension_n {
            return Err(RopewayError::Overstretched);
        }
        let (mut before, mut low, mut step) = (taut, taut, 1e-4 * chord);
        let mut least = f64::INFINITY;
        loop {
            let next = low + step;
            let now = ship(next)?;
            if now <= tension_n {
                let off = |length: f64| Ok(ship(length)? - tension_n);
                return roots::root((low, next), "no length gives this tension", off);
            }
            if now >= least {
                let at = roots::minimum((before, next), ship)?;
                let least_n = ship(at)?;
                if least_n > tension_n {
                    let asked_n = tension_n;
                    return Err(RopewayError::TooLittleTension { asked_n, least_n });
                }
                let off = |length: f64| Ok(ship(length)? - tension_n);
                return roots::root((taut, at), "no length gives this tension", off);
            }
            (before, low, least) = (low, next, now);
            step *= 2.0;
        }
    }

    /// Depth of the unloaded rope below the straight line between its ends at mid-span \[m\].
    fn unloaded_sag(&self, length_m: f64) -> Result<f64, RopewayError> {
        let solution = self.unloaded(length_m)?;
        let half = 0.5 * self.geometry.span_m;
        let off = |arc: f64| Ok(solution.at(arc).x_m - half);
        let arc = roots::root((0.0, length_m), "the rope has no mid-span", off)?;
        Ok(self.geometry.line_m(half) - solution.at(arc).z_m)
    }

    fn section(&self, length_m: f64) -> SectionProperties {
        SectionProperties::new(length_m, self.weight_n_per_m, self.ea_n)
    }

    fn solve(&self, sections: &[SectionProperties]) -> Result<Solution, RopewayError> {
        let length: f64 = sections.iter().map(|section| section.length_m).sum();
        if length * (1.0 + MOST_STRAIN) < self.geometry.chord_m() {
            return Err(RopewayError::Overstretched);
        }
        let line = CatenaryLine {
            ends: EndOffset {
                x_m: self.geometry.span_m,
                z_m: self.geometry.rise_m,
            },
            sections,
            bed: None,
            surface_above_a_m: None,
        };
        Ok(line.solve()?)
    }
}

/// Unstretched length by the setting of a ropeway \[m\].
///
/// # Errors
/// A setting without a solution.
pub fn length_m(ropeway: &Ropeway) -> Result<f64, RopewayError> {
    let span = ElasticRope::of_ropeway(ropeway);
    let given = |value: Option<f64>| {
        value.ok_or(RopewayError::NotFound("the setting of the rope is missing"))
    };
    let setting = &ropeway.setting;
    match setting.by {
        SetBy::BareSag => span.length_for_unloaded_sag(given(setting.sag_m)?),
        SetBy::LoadedSag => span.length_for_loaded_sag(given(setting.sag_m)?),
        SetBy::BareHorizontal => span.length_for_unloaded_horizontal(given(setting.horizontal_n)?),
        SetBy::Length => given(setting.length_m),
        SetBy::Tension => span.length_for_tension(given(setting.tension_n)?, |length| {
            span.with_cargo(length, ropeway.cargo.position)
        }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ropeway::loaded::LoadedRope;

    fn span(rise_m: f64, ea_n: f64) -> ElasticRope {
        ElasticRope {
            geometry: SpanGeometry {
                span_m: 80.0,
                rise_m,
            },
            weight_n_per_m: 21.56,
            ea_n,
            cargo_n: 490.0,
        }
    }

    #[test]
    fn a_rope_that_cannot_stretch_is_two_catenaries() {
        let stiff = span(6.0, 1e15);
        for x in [0.8, 20.0, 40.0, 77.0] {
            let two =
                LoadedRope::with_horizontal_tension(stiff.geometry, 21.56, 2000.0, (x, 490.0))
                    .unwrap();
            let rest = stiff.with_cargo(two.length_m(), x / 80.0).unwrap();
            assert!((rest.solution.h_b_n / 2000.0 - 1.0).abs() < 1e-7, "{x}");
            assert!((rest.sag_m - two.sag_m()).abs() < 1e-6);
            assert!((rest.platform_n() / two.end_tensions_n().0 - 1.0).abs() < 1e-7);
        }
    }

    #[test]
    fn lengths_found_by_sag_and_tension_give_them() {
        let rope = span(-3.0, 2.0e7);
        let length = rope.length_for_unloaded_sag(7.0).unwrap();
        assert!((rope.unloaded_sag(length).unwrap() - 7.0).abs() < 1e-9);
        let length = rope.length_for_loaded_sag(7.0).unwrap();
        assert!((rope.with_cargo(length, 0.5).unwrap().sag_m - 7.0).abs() < 1e-9);
        for tension in [1800.0, 4000.0, 40_000.0] {
            let rest = |length| rope.with_cargo(length, 0.3);
            let length = rope.length_for_tension(tension, rest).unwrap();
            let found = rest(length).unwrap().ship_n();
            assert!((found / tension - 1.0).abs() < 1e-9, "{tension}");
        }
        let refused = rope.length_for_tension(500.0, |length| rope.with_cargo(length, 0.3));
        assert!(matches!(
            refused,
            Err(RopewayError::TooLittleTension { .. })
        ));
    }

    #[test]
    fn at_a_support_the_support_carries_the_cargo() {
        let rope = span(0.0, 2.0e7);
        let bare = rope.unloaded(81.6).unwrap();
        for (position, carrier) in [(0.0, Carrier::Platform), (1.0, Carrier::Ship)] {
            let rest = rope.with_cargo(81.6, position).unwrap();
            assert_eq!(rest.carrier, carrier);
            assert!((rest.ship_n() - bare.tension_b_n()).abs() < 1e-9);
            assert!(rest.sag_m.abs() < 1e-9);
        }
        let near = rope.with_cargo(81.6, 1e-4).unwrap();
        assert_eq!(near.carrier, Carrier::Rope);
        assert!(near.sag_m > 0.0 && near.sag_m < 0.1);
    }

    #[test]
    fn a_rope_that_would_have_to_stretch_too_far_is_refused() {
        assert_eq!(
            span(0.0, 2e7).unloaded(70.0),
            Err(RopewayError::Overstretched)
        );
    }
}
