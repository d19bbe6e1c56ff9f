//! Members of bodies: sums over their part in the water, and their ends.

use std::f64::consts::{PI, TAU};
use std::path::PathBuf;
use std::sync::atomic::AtomicBool;

use seacable::case::kind;
use seacable::export::{ExportOptions, Target, export};
use seacable::import::ImportOptions;
use seacable::system::analysis::periods::periods;
use seacable::system::motion::run::{MotionRun, run};
use seacable::system::warnings::warnings;
use seacable::system::{SolvedSystem, SystemFile};

const RHO: f64 = 1025.0;
const G: f64 = 9.80665;

pub(crate) fn file(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
        .join("tests/trials/files")
        .join(name)
}

pub(crate) fn read(name: &str) -> SolvedSystem {
    seacable::open::load_as::<SystemFile>(&file(name), &ImportOptions::default())
        .unwrap()
        .computed
}

pub(crate) fn parsed(text: &str) -> SolvedSystem {
    let text = format!("[system]\ntitle = \"t\"\n{text}");
    kind::parse::<SystemFile>(&text, "t.toml").unwrap()
}

fn moved(text: &str) -> MotionRun {
    let system = parsed(text);
    let solver = system.file.solver.clone().unwrap();
    let done = run(&system, &solver, &AtomicBool::new(false), &mut |_| {}).unwrap();
    assert_eq!(done.failure, None);
    done
}

fn channel<'a>(run: &'a MotionRun, name: &str) -> &'a [f64] {
    &run.history.channel(name).unwrap().values
}

/// The natural period of a direction of a body \[s\].
fn period(system: &SolvedSystem, direction: &str) -> f64 {
    let modes = periods(&system.network, &system.rest).unwrap().modes;
    let mut named = modes
        .iter()
        .filter(|mode| mode.names(&system.network).1 == direction);
    named.next().unwrap().period_s.unwrap()
}

/// Periods of two coupled motions, longest first: `K x = w² M x`.
fn two(mass: [f64; 3], stiffness: [f64; 2]) -> [f64; 2] {
    let [m11, m12, m22] = mass;
    let [k1, k2] = stiffness;
    let (a, b, c) = (m11 * m22 - m12 * m12, m11 * k2 + m22 * k1, k1 * k2);
    let root = (b * b - 4.0 * a * c).sqrt();
    [(b - root) / (2.0 * a), (b + root) / (2.0 * a)].map(|w2| TAU / w2.sqrt())
}

/// A buoy of 8 m draft between two strings: its part in air has no added mass, so that its freeboard changes no period. Closed form: surge and
/// pitch with the strings' stiffness, pitch 8.287 s. Before: 8.552 and 7.993 s.
#[test]
fn freeboard_changes_no_period() {
    let (g, draft, radius, tension) = (9.81, 8.0_f64, 3.0_f64, 2e6 * (97.0 / 95.0 - 1.0));
    let area = PI * radius * radius;
    let (mass, centre) = (RHO * area * draft, -4.5);
    let added = 0.9 * RHO * area;
    let surge = mass + added * draft;
    let coupled = mass * centre - added * draft * draft / 2.0;
    let turning = 4e6 + mass * centre * centre + added * draft.powi(3) / 3.0;
    let righting = mass * g * (-draft / 2.0 - centre) + RHO * g * PI * radius.powi(4) / 4.0;
    let strings = 2.0 * tension * radius * (1.0 + radius / 97.0);
    let stiffness = [2.0 * 2e6 / 95.0, righting + strings];
    let closed = two([surge, coupled, turning], stiffness);
    assert!((closed[1] - 8.287).abs() < 0.001, "{closed:?}");
    let found = ["freeboard_0.toml", "freeboard_1.toml"].map(|name| period(&read(name), "pitch"));
    for found in found {
        assert!((found / closed[1] - 1.0).abs() < 1e-5, "{found} {closed:?}");
    }
    assert!((found[0] / found[1] - 1.0).abs() < 1e-10, "{found:?}");
}

