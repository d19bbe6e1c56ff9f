//! What is recorded of a system in motion beside tensions and places, against closed forms and other results of the same run.

use std::sync::atomic::AtomicBool;

use seacable::run::Run;
use seacable::run::job::{Request, execute};

use crate::motion::{channel, moved};
use crate::{HEAD, solved};

/// The history of a channel of a line case.
fn of_line(text: &str, name: &str) -> Vec<f64> {
    let case = seacable::case::parse(&format!("[case]\ntitle = \"t\"\n{text}"), "t.toml").unwrap();
    let request = Request {
        case,
        text: String::new(),
        file: "t.toml".to_owned(),
        overrides: Vec::new(),
        id: "t".to_owned(),
    };
    let run: Run = execute(&request, &AtomicBool::new(false), &mut |_| {});
    assert_eq!(run.info.failure, None);
    run.history.channel(name).unwrap().values.clone()
}

/// Weight of the chain \[N/m\] and its length \[m\].
const WEIGHT: f64 = 1000.0;
const LENGTH: f64 = 120.0;

const CHAIN: &str = "[environment]\nwater_density_kg_per_m3 = 0.0\ngravity_m_per_s2 = 10.0\n\
     [seabed]\ndepth_m = 50.0\nstiffness_n_per_m3 = 1e6\n[materials.chain]\nmass_kg_per_m = 100.0\ndiameter_m = 0.1\nea_n = 1e9\n";

/// A chain on the bed, its top heaved slowly.
fn chain(recorded: &str) -> String {
    format!(
        "{CHAIN}[points.anchor]\nkind = \"fixed\"\nposition_m = [0.0, 0.0, -50.0]\n\
         [points.top]\nkind = \"moved\"\nposition_m = [95.0, 0.0, 0.0]\namplitude_m = [0.0, 0.0, 3.0]\nperiod_s = 40.0\n\
         [[lines]]\nname = \"chain\"\nfrom = \"anchor\"\nto = \"top\"\nmaterial = \"chain\"\nlength_m = {LENGTH:?}\nsegments = 60\n\
         [solver]\nmethod = \"quasi\"\nduration_s = 40.0\nerror_estimate = false\n[output]\ninterval_s = 0.5\n{recorded}\n"
    )
}

#[test]
fn the_length_on_the_bed_is_what_the_top_does_not_carry() {
    let run = moved(&chain("uplift = true"));
    let on_bed = channel(&run, "on_bed_m[chain]");
    let pull = channel(&run, "uplift_n[top]");
    for (on_bed, pull) in on_bed.iter().zip(pull) {
        let carried = LENGTH + pull / WEIGHT;
        assert!((on_bed - carried).abs() < 1e-4, "{on_bed} {carried}");
    }
    // The closed form at rest.
    let at_rest = solved(&format!("{HEAD}{}", chain("")));
    let catenary = at_rest.rest.balance.lines[0].on_bed();
    assert!(
        (on_bed[0] - catenary).abs() < 0.05,
        "{} {catenary}",
        on_bed[0]
    );
    // It passes several segments of 2 m, and never jumps.
    let steps = on_bed.windows(2).map(|pair| (pair[1] - pair[0]).abs());
    assert!(steps.fold(0.0, f64::max) < 1.0, "{on_bed:?}");
    let swing = on_bed
        .iter()
        .fold(0.0_f64, |most, s| most.max((s - on_bed[0]).abs()));
    assert!(swing > 4.0, "{swing}");
}

#[test]
fn a_line_case_has_the_same_length_on_the_bed() {
    let line = of_line(
        &format!(
            "{CHAIN}[[line]]\nname = \"chain\"\nmaterial = \"chain\"\nlength_m = {LENGTH:?}\nsegments = 60\n\
             [ends.a]\nname = \"anchor\"\nkind = \"anchor\"\nposition_m = [0.0, 0.0, -50.0]\n\
             [ends.b]\nname = \"top\"\nkind = \"moving\"\nposition_m = [95.0, 0.0, 0.0]\namplitude_m = [0.0, 0.0, 3.0]\nperiod_s = 40.0\n\
             [solver]\nmethod = \"quasi\"\nduration_s = 40.0\nerror_estimate = false\n[output]\ninterval_s = 0.5\n"
        ),
        "on_bed_m[line]",
    );
    let run = moved(&chain(""));
    let pairs = line.iter().zip(channel(&run, "on_bed_m[chain]"));
    for (line, system) in pairs {
        assert!((line - system).abs() < 0.02, "{line} {system}");
    }
}

