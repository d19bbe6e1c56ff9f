//! A sea of several wave systems: swell beside wind sea, and short-crested waves as fields that run in different directions.

use std::sync::Arc;

use super::Component;
use super::phasors::{ComputedPhasors, FieldPhasors};
use super::waves::{Surface, WaterMotion, WaveField};
use crate::CurrentGrid;
use crate::numerics::V3;

/// Wave systems that run together, and a current that changes with time; their surfaces and their kinematics add up.
#[derive(Debug, Clone, PartialEq)]
pub struct Sea {
    fields: Vec<WaveField>,
    /// The current, where it changes with time. Its rate of change is no acceleration of the water here, as in MoorDyn.
    current: Option<Arc<CurrentGrid>>,
}

impl Sea {
    /// A sea of these fields.
    #[must_use]
    pub fn new(fields: Vec<WaveField>) -> Self {
        Self {
            fields,
            current: None,
        }
    }

    /// The same with a current that changes with time.
    #[must_use]
    pub fn with_current(self, current: Arc<CurrentGrid>) -> Self {
        Self {
            current: Some(current),
            ..self
        }
    }

    /// Whether it has a current.
    #[must_use]
    pub const fn has_current(&self) -> bool {
        self.current.is_some()
    }

    /// Whether its motion under the surface can be [extrapolated](WaterMotion::extrapolated).
    #[must_use]
    pub fn can_be_extrapolated(&self) -> bool {
        self.current.is_none() && self.fields.iter().all(WaveField::can_be_extrapolated)
    }

    /// Greatest height that the surface can have \[m\].
    #[must_use]
    pub fn crest(&self) -> f64 {
        self.fields.iter().map(WaveField::crest).sum()
    }

    /// Its fields.
    #[must_use]
    pub fn fields(&self) -> &[WaveField] {
        &self.fields
    }

    /// The components as they pass a place \[m\], field by field.
    #[must_use]
    pub fn at_point(&self, place: &V3) -> Vec<Component> {
        let fields = self.fields.iter();
        fields.flat_map(|field| field.at_point(place)).collect()
    }

    /// Height of the surface above still water \[m\] at time t \[s\] over a place.
    #[must_use]
    pub fn elevation(&self, t: f64, place: &V3) -> f64 {
        let fields = self.fields.iter();
        fields.map(|field| field.elevation(t, place)).sum()
    }

    /// What it makes of the water at a place at time t \[s\]; with the height of the surface only where `surface` or a stretching
    /// asks for it. Stretching goes by the surface of all fields together.
    #[must_use]
    pub fn flow(&self, t: f64, place: &V3, surface: bool) -> WaterMotion {
        self.flow_by(t, place, surface, &mut ComputedPhasors::at(t))
    }

    /// The same with the phasors of each field.
    pub(super) fn flow_by(
        &self,
        t: f64,
        place: &V3,
        surface: bool,
        phasors: &mut impl FieldPhasors,
    ) -> WaterMotion {
        let needed = surface || self.fields.iter().any(WaveField::needs_elevation);
        let mut whole = Surface::default();
        if needed {
            for (number, field) in self.fields.iter().enumerate() {
                whole.add(&field.surface_at(t, place, &mut phasors.of_field(number)));
            }
        }
        let mut flow = whole.over(WaterMotion {
            place: *place,
            ..WaterMotion::default()
        });
        for (number, field) in self.fields.iter().enumerate() {
            let part = field.flow_under(t, place, &whole, &mut phasors.of_field(number));
            flow.velocity += part.velocity;
            flow.gradient += part.gradient;
            flow.acceleration += part.acceleration;
            flow.acceleration_gradient += part.acceleration_gradient;
            flow.jerk += part.jerk;
        }
        if let Some(current) = &self.current {
            let (velocity, gradient) = current.at(t, place);
            flow.velocity += velocity;
            flow.gradient += gradient;
        }
        flow
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sea::{DepthDecay, Spectrum, Stretching, WaveLoad, WaveSettings, synthesise};

    fn field(direction: f64, seed: u64, stretching: Stretching) -> WaveField {
        let setting = WaveSettings {
            direction,
            depth: 60.0,
            gravity: 9.81,
            stretching,
            decay: DepthDecay::Airy,
            ramp: 10.0,
            load: WaveLoad::Morison,
        };
        let spectrum = Spectrum::jonswap(4.0, 9.0, 3.3);
        WaveField::new(synthesise(&spectrum, 20, seed, 0), &setting)
    }

    #[test]
    fn derivatives_by_place_are_those_of_the_sum() {
        for stretching in [Stretching::Vertical, Stretching::Wheeler, Stretching::None] {
            let sea = Sea::new(vec![field(0.4, 1, stretching), field(2.1, 2, stretching)]);
            let (t, h) = (17.0, 1e-5);
            for z in [-20.0, -2.0, 4.0] {
                let place = V3::new(12.0, -3.0, z);
                let at = sea.flow(t, &place, true);
                assert!((at.elevation - sea.elevation(t, &place)).abs() < 1e-14);
                for axis in 0..3 {
                    let step = V3::ith(axis, h);
                    let high = sea.flow(t, &(place + step), true);
                    let low = sea.flow(t, &(place - step), true);
                    let by = |a: V3, b: V3| (a - b) / (2.0 * h);
                    let velocity = by(high.velocity, low.velocity);
                    let acceleration = by(high.acceleration, low.acceleration);
                    assert!((velocity - at.gradient.column(axis)).norm() < 1e-7);
                    assert!((acceleration - at.acceleration_gradient.column(axis)).norm() < 1e-7);
                    let slope = (high.elevation - low.elevation) / (2.0 * h);
                    assert!((slope - at.slope[axis]).abs() < 1e-7);
                }
            }
        }
    }

    #[test]
    fn one_field_is_itself_and_two_in_one_direction_are_their_sum() {
        let one = field(0.7, 3, Stretching::Vertical);
        let place = V3::new(5.0, 6.0, -4.0);
        let alone = Sea::new(vec![one.clone()]).flow(30.0, &place, true);
        assert_eq!(alone, one.flow(30.0, &place));
        let twice = Sea::new(vec![one.clone(), one]).flow(30.0, &place, true);
        assert!((twice.velocity - alone.velocity * 2.0).norm() < 1e-13);
        assert!((twice.elevation - 2.0 * alone.elevation).abs() < 1e-13);
    }
}
