//! Floats, modules and bodies on lines of systems: the closed form against the line cut by hand into sections, pieces that age, parts of a line that
//! may break, copies, files of other programs.

use seacable::case::Material;
use seacable::case::kind;
use seacable::export::{ExportOptions, Target, export};
use seacable::import::ImportOptions;
use seacable::system::quantities::value;
use seacable::system::{SolvedSystem, SystemFile};

use crate::motion::{channel, moved};
use crate::{HEAD, solved, tensions};

/// A lazy wave of two sections from the bed to a ship; `sections` and what is attached follow the keys of the line.
fn riser(line: &str, rest: &str) -> String {
    format!(
        "{HEAD}[environment]\nwater_density_kg_per_m3 = 1000.0\n[seabed]\ndepth_m = 100.0\nfriction = 0.0\n\
         [materials.pipe]\ndiameter_m = 0.3\nmass_kg_per_m = 130.0\nea_n = 4e8\ndrag_normal = 1.1\ndrag_tangential = 0.02\naxial_damping_ratio = 0.1\nbreak_load_n = 1e6\n\
         [points.foot]\nkind = \"fixed\"\nposition_m = [0.0, 0.0, -100.0]\n\
         [points.ship]\nkind = \"moved\"\nposition_m = [140.0, 0.0, -5.0]\namplitude_m = [0.5, 0.2, 1.0]\nperiod_s = 8.0\nramp_s = 2.0\n\
         [[lines]]\nname = \"riser\"\nfrom = \"foot\"\nto = \"ship\"\n{line}\n{rest}"
    )
}

const SECTIONS: &str = "[[lines.sections]]\nname = \"low\"\nmaterial = \"pipe\"\nlength_m = 120.0\nsegments = 60\n\
     [[lines.sections]]\nname = \"high\"\nmaterial = \"pipe\"\nlength_m = 80.0\nsegments = 40\n";

const FLOATS: &str = "[[lines.floats]]\nsection = \"low\"\nfrom_m = 60.0\nto_m = 100.0\nlift_kg = 5000.0\nmass_kg = 3000.0\ndrag_area_m2 = 30.0\ndrag_area_tangential_m2 = 8.0\nadded_mass_kg = 6000.0\n";

const MODULES: &str = "[[lines.modules]]\nsection = \"low\"\nfrom_m = 70.0\nto_m = 90.0\npitch_m = 4.0\ndiameter_m = 0.7\nlength_m = 1.0\ndensity_kg_per_m3 = 500.0\nfittings_kg = 5.0\ndrag_normal = 1.0\ndrag_tangential = 0.3\n";

const CLUMP: &str = "[[lines.clumps]]\nname = \"weight\"\nsection = \"high\"\nat_m = 20.0\nmass_kg = 900.0\nwet_mass_kg = 700.0\ndrag_area_m2 = 0.8\nadded_mass_kg = 150.0\n";

const RUN: &str = "[solver]\nduration_s = 3.0\ntime_step_s = 0.05\nerror_estimate = false\nposition_tolerance_m = 1e-10\n";

fn attached() -> String {
    [SECTIONS, FLOATS, MODULES, CLUMP].concat()
}

/// The same cut by hand where something begins, ends or hangs.
fn cut() -> String {
    let material = |name: &str, mass: f64, wet: f64| {
        format!(
            "[materials.{name}]\ndiameter_m = 0.3\nmass_kg_per_m = {mass:?}\nwet_weight_kg_per_m = {wet:?}\nea_n = 4e8\n"
        )
    };
    let section = |material: &str, length: f64, more: &str| {
        format!("[[lines.sections]]\nmaterial = \"{material}\"\nlength_m = {length:?}\n{more}")
    };
    let area = |diameter: f64| 0.25 * std::f64::consts::PI * diameter * diameter;
    let (mass, wet) = (130.0, 130.0 - 1000.0 * area(0.3));
    let floated = (mass + 3000.0 / 40.0, wet - 5000.0 / 40.0);
    let volume = 0.25 * (area(0.7) - area(0.3));
    let of_modules = volume * 500.0 + 5.0 / 4.0;
    let all = (
        floated.0 + of_modules,
        floated.1 + of_modules - volume * 1000.0,
    );
    let line = [
        section("pipe", 60.0, ""),
        section("floated", 10.0, ""),
        section("all", 20.0, ""),
        section("floated", 10.0, ""),
        section("pipe", 20.0, ""),
        section("pipe", 20.0, "clump_kg = 700.0\nclump_mass_kg = 900.0\n"),
        section("pipe", 60.0, ""),
    ];
    let materials = [
        material("floated", floated.0, floated.1),
        material("all", all.0, all.1),
    ];
    riser(&line.concat(), &materials.concat())
}

