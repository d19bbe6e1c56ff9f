//! The section OPTIONS: settings, the value before its name or after it.

use super::elevation::{STEP, elevation};
use std::f64::consts::FRAC_PI_2;

use super::files::{Files, PROFILE};
use super::sections::SectionBlock;
use super::water_kinematics;
use crate::import::fault::Fault;
use crate::import::mooring::{
    Given, Mooring, MooringCurrent, MooringSea, Program, ProgramSetting, Unmodelled,
};
use crate::import::words::{Row, Word};

/// Names of options in small letters, the first by which it is known here, and whether its value is a number.
const NAMES: [(&[&str], bool); 37] = [
    (&["dtm", "dt"], true),
    (&["cfl"], true),
    (&["writelog"], false),
    (&["writeunits"], false),
    (&["tscheme"], false),
    (&["g", "gravity"], true),
    (&["wtrdnsty", "rho", "density", "rhow"], true),
    (&["wtrdpth", "depth", "waterdepth"], false),
    (&["kbot", "kb"], true),
    (&["cbot", "cb"], true),
    (&["dtic", "icdt"], true),
    (&["tmaxic", "ictmax"], true),
    (&["cdscaleic", "icdfac"], true),
    (&["threshic", "icthresh"], true),
    (&["icgendynamic", "gendynamicic"], true),
    (&["fileic", "icfile"], false),
    (&["wavekin"], false),
    (&["currents", "current"], false),
    (&["waterkin"], false),
    (&["dtwave"], true),
    (&["unifycurrentgrid"], true),
    (&["frictioncoefficient", "mu_kt", "cb_friction"], true),
    (&["mu_ka"], true),
    (&["fricdamp", "cv"], true),
    (&["statdynfricscale", "mc"], true),
    (&["dtout"], true),
    (&["seafloorfile", "bathymetryfile", "bathfile"], false),
    (&["disableoutput"], false),
    (&["disableouttime"], false),
    (&["outswitch"], false),
    (&["inertialf"], true),
    (&["inertialf_rampt"], true),
    (&["visco_mod"], false),
    (&["echo"], false),
    (&["rampt", "ramptime"], true),
    (&["wavedirection", "wavedir"], true),
    (&["endtime", "tmax", "duration"], true),
];

/// Settings that a program of the first version had and that mean nothing for its results.
const MEANINGLESS: [&str; 7] = [
    "writelog",
    "writeunits",
    "echo",
    "outswitch",
    "disableoutput",
    "disableouttime",
    "dtout",
];

/// Reads the options, and what the sea of the mooring is by them.
pub fn read_options(
    block: &SectionBlock<'_>,
    files: &Files<'_>,
    mooring: &mut Mooring,
    faults: &mut Vec<Fault>,
) {
    for row in &block.rows {
        if row.text.trim_start().starts_with(['(', '[']) {
            continue;
        }
        match setting(row) {
            Ok(Some((setting, value))) => {
                if let Some(before) = mooring.setting(&setting.name)
                    && !MEANINGLESS.contains(&setting.name.as_str())
                    && before.value != setting.value
                {
                    let remark = format!(
                        "{} is set twice, as {} = {} and {} = {}; the last counts, as in MoorDyn.",
                        setting.written,
                        before.written,
                        before.value,
                        setting.written,
                        setting.value
                    );
                    mooring.remarks.push(remark);
                    mooring.settings.retain(|one| one.name != setting.name);
                }
                if let Err(fault) = take(&setting, value, files, mooring) {
                    faults.push(fault);
                }
                mooring.settings.push(setting);
            }
            Ok(None) => {
                let words = row.words();
                let name = words.get(1).or(words.first());
                let name = name.map(|word| word.text.to_owned());
                mooring.not_known.extend(name);
            }
            Err(fault) => faults.push(fault),
        }
    }
    if let Err(fault) = waves_by_elevation(files, mooring) {
        faults.push(fault);
    }
}

/// Waves by a history of elevation, where the settings have them.
fn waves_by_elevation(files: &Files<'_>, mooring: &mut Mooring) -> Result<(), Fault> {
    let Some(kind) = mooring
        .setting("wavekin")
        .filter(|kind| kind.number() == Some(3.0))
    else {
        return Ok(());
    };
    let at = Word {
        text: &kind.value,
        start: kind.span.start,
    };
    let step = mooring.setting("dtwave");
    let given = step.and_then(|step| Some(Given::new(step.number()?, step.span.clone())));
    let step = given.unwrap_or_else(|| Given::new(STEP, kind.span.clone()));
    let key = format!("OPTIONS, {}", kind.written);
    let found = elevation(files, at, &key, &step)?;
    let span = kind.span.clone();
    mooring.sea.elevation = Some(Given::new(found, span));
    Ok(())
}

