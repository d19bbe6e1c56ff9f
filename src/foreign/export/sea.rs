//! Gravity, water, bed, current and waves as options.

use std::f64::consts::{FRAC_PI_2, TAU};

use super::number::{all_written, written};
use super::sheet::Sheet;
use crate::case::{DragLength, OneOrMany, Waves};
use crate::numerics::DepthGrid;
use crate::system::bed::Bed;
use crate::system::model::StartPlacement;
use crate::system::{SolvedSystem, SystemFile};

/// Push and damping of a bed that nothing touches \[Pa/m, Pa s/m\]: the defaults of MoorDyn.
const BED: [f64; 2] = [3.0e6, 3.0e5];

/// Name of the file of depths over a grid.
const DEPTHS: &str = "seafloor.txt";

/// Writes the options of MoorDyn.
pub fn options(solved: &SolvedSystem, step: f64, sheet: &mut Sheet) {
    let file = &solved.file;
    let mut option = |value: String, name: &'static str| sheet.options.push((value, name));
    option(written(step), "dtM");
    option("RK4".to_owned(), "tScheme");
    option(written(file.environment.gravity_m_per_s2), "g");
    option(
        written(file.environment.water_density_kg_per_m3),
        "WtrDnsty",
    );
    let start = &file.start;
    if start.placement == StartPlacement::Given && start.parts.is_none() {
        option(written(0.0), "TmaxIC");
    }
    bed_options(solved, sheet);
    current_options(file, sheet);
    if !file.waves.is_empty() {
        sheet.options.push(("7".to_owned(), "WaveKin"));
        sheet
            .files
            .push(("wave_frequencies.txt".to_owned(), components(solved)));
    }
    if !solved.network.crossed && rises_out(solved) {
        sheet.remarks.push(
            "MoorDyn weighs what is above the water as in air, here it counts as under water (environment.water_surface)."
                .to_owned(),
        );
    }
    if file.environment.drag_length == DragLength::Stretched {
        sheet.remarks.push(
            "Drag acts on the unstretched length of lines in MoorDyn, here on the stretched."
                .to_owned(),
        );
    }
}

/// Writes depth, contact and friction of the bed.
fn bed_options(solved: &SolvedSystem, sheet: &mut Sheet) {
    let file = &solved.file;
    let mut option = |value: String, name: &'static str| sheet.options.push((value, name));
    match &file.seabed {
        Some(bed) => {
            option(written(bed.depth_m), "WtrDpth");
            if bed.depth_file.is_some() {
                option(DEPTHS.to_owned(), "SeafloorFile");
            }
            option(written(bed.stiffness_n_per_m3), "kBot");
            option(written(bed.damping_n_s_per_m3), "cBot");
            let friction = common_friction(file);
            if friction > 0.0 {
                option(written(friction), "FrictionCoefficient");
            }
        }
        // Without a depth MoorDyn has its bed at the deepest fixed point.
        None => {
            option(written(far_bed(solved)), "WtrDpth");
            option(written(BED[0]), "kBot");
            option(written(BED[1]), "cBot");
        }
    }
    if let Some(Bed::Grid(grid)) = &solved.network.bed {
        sheet.files.push((DEPTHS.to_owned(), depths(grid)));
    }
}

/// Writes the current by depth, or the file that it is given by.
fn current_options(file: &SystemFile, sheet: &mut Sheet) {
    if let Some((current, speed)) = file
        .current
        .as_ref()
        .and_then(|current| Some((current, current.speed_m_per_s.as_ref()?)))
    {
        sheet.options.push(("1".to_owned(), "Currents"));
        let text = profile(speed, &current.direction_deg, current.depth_m.as_deref());
        sheet.files.push(("current_profile.txt".to_owned(), text));
    }
    if let Some((mode, name, text)) = current_by_file(file) {
        sheet.options.push((mode.to_owned(), "Currents"));
        // Files are written with the ends of lines of Unix.
        sheet.files.push((name.to_owned(), text.replace('\r', "")));
    }
}

/// Whether a line ends above the water.
pub fn rises_out(solved: &SolvedSystem) -> bool {
    let places = &solved.rest.placement.points;
    let mut ends = solved
        .network
        .lines
        .iter()
        .flat_map(|line| [line.from, line.to]);
    solved.network.density > 0.0 && ends.any(|point| places[point].z > 0.0)
}

/// Depths over a grid in the form of MoorDyn: counts, places along x and y, and heights of the bed, which are negative.
fn depths(grid: &DepthGrid) -> String {
    let [x, y] = grid.places();
    let mut text = format!("{} {}\n", x.len(), y.len());
    for places in [x, y] {
        text += &format!("{}\n", all_written(places));
    }
    for (x, y) in y.iter().flat_map(|y| x.iter().map(move |x| (*x, *y))) {
        text += &format!("{}\n", all_written(&[x, y, -grid.at(x, y).depth]));
    }
    text
}