/// Pitch of a spar with surge condensed, added mass over the 79.97 m in the water: 13.0079 s (CableDyn 13.007). Before: 13.163 s.
#[test]
fn a_spar_pitches_with_the_added_mass_of_its_part_in_the_water() {
    let (mass, centre, inertia, radius) =
        (4.12e6, -66.177_184_466_019_41, 933_590_655.339_805_8, 4.0);
    let area = PI * radius * radius;
    let draft = mass / (RHO * area);
    let rises = 80.0 - draft;
    let (added, top, foot) = (RHO * area, -rises, -80.0_f64);
    let surge = mass + added * draft;
    let coupled = mass * centre + added * (top * top - foot * foot) / 2.0;
    let about = added * (top.powi(3) - foot.powi(3)) / 3.0;
    let turning = inertia + mass * centre * centre + about;
    let buoyant = 0.5 * (top + foot);
    let righting = mass * G * (buoyant - centre) + RHO * G * PI * f64::powi(radius, 4) / 4.0;
    let closed = TAU * ((turning - coupled * coupled / surge) / righting).sqrt();
    assert!((closed - 13.0079).abs() < 1e-4, "{closed}");
    let found = period(&read("spar_added_mass.toml"), "pitch");
    assert!((found / closed - 1.0).abs() < 1e-8, "{found} {closed}");
}

/// Heave of a spar with the added mass of its end, rho CaEnd 2/3 pi r³ (as MoorDyn, RAFT and CableDyn have it): 18.1206 s. Before: 17.942 s,
/// with a note that CdEnd and CaEnd do not act.
#[test]
fn a_spar_heaves_with_the_added_mass_of_its_end() {
    let system = read("spar_end_added_mass.txt");
    let mass = 4.12e6 + RHO * 0.6 * 2.0 / 3.0 * PI * 64.0;
    let closed = TAU * (mass / (RHO * G * PI * 16.0)).sqrt();
    assert!((closed - 18.1206).abs() < 1e-4, "{closed}");
    let found = period(&system, "heave");
    assert!((found / closed - 1.0).abs() < 1e-8, "{found} {closed}");
    assert!(!system.file.about.notes.contains("do not act"));
    let member = &system.file.bodies["body1"].members[0];
    assert_eq!([member.drag_end, member.added_mass_end], [0.6, 0.6]);
    // And back.
    let made = export(&system, Target::MoorDyn, ExportOptions::default()).unwrap();
    let row = made.text.lines().find(|line| line.starts_with("rod1 "));
    let numbers: Vec<f64> = row
        .unwrap()
        .split_whitespace()
        .skip(1)
        .map(|word| word.parse().unwrap())
        .collect();
    assert_eq!(numbers, [8.0, 0.0, 0.8, 1.0, 0.6, 0.6]);
}

/// A cylinder of 20 m draft and 3 m radius in heave, with these keys of its member.
fn heaving(keys: &str, more: &str) -> String {
    let mass = RHO * PI * 9.0 * 20.0;
    format!(
        "[bodies.spar]\nkind = \"free\"\nmass_kg = {mass:?}\ncentre_of_gravity_m = [0.0, 0.0, -14.0]\ninertia_kg_m2 = [4e7, 4e7, 3e6]\n{more}
        [[bodies.spar.members]]\nfrom_m = [0.0, 0.0, -20.0]\nto_m = [0.0, 0.0, 8.0]\ndiameter_m = 6.0\n{keys}\n"
    )
}

fn solver(duration: f64, step: f64) -> String {
    format!(
        "[solver]\nduration_s = {duration:?}\ntime_step_s = {step:?}\nerror_estimate = false\n[output]\ninterval_s = {step:?}\n"
    )
}

/// The highest places of a swing, by parabolas through three rows, with their times.
fn crests(run: &MotionRun, name: &str) -> Vec<(f64, f64)> {
    let (time, values) = (&run.history.time, channel(run, name));
    let step = time[1] - time[0];
    let rows = values.windows(3).enumerate();
    let tops = rows.filter(|(_, z)| z[1] > z[0] && z[1] >= z[2]);
    tops.map(|(k, z)| {
        let (slope, bend) = (0.5 * (z[2] - z[0]), z[2] - 2.0 * z[1] + z[0]);
        let off = -slope / bend;
        (time[k + 1] + off * step, z[1] - 0.5 * slope * slope / bend)
    })
    .collect()
}

