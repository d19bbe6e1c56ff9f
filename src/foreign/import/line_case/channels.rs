//! Channels of a case by the names that its system gives them.

use super::lines::{line_at, line_of, lines};
use super::places::{bottom_point, turning};
use super::places::{end_of, on_free_end};
use super::source::{BESIDE, LINE, LineSource};
use crate::case::{
    ChannelId, ChannelLocation, ChannelQuantity, EndKind, LineEnd, MotionName, OnSection, channels,
};
use crate::scene::{clump_bed_area, payload_bed_area};
use crate::system::motion::channels::WHOLE;

/// What is recorded of points that bear on the bed.
const OF_BED: [ChannelQuantity; 2] = [ChannelQuantity::BedForce, ChannelQuantity::LandingSpeed];

/// The channel of the system that is a channel of the case; nothing where the system has none.
pub(super) fn translated(source: &LineSource<'_>, id: &ChannelId) -> Option<ChannelId> {
    let spec = channels(&source.case)
        .into_iter()
        .find(|spec| spec.id == *id)?;
    match spec.site {
        ChannelLocation::Joint(joint) => Some(tension(source, joint)),
        ChannelLocation::End(end) => at_end(source, id, end),
        ChannelLocation::Section(section, end) => {
            let own = &source.case.line.get(section)?.name;
            let line = line_of(&source.case, own, end)?;
            let (name, own) = (line.name, if line.is_one() { "1" } else { own });
            Some(id.quantity.at(format!("{name}|{own}.{}", letter(end))))
        }
        ChannelLocation::Gauge => Some(id.clone()),
        // Of a body that turns the balance of a system counts loads by their work.
        ChannelLocation::Line if id.quantity == ChannelQuantity::Energy => {
            (turning(source).is_none()).then(|| id.quantity.at(WHOLE))
        }
        ChannelLocation::Line => {
            let of_line = [ChannelQuantity::OnBed, ChannelQuantity::Sliding];
            let is_one = of_line.contains(&id.quantity) && lines(&source.case).len() == 1;
            is_one.then(|| id.quantity.at(LINE))
        }
        ChannelLocation::Body(number) => of_clump(source, id, number),
        ChannelLocation::Traveller => of_traveller(id),
    }
}

const fn letter(end: LineEnd) -> &'static str {
    match end {
        LineEnd::A => "a",
        LineEnd::B => "b",
    }
}

/// What is recorded of the body that travels: of its point, and the length of the line behind it.
fn of_traveller(id: &ChannelId) -> Option<ChannelId> {
    match id.quantity {
        ChannelQuantity::Arc => Some(ChannelQuantity::Length.at(BESIDE[0])),
        quantity => ChannelQuantity::POSITION
            .contains(&quantity)
            .then(|| id.clone()),
    }
}

/// The tension where two sections meet, or at an end, by its number from end A.
fn tension(source: &LineSource<'_>, joint: usize) -> ChannelId {
    let case = &source.case;
    let (name, place) = match joint {
        0 => (line_at(case, LineEnd::A), "a".to_owned()),
        joint if joint == case.line.len() => (line_at(case, LineEnd::B), "b".to_owned()),
        joint => {
            let [before, behind] = [joint - 1, joint].map(|section| &case.line[section].name);
            let line = line_of(case, before, LineEnd::B);
            let name = line.map_or(LINE, |line| line.name);
            (name, format!("{before}|{behind}"))
        }
    };
    ChannelQuantity::Tension.at(format!("{name}|{place}"))
}

/// What is recorded of a clump by its number: of the body on the line, or of the point at the free end that it hangs on.
fn of_clump(source: &LineSource<'_>, id: &ChannelId, number: usize) -> Option<ChannelId> {
    let case = &source.case;
    let clump = case.clumps.get(number)?;
    let Some(letter) = end_of(case, clump) else {
        let section = case.line.iter().find(|one| clump.is_on(Some(&one.name)))?;
        let line = line_of(case, &section.name, LineEnd::A)?.name;
        return Some(id.quantity.at(format!("{line}|{}", clump.name)));
    };
    let (end, given) = match letter {
        "a" => (LineEnd::A, &case.ends.a),
        _ => (LineEnd::B, &case.ends.b),
    };
    let own = id.quantity.at(given.name.as_str());
    at_end(source, &own, end).filter(|_| given.kind == EndKind::Free)
}

/// Whether the point at an end bears on the bed by itself.
fn bears(source: &LineSource<'_>, end: LineEnd) -> bool {
    let case = &source.case;
    let payload = case.payload.as_ref();
    let payload = payload.filter(|_| case.ends.b.kind == EndKind::Payload && end == LineEnd::B);
    let area = match payload {
        Some(payload) => payload_bed_area(payload, &case.environment),
        None => on_free_end(source, letter(end))
            .map_or(0.0, |clump| clump_bed_area(clump, &case.environment)),
    };
    case.seabed.is_some() && area > 0.0
}

/// What is recorded at an end: of its point, while the line is at it, or of the line.
fn at_end(source: &LineSource<'_>, id: &ChannelId, end: LineEnd) -> Option<ChannelId> {
    let given = match end {
        LineEnd::A => &source.case.ends.a,
        LineEnd::B => &source.case.ends.b,
    };
    let quantity = id.quantity;
    if ChannelQuantity::BENDING.contains(&quantity) {
        let line = line_at(&source.case, end);
        return Some(quantity.at(format!("{line}|{}", letter(end))));
    }
    let turns = end == LineEnd::B && turning(source).is_some();
    let is_on_vessel = given.kind == EndKind::Moving && given.motion == MotionName::Vessel;
    let is_force =
        ChannelQuantity::FORCE.contains(&quantity) || quantity == ChannelQuantity::Uplift;
    let is_unread = turns && quantity == ChannelQuantity::Speed || is_on_vessel && is_force;
    if is_unread {
        return None;
    }
    if turns && OF_BED.contains(&quantity) {
        return bears(source, end).then(|| quantity.at(bottom_point(source)));
    }
    let payload = source.case.payload.as_ref();
    let is_cut_off = given.kind == EndKind::Payload
        && payload.is_some_and(|payload| payload.release_s.is_some());
    let moves = ChannelQuantity::POSITION.contains(&quantity) || quantity == ChannelQuantity::Speed;
    if moves && (is_cut_off || given.release_s.is_some()) {
        // What is let go is the end of the line, which its point stays behind.
        let line = line_at(&source.case, end);
        return Some(quantity.at(format!("{line}|{}", letter(end))));
    }
    let of_point =
        moves || is_force || (OF_BED.contains(&quantity) && bears(source, end) && !is_cut_off);
    of_point.then(|| id.clone())
}
