//! Settings and columns that `MoorDyn` takes otherwise than they seem to be meant.

use super::finding::{AuditFinding, Topic};
use super::wave_pressure;
use crate::import::fault::line_and_column;
use crate::import::mooring::{
    Damping, Hold, Mass, Mooring, MooringLineType, Program, ProgramSetting, Stiffness,
};
use crate::import::to_case::is_in_air;
use crate::import::to_case::sea::SeaOfCase;
use crate::number::{digits, si};

/// Names of options that `MoorDyn` in C++ reads (`MoorDyn2.cpp`, `readOptionsLine`, version 2.7).
const KNOWN: [&str; 39] = [
    "dtm",
    "dt",
    "cfl",
    "writelog",
    "tscheme",
    "g",
    "gravity",
    "rho",
    "wtrdnsty",
    "wtrdpth",
    "kbot",
    "kb",
    "cbot",
    "cb",
    "dtic",
    "icdt",
    "tmaxic",
    "ictmax",
    "cdscaleic",
    "icdfac",
    "threshic",
    "icthresh",
    "gendynamicic",
    "icgendynamic",
    "fileic",
    "icfile",
    "wavekin",
    "dtwave",
    "currents",
    "unifycurrentgrid",
    "writeunits",
    "frictioncoefficient",
    "fricdamp",
    "statdynfricscale",
    "dtout",
    "seafloorfile",
    "disableoutput",
    "disableouttime",
    "echo",
];
/// Options that change no result.
const WITHOUT_EFFECT: [&str; 8] = [
    "writelog",
    "writeunits",
    "disableoutput",
    "disableouttime",
    "outswitch",
    "dtout",
    "echo",
    "endtime",
];
/// Difference of depths that counts \[m\].
const DEPTH: f64 = 0.05;
/// Speed at which friction should have come to its full value \[m/s\].
const SLIDING: f64 = 0.1;
/// Friction by speed in `MoorDyn` where the file gives none \[N s/m\].
const FRICTION_DAMPING: f64 = 200.0;
/// Internal damping \[N s\] that may have been meant as a share of the critical one, and the share below which it damps nothing.
const RATIO_LIKE: f64 = 10.0;
const UNDAMPED: f64 = 1e-4;
/// Share of the critical damping of a segment above which it is taken for a mistake.
const OVERDAMPED: f64 = 5.0;

/// Finds them in a file with this text.
pub fn find(mooring: &Mooring, sea: &SeaOfCase, text: &str, findings: &mut Vec<AuditFinding>) {
    for setting in &mooring.settings {
        findings.extend(option(setting, text));
    }
    findings.extend(depth(mooring, sea));
    findings.extend(friction(mooring, sea));
    damping(mooring, findings);
    bodies(mooring, text, findings);
    failures(mooring, findings);
    findings.extend(current(mooring));
    findings.extend(wave_pressure::find(mooring));
}

/// A profile of the current that is not listed from below. `MoorDyn` looks for the rows about a height from the first one on and takes the first where
/// the height is at or below it (`interp_factor` in its `source/Util/Interp.hpp`, version 2.7).
fn current(mooring: &Mooring) -> Option<AuditFinding> {
    let (given, first) = (
        mooring.sea.current.as_ref()?,
        mooring.sea.current_first.as_ref()?,
    );
    let speed = |row: &[f64; 3]| f64::hypot(row[1], row[2]);
    let beneath = given.value.rows.iter().filter(|row| row[0] < first[0]);
    let apart = |row: &&[f64; 3]| f64::hypot(row[1] - first[1], row[2] - first[2]);
    let other = beneath.max_by(|one, other| apart(one).total_cmp(&apart(other)))?;
    if apart(&other) <= 0.0 {
        return None;
    }
    let what = format!(
        "current_profile.txt does not list its rows from below: MoorDyn 2.7 has the current of its first row, {}, everywhere at z = {} m and below, also at z = {} m, where the file has {}",
        si(speed(first), "m/s"),
        digits(first[0], 6),
        digits(other[0], 6),
        si(speed(other), "m/s")
    );
    let finding = AuditFinding::new(
        Topic::Setting,
        "Currents",
        what,
        "list the rows from the lowest to the highest",
    );
    Some(
        finding
            .at(&given.span)
            .figure(speed(first), speed(other), "m/s"),
    )
}

