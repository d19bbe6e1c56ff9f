//! Waves of a case or a system.

use super::error::SceneError;
use super::irregular_record::IrregularRecord;
use super::{AttachedBody, Segment, Water};
use crate::case::{
    self, Case, DecayName, Method, SpectrumName, StretchingName, WaterSurface, WaveKind,
    WaveLoadName,
};
use crate::numerics::V3;
use crate::numerics::random::Random;
use crate::physics::sea::{
    Component, DepthDecay, Sea, Spectrum, Stretching, WaveField, WaveLoad, WaveSettings, spread,
    synthesise, wave_number,
};

/// Fraction of the breaking steepness above which linear theory is remarked on.
const STEEP: f64 = 0.6;

/// The water of a case with waves or with a line that crosses the surface, and remarks on it.
pub(super) fn water(
    case: &Case,
    segments: &[Segment],
    bodies: &[AttachedBody],
) -> Result<(Option<Water>, Vec<String>), SceneError> {
    let crossed = case.environment.water_surface == WaterSurface::Crossed;
    let mut remarks = Vec::new();
    let waves = match &case.waves {
        Some(said) => {
            let bed = case.seabed.as_ref().map(|bed| bed.depth_m);
            let gravity = case.environment.gravity_m_per_s2;
            if case.solver.method == Method::Static {
                remarks.push("statics take no account of the waves".to_owned());
            }
            remarks.extend(steep(said, depth(said, bed), gravity));
            Some(sea(std::slice::from_ref(said), bed, gravity)?)
        }
        None => None,
    };
    if waves.is_none() && !crossed {
        return Ok((None, remarks));
    }
    let of_water = (
        case.environment.water_density_kg_per_m3,
        case.environment.gravity_m_per_s2,
    );
    if of_water.0 <= 0.0 || of_water.1 <= 0.0 {
        return Err(SceneError::Impossible {
            key: "environment".into(),
            why: "waves and a surface need water with density, and gravity",
        });
    }
    let mut water = Water::around(segments, bodies, of_water, waves, crossed);
    water.gauge = gauge(case);
    Ok((Some(water), remarks))
}

/// Position of the wave gauge.
fn gauge(case: &Case) -> V3 {
    let waves = case.waves.as_ref();
    let given = waves.and_then(|waves| waves.gauge_m);
    let over = waves.and_then(|waves| waves.gauge_over.as_ref());
    let ends = [&case.ends.b, &case.ends.a].into_iter();
    let mut ends = ends.filter(|end| over.is_none_or(|over| *over == end.name));
    let mut end = || ends.find_map(|end| end.position_m);
    let [x, y] = given
        .or_else(|| end().map(|[x, y, _]| [x, y]))
        .unwrap_or_default();
    V3::new(x, y, 0.0)
}

/// The irregular records of a case: its waves, and the axes of ends that move irregularly.
#[must_use]
pub fn records(case: &Case) -> Vec<IrregularRecord> {
    let mut list = Vec::new();
    if let Some(waves) = &case.waves
        && waves.kind == WaveKind::Irregular
        && let (Some(spectrum), Ok(components)) = (spectrum(waves), components(waves, 0))
    {
        list.push(IrregularRecord {
            name: "waves".to_owned(),
            of_waves: true,
            seed: waves.seed,
            spectrum,
            components,
        });
    }
    for end in [&case.ends.a, &case.ends.b] {
        list.extend(super::ends::records(end));
    }
    list
}

/// Depth that waves feel over a bed of a depth \[m\].
fn depth(waves: &case::Waves, bed: Option<f64>) -> f64 {
    waves.depth_m.or(bed).unwrap_or(f64::INFINITY)
}

/// The spectrum of irregular waves; none for others.
pub(crate) fn spectrum(waves: &case::Waves) -> Option<Spectrum> {
    let (height, period) = (waves.significant_height_m?, waves.peak_period_s?);
    Some(match waves.spectrum {
        SpectrumName::Jonswap => Spectrum::jonswap(height, period, waves.gamma),
        SpectrumName::PiersonMoskowitz => Spectrum::pierson_moskowitz(height, period),
    })
}

/// Random streams of one seed that each wave system of a sea has for its own.
const STREAMS: u64 = 10;
/// The stream of directions among them; the first is that of frequencies and phases.
const DIRECTIONS: u64 = 5;