#[test]
fn the_force_on_a_point_is_the_tension_there_and_the_sum_of_its_lines() {
    let run = moved(&chain("forces = true"));
    let [x, z] = ["force_x_n[top]", "force_z_n[top]"].map(|name| channel(&run, name));
    let tension = channel(&run, "tension_n[chain|b]");
    for ((x, z), tension) in x.iter().zip(z).zip(tension) {
        assert!(
            (x.hypot(*z) / tension - 1.0).abs() < 1e-9,
            "{x} {z} {tension}"
        );
    }
    // Two lines that hang alike from one point: their weights, and nothing sideways.
    let line = |name: &str, x: f64| {
        format!(
            "[points.{name}]\nkind = \"fixed\"\nposition_m = [{x:?}, 0.0, 0.0]\n\
             [[lines]]\nname = \"{name}\"\nfrom = \"{name}\"\nto = \"middle\"\nmaterial = \"chain\"\nlength_m = 30.0\nsegments = 10\n"
        )
    };
    let run = moved(&format!(
        "{CHAIN}[points.middle]\nkind = \"fixed\"\nposition_m = [0.0, 0.0, 0.0]\n{}{}\
         [solver]\nduration_s = 1.0\nerror_estimate = false\n[output]\nforces = true\n",
        line("left", -25.0),
        line("right", 25.0)
    ));
    let at = |name: &str| channel(&run, name)[0];
    assert!((at("force_z_n[middle]") + 30.0 * WEIGHT).abs() < 1e-3);
    assert!(at("force_x_n[middle]").abs() < 1e-3);
    assert!((at("force_x_n[left]") + at("force_x_n[right]")).abs() < 1e-3);
    // They hang high above the bed.
    assert!(run.history.channel("on_bed_m[left]").is_none());
}

/// A rope whose stiffness goes with its mean load, in a pipe's sheath.
const ROPE: &str = "[environment]\nwater_density_kg_per_m3 = 1025.0\n\
     [materials.rope]\ndiameter_m = 0.2\nmass_kg_per_m = 35.0\nea_n = 1.8e8\nbreak_load_n = 1.4e7\ndynamic_stiffness = \"secant\"\n\
     dynamic_alpha = 14.5\ndynamic_beta = 0.21\ndynamic_gamma = 0.27\n\
     [materials.pipe]\ndiameter_m = 0.2\nmass_kg_per_m = 60.0\nea_n = 5e8\nbore = { diameter_m = 0.15, content_density_kg_per_m3 = 800.0, pressure_pa = 1e6 }\n";

