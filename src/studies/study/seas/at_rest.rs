//! Loads of a system at rest: results by name in the place of records.

use super::least_along;
use super::loads::{Extreme, PlaceLoads};
use super::records::RecordedSeries;
use super::scene::CheckedScene;
use crate::case::{CheckKind, GreatestMethod};
use crate::checks::resolved::Check;
use crate::checks::utilisation::Estimate;
use crate::study::vary::system::SystemResult;

/// A result of a system at rest that checks need.
#[derive(Debug, Clone, PartialEq)]
pub struct RestName {
    /// Its name.
    pub name: String,
    series: RecordedSeries,
    place: String,
}

/// The results that the checks of a system at rest need.
#[must_use]
pub(super) fn names(scene: &CheckedScene, checks: &[Check], bodies: &[String]) -> Vec<RestName> {
    let of = |series: RecordedSeries, name: &str, place: &str| RestName {
        name: format!("{name}[{place}]"),
        series,
        place: place.to_owned(),
    };
    let mut names: Vec<RestName> = Vec::new();
    let mut add = |name: RestName| {
        if !names.contains(&name) {
            names.push(name);
        }
    };
    for place in &scene.tensions {
        add(of(RecordedSeries::Tension, "tension_n", place));
    }
    for check in checks {
        let named = check.inputs.of.iter().flatten();
        match check.kind {
            CheckKind::Uplift => scene
                .anchors
                .iter()
                .filter(|anchor| check.holds_for(anchor))
                .for_each(|anchor| add(of(RecordedSeries::Uplift, "uplift_n", anchor))),
            CheckKind::Offset => named
                .filter(|name| bodies.contains(name))
                .for_each(|body| add(of(RecordedSeries::Offset, "offset_m", body))),
            CheckKind::BedClearance | CheckKind::SurfaceClearance => {
                named
                    .filter(|name| !bodies.contains(name) && !scene.is_line(name))
                    .for_each(|point| add(of(RecordedSeries::Height, "z_m", point)));
                let lines = scene.lines.iter();
                lines
                    .filter_map(|line| bed_clearance(check, line))
                    .for_each(&mut add);
            }
            _ => {}
        }
    }
    names
}

/// The least height of a line above the bed, where a check holds it.
fn bed_clearance(check: &Check, line: &str) -> Option<RestName> {
    let place = least_along::place(check, line)?;
    let stretch = check.inputs.stretch_m;
    let stretch = stretch.map(|[from, to]| format!("|{from}..{to}"));
    Some(RestName {
        name: format!("bed_clearance_m[{line}{}]", stretch.unwrap_or_default()),
        series: RecordedSeries::BedClearance,
        place,
    })
}

/// The loads of an equilibrium: each value is its own mean, greatest and least value, with its numerical error.
#[must_use]
pub(super) fn loads(
    names: &[RestName],
    results: &[Result<SystemResult, String>],
    load_case: usize,
) -> Vec<PlaceLoads> {
    let found = names.iter().zip(results);
    let found = found.filter_map(|(name, result)| Some((name, result.as_ref().ok()?)));
    found
        .map(|(name, result)| {
            let estimate = Estimate {
                value: result.value,
                numerical: result.error,
                sample: None,
            };
            let extreme = Extreme {
                estimate,
                method: GreatestMethod::Seen,
                seen: result.value,
                load_case,
                time: None,
            };
            PlaceLoads {
                series: name.series,
                place: name.place.clone(),
                mean: estimate,
                deviation: 0.0,
                greatest: extreme,
                least: extreme,
                duration: 0.0,
            }
        })
        .collect()
}
