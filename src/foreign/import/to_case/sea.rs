//! Water, gravity, bed, current and waves of a case.

use std::f64::consts::TAU;
use std::fmt::Write as _;

use super::super::imported::ImportOptions;
use super::case_text::{CaseText, number, numbers, text};
use crate::import::mooring::{
    CurrentFile, Elevation, Given, Hold, Mooring, MooringCurrent, MooringSea, Program,
    WaveComponent,
};
use crate::import::{fault::Fault, yaml};

/// Gravity \[m/s²\] where none is given: that of MoorDyn.
pub const GRAVITY: f64 = 9.80665;

/// Gravity \[m/s²\] and the program that takes it where a file of this one gives none.
const fn gravity_of(program: Program) -> f64 {
    match program {
        Program::Raft | Program::Ontology | Program::FaModel => yaml::GRAVITY,
        Program::MoorDyn | Program::MoorDyn1 | Program::MapPlusPlus | Program::CableDyn => GRAVITY,
    }
}

/// Why what is above the water weighs what it weighs in air; nothing where a program weighs it as under water. MoorDyn has a share of each
/// segment under water (`Line::calcSubSeg`), MoorPy one weight along a line by the heights of its ends (`Line.staticSolve`); MAP++ knows no surface
/// (`omega` in its `src/mapinit.c`).
const fn crossed_by(program: Program) -> Option<&'static str> {
    match program {
        Program::MoorDyn | Program::MoorDyn1 => Some("as MoorDyn weighs what is above the water"),
        Program::Raft | Program::Ontology | Program::FaModel => Some(
            "MoorPy weighs a line that leaves the water by the heights of its ends, here each part as it is",
        ),
        Program::CableDyn => Some("what is above the water weighs what it weighs in air"),
        Program::MapPlusPlus => None,
    }
}

/// The program whose defaults a program takes.
const fn default_of(program: Program) -> &'static str {
    match program {
        Program::Raft => "MoorPy, which computes the lines of RAFT,",
        Program::Ontology => "MoorPy, which computes the lines of WISDEM,",
        Program::FaModel => "MoorPy, which computes the lines of FAModel,",
        other => other.name(),
    }
}

/// The program whose bed is taken: what MoorPy takes is what MoorDyn does.
const fn bed_of(program: Program) -> &'static str {
    match program {
        Program::Raft | Program::Ontology | Program::FaModel => "MoorPy",
        Program::MoorDyn | Program::MoorDyn1 | Program::MapPlusPlus => "MoorDyn",
        Program::CableDyn => "CableDyn",
    }
}
/// Density \[kg/m³\] where none is given: that of MoorDyn.
pub const DENSITY: f64 = 1025.0;
/// Push \[Pa/m\] and damping \[Pa s/m\] of the bed where none is given: those of MoorDyn, and of CableDyn.
const fn bed_springs(program: Program) -> [f64; 2] {
    match program {
        Program::CableDyn => [1.0e5, 1.0e4],
        _ => [3.0e6, 3.0e5],
    }
}

/// What the sea of a case is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SeaOfCase {
    /// \[m/s²\].
    pub gravity: f64,
    /// \[kg/m³\].
    pub density: f64,
    /// \[m\]; none where no bed is known.
    pub depth: Option<f64>,
}

/// The sea by the file and what the options add.
///
/// # Errors
/// The program needs it from outside, and it is not given.
pub fn sea_of(mooring: &Mooring, options: &ImportOptions) -> Result<SeaOfCase, Vec<Fault>> {
    let sea = &mooring.sea;
    let value = |given: &Option<Given<f64>>| given.as_ref().map(|given| given.value);
    let gravity = options.gravity.or(value(&sea.gravity));
    let density = options.density.or(value(&sea.density));
    let depth = options.depth.or(value(&sea.depth));
    if mooring.program == Program::MapPlusPlus {
        let missing = [
            (gravity, "gravity", "--gravity 9.80665"),
            (density, "density of the water", "--density 1025"),
            (depth, "depth", "--depth 320"),
        ];
        let faults: Vec<Fault> = missing
            .into_iter()
            .filter(|(given, _, _)| given.is_none())
            .map(|(_, what, option)| {
                Fault::new(
                    0..0,
                    "",
                    format!("a MAP++ file does not say the {what}: the program that calls it does"),
                    format!("give it, for example `{option}`"),
                )
            })
            .collect();
        if !faults.is_empty() {
            return Err(faults);
        }
    }
    Ok(SeaOfCase {
        gravity: gravity.unwrap_or(gravity_of(mooring.program)),
        density: density.unwrap_or(DENSITY),
        depth: depth.or_else(|| deepest(mooring)),
    })
}

/// The depth of the deepest fixed point, which MoorDyn takes for that of the bed.
fn deepest(mooring: &Mooring) -> Option<f64> {
    if mooring.program == Program::CableDyn {
        // Without a depth it has no bed.
        return None;
    }
    let points = mooring.points.iter();
    let fixed = points.filter(|point| point.hold.value == Hold::Fixed);
    let depths = fixed.map(|point| -point.place[2].value);
    depths.fold(None, |deepest: Option<f64>, depth| {
        Some(deepest.map_or(depth, |deepest| deepest.max(depth)))
    })
}

