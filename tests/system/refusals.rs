//! Bad systems: each refused at its place, with the reason and a remedy.

use seacable::case::kind;
use seacable::system::SystemFile;

const GOOD: &str = r#"[system]
title = "test"

[seabed]
depth_m = 100.0

[materials.chain]
diameter_m = 0.1
mass_kg_per_m = 200.0
ea_n = 8e8

[bodies.platform]
kind = "held"

[points.anchor]
kind = "fixed"
position_m = [-300.0, 0.0, -100.0]

[points.fairlead]
kind = "body"
body = "platform"
position_m = [-10.0, 0.0, -10.0]

[points.middle]
kind = "free"

[[lines]]
name = "low"
from = "anchor"
to = "middle"
material = "chain"
length_m = 200.0

[[lines]]
name = "high"
from = "middle"
to = "fairlead"
material = "chain"
length_m = 130.0
"#;

/// Line, key and words of the first finding of the file with one text in the place of another.
fn refused(from: &str, to: &str, line: u32, words: &[&str]) {
    assert!(GOOD.contains(from), "{from}");
    let text = GOOD.replacen(from, to, 1);
    let found = kind::parse::<SystemFile>(&text, "system.toml").unwrap_err();
    let first = &found[0];
    let said = format!("{first}");
    assert_eq!(first.line, line, "{said}");
    for word in words {
        assert!(said.contains(word), "{said} lacks {word}");
    }
    assert!(!first.remedy.is_empty());
}

#[test]
fn the_good_one_is_solved() {
    assert!(kind::parse::<SystemFile>(GOOD, "system.toml").is_ok());
}

#[test]
fn unknown_names_are_refused_with_the_nearest() {
    refused(
        "from = \"anchor\"",
        "from = \"ancor\"",
        29,
        &[
            "lines.low.from",
            "there is no point named \"ancor\"",
            "anchor",
        ],
    );
    refused(
        "material = \"chain\"",
        "material = \"chian\"",
        31,
        &["there is no material", "chain"],
    );
    refused(
        "body = \"platform\"",
        "body = \"platfrom\"",
        21,
        &["there is no body", "platform"],
    );
}

#[test]
fn impossible_lines_are_refused() {
    refused(
        "to = \"middle\"",
        "to = \"anchor\"",
        30,
        &["begins and ends at \"anchor\"", "another point"],
    );
    refused("length_m = 200.0", "length_m = 0.0", 32, &["out of range"]);
    refused(
        "length_m = 200.0\n",
        "",
        27,
        &["length_m", "unstretched length"],
    );
}

#[test]
fn places_outside_the_water_are_refused() {
    refused(
        "-300.0, 0.0, -100.0",
        "-300.0, 0.0, -101.5",
        17,
        &["1.5 m below the bed"],
    );
    refused(
        "-300.0, 0.0, -100.0",
        "-300.0, 0.0, 3.0",
        17,
        &["3 m above the water"],
    );
}

#[test]
fn what_nothing_holds_is_refused() {
    refused(
        "kind = \"held\"",
        "kind = \"free\"",
        12,
        &["mass_kg", "a free body needs its mass"],
    );
    let loose = "[points.middle]\nkind = \"free\"\n\n[points.adrift]\nkind = \"free\"\n";
    refused(
        "[points.middle]\nkind = \"free\"\n",
        loose,
        27,
        &["nothing holds \"adrift\"", "join it by a line"],
    );
}

#[test]
fn masses_and_matrices_must_fit() {
    refused(
        "position_m = [-300.0, 0.0, -100.0]",
        "position_m = [-300.0, 0.0, -100.0]\nmass_kg = 5.0",
        18,
        &["no effect on a point that is held"],
    );
    refused(
        "kind = \"held\"",
        "kind = \"held\"\nadded_mass = [1.0, 2.0]",
        14,
        &["has 2 numbers", "36"],
    );
}

/// What a refusal of the file with more at its end says.
fn refused_with(more: &str, words: &str) {
    let text = format!("{GOOD}{more}");
    let found = kind::parse::<SystemFile>(&text, "system.toml").unwrap_err();
    let first = &found[0];
    let said = format!("{first}");
    assert!(said.contains(words), "{said}");
    assert!(first.line > 0 && !first.remedy.is_empty(), "{said}");
}