/// The known name of an option, and whether its value is a number.
fn known(word: &str) -> Option<(&'static str, bool)> {
    let lower = word.to_lowercase();
    let found = NAMES
        .iter()
        .find(|(names, _)| names.contains(&lower.as_str()));
    found.map(|(names, number)| (names[0], *number))
}

/// The setting of a row, and the word of its value; none where its name is not known.
fn setting<'t>(row: &Row<'t>) -> Result<Option<(ProgramSetting, Word<'t>)>, Fault> {
    let words = row.words();
    let (name, value) = match words.as_slice() {
        [value, name, ..] if known(name.text).is_some() => (*name, *value),
        [name, value, ..] if known(name.text).is_some() => (*name, *value),
        [name] if known(name.text).is_some() => {
            return Err(Fault::new(
                name.span(),
                format!("OPTIONS, {}", name.text),
                format!("the option `{}` has no value", name.text),
                "write its value before its name",
            ));
        }
        [word] if word.number().is_some() => {
            return Err(Fault::new(
                word.span(),
                "OPTIONS",
                format!(
                    "`{}` stands alone: it does not say which option it sets",
                    word.text
                ),
                "write the name of the option behind its value",
            ));
        }
        _ => return Ok(None),
    };
    let Some((known, is_number)) = known(name.text) else {
        return Ok(None);
    };
    let key = format!("OPTIONS, {}", name.text);
    if is_number && !MEANINGLESS.contains(&known) {
        value.required(&key)?;
    }
    let setting = ProgramSetting {
        name: known.to_owned(),
        written: name.text.to_owned(),
        value: value.text.to_owned(),
        span: value.span(),
    };
    Ok(Some((setting, value)))
}

/// The name by which an option is known here.
#[must_use]
pub fn known_name(word: &str) -> &'static str {
    known(word).map_or("", |(name, _)| name)
}

/// What a setting says of the sea.
///
/// # Errors
/// Its value is none, or the file that it names has a fault.
pub fn take(
    setting: &ProgramSetting,
    value: Word<'_>,
    files: &Files<'_>,
    mooring: &mut Mooring,
) -> Result<(), Fault> {
    let key = format!("OPTIONS, {}", setting.written);
    let number = || -> Result<Option<Given<f64>>, Fault> {
        Ok(Some(Given::new(value.required(&key)?, value.span())))
    };
    let sea = &mut mooring.sea;
    match setting.name.as_str() {
        "g" => sea.gravity = number()?.map(|given| Given::new(given.value.abs(), given.span)),
        "wtrdnsty" => sea.density = number()?,
        "wtrdpth" => match value.number() {
            Some(_) => sea.depth = number()?.map(|given| Given::new(given.value.abs(), given.span)),
            None => depths(value, &key, files, sea)?,
        },
        "seafloorfile" => depths(value, &key, files, sea)?,
        "kbot" => sea.bed_stiffness = number()?,
        "cbot" => sea.bed_damping = number()?,
        "frictioncoefficient" => sea.friction = number()?,
        // MoorDyn of OpenFAST: mu_kT is across lines alone, and none unless given.
        "mu_ka" => sea.friction_along = number()?,
        "currents" => current(value, &key, files, mooring)?,
        "wavekin" => waves(value, &key, files, mooring)?,
        "waterkin" => water_kinematics(value, &key, files, mooring)?,
        _ => {}
    }
    Ok(())
}

/// A file of rows x, y, depth over a grid, as `CableDyn` has them, which the case carries as one of its own.
///
/// # Errors
/// The file is not there, or a row of it is not three numbers.
pub fn depths_of_places(
    value: Word<'_>,
    name: &str,
    files: &Files<'_>,
    sea: &mut MooringSea,
) -> Result<(), Fault> {
    let key = format!("OPTIONS, {name}");
    let text = files.text(value, &key)?;
    let mut rows = String::from("x_m,y_m,depth_m\n");
    let mut greatest = 0.0_f64;
    for (line, row) in (1..).zip(Row::all(&text)) {
        let words = row.words();
        if words.is_empty() {
            continue;
        }
        let numbers: Vec<f64> = words.iter().filter_map(Word::number).collect();
        let &[x, y, depth] = numbers.as_slice() else {
            let problem = format!(
                "in `{}`, line {line}: the row is not x, y and depth",
                value.text
            );
            return Err(Fault::new(
                value.span(),
                key,
                problem,
                "write three numbers on each row",
            ));
        };
        greatest = greatest.max(depth);
        rows.push_str(&format!("{x:?},{y:?},{depth:?}\n"));
    }
    sea.depth = Some(Given::new(greatest, value.span()));
    sea.depth_text = Some(rows);
    sea.depth_file = Some(Given::new(value.text.to_owned(), value.span()));
    Ok(())
}

/// A file of depths over a grid, which the case carries in it.
fn depths(
    value: Word<'_>,
    key: &str,
    files: &Files<'_>,
    sea: &mut MooringSea,
) -> Result<(), Fault> {
    sea.depth_text = Some(files.text(value, key)?);
    sea.depth_file = Some(Given::new(value.text.to_owned(), value.span()));
    Ok(())
}

