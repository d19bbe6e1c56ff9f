//! The three chains of the VolturnUS-S platform, their fairleads moved by 3 m in 12 s, as each program reads them.
//!
//! Allen et al. 2020, NREL/TP-5000-76773: lengths, masses and stiffness as in `cases/systems/volturnus.toml`.

use std::f64::consts::TAU;

use crate::waves;

pub(crate) const DURATION_S: f64 = 120.0;
/// Rows are compared at these times \[s\].
pub(crate) const COMPARED_S: f64 = 0.5;
const AMPLITUDE_M: f64 = 3.0;
const PERIOD_S: f64 = 12.0;

const DEPTH_M: f64 = 200.0;
const ANCHOR_M: f64 = 837.6;
const FAIRLEAD_M: [f64; 2] = [58.0, -14.0];
const LENGTH_M: f64 = 850.0;
const DIAMETER_M: f64 = 0.333;
const MASS_KG_PER_M: f64 = 685.0;
const EA_N: f64 = 3.27e9;
const AXIAL_DAMPING_N_S: f64 = 3e6;
/// Drag across and along, added mass across and along.
const WATER: [f64; 4] = [1.11, 0.2, 0.82, 0.27];
const DENSITY: f64 = 1025.0;
const BED: [f64; 2] = [1e5, 1e4];
/// Headings of the lines; the first is that along which the fairleads are moved.
const HEADINGS_DEG: [f64; 3] = [180.0, 300.0, 420.0];

/// The waves of a scene, and how MoorDyn has them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Sea {
    Still,
    /// Read off a grid (`WaveKin` 3).
    Grid,
    /// Summed at the nodes (`WaveKin` 7).
    Summed,
}

/// Displacement \[m\], velocity and acceleration along x: a sine that grows over two periods, twice continuously differentiable.
fn moved(time: f64) -> [f64; 3] {
    let ramp_s = 2.0 * PERIOD_S;
    let s = (time / ramp_s).min(1.0);
    let r = s * s * s * (10.0 - 15.0 * s + 6.0 * s * s);
    let r1 = 30.0 * s * s * (1.0 - s) * (1.0 - s) / ramp_s;
    let r2 = 60.0 * s * (1.0 - s) * (1.0 - 2.0 * s) / (ramp_s * ramp_s);
    let w = TAU / PERIOD_S;
    let (sin, cos) = (w * time).sin_cos();
    [
        r * sin,
        r1 * sin + r * w * cos,
        r2 * sin + 2.0 * r1 * w * cos - r * w * w * sin,
    ]
    .map(|value| AMPLITUDE_M * value)
}

fn times(call_s: f64) -> impl Iterator<Item = f64> {
    let count = (DURATION_S / call_s).round() as usize;
    (0..=count).map(move |k| k as f64 * call_s)
}

/// Rows of calls between two that are compared.
pub(crate) fn calls_a_row(call_s: f64) -> usize {
    (COMPARED_S / call_s).round() as usize
}

/// Places of the anchors and of the fairleads.
fn places() -> Vec<[f64; 3]> {
    let at = |radius: f64, z: f64| {
        HEADINGS_DEG.map(|heading| {
            let (sin, cos) = heading.to_radians().sin_cos();
            [radius * cos, radius * sin, z]
        })
    };
    [at(ANCHOR_M, -DEPTH_M), at(FAIRLEAD_M[0], FAIRLEAD_M[1])].concat()
}

/// The line that is compared.
pub(crate) const LINE_HERE: &str = "chain";

/// The system here, its motion in a table with a row for each call.
pub(crate) fn here(segments: usize, call_s: f64, sea: Sea, solver: &str) -> String {
    let rows: Vec<f64> = times(call_s).collect();
    let along: Vec<f64> = rows.iter().map(|time| moved(*time)[0]).collect();
    let [normal, tangential, added, added_along] = WATER;
    let waves = if sea == Sea::Still {
        String::new()
    } else {
        waves::here()
    };
    format!(
        "[system]\ntitle = \"Three chains\"\n\
         [environment]\ngravity_m_per_s2 = 9.80665\nwater_density_kg_per_m3 = {DENSITY:?}\ndrag_length = \"unstretched\"\n\
         [seabed]\ndepth_m = {DEPTH_M:?}\nstiffness_n_per_m3 = {:?}\ndamping_n_s_per_m3 = {:?}\n\
         [materials.chain]\ndiameter_m = {DIAMETER_M:?}\nmass_kg_per_m = {MASS_KG_PER_M:?}\nea_n = {EA_N:?}\naxial_damping_n_s = {AXIAL_DAMPING_N_S:?}\n\
         drag_normal = {normal:?}\ndrag_tangential = {tangential:?}\ndrag_tangential_width = \"perimeter\"\n\
         added_mass_normal = {added:?}\nadded_mass_tangential = {added_along:?}\n\
         [bodies.platform]\nkind = \"moved\"\ntable_time_s = {rows:?}\ntable_x_m = {along:?}\n\
         [points.anchor]\nkind = \"fixed\"\nposition_m = [{:?}, 0.0, {:?}]\n\
         [points.fairlead]\nkind = \"body\"\nbody = \"platform\"\nposition_m = [{:?}, 0.0, {:?}]\n\
         [[lines]]\nname = \"{LINE_HERE}\"\nfrom = \"anchor\"\nto = \"fairlead\"\nmaterial = \"chain\"\nlength_m = {LENGTH_M:?}\nsegments = {segments}\n\
         repeat_at_deg = [0.0, 120.0, 240.0]\n\
         [solver]\nduration_s = {DURATION_S:?}\nerror_estimate = false\n{solver}\n[output]\ninterval_s = {COMPARED_S:?}\n{waves}",
        BED[0], BED[1], -ANCHOR_M, -DEPTH_M, -FAIRLEAD_M[0], FAIRLEAD_M[1],
    )
}