#[test]
fn parts_of_bodies_and_analyses_must_make_sense() {
    let member =
        "[[bodies.platform.members]]\nfrom_m = [1, 0, 0]\nto_m = [1, 0, 0]\ndiameter_m = 2\n";
    refused_with(member, "the member begins and ends there");
    let wind = |from: f64, to: f64| {
        let one = "[[bodies.platform.wind_loads]]\nheading_deg";
        format!("{one} = {from}\n{one} = {to}\n")
    };
    refused_with(&wind(90.0, 0.0), "0 does not follow 90");
    refused_with(&wind(-180.0, 180.0), "180 does not follow -180");
    let rod = "[rods.bar]\nkind = \"held\"\nend_a_m = [0, 0, -5]\nend_b_m = [0, 0, -5]\nmass_kg = 1\ndiameter_m = 1\n";
    refused_with(rod, "the rod begins and ends there");
    let same = rod.replace("bar", "platform").replacen("-5", "-6", 1);
    refused_with(&same, "there is a body named \"platform\" too");
    let point = rod.replace("-5]\nmass", "-6]\nmass")
        + "[points.bar-b]\nkind = \"fixed\"\nposition_m = [0, 0, -6]\n";
    refused_with(&point, "its end is named \"bar-b\", as a point is");
    let deep = rod.replace("end_b_m = [0, 0, -5]", "end_b_m = [0, 0, -105]");
    refused_with(&deep, "lies 5 m below the bed");
    refused_with("[wind]\nspeed_m_per_s = 9\n", "acts on nothing");
    let other = "[bodies.other]\nkind = \"held\"\n";
    let curve = "[[offset_curves]]\nto_m = 5\n";
    refused_with(&format!("{other}{curve}"), "the system has 2 bodies");
    refused_with(
        "[[watch_circles]]\nload_n = 5\nbody = \"platfrom\"\n",
        "no body named",
    );
    let table = "[materials.rope]\ndiameter_m = 0.1\nmass_kg_per_m = 1\nea_n = 1e6\nstrain = [0, 0.1]\ntension_n = [0, 1e5]\n";
    refused_with(table, "the stiffness is given twice");
}

/// As [`refused`], with tables of ageing at the end of the file; its line counts from the first of them.
fn ageing_refused(tables: &str, line: u32, words: &[&str]) {
    let last = "length_m = 130.0\n";
    refused(last, &format!("{last}\n{tables}"), 40 + line, words);
}

#[test]
fn ageing_that_cannot_be_is_refused() {
    let tables = |growth: &str| format!("[ageing]\nyears = 20.0\n[[ageing.growth]]\n{growth}");
    ageing_refused(
        "[ageing]\nyears = 20.0\n",
        2,
        &["ageing.years", "nothing grows"],
    );
    ageing_refused(
        &tables("depth_m = [0.0, 50.0]\nthickness_m = [0.1]\n"),
        5,
        &["thickness_m", "1 values for 2 depths"],
    );
    ageing_refused(
        &tables("thickness_m = [0.1, 0.2]\n"),
        4,
        &["depths that they belong to are missing"],
    );
    ageing_refused(
        &tables("depth_m = [50.0, 40.0]\nthickness_m = [0.1, 0.2]\n"),
        4,
        &["must increase: 40 m follows 50 m"],
    );
    ageing_refused(
        &tables("material = \"chian\"\nthickness_m = [0.1]\n"),
        4,
        &["no material named \"chian\"", "chain"],
    );
    ageing_refused(
        &tables("thickness_m = [0.1]\n[[ageing.growth]]\nthickness_m = [0.2]\n"),
        5,
        &["the growth of all materials is given twice"],
    );
    ageing_refused(
        &tables("thickness_m = [0.1]\nnominal_diameter_m = 0.05\n"),
        5,
        &["growth on all materials", "name the material"],
    );
    ageing_refused(&tables("depth_m = [0.0]\n"), 3, &["thickness_m", "missing"]);
    ageing_refused(
        "[ageing]\nyears = 20.0\n[[ageing.corrosion]]\nmaterial = \"chain\"\nbar_diameter_m = 0.05\nrate_m_per_year = [0.4]\n",
        6,
        &["nothing is left of a bar of 0.05 m", "0.0003 for 0.3 mm"],
    );
    let once = "[[ageing.corrosion]]\nmaterial = \"chain\"\nbar_diameter_m = 0.05\nrate_m_per_year = [0.0004]\n";
    ageing_refused(
        &format!("[ageing]\nyears = 20.0\n{once}{once}"),
        8,
        &["the corrosion of \"chain\" is given twice"],
    );
}

