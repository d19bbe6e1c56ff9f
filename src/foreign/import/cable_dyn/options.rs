//! The section OPTIONS: a value before its name, what follows ` - ` is a remark; records of several values for currents and waves.

use super::unmodelled;
use crate::import::fault::Fault;
use crate::import::moordyn::files::Files;
use crate::import::moordyn::options as moordyn;
use crate::import::moordyn::sections::SectionBlock;
use crate::import::mooring::{Given, Mooring, MooringCurrent, ProgramSetting};
use crate::import::words::{Row, Word};

/// Options that are those of `MoorDyn` by another name, in small letters.
const SAME: [(&str, &str); 20] = [
    ("g", "g"),
    ("gravity", "g"),
    ("rhow", "rho"),
    ("wtrdnsty", "rho"),
    ("water_density", "rho"),
    ("wtrdpth", "WtrDpth"),
    ("water_depth", "WtrDpth"),
    ("kbot", "kBot"),
    ("kb", "kBot"),
    ("cbot", "cBot"),
    ("cb", "cBot"),
    ("frictionmu", "FrictionCoefficient"),
    ("mu", "FrictionCoefficient"),
    ("frictioncoefficient", "FrictionCoefficient"),
    ("frictionmuaxial", "FrictionCoefficient"),
    ("frictionmu_axial", "FrictionCoefficient"),
    ("mu_axial", "FrictionCoefficient"),
    ("waterkin", "WaterKin"),
    ("wavekin", "WaterKin"),
    ("currents", "Currents"),
];

/// Options that a calculation at rest and its own solver have no use for.
const PASSED_OVER: [&str; 44] = [
    "bodyscheme",
    "bodysubstep",
    "bodyhydro",
    "bodywetting",
    "rodhydro",
    "dtm",
    "dt",
    "tmax",
    "rangestart",
    "range_start",
    "rhoinf",
    "rho_inf",
    "maxstrain",
    "max_strain",
    "dynamic_solver",
    "modified_newton",
    "modifiednewton",
    "recovery_max_substeps",
    "recoverymaxsubsteps",
    "adaptive_mesh",
    "adaptivemesh",
    "alpha_force_blend",
    "alphaforceblend",
    "cable_statics",
    "cablestatics",
    "axial_quadrature_order",
    "bending_quadrature_order",
    "tensile_safety",
    "tensilesafety",
    "tensile_strain_tolerance",
    "cable_load_feedback",
    "streamorder",
    "nmodes",
    "n_modes",
    "modes",
    "tscheme",
    "dtic",
    "tmaxic",
    "cdscaleic",
    "threshic",
    "writelog",
    "dtout",
    "dtwave",
    "vesselref",
];

/// Options of waves, which are not read.
const OF_WAVES: [&str; 11] = [
    "waves",
    "wave",
    "wavetrain",
    "wave_train",
    "waveseed",
    "wave_seed",
    "wavespreading",
    "wavedirections",
    "wavecomponents",
    "ramptime",
    "ramp_time",
];

/// Friction across lines, in small letters.
const ACROSS: [&str; 4] = [
    "frictionmulateral",
    "frictionmu_lateral",
    "mu_lateral",
    "frictionmunormal",
];

/// Options of a prescribed motion and of its start: what is said of each.
const SAID: [(&str, &str); 4] = [
    ("motionfile", MOTION),
    ("vesselmotion", MOTION),
    ("vesselrao", MOTION),
    ("bodyic", START),
];
const MOTION: &str = "the motion is not read: give it with --motion";
const START: &str = "bodies begin where they rest here";

/// Values that switch an option off.
const OFF: [&str; 3] = ["none", "0", "false"];

/// Reads the options.
pub fn read(
    block: &SectionBlock<'_>,
    files: &Files<'_>,
    mooring: &mut Mooring,
    faults: &mut Vec<Fault>,
) {
    for row in &block.rows {
        let words = without_description(row);
        let read = match words.as_slice() {
            [] => continue,
            [first, ..] if first.is("dynamic_solver") => {
                mooring.passed_over.push(first.text.to_owned());
                continue;
            }
            [model, .., name] if name.is("current") => current(*model, &words, *name, mooring),
            [model, rest @ ..]
                if rest.iter().any(|word| word.is("current")) && is_model(*model) =>
            {
                let at = rest.iter().position(|word| word.is("current")).unwrap_or(0);
                current(*model, &words[..=at + 1], rest[at], mooring)
            }
            words => match words.iter().find(|word| is_of_waves(**word)) {
                Some(name) => {
                    waves(words[0], *name, row, mooring);
                    Ok(())
                }
                None => option(words, files, mooring),
            },
        };
        faults.extend(read.err());
    }
}

