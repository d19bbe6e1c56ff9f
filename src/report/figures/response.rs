//! How the line moves, over time and place: a map of its displacements, and their root mean squares along the line.

use std::f64::consts::TAU;

use super::PlottedRun;
use super::profiles::{over_arc, points};
use seacable_display::chart::{Axis, AxisRange, Chart, GridMap, extent};
use seacable_engine::modes::LinePlane;
use seacable_numerics::V3;
use seacable_runs::run::{LineShape, Profile};

/// What a map of the response shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ResponseMapKind {
    /// Displacements across the line in its plane, from the time on from which the response is recorded.
    Steady,
    /// The same, of each place by its own root mean square: how waves run shows also where they are small.
    Normalised,
    /// The same as the first from time zero: how the motion reaches the line.
    Start,
    /// Displacements out of the plane of the line.
    OutOfPlane,
}

impl ResponseMapKind {
    /// All of them.
    pub const ALL: [Self; 4] = [
        Self::Steady,
        Self::Normalised,
        Self::Start,
        Self::OutOfPlane,
    ];

    /// Its name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Steady => "in the plane",
            Self::Normalised => "in the plane, each place by its own rms",
            Self::Start => "in the plane, from the start",
            Self::OutOfPlane => "out of the plane",
        }
    }
}

/// Displacements of the nodes from their mean places over time and arc length, from the stored shapes of the last run in
/// full ink that has at least three: in diameters where the run knows them, else in metres. `from` is the time \[s\] from
/// which on the motion counts as steady; the mean is taken from there. Stripes that lean are waves that travel, upright ones
/// standing.
#[must_use]
pub fn response_map(sources: &[PlottedRun], from: Option<f64>, of: ResponseMapKind) -> Chart {
    let mut chart = Chart {
        title: format!("Displacement over time and place, {}", of.name()),
        x: Axis::new("time", "s"),
        y: Axis::new("arc length from end A", "m"),
        ..Chart::default()
    };
    // Of one line: displacements of several have no common place.
    let able = |s: &&PlottedRun| {
        !s.dimmed && s.shapes.len() > 2 && s.shapes.iter().all(|shape| shape.line == 0)
    };
    let Some(source) = sources.iter().rfind(able) else {
        return chart;
    };
    if sources.len() > 1 && !source.label.is_empty() {
        chart.title = format!("{}: {}", source.label, chart.title);
    }
    let from = from.unwrap_or(0.0);
    let field = field(source, from, of).filter(|map| map.greatest() > 0.0);
    chart.x.range = field.as_ref().and_then(|map| {
        let shown = map.x.iter().copied();
        extent(shown).filter(|range: &AxisRange| range.1 > range.0)
    });
    chart.y.range = field.as_ref().and_then(|m| extent(m.y.iter().copied()));
    chart.map = field.filter(|_| chart.x.range.is_some());
    chart
}

/// The displacements on the grid of shapes and nodes.
fn field(source: &PlottedRun, from: f64, of: ResponseMapKind) -> Option<GridMap> {
    let arc = arc(source)?;
    let of_line = |shape: &&LineShape| shape.nodes.len() == arc.len();
    let all: Vec<&LineShape> = source.shapes.iter().filter(of_line).collect();
    let begin = all.partition_point(|shape| shape.time < from * (1.0 - 1e-9));
    // A run that has not come so far is shown as far as it is.
    let steady = all.get(begin..).filter(|steady| steady.len() > 2);
    let steady = steady.unwrap_or(&all);
    let mean = mean(steady, arc.len());
    let plane = LinePlane::nearest_to(&mean);
    let directions = match of {
        ResponseMapKind::OutOfPlane => vec![plane.normal; arc.len()],
        _ => plane.across(&mean),
    };
    let diameters = source.profile().and_then(Profile::diameters);
    let shown: &[&LineShape] = if of == ResponseMapKind::Start {
        &all
    } else {
        steady
    };
    let mut values: Vec<f64> = shown
        .iter()
        .flat_map(|shape| shape.nodes.iter().enumerate())
        .map(|(i, place)| {
            let across = (V3::from(*place) - mean[i]).dot(&directions[i]);
            diameters.as_ref().map_or(across, |d| across / d[i])
        })
        .collect();
    let mut axis = Axis::new("displacement", if diameters.is_some() { "D" } else { "m" });
    if of == ResponseMapKind::Normalised {
        even(&mut values, arc.len());
        // A harmonic motion has 1.41.
        axis = Axis::new("by its rms", "").over((-1.5, 1.5));
    }
    Some(GridMap {
        x: shown.iter().map(|shape| shape.time).collect(),
        y: arc,
        values,
        of: axis,
    })
}

