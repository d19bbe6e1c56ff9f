//! Marine growth and corrosion of lines: against materials changed by hand, against the integral over depth, copy by copy.

use std::f64::consts::FRAC_PI_4;

use seacable::system::SolvedSystem;
use seacable::system::loads::share_of_breaking_load;

use crate::{HEAD, place, solved, tensions};

const G: f64 = 9.806_65;
const WATER: f64 = 1025.0;

/// A chain over a free point to a rope, wholly suspended, with the keys of both materials and the rest of the file.
fn two_lines(chain: &str, rope: &str, rest: &str) -> String {
    format!(
        "{HEAD}[materials.chain]\n{chain}\n[materials.rope]\n{rope}
[points.a]\nkind = \"fixed\"\nposition_m = [0.0, 0.0, -190.0]
[points.b]\nkind = \"fixed\"\nposition_m = [250.0, 40.0, -10.0]
[points.middle]\nkind = \"free\"\nmass_kg = 500.0\nvolume_m3 = 6.0
[[lines]]\nname = \"low\"\nfrom = \"a\"\nto = \"middle\"\nmaterial = \"chain\"\nlength_m = 150.0
[[lines]]\nname = \"high\"\nfrom = \"middle\"\nto = \"b\"\nmaterial = \"rope\"\nlength_m = 190.0\n{rest}"
    )
}

const CHAIN: &str = "diameter_m = 0.1\nmass_kg_per_m = 60.0\nea_n = 4e8\nbreak_load_n = 1e6";
const ROPE: &str = "diameter_m = 0.08\nmass_kg_per_m = 30.0\nwet_weight_kg_per_m = 22.0\nea_n = 1e8\nbreak_load_n = 5e5";

fn close(one: f64, other: f64, tolerance: f64) {
    let error = (one - other).abs();
    assert!(
        error <= tolerance * other.abs(),
        "{one} {other}: {error:.3e}"
    );
}

/// Both systems have the same tensions, places and shares of the breaking load.
fn same(one: &SolvedSystem, other: &SolvedSystem) {
    for (index, line) in ["low", "high"].into_iter().enumerate() {
        for end in 0..2 {
            close(tensions(one, line)[end], tensions(other, line)[end], 1e-12);
        }
        let share = |system: &SolvedSystem| {
            share_of_breaking_load(&system.network, &system.rest, index).unwrap()
        };
        close(share(one), share(other), 1e-12);
    }
    for axis in 0..3 {
        close(
            place(one, "middle")[axis],
            place(other, "middle")[axis],
            1e-12,
        );
    }
}

/// Mass per length of a layer on a cylinder.
fn layer(density: f64, diameter: f64, thickness: f64) -> f64 {
    density * FRAC_PI_4 * ((diameter + 2.0 * thickness).powi(2) - diameter.powi(2))
}

#[test]
fn growth_of_one_thickness_is_a_material_changed_by_hand() {
    let growth =
        "[ageing]\nyears = 5.0\n[[ageing.growth]]\nthickness_m = [0.06]\nfull_after_years = 10.0\n";
    let aged = solved(&two_lines(CHAIN, ROPE, growth));
    // Half of the time, half of the thickness.
    let (chain, rope) = (layer(1325.0, 0.1, 0.03), layer(1325.0, 0.08, 0.03));
    let buoyancy = WATER / 1325.0;
    let by_hand = solved(&two_lines(
        &format!(
            "diameter_m = 0.16\nmass_kg_per_m = {}\nea_n = 4e8\nbreak_load_n = 1e6",
            60.0 + chain
        ),
        &format!(
            "diameter_m = 0.14\nmass_kg_per_m = {}\nwet_weight_kg_per_m = {}\nea_n = 1e8\nbreak_load_n = 5e5",
            30.0 + rope,
            22.0 + rope * (1.0 - buoyancy)
        ),
        "",
    ));
    same(&aged, &by_hand);
    let age = aged.age.as_ref().unwrap();
    assert_eq!((age.years, age.growth_m, age.loss_m), (5.0, 0.03, 0.0));
    assert_eq!(age.rounds, 1);
    // On a chain by DNV-OS-E301: on the diameter of its bar, with the factor 2; nothing on the rope.
    let growth = "[ageing]\nyears = 5.0\n[[ageing.growth]]\nmaterial = \"chain\"\nthickness_m = [0.03]\nnominal_diameter_m = 0.05\nmass_factor = 2.0\n";
    let aged = solved(&two_lines(CHAIN, ROPE, growth));
    let gained = 2.0 * layer(1325.0, 0.05, 0.03);
    let wet = 60.0 - WATER * FRAC_PI_4 * 0.01 + gained * (1.0 - buoyancy);
    let by_hand = format!(
        "diameter_m = 0.22\nmass_kg_per_m = {}\nwet_weight_kg_per_m = {wet}\nea_n = 4e8\nbreak_load_n = 1e6",
        60.0 + gained
    );
    same(&aged, &solved(&two_lines(&by_hand, ROPE, "")));
}