#[test]
fn ropes_and_pipes_of_a_system_record_what_those_of_a_line_do() {
    let motion = "position_m = [120.0, 0.0, -20.0]\namplitude_m = [2.0, 0.0, 0.0]\nperiod_s = 10.0\nramp_s = 5.0\n";
    let sections = [("rope", 69.0, 8), ("pipe", 69.0, 8)];
    let solver = "[solver]\nmethod = \"alpha\"\ntime_step_s = 0.1\nduration_s = 20.0\nerror_estimate = false\nposition_tolerance_m = 1e-9\n\
         [output]\ninterval_s = 0.5\n";
    let line: String = sections
        .iter()
        .map(|(name, length, segments)| {
            format!(
                "[[line]]\nname = \"{name}\"\nmaterial = \"{name}\"\nlength_m = {length:?}\nsegments = {segments}\n"
            )
        })
        .collect();
    let line = format!(
        "{ROPE}{line}[ends.a]\nname = \"low\"\nkind = \"fixed\"\nposition_m = [0.0, 0.0, -90.0]\n\
         [ends.b]\nname = \"top\"\nkind = \"moving\"\n{motion}{solver}"
    );
    let parts: String = sections
        .iter()
        .map(|(name, length, _)| {
            format!("[[lines.sections]]\nmaterial = \"{name}\"\nlength_m = {length:?}\n")
        })
        .collect();
    let run = moved(&format!(
        "{ROPE}[points.low]\nkind = \"fixed\"\nposition_m = [0.0, 0.0, -90.0]\n[points.top]\nkind = \"moved\"\n{motion}\
         [[lines]]\nname = \"line\"\nfrom = \"low\"\nto = \"top\"\nsegments = 16\n{parts}{solver}"
    ));
    let pairs = [
        ("mean_load_percent[line|1.a]", "mean_load_percent[rope.a]"),
        ("mean_load_percent[line|1.b]", "mean_load_percent[rope.b]"),
        (
            "load_deviation_percent[line|1.b]",
            "load_deviation_percent[rope.b]",
        ),
        ("stiffness_k[line|1.a]", "stiffness_k[rope.a]"),
        ("wall_tension_n[line|2.a]", "wall_tension_n[pipe.a]"),
        ("wall_tension_n[line|2.b]", "wall_tension_n[pipe.b]"),
    ];
    for (of_system, name) in pairs {
        let expected = of_line(&line, name);
        let found = channel(&run, of_system);
        let scale = expected
            .iter()
            .fold(0.0_f64, |most, value| most.max(value.abs()));
        assert!(scale > 0.0, "{name}");
        for (found, expected) in found.iter().zip(&expected) {
            assert!(
                (found - expected).abs() < 1e-4 * scale,
                "{name}: {found} {expected}"
            );
        }
    }
    assert!(run.history.channel("stiffness_k[line|2.a]").is_none());
    // T_w = T + p_i A_i - p_o A_o at the top, 20 m down.
    let disc = |diameter: f64| 0.25 * std::f64::consts::PI * diameter * diameter;
    let g = 9.80665;
    let pressed = (1e6 + 800.0 * g * 20.0) * disc(0.15) - 1025.0 * g * 20.0 * disc(0.2);
    let wall = channel(&run, "wall_tension_n[line|2.b]")[0] - channel(&run, "tension_n[line|b]")[0];
    assert!((wall / pressed - 1.0).abs() < 1e-9, "{wall} {pressed}");
}

/// A clump and a block that fall from 4 m above their beds once their wire is let go.
#[test]
fn what_lands_has_the_speed_of_its_fall_and_rests_with_its_weight() {
    let clump = "[points.clump]\nkind = \"free\"\nmass_kg = 2000.0\n";
    let block = "[points.eye]\nkind = \"body\"\nbody = \"block\"\nposition_m = [0.0, 0.0, 0.0]\n\
         [bodies.block]\nkind = \"free\"\nposition_m = [0.0, 0.0, -20.0]\nmass_kg = 2000.0\nbottom_m = 1.5\nbed_friction = 0.3\n\
         inertia_kg_m2 = [2e3, 2e3, 2e3]\n";
    for (hung, end, name, below) in [(clump, "clump", "clump", 0.0), (block, "eye", "block", 1.5)] {
        let run = moved(&format!(
            "[environment]\nwater_density_kg_per_m3 = 0.0\ngravity_m_per_s2 = 10.0\n[seabed]\ndepth_m = 24.0\n\
             [materials.wire]\nmass_kg_per_m = 10.0\ndiameter_m = 0.03\nea_n = 5e7\naxial_damping_n_s = 1e4\n\
             [points.top]\nkind = \"fixed\"\nposition_m = [0.0, 0.0, 0.0]\n{hung}\
             [[lines]]\nname = \"wire\"\nfrom = \"{end}\"\nto = \"top\"\nmaterial = \"wire\"\nlength_m = 20.0\nsegments = 10\nrelease_a_s = 0.5\n\
             [solver]\nduration_s = 4.0\nerror_estimate = false\n[output]\ninterval_s = 0.05\n"
        ));
        let last = |quantity: &str| {
            let values = channel(&run, &format!("{quantity}[{name}]"));
            values[values.len() - 1]
        };
        let height = channel(&run, &format!("z_m[{name}]"))[0] - below + 24.0;
        let speed = (2.0 * 10.0 * height).sqrt();
        let landed = last("landing_speed_m_per_s");
        assert!(
            (landed / speed - 1.0).abs() < 1e-2,
            "{name}: {landed} {speed}"
        );
        assert!(
            (last("bed_force_n") / 2e4 - 1.0).abs() < 1e-3,
            "{name}: {}",
            last("bed_force_n")
        );
        assert_eq!(
            channel(&run, &format!("landing_speed_m_per_s[{name}]"))[0],
            0.0
        );
        assert_eq!(channel(&run, &format!("bed_force_n[{name}]"))[0], 0.0);
        if name == "clump" {
            let fastest = channel(&run, "speed_m_per_s[clump]").iter().copied();
            let fastest = fastest.fold(0.0, f64::max);
            // It falls by half a metre a second in an interval of output.
            assert!(
                fastest < 1.01 * speed && fastest > speed - 0.5,
                "{fastest} {speed}"
            );
            assert!(last("speed_m_per_s") < 1e-2, "{}", last("speed_m_per_s"));
        }
    }
}

