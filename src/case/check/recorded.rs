//! The channels that a run of the case would record, by name.

use crate::case::along::STEADY;
use crate::case::channels::{
    LineEnd, body_channels, elevation_channel, energy_channel, force_channels, joint_channels,
    motion_channels, rope_channels, tilt_channel, traveller_channels,
};
use crate::case::model::{CaseKeys, EndKeys, EndKind, Modes};

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
    Some(names)
}

/// Name and kind of an end, and whether it is let go.
fn end<'k>(keys: &'k EndKeys<'_>) -> Option<(&'k str, EndKind, bool)> {
    Some((
        keys.name.get()?,
        keys.kind.value()?,
        keys.release_s.is_given(),
    ))
}

fn channel_names(case: &CaseKeys<'_>) -> Option<Vec<String>> {
    let ends = case.ends.as_ref()?;
    let (a, b) = (end(ends.a.as_ref()?)?, end(ends.b.as_ref()?)?);
    let sections = case
        .line
        .iter()
        .map(|(_, section)| section.name.get().map(String::as_str));
    let sections: Option<Vec<&str>> = sections.collect();
    let sections = sections.filter(|_| case.place.node.get("line").is_some())?;
    let stops = [&[a.0], &sections[..], &[b.0]].concat();
    let mut channels = joint_channels(&stops);
    channels.extend(motion_channels(LineEnd::A, a.0, a.1, a.2));
    channels.extend(motion_channels(LineEnd::B, b.0, b.1, b.2));
    let turns = case
        .payload
        .as_ref()
        .is_some_and(|payload| payload.rotation.is_some());
    channels.extend(tilt_channel(b.0, b.1, turns));
    for (index, (_, clump)) in case.clumps.iter().enumerate() {
        channels.extend(body_channels(index, clump.name.get()?));
    }
    if let Some(traveller) = &case.traveller {
        channels.extend(traveller_channels(traveller.name.get()?));
    }
    channels.extend(force_channels(LineEnd::A, a.0, a.1));
    channels.extend(force_channels(LineEnd::B, b.0, b.1));
    channels.extend(case.waves.as_ref().map(|_| elevation_channel()));
    let energy = case
        .output
        .as_ref()
        .is_some_and(|output| output.energy.is(&true));
    channels.extend(energy.then(energy_channel));
    for (index, (_, section)) in case.line.iter().enumerate() {
        let material = section.material.get()?;
        let material = case.materials.iter().find(|(name, _)| name == material);
        // A variant with static stiffness lacks them, but what is said of the other variants is no fault.
        if material.is_some_and(|(_, keys)| keys.dynamic_stiffness.is_given()) {
            channels.extend(rope_channels(index, section.name.get()?));
        }
    }
    Some(
        channels
            .into_iter()
            .map(|channel| channel.id.to_string())
            .collect(),
    )
}

/// Names of what a run gives of natural modes.
fn modal_names(case: &CaseKeys<'_>) -> Vec<String> {
    let wanted = case.modes.as_ref().and_then(|modes| {
        Some(Modes {
            count: modes.count.value()?,
            near_hz: modes.near_hz.value(),
        })
    });
    wanted.map_or_else(Vec::new, |wanted| wanted.names())
}
