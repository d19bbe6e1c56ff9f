//! Keys of a case of a line by the keys of its system.

use std::path::Path;

use seacable::case::{Diagnostic, StartShape, kind};
use seacable::import::line_case;
use seacable::run::History;
use seacable::system::SystemFile;

use crate::one_line::{line_run, system_run};

/// A wire with a clump and floats between a fixed and a moving end; more keys are put at its end.
pub(crate) const WIRE: &str = r#"
[case]
title = "A wire"
[parameters]
long_m = 40.0
[environment]
water_density_kg_per_m3 = 1000.0
[materials.wire]
diameter_m = 0.06
mass_kg_per_m = 20.0
ea_n = 1e8
drag_normal = 1.2
axial_damping_ratio = 0.05
[[line]]
name = "low"
material = "wire"
length_m = "long_m"
segments = 20
[[line]]
name = "high"
material = "wire"
length_m = 60.0
segments = 30
[[clumps]]
name = "weight"
section = "high"
at_m = 20.0
mass_kg = 900.0
wet_mass_kg = 600.0
drag_area_m2 = 0.8
added_mass_kg = 200.0
[ends.a]
name = "anchor"
kind = "fixed"
position_m = [60.0, 0.0, -70.0]
[ends.b]
name = "ship"
kind = "moving"
position_m = [0.0, 0.0, -5.0]
amplitude_m = [1.0, 0.5, 2.0]
period_s = 8.0
ramp_s = 2.0
[solver]
duration_s = 2.0
time_step_s = 0.02
error_estimate = false
position_tolerance_m = 1e-10
[output]
interval_s = 0.1
"#;

fn converted(more: &str) -> Result<String, Vec<Diagnostic>> {
    let text = format!("{WIRE}{more}");
    line_case::read(&text, Path::new("wire.toml")).map(|imported| imported.text)
}

fn file(more: &str) -> SystemFile {
    let text = converted(more).unwrap();
    kind::read::<SystemFile>(&text, "system.toml")
        .unwrap()
        .content
}

/// The one fault of a case: its line, its key and what is wrong.
fn fault(more: &str) -> (u32, String, String) {
    let found = converted(more).unwrap_err();
    let [one] = found.as_slice() else {
        panic!("{found:?}");
    };
    (one.line, one.key.clone(), one.problem.clone())
}

/// Lines of [`WIRE`], so that what is put at its end begins there.
fn end_of_wire() -> u32 {
    u32::try_from(WIRE.lines().count()).unwrap()
}

#[test]
fn how_a_line_at_rest_is_computed_goes_along() {
    let at_rest = "[solver]\nmethod = \"static\"\naccuracy = 1e-3";
    let text = WIRE.replace("[solver]", at_rest);
    let system = line_case::read(&text, Path::new("wire.toml")).unwrap().text;
    let read = kind::read::<SystemFile>(&system, "system.toml").unwrap();
    let solver = read.content.solver.as_ref().unwrap();
    assert_eq!(
        (solver.accuracy, solver.error_estimate),
        (Some(1e-3), false)
    );
    assert_eq!(read.content.in_time(), None);
}

/// Sections keep their names, and what is attached to them stays as it is worded, with its rows.
#[test]
fn what_is_attached_stays_as_it_is_worded() {
    let floats =
        "[[floats]]\nsection = \"low\"\nfrom_m = \"0.1 * long_m\"\nto_m = 17.0\nlift_kg = 300.0\n";
    let modules = "[[modules]]\nsection = \"high\"\npitch_m = 4.0\ndiameter_m = 0.6\nlength_m = 1.0\ndensity_kg_per_m3 = 500.0\ndrag_normal = 1.0\n";
    let more = format!("{floats}{modules}");
    let line = &file(&more).lines[0];
    let names: Vec<Option<&str>> = line
        .sections
        .iter()
        .map(|one| one.name.as_deref())
        .collect();
    assert_eq!(names, [Some("low"), Some("high")]);
    assert_eq!(line.sections[1].segments, Some(30));
    let clump = &line.clumps[0];
    assert_eq!((clump.name.as_str(), clump.at_m), ("weight", 20.0));
    assert_eq!(clump.section.as_deref(), Some("high"));
    assert_eq!(
        (line.floats[0].from_m, line.floats[0].to_m),
        (4.0, Some(17.0))
    );
    assert_eq!(line.modules[0].pitch_m, 4.0);
    let text = converted(&more).unwrap();
    let worded = text.contains("from_m = \"0.1 * long_m\"");
    assert!(worded, "{text}");
    assert!(!text.contains("buoyed"), "{text}");
}