/// The words of a row up to a lone `-`.
fn without_description<'t>(row: &Row<'t>) -> Vec<Word<'t>> {
    let mut words = row.words();
    if let Some(end) = words.iter().position(|word| word.text == "-") {
        words.truncate(end);
    }
    words
}

fn is_model(word: Word<'_>) -> bool {
    ["none", "uniform", "profile"]
        .iter()
        .any(|model| word.is(model))
}

fn is_of_waves(word: Word<'_>) -> bool {
    OF_WAVES.iter().any(|name| word.is(name))
}

/// `uniform vx vy vz current`, or `profile z vx vy vz z vx vy vz current`.
fn current(
    model: Word<'_>,
    words: &[Word<'_>],
    name: Word<'_>,
    mooring: &mut Mooring,
) -> Result<(), Fault> {
    let key = "OPTIONS, current";
    if OFF.iter().any(|off| model.is(off)) {
        return Ok(());
    }
    let numbers = words[1..words.len() - 1].iter();
    let numbers: Vec<f64> = numbers
        .map(|word| word.required(key))
        .collect::<Result<_, _>>()?;
    let span = model.start..name.start + name.text.len();
    let wrong = |problem: &str| {
        let remedy =
            "write `uniform vx vy vz current` or `profile z1 vx1 vy1 vz1 z2 vx2 vy2 vz2 current`";
        Fault::new(span.clone(), key, problem, remedy)
    };
    let levels: Vec<[f64; 4]> = match *numbers.as_slice() {
        [x, y, z] if model.is("uniform") => vec![[0.0, x, y, z]],
        [a, ax, ay, az, b, bx, by, bz] if model.is("profile") && a != b => {
            vec![[a, ax, ay, az], [b, bx, by, bz]]
        }
        _ => return Err(wrong("the current is not read so")),
    };
    if levels.iter().any(|level| level[3] != 0.0) {
        return Err(wrong(
            "the current has a part upwards: currents here are horizontal",
        ));
    }
    let mut rows: Vec<[f64; 3]> = levels.iter().map(|[z, x, y, _]| [*z, *x, *y]).collect();
    rows.sort_by(|a, b| b[0].total_cmp(&a[0]));
    let profile = MooringCurrent {
        file: String::new(),
        rows,
    };
    mooring.sea.current = Some(Given::new(profile, span));
    Ok(())
}

/// Waves of the file, which act in motion.
fn waves(first: Word<'_>, name: Word<'_>, row: &Row<'_>, mooring: &mut Mooring) {
    let is_sea = ["waves", "wave", "wavetrain", "wave_train"]
        .iter()
        .any(|word| name.is(word));
    if is_sea && !OFF.iter().any(|off| first.is(off)) {
        let what = format!("waves by the option `{}`", name.text);
        let one = unmodelled("waves", row.span(), "OPTIONS, waves", what);
        mooring.unmodelled.push(one);
    }
}

/// An option of a value and a name.
fn option(words: &[Word<'_>], files: &Files<'_>, mooring: &mut Mooring) -> Result<(), Fault> {
    let [value, name, ..] = words else {
        return Err(Fault::new(
            words[0].span(),
            "OPTIONS",
            format!(
                "`{}` stands alone: an option is a value and its name",
                words[0].text
            ),
            "write the name of the option behind its value",
        ));
    };
    let lower = name.text.to_lowercase();
    let is_off = OFF.iter().any(|off| value.is(off));
    let said = SAID.iter().find(|(known, _)| *known == lower);
    if PASSED_OVER.contains(&lower.as_str()) {
        mooring.passed_over.push(name.text.to_owned());
    } else if let Some((_, what)) = said {
        let is_default = is_off || value.is("static");
        if !is_default {
            mooring
                .remarks
                .push(format!("{} {}: {what}.", value.text, name.text));
        }
    } else if ACROSS.contains(&lower.as_str()) {
        if value.number().is_some() || !is_off {
            let across = value.required(&format!("OPTIONS, {}", name.text))?;
            mooring.sea.friction_across = Some(Given::new(across, value.span()));
        }
    } else if is_bathymetry(&lower) {
        return moordyn::depths_of_places(*value, name.text, files, &mut mooring.sea);
    } else if let Some((_, same)) = SAME.iter().find(|(known, _)| *known == lower) {
        if is_off && *same == "FrictionCoefficient" {
            return Ok(());
        }
        let setting = ProgramSetting {
            name: moordyn::known_name(same).to_owned(),
            written: name.text.to_owned(),
            value: value.text.to_owned(),
            span: value.span(),
        };
        moordyn::take(&setting, *value, files, mooring)?;
        mooring.settings.push(setting);
    } else {
        mooring.not_known.push(name.text.to_owned());
    }
    Ok(())
}

fn is_bathymetry(name: &str) -> bool {
    [
        "bathymetryfile",
        "bathymetry_file",
        "seafloorfile",
        "seafloor_file",
    ]
    .contains(&name)
}
