//! The channels that a run of the case would record, by name.

use crate::case::channels::{RecordedEnd, RecordedOutput, RecordedSection, RecordingConditions};
use crate::case::line_quantity::{EnergyQuantity, STEADY};
use crate::case::model::{CaseKeys, EndKeys};
use crate::case::schema::Key;
use crate::case::{FrictionLaw, Method, Subject};

/// Names of the channels a run would record, and of the numbers that it gives beside them; nothing while line or ends are
/// themselves faulty.
pub(super) fn names(case: &CaseKeys<'_>) -> Option<Vec<String>> {
    let mut names = channel_names(case)?;
    names.extend(modal_names(case));
    let response = case
        .output
        .as_ref()
        .is_some_and(|output| output.response_from_s.is_given());
    names.extend(response.then(|| STEADY.to_owned()));
    // Of dynamic runs; a method of another kind may be set for a trial of the case.
    names.extend(EnergyQuantity::ALL.map(|quantity| quantity.name().to_owned()));
    Some(names)
}

fn end<'k>(keys: &'k EndKeys<'_>) -> Option<RecordedEnd<'k>> {
    Some(RecordedEnd {
        name: keys.name.get()?,
        kind: keys.kind.value()?,
        released: keys.release_s.is_given(),
        clamped: keys.clamp_elevation_deg.is_given(),
    })
}

fn channel_names(case: &CaseKeys<'_>) -> Option<Vec<String>> {
    let ends = case.ends.as_ref()?;
    case.place.node.get("line")?;
    let sections = case.line.iter().map(|(_, section)| {
        let material = section.material.get()?;
        let material = case.materials.iter().find(|(name, _)| name == material);
        // A variant with static stiffness lacks them, but statements about the other variants are no fault.
        let dynamic = material.is_some_and(|(_, keys)| keys.dynamic_stiffness.is_given());
        let bore = material.is_some_and(|(_, keys)| keys.bore.is_some());
        let stiffness = material.and_then(|(_, keys)| keys.ei_n_m2.value());
        Some(RecordedSection {
            name: section.name.get()?,
            dynamic_stiffness: dynamic,
            bore,
            bends: stiffness.is_some_and(|stiffness| stiffness > 0.0),
        })
    });
    let sections: Option<Vec<RecordedSection<'_>>> = sections.collect();
    let bodies = case
        .clumps
        .iter()
        .map(|(_, clump)| Some(clump.name.get()?.as_str()));
    let bodies: Option<Vec<&str>> = bodies.collect();
    let traveller = match &case.traveller {
        Some(traveller) => Some(traveller.name.get()?.as_str()),
        None => None,
    };
    let (payload, output) = (case.payload.as_ref(), case.output.as_ref());
    let line = RecordingConditions {
        ends: [end(ends.a.as_ref()?)?, end(ends.b.as_ref()?)?],
        sections: sections?,
        rotates: payload.is_some_and(|payload| payload.rotation.is_some()),
        bodies: bodies?,
        traveller,
        bed: case.seabed.is_some(),
        grips: grips(case)?,
        waves: case.waves.is_some(),
        output: RecordedOutput {
            energy: output.is_some_and(|output| output.energy.is(&true)),
            uplift: output.is_some_and(|output| output.uplift.is(&true)),
            forces: output.is_none_or(|output| !output.forces.is(&false)),
        },
    };
    let channels = line.channels().into_iter();
    Some(channels.map(|channel| channel.id.to_string()).collect())
}

/// Whether friction of the bed holds the line at rest, in a run in time.
fn grips(case: &CaseKeys<'_>) -> Option<bool> {
    let Some(bed) = &case.seabed else {
        return Some(false);
    };
    let method = match &case.solver {
        Some(solver) => solver.method.value()?,
        None => Method::Alpha,
    };
    let [along, across] = [&bed.friction, &bed.friction_lateral];
    let acts = |key: &Key<'_, f64>| key.given().is_some_and(|value| *value > 0.0);
    let is_rough = acts(along) || along.is_given() && acts(across);
    let by_grip = bed.friction_law.value()? == FrictionLaw::Grip;
    Some(method != Method::Static && by_grip && is_rough)
}

/// Names of what a run gives of natural modes.
fn modal_names(case: &CaseKeys<'_>) -> Vec<String> {
    let subjects = case.modes.as_ref().and_then(|modes| {
        let near = modes.near_hz.get().is_some();
        Some(Subject::of_modes(modes.count.value()?, near))
    });
    let subjects = subjects.unwrap_or_default();
    subjects.iter().map(ToString::to_string).collect()
}