/// A line of one section needs no name of it.
#[test]
fn of_one_section_floats_name_none() {
    let (before, after) = WIRE.split_once("[[line]]\nname = \"high\"").unwrap();
    let after = after.split_once("[ends.a]").unwrap().1;
    let floats = "[[floats]]\nsection = \"low\"\nfrom_m = 4.0\nlift_kg = 300.0\n[marks.\"floats.low.lift_kg\"]\nstatus = \"assumed\"\nreason = \"r\"\n";
    let text = format!("{before}[ends.a]{after}{floats}").replace("\"long_m\"", "100.0");
    let system = line_case::read(&text, Path::new("wire.toml")).unwrap().text;
    let read = kind::read::<SystemFile>(&system, "system.toml").unwrap();
    let line = &read.content.lines[0];
    assert_eq!(
        (line.floats[0].section.as_ref(), line.sections.len()),
        (None, 0)
    );
    assert!(
        system.contains("[marks.\"lines.line.floats.1.lift_kg\"]"),
        "{system}"
    );
}

#[test]
fn a_clump_with_drag_and_added_mass_moves_as_on_the_line() {
    let floats = "[[floats]]\nsection = \"low\"\nfrom_m = 4.0\nto_m = 16.0\nlift_kg = 300.0\nmass_kg = 150.0\ndrag_area_m2 = 2.0\ndrag_area_tangential_m2 = 3.0\nadded_mass_kg = 400.0\n";
    assert_moves_as_on_the_line(&format!("{WIRE}{floats}"), "line|low|high");
}

#[test]
fn what_is_attached_acts_at_rest_as_on_the_line() {
    // In a current both are divided alike.
    let more = "[current]\nspeed_m_per_s = 0.8\ndirection_deg = 40.0\n[[floats]]\nsection = \"low\"\nfrom_m = 5.1\nto_m = 17.3\nlift_kg = 300.0\nmass_kg = 150.0\ndrag_area_m2 = 2.0\n[[modules]]\nsection = \"low\"\nfrom_m = 3.0\nto_m = 12.7\ndiameter_m = 0.6\nlength_m = 1.0\npitch_m = 4.0\ndensity_kg_per_m3 = 500.0\ndrag_normal = 1.0\n";
    let text = format!("{WIRE}{more}").replace("[solver]", "[solver]\nmethod = \"static\"");
    let imported = line_case::read(&text, Path::new("wire.toml")).unwrap();
    let system = kind::parse::<SystemFile>(&imported.text, "system.toml").unwrap();
    let line = line_run(text).history;
    for (own, other) in [
        ("tension_n[low|high]", "tension_n[line|low|high]"),
        ("z_m[weight]", "z_m[line|weight]"),
        ("x_m[weight]", "x_m[line|weight]"),
    ] {
        let own = *line.channel(own).unwrap().values.last().unwrap();
        let other = seacable::system::quantities::value(&system, other).unwrap();
        assert!((own - other).abs() < 1e-6 * own.abs(), "{own} {other}");
    }
}

#[test]
fn modules_drag_along_the_line_as_on_it() {
    for (width, bed) in [
        ("perimeter", ""),
        ("diameter", "[seabed]\ndepth_m = 200.0\n"),
    ] {
        let modules = format!(
            "[[modules]]\nsection = \"low\"\nfrom_m = 4.0\nto_m = 16.0\ndiameter_m = 0.6\nlength_m = 1.0\npitch_m = 4.0\n\
             density_kg_per_m3 = 500.0\ndrag_normal = 1.0\ndrag_tangential = 0.8\n{bed}"
        );
        let wire = format!(
            "drag_normal = 1.2\ndrag_tangential = 0.05\ndrag_tangential_width = \"{width}\""
        );
        let text = WIRE.replace("drag_normal = 1.2", &wire);
        assert_moves_as_on_the_line(&format!("{text}{modules}"), "line|low|high");
    }
}