/// A spar let go 1 m too high: its period is that of the added mass of its foot, and from swing to swing 1/a grows by 8 b/(3 m), b the quadratic
/// drag of the foot. Its other end is in air and has neither.
#[test]
fn an_end_in_the_water_drags_and_has_inertia() {
    let keys = "drag_end = 5.0\nadded_mass_end = 1.5";
    let run = moved(&format!(
        "[environment]\nwater_density_kg_per_m3 = 1025.0\n{}{}",
        heaving(keys, "start_offset_m = [0.0, 0.0, 1.0]"),
        solver(80.0, 0.02)
    ));
    let crests = crests(&run, "z_m[spar]");
    let mass = RHO * (PI * 9.0 * 20.0 + 1.5 * 2.0 / 3.0 * PI * 27.0);
    let period = TAU * (mass / (RHO * G * PI * 9.0)).sqrt();
    let drag = 0.5 * RHO * 5.0 * PI * 9.0;
    let last = crests.len() - 1;
    let found = (crests[last].0 - crests[0].0) / last as f64;
    assert!((found / period - 1.0).abs() < 2e-3, "{found} {period}");
    let grows = 8.0 * drag / (3.0 * mass);
    let found = (1.0 / crests[last].1 - 1.0 / crests[0].1) / last as f64;
    assert!((found / grows - 1.0).abs() < 0.02, "{found} {grows}");
}

/// In long waves the force on the foot of a spar is (rho g A - w² rho CaEnd 2/3 pi r³) a exp(-k d).
#[test]
fn an_end_feels_the_acceleration_of_the_waves() {
    let (amplitude, period, added, damping) = (0.05, 9.0, 1.5, 2e5);
    let omega = TAU / period;
    let run = moved(&format!(
        "[environment]\nwater_density_kg_per_m3 = 1025.0\n[[waves]]\nkind = \"regular\"\nheight_m = {:?}\nperiod_s = {period:?}\nramp_s = 30.0\n{}{}",
        2.0 * amplitude,
        heaving(
            &format!("added_mass_end = {added:?}"),
            &format!("damping = [0.0, 0.0, {damping:?}, 1e7, 1e7, 1e6]")
        ),
        solver(150.0, 0.05)
    ));
    let end = RHO * added * 2.0 / 3.0 * PI * 27.0;
    let mass = RHO * PI * 9.0 * 20.0 + end;
    let stiffness = RHO * G * PI * 9.0;
    let force = (stiffness - omega * omega * end) * (-omega * omega / G * 20.0).exp();
    let exact = amplitude * force / (stiffness - omega * omega * mass).hypot(damping * omega);
    let (time, values) = (&run.history.time, channel(&run, "z_m[spar]"));
    let from = time.len() - (5.0 * period / 0.05).round() as usize;
    let rows = time[from..].iter().zip(&values[from..]);
    let (mut sin, mut cos) = (0.0, 0.0);
    for (t, z) in rows {
        sin += z * (omega * t).sin();
        cos += z * (omega * t).cos();
    }
    let found = 2.0 / (time.len() - from) as f64 * f64::hypot(sin, cos);
    assert!((found / exact - 1.0).abs() < 0.01, "{found} {exact}");
}

/// A member that is written as two has the same periods as in one, with the inner ends without coefficients.
#[test]
fn a_member_in_two_parts_is_the_member() {
    let keys = "added_mass_normal = 0.9\nadded_mass_end = 0.7";
    let whole = parsed(&heaving(keys, ""));
    for cut in [-13.0, -0.4, 0.3, 5.0] {
        let first = heaving(&format!("{keys}\nto_added_mass_end = 0.0"), "").replace(
            "to_m = [0.0, 0.0, 8.0]",
            &format!("to_m = [0.0, 0.0, {cut:?}]"),
        );
        let second = format!(
            "[[bodies.spar.members]]\nfrom_m = [0.0, 0.0, {cut:?}]\nto_m = [0.0, 0.0, 8.0]\ndiameter_m = 6.0\nadded_mass_normal = 0.9\nto_added_mass_end = 0.7\n"
        );
        let parts = parsed(&format!("{first}{second}"));
        for direction in ["heave", "roll", "pitch"] {
            let (one, two) = (period(&whole, direction), period(&parts, direction));
            assert!((one / two - 1.0).abs() < 1e-9, "{cut}: {one} {two}");
        }
    }
}

/// A volume that the body states and its members displace again counts twice: that is said, with both.
#[test]
fn water_that_is_displaced_twice_is_said() {
    let said = |keys: &str, member: &str| warnings(&parsed(&heaving(member, keys))).join("\n");
    let volume = "volume_m3 = 3.0";
    let twice = said(volume, "");
    assert!(twice.contains("volume_m3 (3 m3)"), "{twice}");
    assert!(twice.contains("565.5 m3 in the water"), "{twice}");
    assert_eq!(said("", ""), "");
    let plane = "waterplane_stiffness = [0.0, 0.0, 1e5, 1e6, 1e6, 0.0]";
    assert!(said(plane, "").contains("waterplane_stiffness and members"));
}