/// A cantilever, clamped level at A, a weight at its tip: `M = P L + w L² / 2`, and that by EI its curvature.
#[test]
fn a_clamp_bears_the_moment_of_a_cantilever() {
    let (ei, length, tip, weight) = (1e6, 10.0, 100.0, 5.0);
    let rod = "[environment]\nwater_density_kg_per_m3 = 0.0\ngravity_m_per_s2 = 10.0\n\
         [materials.rod]\nmass_kg_per_m = 0.5\ndiameter_m = 0.05\nea_n = 1e8\nei_n_m2 = 1e6\n";
    let solver = "[solver]\nduration_s = 1.0\nerror_estimate = false\n[output]\ninterval_s = 0.5\n";
    let expected = tip * length + 0.5 * weight * length * length;
    let run = moved(&format!(
        "{rod}[points.wall]\nkind = \"fixed\"\nposition_m = [0.0, 0.0, 0.0]\n\
         [points.tip]\nkind = \"free\"\nmass_kg = 10.0\nposition_m = [10.0, 0.0, 0.0]\n\
         [[lines]]\nname = \"rod\"\nfrom = \"wall\"\nto = \"tip\"\nmaterial = \"rod\"\nlength_m = 10.0\nsegments = 20\n\
         clamp_a_elevation_deg = 0.0\n{solver}"
    ));
    let of_system =
        ["moment_nm[rod|a]", "curvature_per_m[rod|a]"].map(|name| channel(&run, name)[0]);
    let line = format!(
        "{rod}[[line]]\nname = \"rod\"\nmaterial = \"rod\"\nlength_m = 10.0\nsegments = 20\n\
         [ends.a]\nname = \"wall\"\nkind = \"fixed\"\nposition_m = [0.0, 0.0, 0.0]\nclamp_elevation_deg = 0.0\n\
         [ends.b]\nname = \"tip\"\nkind = \"payload\"\n[payload]\ndry_mass_kg = 10.0\nvolume_m3 = 0.0\ndrag_area_m2 = 0.0\nadded_mass_kg = 0.0\n{solver}"
    );
    let of_line = ["moment_nm[wall]", "curvature_per_m[wall]"].map(|name| of_line(&line, name)[0]);
    for [moment, curvature] in [of_system, of_line] {
        assert!(
            (moment / expected - 1.0).abs() < 0.01,
            "{moment} {expected}"
        );
        assert!(
            (curvature * ei / expected - 1.0).abs() < 0.01,
            "{curvature}"
        );
    }
    assert!(
        (of_system[0] / of_line[0] - 1.0).abs() < 1e-3,
        "{of_system:?} {of_line:?}"
    );
    assert!(run.history.channel("moment_nm[rod|b]").is_none());
}