/// A depth \[m\] well below everything.
fn far_bed(solved: &SolvedSystem) -> f64 {
    let lengths = solved.file.lines.iter().map(|line| {
        line.length_m
            .unwrap_or_else(|| line.sections.iter().map(|section| section.length_m).sum())
    });
    let longest = lengths.fold(0.0, f64::max);
    let points = solved.rest.placement.points.iter();
    let deepest = points.map(|place| -place.z).fold(0.0, f64::max);
    let far = 2.0 * (deepest + longest);
    // A round number: the same from places that differ in their last digits.
    (far / 100.0).ceil() * 100.0
}

/// Rows of height and velocity.
fn profile(speed: &OneOrMany, direction: &OneOrMany, depths: Option<&[f64]>) -> String {
    let at = |of: &OneOrMany, k: usize| match of {
        OneOrMany::One(value) => *value,
        OneOrMany::Many(all) => all.get(k).copied().unwrap_or(0.0),
    };
    let depths = depths.unwrap_or(&[0.0]);
    let mut text = "CURRENT PROFILE\nz  ux  uy  uz\n(m)  (m/s)  (m/s)  (m/s)\n".to_owned();
    for (k, depth) in depths.iter().enumerate() {
        let (speed, angle) = (at(speed, k), at(direction, k).to_radians());
        text += &format!(
            "{}  {}  {}  0\n",
            written(-depth),
            written(speed * angle.cos()),
            written(speed * angle.sin())
        );
    }
    text
}

/// Rows of angular frequency, complex amplitude and direction, rising from a frequency of 0 as `MoorDyn` wants it. Elevations at nodes
/// (`WaveKin` 7) are sines of the phase, here cosines.
fn components(solved: &SolvedSystem) -> String {
    let mut all: Vec<[f64; 4]> = solved.file.waves.iter().flat_map(regular_waves).collect();
    all.sort_by(|one, other| one[0].total_cmp(&other[0]));
    let mut text = "0 0 0 0\n".to_owned();
    for [frequency, amplitude, phase, direction] in all {
        let (sin, cos) = (phase + FRAC_PI_2).sin_cos();
        // What is left of a zero by rounding is none.
        let part = |of: f64| {
            if of.abs() < 1e-12 {
                0.0
            } else {
                amplitude * of
            }
        };
        text += &format!(
            "{} {} {} {}\n",
            written(frequency),
            written(part(cos)),
            written(part(sin)),
            written(direction)
        );
    }
    text
}

/// The regular waves of a wave system: angular frequency \[rad/s\], amplitude \[m\], phase and direction \[rad\].
fn regular_waves(waves: &Waves) -> Vec<[f64; 4]> {
    let direction = waves.direction_deg.to_radians();
    let one = |height: f64, period: f64, phase: f64| {
        [TAU / period, 0.5 * height, phase.to_radians(), direction]
    };
    match (
        waves.height_m,
        waves.period_s,
        &waves.heights_m,
        &waves.periods_s,
    ) {
        (Some(height), Some(period), _, _) => vec![one(height, period, waves.phase_deg)],
        (_, _, Some(heights), Some(periods)) => {
            let phase = |k: usize| {
                let phases = waves.phases_deg.as_ref();
                phases.and_then(|all| all.get(k)).copied().unwrap_or(0.0)
            };
            let pairs = heights.iter().zip(periods).enumerate();
            pairs
                .map(|(k, (height, period))| one(*height, *period, phase(k)))
                .collect()
        }
        _ => Vec::new(),
    }
}

/// The option and the text of a current by a file of MoorDyn's own that the case carries; nothing for other currents.
#[must_use]
pub fn current_by_file(file: &SystemFile) -> Option<(&'static str, &str, &str)> {
    let name = file.current.as_ref()?.file.as_deref()?;
    let mode = match name {
        "current_profile_dynamic.txt" => "2",
        "current_profile_4d.txt" => "5",
        _ => return None,
    };
    Some((mode, name, &file.files.get(name)?.text))
}

/// The friction of the bed that all lines have, as `MoorDyn` knows it; that of the bed where they differ.
#[must_use]
pub fn common_friction(file: &SystemFile) -> f64 {
    let of_bed = file
        .seabed
        .as_ref()
        .and_then(|bed| bed.friction)
        .unwrap_or(0.0);
    let mut lines = file.lines.iter().map(|line| file.friction_under(line)[0]);
    let Some(first) = lines.next() else {
        return of_bed;
    };
    match lines.all(|other| other == first) {
        true => first,
        false => of_bed,
    }
}