/// Currents: 1 is a profile by height, 2 one that changes with time, 5 a grid of places and times. The others MoorDyn does not compute.
fn current(
    value: Word<'_>,
    key: &str,
    files: &Files<'_>,
    mooring: &mut Mooring,
) -> Result<(), Fault> {
    match value.number() {
        Some(0.0) => {}
        Some(1.0) => {
            let (rows, first) = files.current(value, key)?;
            mooring.sea.current_first = first;
            let profile = MooringCurrent {
                file: PROFILE.to_owned(),
                rows,
            };
            set_current(Given::new(profile, value.span()), key, mooring)?;
        }
        Some(2.0) => {
            let file = files.current_file(value, key, "current_profile_dynamic.txt")?;
            mooring.sea.current_file = Some(Given::new(file, value.span()));
        }
        Some(5.0) => {
            let file = files.current_file(value, key, "current_profile_4d.txt")?;
            mooring.sea.current_file = Some(Given::new(file, value.span()));
        }
        None => return Err(not_a_mode(value, key, "0, 1, 2 or 5")),
        _ => {
            let what = "currents at the nodes of lines, which MoorDyn does not compute either";
            mooring
                .unmodelled
                .push(unmodelled(value, key, "currents", what));
        }
    }
    Ok(())
}

/// The current of a file, which has one alone.
fn set_current(
    profile: Given<MooringCurrent>,
    key: &str,
    mooring: &mut Mooring,
) -> Result<(), Fault> {
    let other = |before: &&Given<MooringCurrent>| before.value.file != profile.value.file;
    if let Some(before) = mooring.sea.current.as_ref().filter(other) {
        let problem = format!(
            "there are two currents, of `{}` and of `{}`",
            before.value.file, profile.value.file
        );
        return Err(Fault::new(profile.span, key, problem, "leave one"));
    }
    mooring.sea.current = Some(profile);
    Ok(())
}

/// A file of water kinematics, of which a steady current is taken.
fn water_kinematics(
    value: Word<'_>,
    key: &str,
    files: &Files<'_>,
    mooring: &mut Mooring,
) -> Result<(), Fault> {
    let is_off = value.number() == Some(0.0) || value.is("none") || value.text == "-";
    if is_off {
        return Ok(());
    }
    if value.is("SEASTATE") {
        let what = "the waves and the current of the host (SEASTATE)";
        let what = unmodelled(value, key, "waves", what);
        mooring.unmodelled.push(what);
        return Ok(());
    }
    if files.path(value.text).is_none() {
        let what = format!(
            "the file of water kinematics {}, which is not beside this one",
            value.text
        );
        let what = unmodelled(value, key, "waves", &what);
        mooring.unmodelled.push(what);
        return Ok(());
    }
    let text = files.text(value, key)?;
    let depths_too = mooring.program == Program::CableDyn;
    let found = water_kinematics::read(&text, (value, key), depths_too)?;
    mooring.unmodelled.extend(found.unmodelled);
    mooring.remarks.extend(found.remarks);
    match found.current {
        Some(profile) => set_current(Given::new(profile, value.span()), key, mooring),
        None => Ok(()),
    }
}

/// Waves: 2 and 7 have their components in a file, 3 a history of elevation; those from outside are not modelled.
fn waves(
    value: Word<'_>,
    key: &str,
    files: &Files<'_>,
    mooring: &mut Mooring,
) -> Result<(), Fault> {
    match value.number() {
        Some(0.0) => {}
        // As sums over a grid its elevations are cosines, at the nodes sines (source/Waves/SpectrumKin.cpp).
        Some(which @ (2.0 | 7.0)) => {
            let lag = if which == 7.0 { FRAC_PI_2 } else { 0.0 };
            let components = files.waves(value, key, lag)?;
            mooring.sea.waves = Some(Given::new(components, value.span()));
        }
        // Read with the last of the options, which may be the step of the history.
        Some(3.0) => {}
        None => return Err(not_a_mode(value, key, "0, 2, 3 or 7")),
        _ => {
            let what = "waves given from outside or by velocities at nodes, of which the file does not say how the water moves";
            mooring
                .unmodelled
                .push(unmodelled(value, key, "waves", what));
        }
    }
    Ok(())
}

/// A mode that is no number.
fn not_a_mode(value: Word<'_>, key: &str, modes: &str) -> Fault {
    let problem = format!("`{}` is not a number", value.text);
    Fault::new(value.span(), key, problem, format!("give {modes}"))
}

fn unmodelled(value: Word<'_>, key: &str, name: &'static str, what: &str) -> Unmodelled {
    Unmodelled {
        name,
        span: value.span(),
        key: key.to_owned(),
        what: what.to_owned(),
    }
}