/// A bight that hangs clear of the bed is lowered onto it by one end: at the end it lies as one that was there from the first.
#[test]
fn a_line_that_is_lowered_onto_the_bed_records_its_length_there() {
    let bight = |b: &str| {
        format!(
            "{CHAIN}[points.a]\nkind = \"fixed\"\nposition_m = [0.0, 0.0, 30.0]\n[points.b]\n{b}\n\
             [[lines]]\nname = \"bight\"\nfrom = \"a\"\nto = \"b\"\nmaterial = \"chain\"\nlength_m = 130.0\nsegments = 65\n\
             [solver]\nmethod = \"quasi\"\nduration_s = 40.0\nerror_estimate = false\n"
        )
    };
    let lowered = "kind = \"moved\"\nposition_m = [40.0, 0.0, 30.0]\ntable_time_s = [0.0, 20.0, 40.0]\n\
         table_z_m = [0.0, -60.0, -60.0]";
    let run = moved(&bight(lowered));
    let on_bed = channel(&run, "on_bed_m[bight]");
    let there = solved(&format!(
        "{HEAD}{}",
        bight("kind = \"fixed\"\nposition_m = [40.0, 0.0, -30.0]")
    ));
    let exact = there.rest.balance.lines[0].on_bed();
    let last = on_bed.last().unwrap();
    assert!(on_bed[0] == 0.0 && exact > 10.0, "{} {exact}", on_bed[0]);
    assert!((last - exact).abs() < 1.0, "{last} {exact}");
}

/// A line of two sections of two materials, its top moved; `names` are those of the sections.
fn of_sections(names: [&str; 2], more: &str) -> String {
    let section = |name: &str, length: f64| {
        format!(
            "[[lines.sections]]\n{name}material = \"chain\"\nlength_m = {length:?}\nsegments = 20\n"
        )
    };
    format!(
        "{CHAIN}[points.anchor]\nkind = \"fixed\"\nposition_m = [0.0, 0.0, -50.0]\n\
         [points.top]\nkind = \"moved\"\nposition_m = [95.0, 0.0, 0.0]\namplitude_m = [0.0, 0.0, 1.0]\nperiod_s = 10.0\n\
         [[lines]]\nname = \"mooring\"\nfrom = \"anchor\"\nto = \"top\"\n{}{}{more}",
        section(names[0], 70.0),
        section(names[1], 50.0)
    )
}

const SHORT_RUN: &str = "[solver]\nduration_s = 0.5\nerror_estimate = false\n";

#[test]
fn where_sections_meet_a_channel_has_their_names() {
    let named = ["name = \"low\"\n", "name = \"high\"\n"];
    let at_rest = |names, place: &str| {
        let solved = solved(&format!("{HEAD}{}", of_sections(names, "")));
        seacable::system::quantities::value(&solved, &format!("tension_n[mooring|{place}]"))
    };
    let by_number = at_rest(["", ""], "1").unwrap();
    assert_eq!(at_rest(named, "low|high"), Ok(by_number));
    assert!(at_rest(named, "1").is_err() && at_rest(named, "high|low").is_err());
    let run = moved(&of_sections(["", ""], SHORT_RUN));
    let by_number = channel(&run, "tension_n[mooring|1]").to_vec();
    let run = moved(&of_sections(named, SHORT_RUN));
    assert_eq!(channel(&run, "tension_n[mooring|low|high]"), by_number);
}

#[test]
fn sections_are_named_in_key_paths_and_all_of_a_line_or_none() {
    let named = ["name = \"low\"\n", "name = \"high\"\n"];
    let mark = "[marks.\"lines.mooring.sections.high.length_m\"]\nstatus = \"assumed\"\nreason = \"none\"\n";
    let text = format!("{HEAD}{}", of_sections(named, mark));
    let file = solved(&text).file;
    assert_eq!(file.lines[0].sections[1].name.as_deref(), Some("high"));
    let set = seacable::case::kind::set_all::<seacable::system::SystemFile>(
        &text,
        &[("lines.mooring.sections.high.length_m", "60.0")],
    );
    assert_eq!(
        solved(&set.unwrap()).file.lines[0].sections[1].length_m,
        60.0
    );
    for (names, key, problem) in [
        (
            ["name = \"low\"\n", ""],
            "lines.mooring.sections.low.name",
            "for some sections",
        ),
        (
            ["name = \"low\"\n", "name = \"low\"\n"],
            "lines.mooring.sections.2.name",
            "used twice",
        ),
    ] {
        let text = format!("{HEAD}{}", of_sections(names, ""));
        let found = seacable::case::kind::parse::<seacable::system::SystemFile>(&text, "s.toml")
            .unwrap_err();
        assert_eq!(found[0].key, key);
        assert!(found[0].problem.contains(problem), "{found:?}");
    }
}