fn same(one: &SolvedSystem, other: &SolvedSystem, within: f64) {
    let (own, others) = (tensions(one, "riser"), tensions(other, "riser"));
    for (a, b) in own.iter().zip(others) {
        assert!((a - b).abs() < within * own[1], "{own:?} {others:?}");
    }
}

#[test]
fn at_rest_the_line_is_the_closed_form_of_what_is_on_it() {
    let (own, by_hand) = (solved(&riser(&attached(), "")), solved(&cut()));
    assert!(own.network.lines[0].discretised.is_none());
    same(&own, &by_hand, 1e-10);
    for (name, other) in [
        ("tension_n[riser|low|high]", "tension_n[riser|5]"),
        ("on_bed_m[riser]", "on_bed_m[riser]"),
    ] {
        let (own, other) = (value(&own, name).unwrap(), value(&by_hand, other).unwrap());
        assert!(
            (own - other).abs() < 1e-8 * other.max(1.0),
            "{name}: {own} {other}"
        );
    }
    let depth = value(&own, "z_m[riser|weight]").unwrap();
    assert!(depth < -5.0 && depth > -100.0, "{depth}");
    assert!(value(&own, "z_m[riser|nothing]").is_err());
}

#[test]
fn a_body_with_a_name_is_followed_in_time() {
    let run = moved(riser(&attached(), RUN).strip_prefix(HEAD).unwrap());
    let depth = channel(&run, "z_m[riser|weight]");
    let at_rest = value(&solved(&riser(&attached(), "")), "z_m[riser|weight]").unwrap();
    assert!((depth[0] - at_rest).abs() < 0.02, "{} {at_rest}", depth[0]);
    assert!(
        depth.iter().any(|z| (z - depth[0]).abs() > 0.1),
        "{depth:?}"
    );
    assert!(
        channel(&run, "bed_force_n[riser|weight]")
            .iter()
            .all(|force| *force == 0.0)
    );
}

#[test]
fn pieces_of_a_line_that_age_have_their_share() {
    let growth = "[ageing]\nyears = 1.0\npieces = 7\n[[ageing.growth]]\ndepth_m = [0.0, 200.0]\nthickness_m = [0.0, 0.0]\n";
    let aged = solved(&riser(&attached(), growth));
    same(&aged, &solved(&riser(&attached(), "")), 1e-9);
    assert!(value(&aged, "tension_n[riser|low|high]").is_ok());
}

#[test]
fn a_line_that_may_break_has_on_both_parts_what_was_on_it() {
    let whole = moved(riser(&attached(), RUN).strip_prefix(HEAD).unwrap());
    // Within floats and modules.
    let breaks = format!("break_at_m = 80.0\nbreak_n = 1e11\n{}", attached());
    let parted = moved(riser(&breaks, RUN).strip_prefix(HEAD).unwrap());
    for name in ["tension_n[riser|a]", "tension_n[riser|b]"] {
        let (own, other) = (channel(&whole, name), channel(&parted, name));
        let pairs = own.iter().zip(other);
        let apart = pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        let greatest = own.iter().copied().fold(0.0, f64::max);
        assert!(apart < 1e-5 * greatest, "{name}: {apart} of {greatest}");
    }
}