/// Writes the environment and the bed; `in_air` where nothing of the system is in the water.
pub fn write(
    case: &mut CaseText<'_>,
    mooring: &Mooring,
    options: &ImportOptions,
    sea: &SeaOfCase,
    in_air: bool,
) {
    case.table("[environment]", None);
    let program = default_of(mooring.program);
    let mut one =
        |key: &str, option: Option<f64>, given: &Option<Given<f64>>, value: f64, column| match (
            option, given,
        ) {
            (Some(_), _) => case.assumed(key, &number(value), "given with the command"),
            (None, Some(given)) => case.given(key, &number(value), &given.span, column),
            (None, None) => {
                let why = format!("assumed: {program} takes it where the file is silent");
                case.assumed(key, &number(value), &why);
            }
        };
    let given = &mooring.sea;
    one(
        "gravity_m_per_s2",
        options.gravity,
        &given.gravity,
        sea.gravity,
        "g",
    );
    if in_air {
        case.assumed(
            "water_density_kg_per_m3",
            "0.0",
            "everything is above the water",
        );
    } else {
        let key = "water_density_kg_per_m3";
        one(key, options.density, &given.density, sea.density, "rho");
    }
    let has_surface = !in_air && sea.density > 0.0 && sea.gravity > 0.0;
    if let Some(why) = crossed_by(mooring.program).filter(|_| has_surface) {
        case.assumed("water_surface", "\"crossed\"", why);
    }
    if matches!(mooring.program, Program::MoorDyn | Program::MoorDyn1) {
        case.assumed("drag_length", "\"unstretched\"", "as MoorDyn takes it");
    }
    if let Some(depth) = sea.depth.filter(|depth| *depth > 0.0 && !in_air) {
        bed(case, mooring, options, depth);
    }
}

fn bed(case: &mut CaseText<'_>, mooring: &Mooring, options: &ImportOptions, depth: f64) {
    let sea = &mooring.sea;
    let program = bed_of(mooring.program);
    let as_taken = match program {
        "MoorDyn" => ", as MoorDyn takes it",
        _ => "",
    };
    case.table("[seabed]", None);
    match (&sea.depth, options.depth) {
        (Some(given), None) => {
            case.given("depth_m", &number(depth), &given.span, "WtrDpth");
        }
        (_, Some(_)) => case.assumed("depth_m", &number(depth), "given with the command"),
        (None, None) => case.assumed(
            "depth_m",
            &number(depth),
            &format!("assumed: that of the deepest fixed point{as_taken}"),
        ),
    }
    if let Some(file) = &sea.depth_file {
        case.given("depth_file", &text(&file.value), &file.span, "SeafloorFile");
        case.assumed(
            "interpolation",
            "\"bilinear\"",
            "as MoorDyn takes it; waves feel depth_m, in MoorDyn the mean of the grid",
        );
    }
    let springs = bed_springs(mooring.program);
    let rows = [
        ("stiffness_n_per_m3", &sea.bed_stiffness, springs[0], "kBot"),
        ("damping_n_s_per_m3", &sea.bed_damping, springs[1], "cBot"),
    ];
    for (key, given, default, column) in rows {
        match given {
            Some(given) => case.given(key, &number(given.value), &given.span, column),
            None => {
                case.assumed(
                    key,
                    &number(default),
                    &format!("assumed: {program}'s default"),
                );
            }
        }
    }
    friction(case, sea);
}

/// Friction along lines, and across them where that is another.
fn friction(case: &mut CaseText<'_>, sea: &MooringSea) {
    const SILENT: &str = "assumed: none, as where the file is silent";
    let (along, across) = match &sea.friction_along {
        Some(along) => (Some((along, "mu_kA")), sea.friction.as_ref()),
        None => {
            let along = sea.friction.as_ref();
            let along = along.map(|along| (along, "FrictionCoefficient"));
            (along, sea.friction_across.as_ref())
        }
    };
    match along {
        Some((given, name)) => case.given("friction", &number(given.value), &given.span, name),
        // Nothing is said of friction over a grid.
        None if sea.depth_file.is_some() && across.is_none() => {}
        None => case.assumed("friction", "0.0", SILENT),
    }
    match (across, &sea.friction_along) {
        (Some(given), along) => {
            let name = along.as_ref().map_or("FrictionMuLateral", |_| "mu_kT");
            case.given("friction_lateral", &number(given.value), &given.span, name);
        }
        (None, Some(_)) => case.assumed("friction_lateral", "0.0", SILENT),
        (None, None) => {}
    }
}

/// Writes the file of depths, which the case carries in it.
pub fn write_depths(case: &mut CaseText<'_>, mooring: &Mooring) {
    let (Some(file), Some(depths)) = (&mooring.sea.depth_file, &mooring.sea.depth_text) else {
        return;
    };
    case.table(&format!("[files.{}]", text(&file.value)), Some(&file.span));
    case.line(&format!("text = {}", text(depths)), Some(&file.span));
}

