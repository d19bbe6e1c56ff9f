//! Lines and the joints between their sections.

use super::sheet::{RodRow, RodTypeRow, Sheet, SheetLine, SheetPoint};
use super::target::Target;
use crate::case::CreepModel;
use crate::numerics::V3;
use crate::scene::per_axis;
use crate::system::SolvedSystem;
use crate::system::model::{LineInputs, LineSection};
use crate::system::parts::sections;

/// Segments of a line that does not say how many.
const SEGMENTS: usize = 50;
/// Name of the type of joints.
const JOINT: &str = "joint";

/// Writes the joints between the sections of a line, number `index` of its network; what lines there are attached to.
pub fn joints(
    (solved, index, line): (&SolvedSystem, usize, &LineInputs),
    target: Target,
    sheet: &mut Sheet,
) -> Vec<String> {
    let sections = sections(line);
    let total: f64 = sections.iter().map(|section| section.length_m).sum();
    let mut arc = 0.0;
    let pairs = sections.windows(2).map(|pair| {
        arc += pair[0].length_m;
        let place = place(solved, index, arc / total);
        joint(solved, (&pair[0], &pair[1]), place, target, sheet)
    });
    pairs.collect()
}

/// Writes a line between its attachments: its ends and the joints between its sections.
pub fn write(
    (solved, line): (&SolvedSystem, &LineInputs),
    attachments: &[String],
    type_of: &dyn Fn(&str) -> String,
    target: Target,
    sheet: &mut Sheet,
) {
    let sections = sections(line);
    let counts = shared(line.asked_segments().unwrap_or(SEGMENTS), &sections);
    let first = sheet.lines.len();
    for ((section, segments), ends) in sections.iter().zip(counts).zip(attachments.windows(2)) {
        sheet.lines.push(SheetLine {
            of_type: type_of(&section.material),
            ends: [ends[0].clone(), ends[1].clone()],
            length: section.length_m,
            segments,
            without_bed: !line.bed_contact,
        });
    }
    let ends = [attachments.first(), attachments.last()];
    let last = sheet.lines.len();
    for (which, number, time, tension) in [
        (0, first + 1, line.release_a_s, line.release_a_n),
        (1, last, line.release_b_s, line.release_b_n),
    ] {
        if let Some(end) = ends[which].filter(|_| time.is_some() || tension.is_some()) {
            let limits = [time.unwrap_or(0.0), tension.unwrap_or(0.0)];
            sheet.failures.push((end.clone(), number, limits));
        }
    }
    for (number, section) in (first + 1..).zip(&sections) {
        let material = &solved.file.materials[&section.material];
        if target == Target::MoorDyn && material.creep_model == CreepModel::Syrope {
            let mean = material.initial_mean_tension_n.unwrap_or(0.0);
            sheet.pasts.push((number, [material.past_tension_n, mean]));
        }
    }
}

/// Segments of each section by those it asks for or its length, one at least: the same for the same sum, however often they are shared out.
fn shared(total: usize, sections: &[LineSection]) -> Vec<usize> {
    let asked: Option<Vec<usize>> = sections.iter().map(|section| section.segments).collect();
    if let Some(asked) = asked.filter(|asked| asked.iter().sum::<usize>() == total) {
        return asked;
    }
    let total = total.max(sections.len());
    let weight = |section: &LineSection| match section.segments {
        Some(segments) => segments as f64,
        None => section.length_m,
    };
    let whole: f64 = sections.iter().map(weight).sum();
    let spare = (total - sections.len()) as f64;
    let shares: Vec<f64> = sections
        .iter()
        .map(|section| spare * weight(section) / whole)
        .collect();
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a count of segments, bounded by the file"
    )]
    let mut counts: Vec<usize> = shares
        .iter()
        .map(|share| 1 + share.floor() as usize)
        .collect();
    let mut order: Vec<usize> = (0..shares.len()).collect();
    order.sort_by(|a, b| shares[*b].fract().total_cmp(&shares[*a].fract()));
    let left = total - counts.iter().sum::<usize>();
    for k in order.into_iter().cycle().take(left) {
        counts[k] += 1;
    }
    counts
}

/// Where a line is at rest at a share of its length, to the millimetre: it is where a search begins.
fn place(solved: &SolvedSystem, index: usize, share: f64) -> [f64; 3] {
    let line = &solved.network.lines[index];
    let ends = [line.from, line.to].map(|point| &solved.rest.placement.points[point]);
    let (place, _): (V3, f64) = solved.rest.balance.lines[index].at(share, ends);
    let mut rounded: [f64; 3] = place.map(|c| (c * 1e3).round() / 1e3).into();
    // A line sinks into a bed that yields.
    if let Some(bed) = &solved.file.seabed {
        rounded[2] = rounded[2].max(-bed.depth_m);
    }
    rounded
}

/// A joint between two sections: a point, or a rod without length where both bend.
fn joint(
    solved: &SolvedSystem,
    (before, behind): (&LineSection, &LineSection),
    place: [f64; 3],
    target: Target,
    sheet: &mut Sheet,
) -> String {
    let bends = |section: &LineSection| solved.file.materials[&section.material].ei_n_m2 > 0.0;
    let clump = before.clump();
    if target == Target::MoorDyn && clump.is_none() && bends(before) && bends(behind) {
        let number = rod_without_length("Free", [place; 2], sheet);
        return format!("R{number}A");
    }
    let density = solved.file.environment.water_density_kg_per_m3;
    let clump = clump.unwrap_or_default();
    let volume = match density > 0.0 {
        true => (clump.mass_kg - clump.wet_mass_kg) / density,
        false => 0.0,
    };
    sheet.points.push(SheetPoint {
        hold: "Free".to_owned(),
        place,
        mass: clump.mass_kg,
        volume,
        drag_area: per_axis(&clump.drag_area_m2).x,
        added_mass: match density * volume > 0.0 {
            true => per_axis(&clump.added_mass_kg).x / (density * volume),
            false => 0.0,
        },
        load: [0.0; 3],
    });
    sheet.points.len().to_string()
}

/// Writes a rod of no segments, which is a joint with a direction; its number.
pub fn rod_without_length(hold: &str, ends: [[f64; 3]; 2], sheet: &mut Sheet) -> usize {
    if !sheet.rod_types.iter().any(|of| of.name == JOINT) {
        sheet.rod_types.push(RodTypeRow {
            name: JOINT.to_owned(),
            diameter: 0.1,
            ..RodTypeRow::default()
        });
    }
    sheet.rods.push(RodRow {
        of_type: JOINT.to_owned(),
        hold: hold.to_owned(),
        ends,
        segments: 0,
    });
    sheet.rods.len()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn segments_are_shared_out_the_same_again() {
        let section = |length_m| LineSection {
            material: "chain".to_owned(),
            length_m,
            ..LineSection::default()
        };
        let lengths = [516.84, 400.0, 382.762, 33.498, 137.382, 41.197];
        let sections: Vec<LineSection> = lengths.into_iter().map(section).collect();
        for total in [1, 6, 7, 40, 74, 75, 1000] {
            let counts = shared(total, &sections);
            assert_eq!(counts.iter().sum::<usize>(), total.max(6));
            assert!(counts.iter().all(|count| *count >= 1));
            assert_eq!(counts, shared(counts.iter().sum(), &sections));
        }
    }
}
