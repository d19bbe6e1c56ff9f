//! The record of a system at rest: its channels at one instant.

use crate::case::{ChannelId, ChannelQuantity, Statistic};
use crate::run::observer::RunRecord;
use crate::run::requested_statistics::{RequestedStatistic, StatisticSource};
use crate::run::{Channel, History};
use crate::system::SolvedSystem;
use crate::system::network::Held;
use crate::system::quantities::value;

/// The channels of a system at rest, each with its last value as its one number.
pub(super) fn record(solved: &SolvedSystem) -> RunRecord {
    let channels = readings(solved);
    let last = channels.iter().enumerate().map(|(index, (_, value))| {
        let wanted = RequestedStatistic {
            of: StatisticSource::Channel(index),
            statistic: Statistic::Final,
            window: None,
            nth: None,
        };
        (wanted, Some(*value))
    });
    RunRecord {
        statistics: last.collect(),
        history: History {
            time: vec![0.0],
            channels: channels.into_iter().map(channel).collect(),
        },
        ..RunRecord::default()
    }
}

fn channel((id, value): (ChannelId, f64)) -> Channel {
    Channel {
        values: vec![value],
        peak: (value, 0.0),
        trough: (value, 0.0),
        ..Channel::new(id)
    }
}

/// Tensions at both ends of every line and where its sections meet, lengths on the bed, places of free points, poses of the bodies that turn, forces
/// of pins: each by the name that it has in time.
#[must_use]
pub fn readings(solved: &SolvedSystem) -> Vec<(ChannelId, f64)> {
    let mut ids = Vec::new();
    for line in &solved.network.lines {
        let ends = ["a", "b"].map(str::to_owned).into_iter();
        let places = ends.chain(line.meetings());
        ids.extend(
            places.map(|place| ChannelQuantity::Tension.at(format!("{}|{place}", line.name))),
        );
        if line.bed_contact && solved.network.bed.is_some() {
            ids.push(ChannelQuantity::OnBed.at(line.name.as_str()));
        }
    }
    for line in &solved.network.lines {
        let bodies = line.bodies.iter().filter_map(|body| body.name.as_ref());
        let places = bodies.map(|body| format!("{}|{body}", line.name));
        ids.extend(
            places.flat_map(|place| ChannelQuantity::POSITION.map(|axis| axis.at(place.as_str()))),
        );
    }
    for point in &solved.network.points {
        if matches!(point.held, Held::Free(_)) {
            ids.extend(ChannelQuantity::POSITION.map(|axis| axis.at(point.name.as_str())));
        }
    }
    for body in solved.network.bodies.iter().filter(|body| body.pinned) {
        ids.extend(ChannelQuantity::PIN_FORCE.map(|axis| axis.at(body.name.as_str())));
    }
    let named = ids.into_iter().filter_map(|id| {
        let value = value(solved, &id.to_string()).ok()?;
        Some((id, value))
    });
    named.chain(poses(solved)).collect()
}

/// Places of the free bodies \[m\], and the angles of those that turn \[deg\].
fn poses(solved: &SolvedSystem) -> impl Iterator<Item = (ChannelId, f64)> {
    let bodies = solved.network.bodies.iter();
    let turning = bodies.zip(&solved.rest.placement.bodies);
    let turning = turning.filter(|(body, _)| body.turns());
    turning.flat_map(|(body, pose)| {
        let places = ChannelQuantity::POSITION.into_iter().zip(&pose.origin);
        let places = places.map(|(axis, place)| (axis, *place));
        let angles = pose.angles().map(f64::to_degrees);
        let angles = ChannelQuantity::ANGLES.into_iter().zip(angles);
        let all = places.filter(|_| body.free).chain(angles);
        let all = all.map(|(quantity, value)| (quantity.at(body.name.as_str()), value));
        all.collect::<Vec<_>>()
    })
}