/// One across and along the line, by both methods, in a current.
#[test]
fn a_clump_aligned_with_the_line_moves_as_on_the_line() {
    let aligned = "drag_area_normal_m2 = 4.0\ndrag_area_tangential_m2 = 1.5";
    let text = WIRE.replace("drag_area_m2 = 0.8", aligned);
    let current = "[current]\nspeed_m_per_s = 1.2\ndirection_deg = 60.0\n";
    let text = format!("{text}{current}").replace("time_step_s = 0.02", "time_step_s = 0.005");
    let by_alpha = assert_moves_as_on_the_line(&text, "line|low|high");
    let explicit = "method = \"rk4\"\ntime_step_s = 2e-4";
    let by_rk4 = text.replace("time_step_s = 0.005", explicit);
    let by_rk4 = assert_moves_as_on_the_line(&by_rk4, "line|low|high");
    let apart = greatest_difference(&by_alpha, &by_rk4);
    assert!(apart < 1e-3, "{apart}");
    // It is no drag of an area that the water sees from all sides.
    let around = text.replace(aligned, "drag_area_m2 = 4.0");
    let by_axes = assert_moves_as_on_the_line(&around, "line|low|high");
    let apart = greatest_difference(&by_alpha, &by_axes);
    assert!(apart > 1e-2, "{apart}");
}

/// The same of an added mass across and along it.
#[test]
fn an_added_mass_aligned_with_the_line_moves_as_on_the_line() {
    let aligned = "added_mass_normal_kg = 900.0\nadded_mass_tangential_kg = 50.0";
    let text = WIRE.replace("added_mass_kg = 200.0", aligned);
    let text = text.replace("time_step_s = 0.02", "time_step_s = 0.005");
    let by_alpha = assert_moves_as_on_the_line(&text, "line|low|high");
    let explicit = "method = \"rk4\"\ntime_step_s = 2e-4";
    let by_rk4 = text.replace("time_step_s = 0.005", explicit);
    let by_rk4 = assert_moves_as_on_the_line(&by_rk4, "line|low|high");
    let apart = greatest_difference(&by_alpha, &by_rk4);
    assert!(apart < 1e-3, "{apart}");
    // It is no mass that resists alike in all directions.
    let around = text.replace(aligned, "added_mass_kg = 900.0");
    let by_axes = assert_moves_as_on_the_line(&around, "line|low|high");
    let apart = greatest_difference(&by_alpha, &by_axes);
    assert!(apart > 1e-2, "{apart}");
}

/// The greatest difference of two records by the greatest value.
pub(crate) fn greatest_difference(own: &[f64], other: &[f64]) -> f64 {
    let greatest = own.iter().fold(0.0_f64, |a, b| a.max(b.abs()));
    let pairs = own.iter().zip(other);
    let apart = pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    apart / greatest
}

/// The tensions of a wire as a line and as the system of it are the same; that at its lower end.
fn assert_moves_as_on_the_line(text: &str, joint: &str) -> Vec<f64> {
    let text = text.replace("\"long_m\"", "40.0");
    let imported = line_case::read(&text, Path::new("wire.toml")).unwrap();
    let system = system_run(&imported.text).history;
    let line = line_run(text).history;
    for (own, other) in [
        ("tension_n[anchor|low]", "tension_n[line|a]"),
        ("tension_n[high|ship]", "tension_n[line|b]"),
        ("tension_n[low|high]", &format!("tension_n[{joint}]")),
    ] {
        let of = |history: &History, name: &str| history.channel(name).unwrap().values.clone();
        let (own, other) = (of(&line, own), of(&system, other));
        let apart = greatest_difference(&own, &other);
        assert!(own.len() == other.len() && apart < 1e-8, "{apart}");
    }
    let lower = line.channel("tension_n[anchor|low]").unwrap();
    lower.values.clone()
}