/// Writes the current by height.
pub fn write_current(case: &mut CaseText<'_>, profile: &Given<MooringCurrent>) {
    case.table("[current]", Some(&profile.span));
    // The profile runs from above; heights above the water have no water.
    let (file, all) = (&profile.value.file, &profile.value.rows);
    let wet: Vec<&[f64; 3]> = all.iter().filter(|row| row[0] <= 0.0).collect();
    let rows = match wet.is_empty() {
        true => all.iter().collect(),
        false => wet,
    };
    let of = |take: &dyn Fn(&[f64; 3]) -> f64| {
        numbers(&rows.iter().map(|row| take(row)).collect::<Vec<f64>>())
    };
    let speeds = of(&|row| f64::hypot(row[1], row[2]));
    let directions = of(&|row| row[2].atan2(row[1]).to_degrees());
    if let [one] = rows.as_slice() {
        let speed = number(f64::hypot(one[1], one[2]));
        case.given("speed_m_per_s", &speed, &profile.span, file);
        let direction = number(one[2].atan2(one[1]).to_degrees());
        case.given("direction_deg", &direction, &profile.span, "");
        return;
    }
    let depths = of(&|row| (-row[0]).max(0.0));
    case.given("depth_m", &depths, &profile.span, file);
    case.given("speed_m_per_s", &speeds, &profile.span, "");
    case.given("direction_deg", &directions, &profile.span, "");
}

/// Writes the file of the current, which the case carries in it.
pub fn write_current_file(case: &mut CaseText<'_>, file: &Given<CurrentFile>) {
    let name = text(file.value.name);
    case.table(&format!("[files.{name}]"), Some(&file.span));
    case.line(
        &format!("text = {}", text(&file.value.text)),
        Some(&file.span),
    );
}

/// What of a current over time and place is other than in MoorDyn.
pub fn remark_on_current(file: &CurrentFile) -> String {
    let between = "The current is linear in time and place between the rows of its file and constant beyond, as MoorDyn's manual has it; its rate is no acceleration of the water, as in MoorDyn.";
    let first = match file.name {
        "current_profile_4d.txt" => {
            " MoorDyn 2 leaves out the first row of the grid and has no current there."
        }
        _ => "",
    };
    let again = match file.varies {
        true => {
            " After its last time MoorDyn 2 begins the file anew; here the current stays as it is."
        }
        false => "",
    };
    format!("{between}{first}{again}")
}

/// Writes the components of a history of elevation as one wave system towards +x.
pub fn write_elevation(case: &mut CaseText<'_>, waves: &Given<Elevation>) {
    let components = &waves.value.components;
    if components.is_empty() {
        return;
    }
    case.table("[[waves]]", Some(&waves.span));
    case.line("kind = \"components\"", None);
    let of = |take: &dyn Fn(&[f64; 3]) -> f64| {
        numbers(&components.iter().map(take).collect::<Vec<f64>>())
    };
    let mut list = |key: &str, values: String| {
        case.given(key, &values, &waves.span, "wave_elevation.txt");
    };
    list("periods_s", of(&|one| TAU / one[0]));
    list("heights_m", of(&|one| 2.0 * one[1]));
    list("phases_deg", of(&|one| one[2].to_degrees()));
    case.assumed("stretching", "\"wheeler\"", "as MoorDyn takes it");
}

/// What the components of a history of elevation are, and what they leave out.
pub fn remark_on_elevation(waves: &Elevation) -> String {
    let mut words = format!(
        "The waves are the {} components of wave_elevation.txt up to 0.5 Hz, as MoorDyn takes them, and repeat after {:.6} s; they leave out {:.1e} of the variance of its samples. Between the places and times of its grid MoorDyn reads them linearly, here they are exact.",
        waves.components.len(),
        waves.period,
        waves.lost
    );
    if waves.mean.abs() > SAME_LEVEL {
        // Writing to a string does not fail.
        let _ = write!(
            words,
            " The mean of the history, {:.4} m, is left out: waves here are about still water.",
            waves.mean
        );
    }
    words
}

/// Mean height of a history below which it is rounding \[m\].
const SAME_LEVEL: f64 = 1e-6;

/// Writes regular waves, each with its direction.
pub fn write_waves(case: &mut CaseText<'_>, components: &Given<Vec<WaveComponent>>) {
    let from = &components.span;
    for component in &components.value {
        case.table("[[waves]]", Some(from));
        case.line("kind = \"regular\"", None);
        let height = number(2.0 * component.amplitude);
        case.given("height_m", &height, from, "wave_frequencies.txt");
        let period = number(TAU / component.frequency);
        case.given("period_s", &period, from, "");
        if component.direction != 0.0 {
            let direction = number(component.direction.to_degrees());
            case.given("direction_deg", &direction, from, "");
        }
        let phase = number(component.phase.to_degrees());
        case.given("phase_deg", &phase, from, "");
    }
}