/// An option that `MoorDyn` does not know, or whose value stands behind its name.
fn option(setting: &ProgramSetting, text: &str) -> Option<AuditFinding> {
    let name = setting.written.to_lowercase();
    if WITHOUT_EFFECT.contains(&setting.name.as_str()) {
        return None;
    }
    let subject = setting.written.clone();
    let start = text[..setting.span.start.min(text.len())]
        .rfind('\n')
        .map_or(0, |end| end + 1);
    let before = text.get(start..setting.span.start).unwrap_or("");
    if before
        .split_whitespace()
        .any(|word| word == setting.written)
    {
        let what = format!(
            "its value {} stands behind its name; MoorDyn reads value and name in that order, does not know an option `{}` and leaves the default",
            setting.value, setting.value
        );
        let remedy = format!("write `{} {}`", setting.value, setting.written);
        return Some(AuditFinding::new(Topic::Setting, subject, what, remedy).at(&setting.span));
    }
    if KNOWN.contains(&name.as_str()) {
        return None;
    }
    if setting.name == "wtrdpth" {
        // Judged by what the depth then is.
        return None;
    }
    let remedy = match KNOWN.iter().find(|name| **name == setting.name) {
        Some(known) => format!("write `{} {known}`", setting.value),
        None => "leave it out, or check that the version that is run knows it".to_owned(),
    };
    let what = "MoorDyn in C++ does not know this option and leaves its default";
    Some(AuditFinding::new(Topic::Setting, subject, what, remedy).at(&setting.span))
}

/// The depth that `MoorDyn` in C++ has, where it is another than the file means: that of `WtrDpth`, or of the deepest fixed point.
fn depth(mooring: &Mooring, sea: &SeaOfCase) -> Option<AuditFinding> {
    if mooring.sea.depth_file.is_some() || mooring.program == Program::MoorDyn1 {
        return None;
    }
    let meant = sea.depth.filter(|_| !is_in_air(mooring))?;
    let setting = mooring.setting("wtrdpth");
    let known = setting.filter(|setting| setting.written.eq_ignore_ascii_case("wtrdpth"));
    let given = known.and(mooring.sea.depth.as_ref());
    let fixed = mooring.points.iter();
    let fixed = fixed.filter(|point| point.hold.value == Hold::Fixed);
    let deepest = fixed.map(|point| -point.place[2].value).fold(0.0, f64::max);
    let taken = given.map_or(0.0, |given| given.value).max(deepest);
    if (taken - meant).abs() <= DEPTH {
        return None;
    }
    let why = match setting {
        Some(setting) if known.is_none() => {
            format!(
                "MoorDyn in C++ does not know the name {} (OpenFAST does)",
                setting.written
            )
        }
        Some(_) => "a fixed point is deeper".to_owned(),
        None => "no depth is given".to_owned(),
    };
    let what = format!(
        "{why}: the bed of MoorDyn in C++ is at z = {}, where {} m is meant, and all that is below it is lifted",
        digits(-taken + 0.0, 6),
        digits(-meant, 6)
    );
    let remedy = format!(
        "write `{} WtrDpth`, which every version knows",
        digits(meant, 6)
    );
    let mut finding = AuditFinding::new(Topic::Setting, "WtrDpth", what, remedy);
    finding.span = setting.map(|setting| setting.span.clone());
    Some(finding.figure(taken, meant, "m"))
}

/// Friction that comes to its full value at speeds that no line has.
fn friction(mooring: &Mooring, sea: &SeaOfCase) -> Option<AuditFinding> {
    let setting = mooring.setting("frictioncoefficient")?;
    let coefficient = mooring.sea.friction.as_ref()?.value;
    if coefficient <= 0.0 {
        return None;
    }
    let given = mooring.setting("fricdamp").and_then(ProgramSetting::number);
    let by_speed = given.unwrap_or(FRICTION_DAMPING);
    let weight = mooring.lines.iter().filter_map(|line| {
        let of = &mooring.line_types[line.of_type.value];
        let Mass::InAir(mass) = of.mass.value else {
            return None;
        };
        let area = std::f64::consts::FRAC_PI_4 * of.diameter.value.powi(2);
        let weight = (mass - sea.density * area) * sea.gravity;
        let segment = line.length.value / line.segments.value.max(1) as f64;
        (weight > 0.0).then_some((weight * segment, line))
    });
    let (node, line) = weight.max_by(|one, other| one.0.total_cmp(&other.0))?;
    // MoorDyn: force = min(speed mu FricDamp, mu N); full at the speed N / FricDamp.
    let speed = node / by_speed;
    if speed.is_nan() || speed <= SLIDING {
        return None;
    }
    let origin = match given {
        Some(_) => "",
        None => ", the default",
    };
    let what = format!(
        "friction grows with speed by FricDamp {}{origin}: a node of line {} that weighs {} has full friction from {} on, and next to none at rest",
        digits(by_speed, 4),
        line.id,
        si(node, "N"),
        si(speed, "m/s")
    );
    let wanted = node / SLIDING;
    let of = &mooring.line_types[line.of_type.value];
    let Mass::InAir(mass) = of.mass.value else {
        return None;
    };
    // The explicit step is stable while friction takes no more than twice the momentum of a node.
    let mass = mass * line.length.value / line.segments.value.max(1) as f64;
    let remedy = format!(
        "give FricDamp {} for full friction from {} on, with steps up to {}",
        digits(wanted, 3),
        si(SLIDING, "m/s"),
        si(2.0 * mass / (coefficient * wanted), "s")
    );
    let finding = AuditFinding::new(Topic::Setting, "FricDamp", what, remedy);
    let span = mooring.setting("fricdamp").unwrap_or(setting);
    Some(finding.at(&span.span).figure(speed, SLIDING, "m/s"))
}