#[test]
fn expressions_stay() {
    let text = converted("").unwrap();
    assert!(text.contains("long_m = 40.0"), "{text}");
    assert!(text.contains("length_m = \"long_m\""), "{text}");
}

#[test]
fn load_cases_have_the_keys_of_the_system() {
    let more = "[[load_cases]]\nkey = \"ends.b.amplitude_m.z\"\nvalues = [1.0, 2.0]\n[[load_cases]]\nkey = \"line.low.length_m\"\nvalues = [39.0, 41.0]\n[[load_cases]]\nkey = \"clumps.weight.mass_kg\"\nvalues = [900.0]\n[[load_cases]]\nkey = \"parameters.long_m\"\nvalues = [39.0]\n";
    let keys: Vec<Option<String>> = file(more).load_cases.into_iter().map(|of| of.key).collect();
    let wanted = [
        "points.ship.amplitude_m.z",
        "lines.line.sections.low.length_m",
        "lines.line.clumps.weight.mass_kg",
        "parameters.long_m",
    ];
    assert_eq!(keys, wanted.map(|key| Some(key.to_owned())));
}

#[test]
fn a_published_curve_has_the_channel_of_the_system() {
    let curve = |channel: &str| {
        format!(
            "[[published_curve]]\nname = \"c\"\nchannel = \"{channel}\"\ntime_s = [0.0, 1.0]\nvalue = [1.0, 2.0]\ntolerance_percent = 5.0\nsource = \"none\"\ninputs = \"assumed\"\n"
        )
    };
    for (own, other) in [
        ("tension_n[high|ship]", "tension_n[line|b]"),
        ("tension_n[low|high]", "tension_n[line|low|high]"),
        ("z_m[weight]", "z_m[line|weight]"),
        ("z_m[ship]", "z_m[ship]"),
        ("force_z_n[ship]", "force_z_n[ship]"),
    ] {
        let found = file(&curve(own));
        assert_eq!(found.published_curve[0].channel.to_string(), other);
        assert_eq!(found.output.forces, Some(true));
    }
    let within = "window_s = [0.0, 1.0]\nperiod_s = 2.0\n";
    let repeats = file(&format!("{}{within}", curve("z_m[weight]")));
    let found = &repeats.published_curve[0];
    assert_eq!(
        (found.window_s, found.period_s),
        (Some([0.0, 1.0]), Some(2.0))
    );
}

#[test]
fn the_start_of_the_line_goes_along() {
    let moving = file("[start]\nvelocity_m_per_s = [1.0, 0.0, 0.0]\n");
    let start = moving.lines[0].start.as_ref().unwrap();
    assert_eq!(start.velocity_m_per_s, [1.0, 0.0, 0.0]);
    assert_eq!(start.shape, StartShape::Equilibrium);
    let straight = file("[start]\nshape = \"straight\"\n");
    let start = straight.lines[0].start.as_ref().unwrap();
    assert_eq!(start.shape, StartShape::Straight);
    assert!(
        file("[start]\nshape = \"equilibrium\"\n").lines[0]
            .start
            .is_none()
    );
}

#[test]
fn what_acts_and_cannot_be_said_is_refused_at_its_key() {
    let line = end_of_wire();
    let cases = [(
        "[[checks]]\nkind = \"offset\"\nof = [\"weight\"]\nlimit_m = 5.0\n",
        3,
        "checks.1.of",
    )];
    for (more, below, key) in cases {
        let (at, found, problem) = fault(more);
        assert_eq!((at, found.as_str()), (line + below, key), "{problem}");
    }
    let body = "[traveller]\nname = \"car\"\nmass_kg = 1.0\nwet_mass_kg = 1.0\nspeed_m_per_s = 1.0\nramp_s = 1.0\n";
    let (at, found, problem) = fault(&format!("{body}from_m = 45.0\nto_m = 70.0\n"));
    assert_eq!((at, found.as_str()), (24, "clumps.weight"), "{problem}");
    let text = WIRE.replace("\"long_m\"", "40.0");
    let text = format!("{text}{body}from_m = 5.0\nto_m = 70.0\n");
    let found = line_case::read(&text, Path::new("wire.toml")).unwrap_err();
    let keys: Vec<&str> = found.iter().map(|fault| fault.key.as_str()).collect();
    assert_eq!(keys, ["traveller.to_m"]);
}

