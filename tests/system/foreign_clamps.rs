//! Files of MoorDyn whose rods hold lines that bend: on bodies, free, pinned, and as modules on a cable.

use seacable::audit::lumped::equilibrium::at_rest;
use seacable::case::kind;
use seacable::export::{ExportOptions, Target, export};
use seacable::import::{self, ImportOptions};
use seacable::numerics::V3;
use seacable::system::quantities::value;
use seacable::system::{SolvedSystem, SystemFile};

use crate::audit::model_of;
use crate::motion::{channel, moved};

/// A power cable clamped at its hang-off by a rod without length on a body, between three mooring lines, all in own numbers.
const HANG_OFF: &str = "\
--- LINE TYPES ---
TypeName Diam Mass/m EA BA/-zeta EI Cd Ca CdAx CaAx
(name) (m) (kg/m) (N) (N-s/-) (N-m^2) (-) (-) (-) (-)
cable 0.15 32 4e8 -1 9000 1.2 1 0.1 0
moor 0.1 60 5e8 -1 0 1.2 1 0.1 0
--- ROD TYPES ---
TypeName Diam Mass/m Cd Ca CdEnd CaEnd
(name) (m) (kg/m) (-) (-) (-) (-)
none 0.1 0 0 0 0 0
col 6 15000 1 1 1 1
--- BODIES ---
ID Attachment X0 Y0 Z0 r0 p0 y0 Mass CG* I* Volume CdA* Ca
(#) (-) (m) (m) (m) (deg) (deg) (deg) (kg) (m) (kg-m^2) (m^3) (m^2) (-)
1 Coupled 0 0 0 0 0 0 300000 0|0|-15 1e7 0 0 0
--- RODS ---
ID RodType Attachment Xa Ya Za Xb Yb Zb NumSegs RodOutputs
(#) (name) (#/key) (m) (m) (m) (m) (m) (m) (-) (-)
1 col Body1 0 0 -20 0 0 10 10 p
2 none Body1 3 0 -15 3.5 0 -15.866 0 p
--- POINTS ---
ID Attachment X Y Z Mass Volume CdA Ca
(#) (-) (m) (m) (m) (kg) (m^3) (m^2) (-)
1 Fixed 90 0 -80 0 0 0 0
2 Fixed -300 0 -80 0 0 0 0
3 Body1 -3 0 -15 0 0 0 0
4 Fixed 300 200 -80 0 0 0 0
5 Body1 3 1 -15 0 0 0 0
6 Fixed 300 -200 -80 0 0 0 0
7 Body1 3 -1 -15 0 0 0 0
--- LINES ---
ID LineType AttachA AttachB UnstrLen NumSegs LineOutputs
(#) (name) (#) (#) (m) (-) (-)
1 cable 1 R2B 130 40 -
2 moor 2 3 310 20 -
3 moor 4 5 370 20 -
4 moor 6 7 370 20 -
--- OPTIONS ---
0.001 dtM
80 WtrDpth
";

/// The text of the case that a file is.
fn read(text: &str) -> String {
    import::read(text, "case.dat", &ImportOptions::default())
        .unwrap()
        .text
}

fn solved(text: &str) -> SolvedSystem {
    kind::parse::<SystemFile>(&read(text), "case.toml").unwrap_or_else(|all| panic!("{all:?}"))
}

fn assert_near(found: f64, known: f64, share: f64) {
    assert!(
        (found - known).abs() <= share * known.abs(),
        "{found} is not {known}"
    );
}

#[test]
fn a_rod_on_a_body_clamps_a_cable() {
    let system = solved(HANG_OFF);
    assert_near(
        value(&system, "tension_n[line1|b]").unwrap(),
        10_911.7,
        1e-5,
    );
    assert_near(value(&system, "tension_n[line1|a]").unwrap(), 2_048.9, 1e-4);
    // As the same rod that is coupled by itself.
    let alone = HANG_OFF.replace("2 none Body1", "2 none Coupled");
    let alone = solved(&alone);
    for name in ["tension_n[line1|a]", "tension_n[line1|b]"] {
        let [one, other] = [&system, &alone].map(|system| value(system, name).unwrap());
        assert_near(one, other, 1e-9);
    }
}

/// MoorDyn 2.7.2 has 10,676 and 2,022 N in the middle of the end segments.
#[test]
fn lumped_masses_are_clamped_as_in_moordyn() {
    let model = model_of(HANG_OFF, 1);
    let rest = at_rest(&model, &model.start).unwrap();
    assert_near(model.end_tension(0, &rest), 10_676.0, 5e-3);
    assert_near(model.tension(0, 0, &rest), 2_022.0, 2e-2);
}

/// Turned and shifted with its body, the rod is where it was.
#[test]
fn the_axis_of_a_rod_is_that_in_the_frame_of_its_body() {
    let straight = solved(HANG_OFF);
    let turned = HANG_OFF
        .replace("1 Coupled 0 0 0 0 0 0", "1 Coupled 0 0 0 0 0 90")
        .replace(
            "2 none Body1 3 0 -15 3.5 0 -15.866",
            "2 none Body1 0 -3 -15 0 -3.5 -15.866",
        );
    let turned = solved(&turned);
    let name = "tension_n[line1|b]";
    assert_near(
        value(&turned, name).unwrap(),
        value(&straight, name).unwrap(),
        1e-8,
    );
}

#[test]
fn a_free_body_feels_the_clamp_and_is_written_as_a_rod_again() {
    let free = HANG_OFF.replace("1 Coupled 0 0 0 0 0 0 300000", "1 Free 0 0 0 0 0 0 300000");
    let system = solved(&free);
    let name = "tension_n[line1|b]";
    let tension = value(&system, name).unwrap();
    let clamped = system.rest.balance.lines[0].clamped().unwrap();
    assert!(clamped.force_n_m[1].norm() > 1e3);
    let made = export(&system, Target::MoorDyn, ExportOptions::default()).unwrap();
    let rod = made
        .text
        .lines()
        .find(|row| row.contains("joint") && row.contains("Body1"));
    assert!(rod.is_some(), "{}", made.text);
    let again = solved(&made.text);
    assert_near(value(&again, name).unwrap(), tension, 1e-6);
}

/// A rod between two lines on a cable, as a module: by a section as stiff as it.
fn module(middle: &str, pieces: [&str; 2]) -> String {
    format!(
        "--- LINE TYPES ---
Name Diam Mass/m EA BA/-zeta EI Cd Ca CdAx CaAx
(-)
cable 0.1 12 4e7 -1 6e3 1.1 1 0.01 0
stiff 0.4 100 4e9 -1 4e7 1.1 1 0.01 0
--- ROD TYPES ---
Name Diam Mass/m Cd Ca CdEnd CaEnd
(-)
module 0.4 100 1.1 1 0 0
joint 0.1 0 0 0 0 0
--- RODS ---
ID RodType Attachment Xa Ya Za Xb Yb Zb NumSegs Outputs
(-)
{middle}
--- POINTS ---
ID Type X Y Z M V CdA Ca
(-)
1 Fixed 0 0 -30 0 0 0 0
2 Fixed 30 0 -30 0 0 0 0
--- LINES ---
ID LineType AttachA AttachB UnstrLen NumSegs Outputs
(-)
1 cable 1 {} 20 60 -
2 cable {} 2 20 60 -
{}
--- OPTIONS ---
200 WtrDpth
",
        pieces[0],
        pieces[1],
        if middle.contains("joint") {
            "3 stiff R1B R2A 2 12 -"
        } else {
            ""
        },
    )
}

#[test]
fn a_module_on_a_cable_is_a_stiff_section_of_it() {
    let rod = solved(&module(
        "1 module Free 14 0 -26 16 0 -26 4 -",
        ["R1A", "R1B"],
    ));
    let section = solved(&module(
        "1 joint Free 14 0 -26 14 0 -26 0 -\n2 joint Free 16 0 -26 16 0 -26 0 -",
        ["R1A", "R2B"],
    ));
    let one = value(&rod, "tension_n[line1|a]").unwrap();
    let other = value(&section, "tension_n[line1|a]").unwrap();
    assert_near(one, other, 2e-3);
    // The module hangs level between lines that are alike.
    let pose = &rod.rest.placement.bodies[0];
    let axis = pose.arm(&V3::x());
    assert!((axis - V3::x()).norm() < 1e-6, "{axis}");
    let place = section.rest.balance.lines[0]
        .at(0.5, [&V3::zeros(), &V3::zeros()])
        .0;
    assert!(
        (pose.origin - place).norm() < 0.02,
        "{} {place}",
        pose.origin
    );
    // Both clamps hold opposite moments.
    let [first, second] =
        [0, 1].map(|line| rod.rest.balance.lines[line].clamped().unwrap().force_n_m);
    let moments = [axis.cross(&first[1]), axis.cross(&second[0])];
    assert!(moments[0].norm() > 10.0);
    assert!(
        (moments[0] + moments[1]).norm() < 1e-4 * moments[0].norm(),
        "{moments:?}"
    );
}

#[test]
fn a_module_moves_as_a_stiff_section() {
    let run = |middle: &str, pieces: [&str; 2]| {
        let case = read(&module(middle, pieces));
        let (_, case) = case.split_once("[system]").unwrap();
        let (head, tail) = case.split_once("[points.p2]").unwrap();
        let tail = tail.replacen(
            "kind = \"fixed\"",
            "kind = \"moved\"\namplitude_m = [0.3, 0.2, 0.5]\nperiod_s = 4.0\nramp_s = 4.0",
            1,
        );
        let (_, head) = head.split_once("title").unwrap();
        let (_, head) = head.split_once('\n').unwrap();
        moved(&format!(
            "{head}[points.p2]{tail}\n[solver]\nduration_s = 10.0\ntime_step_s = 0.02\nerror_estimate = false\n[output]\ninterval_s = 0.1\n"
        ))
    };
    let rod = run("1 module Free 14 0 -26 16 0 -26 4 -", ["R1A", "R1B"]);
    let section = run(
        "1 joint Free 14 0 -26 14 0 -26 0 -\n2 joint Free 16 0 -26 16 0 -26 0 -",
        ["R1A", "R2B"],
    );
    let (one, other) = (
        channel(&rod, "tension_n[line1|a]"),
        channel(&section, "tension_n[line1|a]"),
    );
    let swing = one
        .iter()
        .fold(0.0_f64, |most, v| most.max((v - one[0]).abs()));
    for (one, other) in one.iter().zip(other) {
        assert!(
            (one - other).abs() < 0.05 * swing,
            "{one} {other} of {swing}"
        );
    }
}

#[test]
fn a_pinned_rod_holds_the_direction_of_its_line() {
    let text = module("1 module Pinned 10 0 -10 12 0 -10 4 -", ["R1B", "R1B"]);
    let (head, tail) = text.split_once("2 cable R1B 2").unwrap();
    let (_, options) = tail.split_once("--- OPTIONS").unwrap();
    let case = read(&format!("{head}--- OPTIONS{options}"));
    assert!(case.contains("clamp_b_elevation_deg"), "{case}");
    assert!(case.contains("kind = \"pinned\""), "{case}");
    let system = kind::parse::<SystemFile>(&case, "case.toml").unwrap();
    let line = system.rest.balance.lines[0].clamped().unwrap();
    let axis = system.rest.placement.bodies[0].arm(&V3::x());
    // About the pin: the line at the far end, its clamp, and the weight in water of the rod.
    let displaced = 1025.0 * std::f64::consts::FRAC_PI_4 * 0.16 * 2.0;
    let weight = V3::z() * -((200.0 - displaced) * 9.80665);
    let far = axis * 2.0;
    let sum = far.cross(&system.rest.balance.lines[0].force_b)
        + (-axis).cross(&line.force_n_m[1])
        + axis.cross(&weight);
    assert!(
        sum.norm() < 1e-4 * far.cross(&weight).norm().max(100.0),
        "{sum}"
    );
}

#[test]
fn a_pinned_joint_of_several_lines_that_bend_is_refused() {
    let text = module("1 module Pinned 15 0 -26 15 0 -26 0 -", ["R1A", "R1A"]);
    let found = import::read(&text, "case.dat", &ImportOptions::default()).unwrap_err();
    let found = format!("{found:?}");
    assert!(
        found.contains("a pinned rod without length that joins lines that bend"),
        "{found}"
    );
}