#[test]
fn corrosion_of_one_rate_is_a_material_changed_by_hand() {
    let corrosion = "[ageing]\nyears = 20.0\n[[ageing.corrosion]]\nmaterial = \"chain\"\nbar_diameter_m = 0.055\nrate_m_per_year = [0.0004]\n";
    let aged = solved(&two_lines(CHAIN, ROPE, corrosion));
    let left: f64 = 1.0 - 0.008 / 0.055;
    let share = left * left;
    let by_hand = format!(
        "diameter_m = {}\nmass_kg_per_m = {}\nea_n = {}\nbreak_load_n = {}",
        0.1 * left,
        60.0 * share,
        4e8 * share,
        1e6 * share
    );
    same(&aged, &solved(&two_lines(&by_hand, ROPE, "")));
    close(aged.age.as_ref().unwrap().loss_m, 0.008, 1e-14);
}

#[test]
fn no_years_leave_the_system_as_it_is() {
    let tables = "[ageing]\nyears = 0.0\n[[ageing.growth]]\nthickness_m = [0.06]\n[[ageing.corrosion]]\nmaterial = \"chain\"\nbar_diameter_m = 0.055\nrate_m_per_year = [0.0004]\n";
    let (new, unaged) = (
        solved(&two_lines(CHAIN, ROPE, "")),
        solved(&two_lines(CHAIN, ROPE, tables)),
    );
    assert_eq!(unaged.age, None);
    for line in ["low", "high"] {
        assert_eq!(tensions(&new, line), tensions(&unaged, line));
    }
    assert_eq!(place(&new, "middle"), place(&unaged, "middle"));
    assert_eq!(unaged.network.lines[0].sections.len(), 1);
}

/// Growth that thins with depth, in so many pieces.
fn thinning(pieces: usize) -> String {
    format!(
        "[ageing]\nyears = 1.0\npieces = {pieces}\n[[ageing.growth]]\ndepth_m = [0.0, 200.0]\nthickness_m = [0.2, 0.0]\n"
    )
}

/// The weight that growth adds is the integral over the depths of the line, to the square of the length of the pieces.
#[test]
fn growth_by_depth_adds_its_integral() {
    let new = solved(&two_lines(CHAIN, ROPE, ""));
    let errors = [3, 6, 12, 24].map(|pieces| {
        let aged = solved(&two_lines(CHAIN, ROPE, &thinning(pieces)));
        let index = aged.network.line("high").unwrap();
        let (line, at_rest) = (&aged.network.lines[index], &aged.rest.balance.lines[index]);
        assert_eq!(line.sections.len(), pieces);
        let places = &aged.rest.placement.points;
        let ends = [&places[line.from], &places[line.to]];
        let added: f64 = line
            .sections
            .iter()
            .map(|section| (section.weight_n_per_m / G - 22.0) * section.length_m)
            .sum();
        let count = 4000;
        let each = (0..count).map(|k| {
            let share = (f64::from(k) + 0.5) / f64::from(count);
            let depth = -at_rest.at(share, ends).0.z;
            let thickness = 0.2 * (1.0 - depth / 200.0);
            layer(1325.0, 0.08, thickness) * (1.0 - WATER / 1325.0) * 190.0 / f64::from(count)
        });
        let integral: f64 = each.sum();
        assert!(integral > 1000.0, "{integral}");
        let age = aged.age.as_ref().unwrap();
        assert!(
            age.moved_m < 1e-8 && age.rounds > 1 && age.rounds < 12,
            "{age:?}"
        );
        (added / integral - 1.0).abs()
    });
    for pair in errors.windows(2) {
        assert!(
            pair[0] / pair[1] > 3.5 && pair[0] / pair[1] < 4.5,
            "{errors:?}"
        );
    }
    assert!(errors[2] < 2e-5, "{errors:?}");
    // So do the tension and the place of the junction.
    let results = [6, 12, 24, 96].map(|pieces| {
        let aged = solved(&two_lines(CHAIN, ROPE, &thinning(pieces)));
        [tensions(&aged, "high")[1], place(&aged, "middle")[2]]
    });
    for k in 0..2 {
        let error = |n: usize| (results[n][k] - results[3][k]).abs();
        let quotient = error(0) / error(1);
        assert!(quotient > 3.0 && quotient < 5.0, "{results:?}");
    }
    assert!(place(&new, "middle")[2] > results[3][1] + 1.0);
}