/// The components at the origin, from a random stream of the seed.
fn components(waves: &case::Waves, stream: u64) -> Result<Vec<Component>, SceneError> {
    let missing = |key: &str| SceneError::Missing {
        key: format!("waves.{key}"),
        why: "waves have a height and a period",
    };
    match waves.kind {
        WaveKind::Regular => {
            let height = waves.height_m.ok_or_else(|| missing("height_m"))?;
            let period = waves.period_s.ok_or_else(|| missing("period_s"))?;
            Ok(vec![Component {
                omega: crate::physics::motion::omega(period),
                amplitude: 0.5 * height,
                phase: waves.phase_deg.to_radians(),
            }])
        }
        WaveKind::Irregular => {
            let spectrum = spectrum(waves).ok_or_else(|| missing("significant_height_m"))?;
            Ok(synthesise(&spectrum, waves.components, waves.seed, stream))
        }
        WaveKind::Components => {
            let periods = waves
                .periods_s
                .as_ref()
                .ok_or_else(|| missing("periods_s"))?;
            let heights = waves
                .heights_m
                .as_ref()
                .ok_or_else(|| missing("heights_m"))?;
            Ok(given_components(
                periods,
                heights,
                waves.phases_deg.as_deref(),
            ))
        }
    }
}

/// Components of these periods \[s\], heights \[m\] and leads \[deg\], frequencies rising.
fn given_components(periods: &[f64], heights: &[f64], phases: Option<&[f64]>) -> Vec<Component> {
    let each = periods.iter().zip(heights).enumerate();
    let mut all: Vec<Component> = each
        .map(|(k, (period, height))| Component {
            omega: crate::physics::motion::omega(*period),
            amplitude: 0.5 * height,
            phase: phases
                .and_then(|phases| phases.get(k))
                .map_or(0.0, |phase| phase.to_radians()),
        })
        .collect();
    all.sort_by(|a, b| a.omega.total_cmp(&b.omega));
    all
}

/// The sea of these waves over a bed of a depth \[m\]: a field for each of them, or for each direction of those that are spread.
///
/// # Errors
/// Waves without height or period.
pub fn sea(given: &[case::Waves], bed: Option<f64>, gravity: f64) -> Result<Sea, SceneError> {
    let mut fields = Vec::new();
    for (number, waves) in (0_u64..).zip(given) {
        let setting = setting(waves, depth(waves, bed), gravity);
        let components = components(waves, number * STREAMS)?;
        let Some(exponent) = waves.spreading_exponent else {
            fields.push(WaveField::new(components, &setting));
            continue;
        };
        let mut random = Random::new(waves.seed, number * STREAMS + DIRECTIONS);
        for (angle, part) in spread(components, exponent, &mut random) {
            let turned = WaveSettings {
                direction: setting.direction + angle,
                ..setting
            };
            fields.push(WaveField::new(part, &turned));
        }
    }
    Ok(Sea::new(fields))
}

fn setting(said: &case::Waves, depth: f64, gravity: f64) -> WaveSettings {
    WaveSettings {
        direction: said.direction_deg.to_radians(),
        depth,
        gravity,
        stretching: match said.stretching {
            StretchingName::None => Stretching::None,
            StretchingName::Vertical => Stretching::Vertical,
            StretchingName::Wheeler => Stretching::Wheeler,
            StretchingName::Linear => Stretching::Linear,
        },
        decay: match said.decay {
            DecayName::Airy => DepthDecay::Airy,
            DecayName::AiryCut => DepthDecay::AiryAbove(said.decay_depth_m),
            DecayName::Logarithmic => DepthDecay::Logarithmic(said.decay_depth_m),
        },
        ramp: said.ramp_s,
        load: match said.load {
            WaveLoadName::Morison => WaveLoad::Morison,
            WaveLoadName::Inertia => WaveLoad::Inertia,
        },
    }
}

/// A remark on waves of a system that are close to breaking.
pub fn steep_waves(waves: &case::Waves, bed: Option<f64>, gravity: f64) -> Option<String> {
    steep(waves, depth(waves, bed), gravity)
}

/// A remark on waves that are close to breaking in water of a depth \[m\].
fn steep(said: &case::Waves, depth: f64, gravity: f64) -> Option<String> {
    let (height, period) = match said.kind {
        WaveKind::Regular => (said.height_m, said.period_s),
        WaveKind::Irregular => (said.significant_height_m, said.peak_period_s),
        WaveKind::Components => {
            let (periods, heights) = (said.periods_s.as_ref()?, said.heights_m.as_ref()?);
            let energy: f64 = heights.iter().map(|height| height * height).sum();
            let pairs = periods.iter().zip(heights);
            let highest = pairs.max_by(|a, b| a.1.total_cmp(b.1));
            // Four times the root of the sum of half the squared amplitudes.
            (
                Some((2.0 * energy).sqrt()),
                highest.map(|(period, _)| *period),
            )
        }
    };
    let (height, period) = height.zip(period)?;
    let omega = crate::physics::motion::omega(period);
    let k = wave_number(omega, gravity, depth);
    // Miche's limit: 0.142 L tanh(k h).
    let limit = 0.142 * std::f64::consts::TAU / k * (k * depth).tanh();
    (height > STEEP * limit).then(|| {
        format!(
            "waves {height} m high at a period of {period} s are at {:.0} % of the height at which they break; linear \
             theory gives them too little crest and too much trough",
            100.0 * height / limit
        )
    })
}