/// Arc lengths of the nodes; of an incomplete run those of its first shape, which differ by the stretch of the line alone.
fn arc(source: &PlottedRun) -> Option<Vec<f64>> {
    if let Some(profile) = source.profile() {
        return (profile.arc.len() > 1).then(|| profile.arc.clone());
    }
    let nodes = &source.shapes.first()?.nodes;
    let chords = nodes.windows(2);
    let lengths = chords.map(|pair| (V3::from(pair[1]) - V3::from(pair[0])).norm());
    let mut arc = vec![0.0];
    for length in lengths {
        arc.push(arc[arc.len() - 1] + length);
    }
    (arc.len() > 1).then_some(arc)
}

/// Mean places of the nodes.
fn mean(shapes: &[&LineShape], nodes: usize) -> Vec<V3> {
    let count = shapes.len().max(1) as f64;
    let at = |i: usize| {
        let places = shapes.iter().map(|shape| V3::from(shape.nodes[i]));
        places.sum::<V3>() / count
    };
    (0..nodes).map(at).collect()
}

/// Divides the values of every place by their root mean square; a place at rest stays at zero.
fn even(values: &mut [f64], nodes: usize) {
    let times = values.len() / nodes.max(1);
    let size = |i: usize, values: &[f64]| {
        let squares = values.iter().skip(i).step_by(nodes).map(|v| v * v);
        (squares.sum::<f64>() / times.max(1) as f64).sqrt()
    };
    let sizes: Vec<f64> = (0..nodes).map(|i| size(i, values)).collect();
    let rest = 1e-6 * sizes.iter().copied().fold(0.0, f64::max);
    for (i, value) in values.iter_mut().enumerate() {
        let size = sizes[i % nodes];
        *value = if size > rest { *value / size } else { 0.0 };
    }
}

/// Root mean square displacement along the line, in diameters where the run knows them.
#[must_use]
pub fn rms_profile(sources: &[PlottedRun]) -> Chart {
    let title = "Root mean square displacement along the line";
    over_arc(
        sources,
        title,
        Axis::new("rms displacement", "D"),
        1,
        |_, p| vec![("rms", points(&p.arc, &p.rms_diameters))],
    )
}

/// Amplitudes at the driving period along the line \[m\]: of the motion, of what runs towards either end, and how a wave
/// without drag would change after WKB theory, as great on the mean as what runs towards end A.
#[must_use]
pub fn wave_amplitudes(sources: &[PlottedRun]) -> Chart {
    along_waves(
        sources,
        "Waves at the driving period: amplitudes",
        Axis::new("amplitude", "m"),
        |p| {
            let size = p.wave_cos.iter().zip(&p.wave_sin);
            let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len().max(1) as f64;
            let scale = mean(&p.towards_a) / mean(&p.wkb_amplitude);
            let wkb = p.wkb_amplitude.iter().map(|a| a * scale);
            vec![
                ("motion", size.map(|(c, s)| c.hypot(*s)).collect()),
                ("towards A", p.towards_a.clone()),
                ("towards B", p.towards_b.clone()),
                ("WKB, no drag", wkb.collect()),
            ]
        },
    )
}

/// Lengths of the waves at the driving period along the line \[m\], as computed and by WKB theory.
#[must_use]
pub fn wavelengths(sources: &[PlottedRun]) -> Chart {
    let lengths = |numbers: &[f64]| numbers.iter().map(|k| TAU / k).collect();
    along_waves(
        sources,
        "Waves at the driving period: lengths",
        Axis::new("wavelength", "m"),
        |p| {
            vec![
                ("computed", lengths(&p.wave_number)),
                ("WKB", lengths(&p.wkb_number)),
            ]
        },
    )
}

fn along_waves(
    sources: &[PlottedRun],
    title: &str,
    y: Axis,
    curves: impl Fn(&Profile) -> Vec<(&'static str, Vec<f64>)>,
) -> Chart {
    over_arc(sources, title, y, 4, |_, profile| {
        let profile = Some(profile).filter(|p| !p.towards_a.is_empty());
        let all = profile.into_iter().flat_map(|p| {
            let curves = curves(p).into_iter();
            curves.map(|(name, values)| (name, points(&p.arc, &values)))
        });
        all.collect()
    })
}