/// Copies hang at the depths of their own fairleads, and age by them.
#[test]
fn copies_age_by_their_own_depths() {
    let text = format!(
        "{HEAD}[seabed]\ndepth_m = 100.0\n[materials.chain]\n{CHAIN}\n[bodies.platform]\nkind = \"held\"\npitch_deg = 20.0
[points.anchor]\nkind = \"fixed\"\nposition_m = [-200.0, 0.0, -100.0]
[points.fairlead]\nkind = \"body\"\nbody = \"platform\"\nposition_m = [-30.0, 0.0, -20.0]
[[lines]]\nname = \"line\"\nfrom = \"anchor\"\nto = \"fairlead\"\nmaterial = \"chain\"\nlength_m = 200.0\nrepeat_at_deg = [0.0, 180.0]
[ageing]\nyears = 1.0\n[[ageing.growth]]\ndepth_m = [0.0, 40.0]\nthickness_m = [0.2, 0.0]
[[ageing.corrosion]]\nmaterial = \"chain\"\nbar_diameter_m = 0.05\ndepth_m = [90.0, 100.0]\nrate_m_per_year = [0.0, 0.001]\n"
    );
    let aged = solved(&text);
    let height = |name: &str| place(&aged, name)[2];
    let (low, high) = match height("fairlead") < height("fairlead@180") {
        true => ("line", "line@180"),
        false => ("line@180", "line"),
    };
    assert!((height("fairlead") - height("fairlead@180")).abs() > 10.0);
    let weights = |name: &str| {
        let line = &aged.network.lines[aged.network.line(name).unwrap()];
        let each = line
            .sections
            .iter()
            .map(|section| section.weight_n_per_m / G);
        each.collect::<Vec<f64>>()
    };
    let wet = 60.0 - WATER * FRAC_PI_4 * 0.01;
    // At the top more growth on the higher one, at the bottom both as corroded on the bed.
    let (of_low, of_high) = (weights(low), weights(high));
    assert!(of_high[11] > of_low[11] + 5.0, "{of_low:?} {of_high:?}");
    assert!(of_low[11] > wet - 1e-9);
    close(of_low[0], wet * 0.98 * 0.98, 1e-12);
    close(of_high[0], wet * 0.98 * 0.98, 1e-12);
}

/// Growth that lowers a buoyed line to where less grows settles, however steep the table.
#[test]
fn growth_that_lowers_a_line_settles() {
    for steep in [60.0, 20.0, 8.0] {
        let growth = format!(
            "[ageing]\nyears = 1.0\n[[ageing.growth]]\ndepth_m = [20.0, {}]\nthickness_m = [0.25, 0.0]\n",
            20.0 + steep
        );
        let text = format!(
            "{HEAD}[seabed]\ndepth_m = 100.0\n[materials.rope]\n{ROPE}
[points.a]\nkind = \"fixed\"\nposition_m = [-100.0, 0.0, -100.0]
[points.b]\nkind = \"fixed\"\nposition_m = [100.0, 0.0, -100.0]
[points.buoy]\nkind = \"free\"\nmass_kg = 500.0\nvolume_m3 = 6.2
[[lines]]\nname = \"left\"\nfrom = \"a\"\nto = \"buoy\"\nmaterial = \"rope\"\nlength_m = 130.0
[[lines]]\nname = \"right\"\nfrom = \"buoy\"\nto = \"b\"\nmaterial = \"rope\"\nlength_m = 130.0\n{growth}"
        );
        let aged = solved(&text);
        let age = aged.age.as_ref().unwrap();
        assert!(age.moved_m < 1e-8, "{steep} m: {age:?}");
    }
}

/// Lines in a current feel more drag with growth on them.
#[test]
fn growth_adds_drag_in_a_current() {
    let rope = format!("{ROPE}\ndrag_normal = 1.2");
    let current = "[current]\nspeed_m_per_s = 1.0\ndirection_deg = 90.0\n";
    let new = solved(&two_lines(CHAIN, &rope, current));
    // As heavy as water, so that it adds drag alone.
    let growth = "[ageing]\nyears = 1.0\n[[ageing.growth]]\nmaterial = \"rope\"\nthickness_m = [0.04]\ndensity_kg_per_m3 = 1025.0\n";
    let aged = solved(&two_lines(CHAIN, &rope, &format!("{current}{growth}")));
    let doubled = format!(
        "{}\ndrag_normal = 2.4",
        ROPE.replace("mass_kg_per_m = 30.0", "mass_kg_per_m = 31.0")
    );
    let by_hand = solved(&two_lines(CHAIN, &doubled, current));
    let aside = |system: &SolvedSystem| place(system, "middle")[1];
    assert!(aged.is_discretised());
    assert!(aside(&aged) > aside(&new) + 1.0);
    close(aside(&aged), aside(&by_hand), 1e-6);
    // By depth as well, in pieces with as many segments in all.
    let thinning = solved(&two_lines(
        CHAIN,
        &rope,
        &format!("{current}{}", thinning(12)),
    ));
    let age = thinning.age.as_ref().unwrap();
    assert!(age.moved_m < 1e-6, "{age:?}");
    assert!(aside(&thinning) > aside(&new) + 1.0);
}