/// A body that travels parts the section that it is on, and what is recorded at the ends and of it keeps its names.
#[test]
fn a_body_that_travels_parts_the_line() {
    let curve = |channel: &str| {
        format!(
            "[[published_curve]]\nname = \"c\"\nchannel = \"{channel}\"\ntime_s = [0.0, 1.0]\nvalue = [1.0, 2.0]\ntolerance_percent = 5.0\nsource = \"none\"\ninputs = \"assumed\"\n"
        )
    };
    let text = WIRE.replace("\"long_m\"", "40.0");
    let body = "[traveller]\nname = \"car\"\nmass_kg = 50.0\nwet_mass_kg = 40.0\nspeed_m_per_s = 2.0\nramp_s = 1.0\nfrom_m = 30.0\nto_m = 10.0\n";
    for (own, other) in [
        ("tension_n[anchor|low]", "tension_n[line-1|a]"),
        ("tension_n[low|high]", "tension_n[line-2|low|high]"),
        ("tension_n[high|ship]", "tension_n[line-2|b]"),
        ("arc_m[car]", "length_m[line-1]"),
        ("z_m[car]", "z_m[car]"),
    ] {
        let text = format!("{text}{body}{}", curve(own));
        let system = line_case::read(&text, Path::new("wire.toml")).unwrap().text;
        let file = kind::read::<SystemFile>(&system, "system.toml").unwrap();
        let file = file.content;
        assert_eq!(file.published_curve[0].channel.to_string(), other);
        let lengths = file.lines.iter().map(|line| {
            let sections = line.sections.iter();
            sections.map(|section| section.length_m).collect::<Vec<_>>()
        });
        let lengths: Vec<Vec<f64>> = lengths.collect();
        let of_first = file.lines[0].length_m;
        assert_eq!((of_first, &*lengths[1]), (Some(30.0), &[10.0, 60.0][..]));
        let hauled = &file.sliding_points[0];
        assert_eq!(
            (hauled.rate_m_per_s, hauled.stop_s, hauled.ramp_s),
            (Some(-2.0), Some(10.0), 1.0)
        );
        let car = &file.points["car"];
        assert_eq!((car.mass_kg, car.displaced_m3(1000.0)), (50.0, 0.01));
    }
}

#[test]
fn what_other_views_have_is_a_remark() {
    let more =
        "[[study]]\nname = \"s\"\nkey = \"ends.b.motion\"\nvalues = [\"harmonic\", \"table\"]\n";
    let notes = file(more).about.notes;
    let studies = "NOT CARRIED OVER: studies of keys whose value no key of a system has alone: s.";
    assert!(notes.contains(studies), "{notes}");
}

/// A fault that shows in the system alone stands at the key of the case.
#[test]
fn faults_of_the_system_stand_at_the_keys_of_the_case() {
    let text = format!("{WIRE}[seabed]\ndepth_m = 60.0\n");
    let imported = line_case::read(&text, Path::new("wire.toml")).unwrap();
    let found = kind::read::<SystemFile>(&imported.text, "system.toml").unwrap_err();
    let here = imported.at_its_row(&found[0], "wire.toml", &text);
    assert_eq!((here.key.as_str(), here.line), ("ends.a.position_m", 35));
}

#[test]
fn checks_have_what_they_are_held_to() {
    let more = "[[checks]]\nkind = \"uplift\"\nof = [\"anchor\"]\nlimit_n = 1.0\n";
    let found = file(more);
    assert!(found.output.uplift && found.checks.len() == 1);
    assert!(!file("").output.uplift);
}

