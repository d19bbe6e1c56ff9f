//! What in a file contradicts itself.

use super::finding::{AuditFinding, Topic};
use crate::import::mooring::{Attachment, Hold, Mass, Mooring, MooringLineType, Stiffness};
use crate::import::to_case::names::Names;
use crate::import::to_case::sea::SeaOfCase;
use crate::number::{digits, percent, rounded, si};
use crate::numerics::V3;
use crate::system::SolvedSystem;
use crate::system::stability::Stability;

/// Strain of a line between its ends as the file has them, above which its length contradicts them.
const STRAIN: f64 = 0.05;
/// The same where it is above the strain of its breaking load.
const BROKEN: f64 = 1.0;
/// Density on the displaced volume that no line has \[kg/m³\].
const DENSITY: f64 = 15_000.0;
/// Distance below the bed that counts \[m\].
const BELOW: f64 = 0.1;
/// Distance of a free point from its equilibrium that counts: by the length of the longest line, and at least \[m\].
const ASIDE: f64 = 0.01;
const ASIDE_M: f64 = 1.0;

/// What the file says against itself, before it is computed.
pub fn find(mooring: &Mooring, sea: &SeaOfCase, findings: &mut Vec<AuditFinding>) {
    for remark in &mooring.remarks {
        findings.push(AuditFinding::new(
            Topic::Contradiction,
            "file",
            remark.trim_end_matches('.'),
            "correct the file so that it says what is meant",
        ));
    }
    for of in &mooring.line_types {
        findings.extend(line_type(of));
    }
    lengths(mooring, findings);
    let Some(depth) = sea.depth else { return };
    for point in &mooring.points {
        let z = point.place[2].value;
        let is_on_body = matches!(point.hold.value, Hold::Body(_));
        if z.is_finite() && z < -depth - BELOW && !is_on_body {
            let what = format!(
                "it is at z = {} m, {} below the bed",
                digits(z, 6),
                si(-depth - z, "m")
            );
            let finding = AuditFinding::new(
                Topic::Contradiction,
                format!("point {}", point.id),
                what,
                "correct its height or the depth of the water",
            );
            findings.push(finding.at(&point.place[2].span).figure(z, -depth, "m"));
        }
    }
}

fn line_type(of: &MooringLineType) -> Option<AuditFinding> {
    let Mass::InAir(mass) = of.mass.value else {
        return None;
    };
    let area = std::f64::consts::FRAC_PI_4 * of.diameter.value.powi(2);
    let density = mass / area;
    if density <= DENSITY {
        return None;
    }
    let what = format!(
        "mass over displaced volume is {} kg/m3, more than steel: the diameter seems to be that of the bar of a chain, not of its volume",
        digits(density, 4)
    );
    let remedy = format!(
        "give the diameter of equal volume, about {} for studless chain",
        si(1.8 * of.diameter.value, "m")
    );
    let finding = AuditFinding::new(
        Topic::Contradiction,
        format!("line type {}", of.name),
        what,
        remedy,
    );
    Some(
        finding
            .at(&of.diameter.span)
            .figure(density, 7850.0, "kg/m3"),
    )
}

/// Lines shorter than the distance of their ends.
fn lengths(mooring: &Mooring, findings: &mut Vec<AuditFinding>) {
    for line in &mooring.lines {
        let ends = [0, 1].map(|end| place(mooring, line.ends[end].value));
        let [Some(a), Some(b)] = ends else { continue };
        let apart = (b - a).norm();
        let strain = apart / line.length.value - 1.0;
        let of = &mooring.line_types[line.of_type.value];
        let Stiffness::Constant(ea) = of.stiffness.value else {
            continue;
        };
        let tension = ea * strain;
        let breaks = of.break_load.as_ref().map(|load| load.value);
        let above = breaks.is_some_and(|load| tension > BROKEN * load);
        if strain <= STRAIN && !above {
            continue;
        }
        let what = format!(
            "its ends are {} apart in the file, {} more than its length: {} strain, {} of tension",
            si(apart, "m"),
            si(apart - line.length.value, "m"),
            percent(strain),
            si(tension, "N")
        );
        let finding = AuditFinding::new(
            Topic::Contradiction,
            format!("line {}", line.id),
            what,
            "correct its length or the places of its ends",
        );
        findings.push(
            finding
                .at(&line.length.span)
                .figure(apart, line.length.value, "m"),
        );
    }
}

