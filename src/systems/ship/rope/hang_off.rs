//! Motion of the hang-off point that the rope follows.

use crate::numerics::V3;
use crate::ropeway::winch::ShipOffset;
use crate::ship::MotionAnalysis;
use crate::ship::coupled::CoupledAnalysis;
use crate::ship::model::{MotionSettings, PlatformRope};
use crate::ship::motion::wave_response::WaveResponse;

/// Motion of the hang-off point of a rope.
#[derive(Debug, Clone)]
pub struct HangOffMotion<'a> {
    /// Settings of the rope.
    pub rope: &'a PlatformRope,
    /// Displacements in ship axes, at equal steps from t = 0 \[m\].
    pub displacements: Vec<V3>,
    /// Step \[s\].
    pub step: f64,
    /// Settings of the motion and its response to waves, for records of other seeds; absent where there are none.
    pub seeds: Option<(&'a MotionSettings, Option<&'a WaveResponse>)>,
}

impl<'a> HangOffMotion<'a> {
    /// That of the motion analysis.
    #[must_use]
    pub fn of_motion(
        rope: &'a PlatformRope,
        settings: &'a MotionSettings,
        analysis: &'a MotionAnalysis,
    ) -> Self {
        Self {
            rope,
            displacements: analysis.point_displacements(&V3::from(settings.hang_point_m)),
            step: analysis.motion.step,
            seeds: Some((settings, analysis.response())),
        }
    }

    /// That of the coupled analysis, which has one record.
    #[must_use]
    pub fn of_coupled(
        rope: &'a PlatformRope,
        settings: Option<&MotionSettings>,
        coupled: &CoupledAnalysis,
    ) -> Self {
        let hang_off = settings.map_or([0.0; 3], |settings| settings.hang_point_m);
        Self {
            rope,
            displacements: coupled.point_displacements(&V3::from(hang_off)),
            step: coupled.step,
            seeds: None,
        }
    }

    /// Positions in the plane of a ropeway of this span \[m\].
    #[must_use]
    pub fn series(&self, span: f64) -> Vec<ShipOffset> {
        let at = |(i, displacement): (usize, &V3)| {
            let (x_m, z_m) = self.in_plane(displacement, span);
            ShipOffset {
                time_s: self.step * i as f64,
                x_m,
                z_m,
            }
        };
        self.displacements.iter().enumerate().map(at).collect()
    }

    /// Displacement away from the platform and upwards \[m\].
    pub(super) fn in_plane(&self, displacement: &V3, span: f64) -> (f64, f64) {
        in_plane(displacement, self.rope.bearing_deg.to_radians(), span)
    }
}

/// Displacement away from the platform and upwards, of a displacement in ship axes. The platform lies at a bearing \[rad\] from
/// the bow to port, a span \[m\] away; displacement across the rope lengthens it to second order.
fn in_plane(displacement: &V3, bearing: f64, span: f64) -> (f64, f64) {
    let (sin, cos) = bearing.sin_cos();
    let away = -(displacement.x * cos + displacement.y * sin);
    let across = displacement.y * cos - displacement.x * sin;
    ((span + away).hypot(across) - span, displacement.z)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn displacement_away_lengthens_the_span_and_across_by_its_square() {
        // The platform to port.
        let port = 0.5 * PI;
        let (x, z) = in_plane(&V3::new(0.0, -1.0, 0.3), port, 80.0);
        assert!((x - 1.0).abs() < 1e-12 && z == 0.3);
        let (x, _) = in_plane(&V3::new(4.0, 0.0, 0.0), port, 80.0);
        assert!((x - (80.0_f64.hypot(4.0) - 80.0)).abs() < 1e-12);
        let (x, _) = in_plane(&V3::new(2.0, 0.0, 0.0), 0.0, 80.0);
        assert!((x + 2.0).abs() < 1e-12);
    }
}