#[test]
fn runs_beside_it_go_along() {
    let beside = WIRE.replace(
        "\n[parameters]",
        "\nbeside = [\"other.toml\"]\n[parameters]",
    );
    let text = line_case::read(&beside, Path::new("wire.toml"))
        .unwrap()
        .text;
    let about = kind::read::<SystemFile>(&text, "system.toml").unwrap();
    let about = about.content.about;
    assert_eq!(about.beside, Some(vec!["other.toml".to_owned()]));
    assert!(about.notes.is_empty(), "{}", about.notes);
}

/// A motion by a file, whose rows are those of its table; what is wrong with it stands at its key or its row.
#[test]
fn a_motion_by_a_file_stays_one() {
    let harmonic = "amplitude_m = [1.0, 0.5, 2.0]\nperiod_s = 8.0\n";
    let by_file =
        "motion = \"table\"\nmotion_file = \"m.csv\"\nmotion_interpolation = \"linear\"\n";
    let text = |rows: &str| {
        let wire = WIRE
            .replace(harmonic, by_file)
            .replace("\"long_m\"", "40.0");
        let wire = wire.replace(
            "[output]",
            &format!("[files.\"m.csv\"]\ntext = \"\"\"\n{rows}\"\"\"\n[output]"),
        );
        line_case::read(&wire, Path::new("wire.toml")).unwrap().text
    };
    let rows = "time_s,x_m,y_m,z_m\n0,0,0,0\n1,0.5,0,1\n2,0,0.2,0\n";
    let system = text(rows);
    assert!(system.contains("motion_file = \"m.csv\""), "{system}");
    let values = |system: &str| {
        let history = system_run(system).history;
        history.channel("tension_n[line|b]").unwrap().values.clone()
    };
    let [own, still] =
        [rows, "time_s,x_m,y_m,z_m\n0,0,0,0\n2,0,0,0\n"].map(|rows| values(&text(rows)));
    let table = "table_time_s = [0.0, 1.0, 2.0]\ntable_x_m = [0.0, 0.5, 0.0]\ntable_y_m = [0.0, 0.0, 0.2]\ntable_z_m = [0.0, 1.0, 0.0]\n";
    let by_keys: Vec<String> = system
        .lines()
        .map(|line| match line.starts_with("motion_file") {
            true => table.to_owned(),
            false => line.to_owned(),
        })
        .collect();
    assert_eq!(own, values(&by_keys.join("\n")));
    assert!(greatest_difference(&own, &still) > 1e-2, "{own:?}");
    for (from, to, key, problem) in [
        (
            "\n2,0,0.2,0",
            "",
            "points.ship.motion_file",
            "its times go from 0 s to 1 s",
        ),
        ("\n1,0.5", "\n3,0.5", "time_s", "does not come after"),
        (
            "motion_file = ",
            "table_time_s = [0.0, 2.0]\nmotion_file = ",
            "points.ship.table_time_s",
            "is given beside a motion by a file",
        ),
    ] {
        let wrong = system.replace(from, to);
        let found = kind::read::<SystemFile>(&wrong, "system.toml").unwrap_err();
        assert!(
            found[0].key == key && found[0].problem.contains(problem),
            "{found:?}"
        );
        assert!(found[0].line > 0, "{found:?}");
    }
}

/// A box on a wire, whose volume, drag area and added mass follow from its sides.
const BOX: &str = r#"
[case]
title = "A box on a wire"
[parameters]
side_m = 1.2
[environment]
water_density_kg_per_m3 = 1000.0
[materials.wire]
diameter_m = 0.06
mass_kg_per_m = 20.0
ea_n = 1e8
drag_normal = 1.2
[[line]]
name = "wire"
material = "wire"
length_m = 40.0
segments = 20
[ends.a]
name = "ship"
kind = "moving"
position_m = [0.0, 0.0, -5.0]
amplitude_m = [1.0, 0.5, 2.0]
period_s = 8.0
ramp_s = 2.0
[ends.b]
name = "box"
kind = "payload"
[payload]
dry_mass_kg = 9000.0
[payload.shape]
kind = "box"
length_m = "2 * side_m"
breadth_m = "side_m"
height_m = 0.8
[solver]
duration_s = 2.0
time_step_s = 0.02
error_estimate = false
position_tolerance_m = 1e-10
[output]
interval_s = 0.1
[[study]]
name = "length"
key = "payload.shape.length_m"
values = [2.0, 3.0]
[[study]]
name = "density"
key = "environment.water_density_kg_per_m3"
values = [1000.0, 1025.0]
[[published]]
name = "tension with the longer box"
channel = "tension_n[ship|wire]"
statistic = "max"
value = 8e4
tolerance_rel = 0.5
tolerance_reason = "none"
source = "none"
inputs = "published"
at = { study = "length", value = 3.0 }
"#;