#[test]
fn keys_without_effect_are_named() {
    let free = |key: &str| format!("kind = \"free\"\nmass_kg = 1e4\n{key}");
    for (key, words) in [
        ("bed_friction = 0.5", "nothing of the body bears on the bed"),
        ("drift_towards_deg = 30.0", "no drift loads"),
    ] {
        refused("kind = \"held\"", &free(key), 15, &[words]);
    }
}

#[test]
fn keys_of_friction_need_friction_and_their_law() {
    let bed = "depth_m = 100.0";
    let across = format!("{bed}\nfriction_lateral = 0.5");
    refused(bed, &across, 6, &["the bed has no friction"]);
    let other = format!("{bed}\nfriction = 0.3\nslip_speed_m_per_s = 0.1");
    refused(bed, &other, 7, &["no effect with the friction law `grip`"]);
    let line = "length_m = 130.0";
    let across = format!("{line}\nfriction_lateral = 0.5");
    refused(line, &across, 40, &["neither the line nor the bed"]);
}

#[test]
fn clamps_need_a_line_that_bends_and_something_that_holds_them() {
    for (key, line, words) in [
        ("clamp_a_elevation_deg = 10.0", 33, "does not bend"),
        ("clamp_a_azimuth_deg = 10.0", 33, "hinged"),
        (
            "clamp_b_elevation_deg = 10.0",
            33,
            "a free point has no directions",
        ),
    ] {
        let from = "length_m = 200.0";
        refused(from, &format!("{from}\n{key}"), line, &[words]);
    }
}

#[test]
fn drag_of_a_clump_given_twice() {
    let section = "[[lines.sections]]\nmaterial = \"chain\"\nlength_m = 100.0";
    let two = |first: &str, second: &str| format!("{section}\n{first}\n{section}\n{second}\n\n");
    let whole = "material = \"chain\"\nlength_m = 200.0\n\n";
    refused(
        whole,
        &two(
            "clump_kg = 10.0\nclump_drag_area_normal_m2 = 2.0\nclump_drag_area_m2 = 1.0",
            "",
        ),
        36,
        &[
            "clump_drag_area_m2",
            "is given beside `clump_drag_area_normal_m2`",
            "leave it out",
        ],
    );
    refused(
        whole,
        &two("", "clump_drag_area_tangential_m2 = 1.0"),
        38,
        &["clump_drag_area_tangential_m2", "is at the end of the line"],
    );
}

#[test]
fn a_point_has_no_direction_that_its_drag_or_added_mass_could_go_with() {
    for key in [
        "drag_area_normal_m2",
        "drag_area_tangential_m2",
        "added_mass_normal_kg",
        "added_mass_tangential_kg",
    ] {
        refused(
            "kind = \"free\"",
            &format!("kind = \"free\"\nmass_kg = 5.0\n{key} = 1.0"),
            27,
            &[
                &format!("points.middle.{key}"),
                "goes with the direction of a line",
                "[[lines.clumps]]",
            ],
        );
    }
}

#[test]
fn added_mass_of_a_clump_given_twice() {
    let section = "[[lines.sections]]\nmaterial = \"chain\"\nlength_m = 100.0";
    let two = |first: &str, second: &str| format!("{section}\n{first}\n{section}\n{second}\n\n");
    let whole = "material = \"chain\"\nlength_m = 200.0\n\n";
    refused(
        whole,
        &two(
            "clump_kg = 10.0\nclump_added_mass_tangential_kg = 2.0\nclump_added_mass_kg = 1.0",
            "",
        ),
        36,
        &[
            "clump_added_mass_kg",
            "is given beside `clump_added_mass_tangential_kg`",
            "leave it out",
        ],
    );
    refused(
        whole,
        &two("", "clump_added_mass_normal_kg = 1.0"),
        38,
        &["clump_added_mass_normal_kg", "is at the end of the line"],
    );
}
