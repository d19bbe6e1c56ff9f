//! Line types against tables of makers and of other programs.

use super::{LINE_TYPES, LineProperties, find, nominal_diameter, properties, with_material};

fn of(name: &str, diameter: f64) -> LineProperties {
    properties(find(name).unwrap(), diameter).unwrap()
}

fn near(value: f64, wanted: f64, share: f64) {
    let error = (value / wanted - 1.0).abs();
    assert!(error <= share, "{value} is no {wanted}");
}

/// Loads in kN as makers print them by IACS UR W22: diameter in mm, breaking loads of R3, R3S, R4, proof loads of R3S and R4
/// without and with stud.
const PRINTED: [[f64; 8]; 4] = [
    [34.0, 1065.0, 1189.0, 1308.0, 831.0, 859.0, 917.0, 1031.0],
    [50.0, 2230.0, 2490.0, 2740.0, 1740.0, 1800.0, 1920.0, 2160.0],
    [60.0, 3147.0, 3514.0, 3867.0, 2456.0, 2541.0, 2710.0, 3049.0],
    [70.0, 4196.0, 4686.0, 5156.0, 3274.0, 3387.0, 3613.0, 4065.0],
];

#[test]
fn chain_has_the_loads_of_makers_tables() {
    for [d, r3, r3s, r4, r3s_studless, r3s_stud, r4_studless, r4_stud] in PRINTED {
        let breaks = |name| of(name, 1e-3 * d).break_load.value / 1e3;
        let proof = |name| of(name, 1e-3 * d).proof_load.unwrap().value / 1e3;
        // Printed to whole kN.
        let rounds = |value: f64, printed: f64| {
            assert!((value - printed).abs() <= 1.0, "{value} {printed} at {d}");
        };
        rounds(breaks("chain-r3-stud"), r3);
        rounds(breaks("chain-r3s-studless"), r3s);
        rounds(breaks("chain-r4-studless"), r4);
        rounds(proof("chain-r3s-studless"), r3s_studless);
        rounds(proof("chain-r3s-stud"), r3s_stud);
        rounds(proof("chain-r4-studless"), r4_studless);
        rounds(proof("chain-r4-stud"), r4_stud);
    }
}

#[test]
fn r4_studless_chain_of_120_mm() {
    let chain = of("chain-r4-studless", 0.120);
    near(
        chain.break_load.value,
        0.0274e3 * 14_400.0 * (44.0 - 9.6),
        1e-12,
    );
    near(chain.mass.value, 286.56, 1e-12);
    near(chain.ea.value, 5.15e10 * 0.022_619_467_105_846_51, 1e-12);
    near(
        chain.drag_normal.value * chain.diameter.value,
        2.4 * 0.12,
        1e-12,
    );
    // Steel of 7850 kg/m^3 loses 0.13 of its weight in sea water.
    near(chain.wet_weight.value / chain.mass.value, 0.87, 2e-3);
}

/// Properties that MoorPy computes from its default coefficients: type, nominal diameter, volume-equivalent diameter \[m\],
/// mass \[kg/m\], EA and breaking load \[N\], normal drag; and how near: its chain takes 20.0 for 19.9 and 1.21e9 for 1.2056e9, its
/// stiffness of chain falls a thousandth as fast with the diameter as that of DNV-OS-E301.
const MOORPY: [(&str, f64, [f64; 5], f64); 5] = [
    (
        "chain-r4-studless",
        0.12,
        [0.216, 288.0, 1.2326e9, 1.3640e7, 1.333],
        0.06,
    ),
    (
        "spiral-strand",
        0.09,
        [0.1062, 42.873, 7.8651e8, 8.2782e6, 1.021],
        5e-3,
    ),
    (
        "polyester",
        0.15,
        [0.118_72, 15.2775, 9.702e7, 6.93e6, 2.021],
        1e-3,
    ),
    (
        "nylon",
        0.12,
        [0.097, 8.424, 1.689_12e7, 3.378_24e6, 1.979],
        1e-3,
    ),
    (
        "hmpe",
        0.1,
        [0.080_48, 4.96, 3.612_56e8, 6.451e6, 1.988],
        1e-3,
    ),
];

#[test]
fn types_are_near_those_of_moorpy() {
    for (name, d, [diameter, mass, ea, load, drag], share) in MOORPY {
        let line = of(name, d);
        near(line.diameter.value, diameter, share);
        near(line.mass.value, mass, share);
        near(line.ea.value, ea, share);
        near(line.break_load.value, load, share);
        near(line.drag_normal.value, drag, share);
    }
}

#[test]
fn properties_are_positive_and_grow_with_the_diameter() {
    for line_type in LINE_TYPES {
        let [least, greatest] = line_type.diameters_m;
        let sizes = (0..=40).map(|i| least + (greatest - least) * f64::from(i) / 40.0);
        let lines: Vec<_> = sizes.map(|d| properties(line_type, d).unwrap()).collect();
        for line in &lines {
            let proof = line.proof_load.as_ref().map_or(1.0, |load| load.value);
            let least = proof.min(line.ea.value).min(line.mass.value);
            assert!(
                least > 0.0 && line.drag_normal.value > 0.0,
                "{}",
                line_type.name
            );
            assert!(proof < line.break_load.value);
            assert!(line.warning.is_none());
        }
        let grows = |read: fn(&LineProperties) -> f64| {
            assert!(lines.windows(2).all(|pair| read(&pair[0]) < read(&pair[1])));
        };
        grows(|line| line.diameter.value);
        grows(|line| line.mass.value);
        grows(|line| line.ea.value);
        grows(|line| line.break_load.value);
    }
}

#[test]
fn higher_grades_bear_more() {
    let loads = ["r3", "r3s", "r4", "r4s", "r5"]
        .map(|grade| of(&format!("chain-{grade}-studless"), 0.1).break_load.value);
    assert!(loads.is_sorted());
}

#[test]
fn diameters_are_lengths() {
    for text in ["120mm", "0.12 m", "0.12", "12 cm"] {
        near(nominal_diameter(text).unwrap(), 0.12, 1e-12);
    }
    for text in ["", "120", "nan", "-1mm", "0", "1e-300", "12 kg", "inf"] {
        assert!(nominal_diameter(text).is_err(), "{text}");
    }
    assert!(properties(&LINE_TYPES[0], f64::NAN).is_err());
    assert!(of("polyester", 0.001).warning.is_some());
}

#[test]
fn every_type_is_read_back_as_the_material_it_is() {
    let text = include_str!("../../../cases/mooring/hybrid_fixed.toml");
    for line_type in LINE_TYPES {
        let line = properties(line_type, line_type.diameters_m[1]).unwrap();
        let (edited, name) = with_material(text, &line);
        let case = crate::case::parse(&edited, "edited.toml").unwrap();
        let (read, meant) = (&case.materials[&name], line.material());
        near(read.diameter_m, meant.diameter_m, 1e-6);
        near(read.mass_kg_per_m, meant.mass_kg_per_m, 1e-6);
        near(read.ea_n.unwrap(), meant.ea_n.unwrap(), 1e-6);
        near(
            read.break_load_n.unwrap(),
            meant.break_load_n.unwrap(),
            1e-6,
        );
        let (again, second) = with_material(&edited, &line);
        assert_ne!(name, second);
        assert!(crate::case::parse(&again, "again.toml").is_ok());
    }
}