/// Where a part is by the file; nothing of parts on bodies, whose places are in the frame of the body.
fn place(mooring: &Mooring, at: Attachment) -> Option<V3> {
    match at {
        Attachment::Point(point) => {
            let point = &mooring.points[point];
            let place = V3::from(point.place.each_ref().map(|given| given.value));
            let is_here =
                !matches!(point.hold.value, Hold::Body(_)) && place.iter().all(|c| c.is_finite());
            is_here.then_some(place)
        }
        Attachment::Rod(rod, end) => {
            let rod = &mooring.rods[rod];
            let end = if rod.is_joint() { 0 } else { end };
            let is_here = !matches!(rod.hold.value.base(), Hold::Body(_));
            is_here.then(|| V3::from(rod.end(end)))
        }
        Attachment::Inside(_) => None,
    }
}

/// What the system at rest says against the file.
pub fn find_at_rest(mooring: &Mooring, solved: &SolvedSystem, findings: &mut Vec<AuditFinding>) {
    if let Stability::Unstable(what) = &solved.stability {
        findings.push(AuditFinding::new(
            Topic::Equilibrium,
            "system",
            format!("its equilibrium is unstable: {what}"),
            "begin nearer to the equilibrium that is meant",
        ));
    }
    let names = Names::of_mooring(mooring);
    let lengths = mooring.lines.iter().map(|line| line.length.value);
    let longest = lengths.fold(0.0, f64::max);
    let much = (ASIDE * longest).max(ASIDE_M);
    let placed = |name: &str| {
        let points = solved.network.points.iter();
        let number = points.enumerate().find(|(_, point)| point.name == name);
        number.map(|(number, _)| solved.rest.placement.points[number])
    };
    let free_points = mooring.points.iter().zip(&names.points);
    let free_points = free_points.filter(|(point, _)| point.hold.value == Hold::Free);
    let points = free_points.map(|(point, name)| {
        let given = V3::from(point.place.each_ref().map(|given| given.value));
        (
            format!("point {}", point.id),
            given,
            name,
            &point.place[0].span,
        )
    });
    let joints = mooring.rods.iter().zip(&names.rods);
    let joints = joints.filter(|(rod, _)| rod.is_joint() && rod.hold.value == Hold::Free);
    let joints = joints.map(|(rod, name)| {
        let given = V3::from(rod.end(0));
        (format!("rod {}", rod.id), given, name, &rod.ends[0][0].span)
    });
    for (subject, given, name, span) in points.chain(joints) {
        let Some(rests) = placed(name) else { continue };
        let apart = (rests - given).norm();
        if !given.iter().all(|c| c.is_finite()) || apart <= much {
            continue;
        }
        let [x, y, z] = [rests.x, rests.y, rests.z].map(|c| rounded(c + 0.0, 3));
        let what = format!("it is {} from where it rests", si(apart, "m"));
        let remedy = format!("begin at its equilibrium: {x} {y} {z}");
        let finding = AuditFinding::new(Topic::Start, subject, what, remedy);
        findings.push(finding.at(span).figure(apart, 0.0, "m"));
    }
    breaking(mooring, solved, findings);
}

/// Lines that bear more than they break at.
fn breaking(mooring: &Mooring, solved: &SolvedSystem, findings: &mut Vec<AuditFinding>) {
    let exact = super::exact::ExactLine::all(mooring, solved);
    for (line, exact) in mooring.lines.iter().zip(exact) {
        let load = mooring.line_types[line.of_type.value].break_load.as_ref();
        let Some((exact, load)) = exact.zip(load) else {
            continue;
        };
        let tension = exact.at(1.0).1.max(exact.at(0.0).1);
        if tension > load.value {
            let what = format!(
                "it bears {} at rest, more than its breaking load of {}",
                si(tension, "N"),
                si(load.value, "N")
            );
            let subject = format!("line {}", line.id);
            let remedy = "choose a stronger line, or correct the breaking load";
            let finding = AuditFinding::new(Topic::Contradiction, subject, what, remedy);
            findings.push(finding.at(&load.span).figure(tension, load.value, "N"));
        }
    }
}