/// The file of MoorDyn.
pub(crate) fn moordyn(segments: usize, step_s: f64, sea: Sea) -> String {
    let points: String = (1..)
        .zip(places())
        .map(|(id, [x, y, z])| {
            let kind = if id <= HEADINGS_DEG.len() {
                "Fixed"
            } else {
                "Coupled"
            };
            format!("{id} {kind} {x} {y} {z} 0 0 0 0\n")
        })
        .collect();
    let count = HEADINGS_DEG.len();
    let lines: String = (1..=count)
        .map(|id| format!("{id} chain {id} {} {LENGTH_M} {segments} -\n", id + count))
        .collect();
    let waves = match sea {
        Sea::Still => "",
        Sea::Grid => "3 WaveKin\n0.25 dtWave\n",
        Sea::Summed => "7 WaveKin\n",
    };
    let [normal, tangential, added, added_along] = WATER;
    format!(
        "--- MoorDyn ---\nThree chains\n--- LINE TYPES ---\nName Diam Mass/m EA BA/-zeta EI Cd Ca CdAx CaAx\n(name) (m) (kg/m) (N) (N-s/-) (N-m^2) (-) (-) (-) (-)\n\
         chain {DIAMETER_M} {MASS_KG_PER_M} {EA_N} {AXIAL_DAMPING_N_S} 0 {normal} {added} {tangential} {added_along}\n\
         --- POINTS ---\nID Type X Y Z Mass Volume CdA Ca\n(#) (-) (m) (m) (m) (kg) (m^3) (m^2) (-)\n{points}\
         --- LINES ---\nID Type AttachA AttachB UnstrLen NumSegs Outputs\n(#) (name) (#) (#) (m) (-) (-)\n{lines}\
         --- OPTIONS ---\nRK4 tScheme\n{step_s} dtM\n0 writeLog\n{DEPTH_M} WtrDpth\n{DENSITY} WtrDnsty\n9.80665 g\n{} kBot\n{} cBot\n0 TmaxIC\n\
         1000 dtOut\n{waves}--- need this line ---\n",
        BED[0], BED[1],
    )
}

/// The motion of MoorDyn: a row for each call.
pub(crate) fn moordyn_motion(call_s: f64) -> String {
    let fairleads = &places()[HEADINGS_DEG.len()..];
    let row = |time: f64| {
        let [along, ..] = moved(time);
        let at = |place: &[f64; 3]| format!(" {} {} {}", place[0] + along, place[1], place[2]);
        format!("{time}{}\n", fairleads.iter().map(at).collect::<String>())
    };
    times(call_s).map(row).collect()
}

/// The deck of CableDyn.
pub(crate) fn cable_dyn(segments: usize, step_s: f64) -> String {
    let count = HEADINGS_DEG.len();
    let points: String = (1..)
        .zip(places())
        .map(|(id, [x, y, z])| {
            let kind = if id <= count { "Fixed" } else { "Coupled" };
            format!("{id} {kind} {x} {y} {z}\n")
        })
        .collect();
    let lines: String = (1..=count)
        .map(|id| format!("{id} {id} {} -\n", id + count))
        .collect();
    let sections: String = (1..=count)
        .map(|id| format!("{id} chain {LENGTH_M} {segments}\n"))
        .collect();
    let [normal, tangential, added, added_along] = WATER;
    format!(
        "--- CableDyn Input File ---\nThree chains\n--- LINE TYPES ---\nName Diam Mass EA BA EI Cdn Cdt Can Cat\n(-) (m) (kg/m) (N) (N-s) (N-m^2) (-) (-) (-) (-)\n\
         chain {DIAMETER_M} {MASS_KG_PER_M} {EA_N} {AXIAL_DAMPING_N_S} 0 {normal} {tangential} {added} {added_along}\n\
         --- POINTS ---\nID Type X Y Z\n(#) (-) (m) (m) (m)\n{points}--- LINES ---\nID NodeA NodeB Outputs\n(#) (#) (#) (-)\n{lines}\
         --- SECTIONS ---\nLineID LineType Length NumSegs\n(#) (-) (m) (-)\n{sections}\
         --- OPTIONS ---\n9.80665 g\n{DENSITY} WtrDnsty\n{DEPTH_M} WtrDpth\n{} kBot\n{} cBot\n{step_s} dtM\n{DURATION_S} TMax\n--- OUTPUTS ---\n\"FairTen1\"\n--- need this line ---\n",
        BED[0], BED[1],
    )
}

/// The motion of CableDyn: displacement, velocity and acceleration in a row for each step.
pub(crate) fn cable_dyn_motion(step_s: f64) -> String {
    let row = |time: f64| {
        let [x, v, a] = moved(time);
        format!("{time} {x} {v} {a}\n")
    };
    times(step_s).map(row).collect()
}