/// The form of a payload is that of its point: one function gives both what follows from it, expressions and studies of it stay.
#[test]
fn the_shape_of_a_payload_is_that_of_its_point() {
    let imported = line_case::read(BOX, Path::new("box.toml")).unwrap();
    let text = &imported.text;
    assert!(text.contains("shape.length_m = \"2 * side_m\""), "{text}");
    let found = kind::read::<SystemFile>(text, "box.toml").unwrap().content;
    let point = &found.points["box"];
    let numbers = [&point.drag_area_m2, &point.added_mass_kg];
    assert!(point.volume_m3.is_none() && numbers.iter().all(|number| number.is_none()));
    assert!((point.displaced_m3(1000.0) / (2.4 * 1.2 * 0.8) - 1.0).abs() < 1e-12);
    let heavier =
        point.hydrodynamics(1025.0).added_mass.z / point.hydrodynamics(1000.0).added_mass.z;
    assert!((heavier / 1.025 - 1.0).abs() < 1e-12, "{heavier}");
    let studies: Vec<&str> = found.study.iter().map(|study| &*study.key).collect();
    let wanted = [
        "points.box.shape.length_m",
        "environment.water_density_kg_per_m3",
    ];
    assert_eq!(studies, wanted);
    assert_eq!(found.published.len(), 1);
    assert!(
        !found.about.notes.contains("NOT CARRIED OVER"),
        "{}",
        found.about.notes
    );
    let (line, system) = (line_run(BOX.to_owned()), system_run(text));
    let pairs = [
        ("tension_n[ship|wire]", "tension_n[line|a]"),
        ("z_m[box]", "z_m[box]"),
    ];
    for (of_line, of_system) in pairs {
        let values = |history: &History, name: &str| history.channel(name).unwrap().values.clone();
        let (line, system) = (
            values(&line.history, of_line),
            values(&system.history, of_system),
        );
        let size = line.iter().fold(0.0, |m: f64, v| m.max(v.abs()));
        for (line, system) in line.iter().zip(&system) {
            assert!(
                (line - system).abs() < 1e-8 * size,
                "{of_line}: {line} {system}"
            );
        }
    }
    let held = text.replace("kind = \"free\"", "kind = \"fixed\"");
    let faults = kind::read::<SystemFile>(&held, "box.toml").unwrap_err();
    let of_shape = faults.iter().find(|fault| fault.key == "points.box.shape");
    let of_shape = of_shape.unwrap_or_else(|| panic!("{faults:?}\n{held}"));
    assert!(of_shape.problem.contains("no effect"), "{of_shape:?}");
}

/// On a bed the area that bears is a number that follows from the shape: its expressions are refused, its studies left out.
#[test]
fn a_shape_that_bears_on_a_bed_states_its_area() {
    let bed = "[seabed]\ndepth_m = 100.0\n";
    let refused = line_case::read(&format!("{BOX}{bed}"), Path::new("box.toml")).unwrap_err();
    let keys: Vec<&str> = refused.iter().map(|fault| &*fault.key).collect();
    assert_eq!(keys, ["payload.shape.length_m", "payload.shape.breadth_m"]);
    let given = BOX.replace(
        "dry_mass_kg = 9000.0",
        "dry_mass_kg = 9000.0\nbed_area_m2 = 2.0",
    );
    let imported = line_case::read(&format!("{given}{bed}"), Path::new("box.toml")).unwrap();
    assert!(
        imported.text.contains("points.box.shape.length_m"),
        "{}",
        imported.text
    );
}