/// Internal damping in the wrong sense.
fn damping(mooring: &Mooring, findings: &mut Vec<AuditFinding>) {
    for (number, of) in mooring.line_types.iter().enumerate() {
        let lines = mooring.lines.iter();
        let of_type = lines.filter(|line| line.of_type.value == number);
        let segments = of_type.map(|line| line.length.value / line.segments.value.max(1) as f64);
        let shortest = segments.fold(f64::INFINITY, f64::min);
        let Mass::InAir(mass) = of.mass.value else {
            continue;
        };
        let Stiffness::Constant(ea) = of.stiffness.value else {
            continue;
        };
        let critical = shortest * (ea * mass).sqrt();
        if !critical.is_finite() || critical <= 0.0 {
            continue;
        }
        let finding = damping_of_type(of, critical);
        findings.extend(finding.map(|finding| finding.at(&of.damping.span)));
    }
}

/// What is wrong with the internal damping of a line type, by the critical damping of its shortest segment \[N s\].
fn damping_of_type(of: &MooringLineType, critical: f64) -> Option<AuditFinding> {
    let subject = format!("line type {}", of.name);
    match of.damping.value {
        Damping::Coefficient(value)
            if value > 0.0 && value <= RATIO_LIKE && value / critical < UNDAMPED =>
        {
            let what = format!(
                "internal damping of {} N s is {} of the critical damping of a segment: it damps nothing",
                digits(value, 4),
                digits(value / critical, 2)
            );
            let remedy = format!(
                "a share of the critical damping is written as -{}",
                digits(value, 4)
            );
            let finding = AuditFinding::new(Topic::Setting, subject, what, remedy);
            Some(finding.figure(value, critical, "N s"))
        }
        Damping::Ratio(ratio) if ratio > OVERDAMPED => {
            let what = format!(
                "-{} is {} times the critical damping of a segment, {}",
                digits(ratio, 6),
                digits(ratio, 6),
                si(ratio * critical, "N s")
            );
            let remedy = "write a coefficient in N s without sign, or a share between -0.1 and -1";
            let finding = AuditFinding::new(Topic::Setting, subject, what, remedy);
            Some(finding.figure(ratio * critical, critical, "N s"))
        }
        Damping::Coefficient(value) if value > OVERDAMPED * critical => {
            let what = format!(
                "internal damping of {} is {} times the critical damping of a segment",
                si(value, "N s"),
                digits(value / critical, 3)
            );
            let remedy = format!(
                "{} is critical; it also limits the time step",
                si(critical, "N s")
            );
            let finding = AuditFinding::new(Topic::Setting, subject, what, remedy);
            Some(finding.figure(value, critical, "N s"))
        }
        _ => None,
    }
}

/// Rows of bodies whose drag has six numbers: `MoorDyn` 2.7 takes the last five of them.
fn bodies(mooring: &Mooring, text: &str, findings: &mut Vec<AuditFinding>) {
    for body in &mooring.bodies {
        let entry = text.get(body.drag_area.span.clone()).unwrap_or("");
        if entry.split('|').count() != 6 {
            continue;
        }
        let finding = AuditFinding::new(
            Topic::Setting,
            format!("body {}", body.id),
            format!("of the six drag areas `{entry}` MoorDyn loses the first"),
            "give one for the directions and one for the turns, `a|b`",
        );
        findings.push(finding.at(&body.drag_area.span));
    }
}

/// Failures by time, which come at once.
fn failures(mooring: &Mooring, findings: &mut Vec<AuditFinding>) {
    for failure in &mooring.failures {
        if let Some(time) = &failure.time {
            let what = format!(
                "it fails at {}; MoorDyn 2.7 lets it fail in its first step, and the line stays in place",
                si(time.value, "s")
            );
            let remedy = "let it fail by tension, or end the line in a run of its own";
            let finding = AuditFinding::new(Topic::Setting, "FAILURE", what, remedy);
            findings.push(finding.at(&time.span));
        }
    }
}

/// Row and column of bytes of the file, both from 1.
#[must_use]
pub fn row_and_column(text: &str, span: &std::ops::Range<usize>) -> (u32, u32) {
    line_and_column(text, span.start)
}