#[test]
fn files_of_other_programs_have_it_in_sections() {
    let own = solved(&riser(&attached(), ""));
    for target in [Target::MoorDyn, Target::MapPlusPlus] {
        let made = export(&own, target, ExportOptions::default()).unwrap();
        let folder = std::env::temp_dir().join(format!("seacable-attached-{}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        let path = folder.join("written.dat");
        std::fs::write(&path, &made.text).unwrap();
        let options = ImportOptions {
            depth: Some(100.0),
            density: Some(1000.0),
            gravity: Some(own.file.environment.gravity_m_per_s2),
            ..ImportOptions::default()
        };
        let again = seacable::open::load_as::<SystemFile>(&path, &options);
        let again = again.unwrap_or_else(|found| panic!("{found:?}")).computed;
        let top = |system: &SolvedSystem| {
            let lines = &system.rest.balance.lines;
            lines
                .iter()
                .map(|line| line.tensions()[1])
                .fold(0.0, f64::max)
        };
        let (a, b) = (top(&own), top(&again));
        assert!((a - b).abs() < 1e-6 * a, "{target:?}: {a} {b}");
    }
    let two = CLUMP.replace("weight", "other");
    let twice = solved(&riser(&format!("{}{two}", attached()), ""));
    let refused = export(&twice, Target::MoorDyn, ExportOptions::default()).unwrap_err();
    assert_eq!(refused[0].key, "lines.riser.clumps.other.at_m");
}

#[test]
fn what_is_off_its_section_is_refused_at_its_key() {
    let one = "material = \"pipe\"\nlength_m = 200.0\n";
    let bare = |table: &str| {
        table
            .replace("section = \"low\"\n", "")
            .replace("section = \"high\"\n", "")
    };
    let floats = bare(FLOATS);
    for (line, key, problem) in [
        (
            format!("{SECTIONS}{floats}"),
            "lines.riser.floats.1.section",
            "is missing",
        ),
        (
            format!("{one}{}", floats.replace("to_m = 100.0", "to_m = 300.0")),
            "lines.riser.floats.1.to_m",
            "beyond their section",
        ),
        (
            format!("{SECTIONS}{}", MODULES.replace("\"low\"", "\"lwo\"")),
            "lines.riser.modules.lwo.section",
            "no section named",
        ),
        (
            format!("{SECTIONS}{}", CLUMP.replace("at_m = 20.0", "at_m = 80.0")),
            "lines.riser.clumps.weight.at_m",
            "at the end of the line",
        ),
        (
            format!("{one}{}", bare(CLUMP).replace("at_m = 20.0", "at_m = 0.0")),
            "lines.riser.clumps.weight.at_m",
            "at the end of the line",
        ),
        (
            format!("{SECTIONS}{CLUMP}{CLUMP}"),
            "lines.riser.clumps.2.name",
            "used twice",
        ),
        (
            format!(
                "{SECTIONS}{}",
                CLUMP.replace("drag_area_m2", "drag_area_normal_m2 = 1.0\ndrag_area_m2")
            ),
            "lines.riser.clumps.weight.drag_area_m2",
            "beside",
        ),
    ] {
        let found = kind::parse::<SystemFile>(&riser(&line, ""), "s.toml").unwrap_err();
        assert_eq!(found[0].key, key, "{found:?}");
        assert!(found[0].problem.contains(problem), "{found:?}");
    }
    assert!(kind::parse::<SystemFile>(&riser(&format!("{one}{floats}"), ""), "s.toml").is_ok());
    // Paid out of, it would pass the end.
    let payout = format!("{RUN}[[payouts]]\nline = \"riser\"\nend = \"b\"\nrate_m_per_s = 0.1\n");
    let found = kind::parse::<SystemFile>(&riser(&attached(), &payout), "s.toml").unwrap_err();
    assert_eq!(found[0].key, "payouts.1.line");
}

/// A body at the beginning of a section, and one by the keys of the section before.
#[test]
fn a_body_where_sections_meet_is_said_in_either_way() {
    let by_clump = CLUMP.replace("at_m = 20.0", "at_m = 0.0");
    let by_keys = "clump_kg = 700.0\nclump_mass_kg = 900.0\nclump_drag_area_m2 = 0.8\nclump_added_mass_kg = 150.0\n";
    let sections = SECTIONS.replacen("segments = 60\n", &format!("segments = 60\n{by_keys}"), 1);
    let [one, other] = [format!("{SECTIONS}{by_clump}"), sections].map(|line| {
        let run = moved(riser(&line, RUN).strip_prefix(HEAD).unwrap());
        channel(&run, "tension_n[riser|b]").to_vec()
    });
    assert_eq!(one, other);
}

#[test]
fn a_body_between_two_nodes_is_remarked() {
    let warned = |at: &str, rest: &str| {
        let clump = CLUMP.replace("at_m = 20.0", at);
        let solved = solved(&riser(&format!("{SECTIONS}{clump}"), rest));
        let all = seacable::system::warnings::warnings(&solved);
        all.iter()
            .any(|one| one.contains("hang at the nearest nodes"))
    };
    assert!(warned("at_m = 20.7", RUN) && !warned("at_m = 20.0", RUN));
    // A closed form has every place.
    assert!(!warned("at_m = 20.7", ""));
}

#[test]
fn the_stretches_of_a_part_keep_its_mass_and_weight() {
    let own = solved(&riser(&attached(), ""));
    let parts = seacable::system::parts::parts(&own.file, &own.file.lines[0]);
    let stretches: Vec<_> = parts
        .iter()
        .flat_map(|part| part.uniform(&own.file.environment, true))
        .collect();
    let sum = |of: fn(&Material) -> f64| -> f64 {
        stretches
            .iter()
            .map(|one| one.length_m * of(&one.material))
            .sum()
    };
    let volume = (0.49 - 0.09) * 0.25 * std::f64::consts::PI * 5.0;
    let mass = 130.0 * 200.0 + 3000.0 + volume * 500.0 + 25.0;
    assert!((sum(|of| of.mass_kg_per_m) - mass).abs() < 1e-8 * mass);
    let added = |of: &Material| {
        1000.0 * 0.25 * std::f64::consts::PI * of.diameter_m.powi(2) * of.added_mass_normal
    };
    let bare = 1000.0 * 0.25 * std::f64::consts::PI * 0.09 * 200.0;
    let all: f64 = sum(added);
    assert!(
        (all - (bare + 6000.0 + volume * 1000.0)).abs() < 1e-8 * all,
        "{all}"
    );
}
