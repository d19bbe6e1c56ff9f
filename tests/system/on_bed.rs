//! Free points that land on the bed and slide along it.

use seacable::system::motion::run::MotionRun;

use crate::motion::{channel, moved};

/// The block as a point, and as a body that bears on the bed by its foot.
const POINT: &str = "[points.block]\nkind = \"free\"\nposition_m = [0.0, 0.0, -20.0]\n";
const BODY: &str = "[points.eye]\nkind = \"body\"\nbody = \"block\"\nposition_m = [0.0, 0.0, 0.0]\n\
    [bodies.block]\nkind = \"free\"\nposition_m = [0.0, 0.0, -18.5]\nbottom_m = 1.5\ncentre_of_gravity_m = [0.0, 0.0, -0.5]\ninertia_kg_m2 = [200.0, 200.0, 200.0]\n";

/// A block on the bed under a side load of 1 kN, held by a stay until 1 s.
fn block(kind: &str, friction: f64) -> MotionRun {
    let (end, height) = match kind {
        POINT => ("block", -20.0),
        _ => ("eye", -18.5),
    };
    moved(&format!(
        "[environment]\nwater_density_kg_per_m3 = 0.0\ngravity_m_per_s2 = 10.0\n[seabed]\ndepth_m = 20.0\n\
         [materials.wire]\nmass_kg_per_m = 0.1\ndiameter_m = 0.01\nea_n = 1e6\naxial_damping_n_s = 1e3\n\
         [points.post]\nkind = \"fixed\"\nposition_m = [-30.0, 0.0, {height:?}]\n\
         {kind}mass_kg = 500.0\nload_n = [1000.0, 0.0, 0.0]\nbed_friction = {friction:?}\n\
         [[lines]]\nname = \"stay\"\nfrom = \"post\"\nto = \"{end}\"\nmaterial = \"wire\"\nlength_m = 30.0\nsegments = 10\nrelease_b_s = 1.0\n\
         [solver]\nduration_s = 5.0\nerror_estimate = false\n[output]\ninterval_s = 0.25\n"
    ))
}

#[test]
fn a_block_stays_where_friction_holds_it() {
    for kind in [POINT, BODY] {
        let run = block(kind, 0.3);
        let x = channel(&run, "x_m[block]");
        // The bed gives way along itself as much as under the weight: a millimetre by 5 kN.
        let given = x[x.len() - 1] - x[0];
        assert!((given - 0.2e-3).abs() < 0.02e-3, "{given}");
        assert!(run.balance.relative_drift() < 0.02, "{:?}", run.balance);
    }
}

#[test]
fn a_block_slides_where_friction_does_not_hold_it() {
    for (kind, friction) in [(POINT, 0.0), (POINT, 0.1), (BODY, 0.0), (BODY, 0.1)] {
        let run = block(kind, friction);
        // Of the centre of gravity, half a metre below the origin of the body, which swings.
        let swung = (kind == BODY).then(|| channel(&run, "pitch_deg[block]"));
        let below = |k: usize| swung.map_or(0.0, |pitch| 0.5 * pitch[k].to_radians().sin());
        let x = channel(&run, "x_m[block]").iter().enumerate();
        let x: Vec<f64> = x.map(|(k, x)| x - below(k)).collect();
        let acceleration = (1000.0 - friction * 5000.0) / 500.0;
        for (x_now, time) in x.iter().zip(&run.history.time) {
            let since = (time - 1.0).max(0.0);
            let expected = 0.5 * acceleration * since * since;
            let off = x_now - x[0] - expected;
            assert!(
                off.abs() < 5e-3 * expected.max(1.0),
                "{friction} {time}: {off}"
            );
        }
        assert!(run.balance.relative_drift() < 0.01, "{:?}", run.balance);
    }
}

/// A clump that a taut wire lets down onto its area, 23.5 m below the surface, where its bottom has sunk into the bed.
const SUNK: &str = "[environment]\nwater_density_kg_per_m3 = 0.0\ngravity_m_per_s2 = 10.0\n\
    [seabed]\ndepth_m = 25.0\nstiffness_n_per_m3 = 2e5\ndamping_n_s_per_m3 = 2e4\n\
    [materials.wire]\nmass_kg_per_m = 1.0\ndiameter_m = 0.02\nea_n = 1e6\naxial_damping_n_s = 1e3\n\
    [points.top]\nkind = \"fixed\"\nposition_m = [0.0, 0.0, 0.0]\n\
    [points.clump]\nkind = \"free\"\nposition_m = [0.0, 0.0, -23.4]\nmass_kg = 4000.0\nbed_area_m2 = 2.5\nbottom_m = 1.5\n\
    [[lines]]\nname = \"wire\"\nfrom = \"top\"\nto = \"clump\"\nmaterial = \"wire\"\nlength_m = 23.5\nsegments = 10\n";

#[test]
fn an_area_sinks_by_the_weight_that_the_line_leaves() {
    let system = crate::solved(&format!("{}{SUNK}", crate::HEAD));
    let [_, foot] = crate::tensions(&system, "wire");
    let [x, y, z] = crate::place(&system, "clump");
    let sunk = -25.0 + 1.5 - z;
    assert_eq!([x, y], [0.0; 2]);
    assert!(foot > 0.0 && sunk > 0.05, "{foot} {sunk}");
    // The stretch of the wire is e with T + w L / 2 = EA e / L.
    let pull = 1e6 * (-z - 23.5) / 23.5 - 0.5 * 10.0 * 23.5;
    assert!((foot - pull).abs() < 1e-6 * pull, "{foot} {pull}");
    let borne = 4e4 - foot;
    assert!((sunk * 5e5 - borne).abs() < 1e-6 * borne, "{sunk}");
}

#[test]
fn an_area_bounces_on_its_springs_in_time_by_every_method() {
    for method in ["alpha", "rk4"] {
        let text = "start_offset_m = [0.0, 0.0, 0.5]\ndrag_area_m2 = [1.0, 1.0, 3.0]\nadded_mass_kg = [100.0, 100.0, 900.0]\n";
        let (head, line) = SUNK.split_once("[[lines]]").unwrap();
        let run = moved(&format!(
            "{head}{text}[[lines]]{line}[solver]\nmethod = \"{method}\"\nduration_s = 20.0\nerror_estimate = false\n[output]\ninterval_s = 0.1\n"
        ));
        let [z, bears] = ["z_m[clump]", "bed_force_n[clump]"].map(|name| channel(&run, name));
        let at_rest = crate::place(&crate::solved(&format!("{}{SUNK}", crate::HEAD)), "clump")[2];
        let last = z.len() - 1;
        assert!(
            (z[last] - at_rest).abs() < 1e-4,
            "{method}: {} {at_rest}",
            z[last]
        );
        assert!(
            (bears[last] - 5e5 * (-23.5 - z[last])).abs() < 5.0,
            "{method}: {}",
            bears[last]
        );
        assert!(
            run.balance.relative_drift() < 0.01,
            "{method}: {:?}",
            run.balance
        );
    }
}

/// Slowly lifted, what suction holds pulls with its weight and the breakout force at most, and with its weight after that.
#[test]
fn suction_of_points_and_bodies_is_overcome_once() {
    let suction = "breakout_n = 5000.0\nbreakout_distance_m = 0.2\n";
    let lifted = "kind = \"moved\"\namplitude_m = [0.0, 0.0, 2.0]\nperiod_s = 400.0\n";
    let point = SUNK.replace("bottom_m = 1.5\n", &format!("bottom_m = 1.5\n{suction}"));
    let (head, rest) = SUNK.split_once("[points.clump]").unwrap();
    let (_, line) = rest.split_once("[[lines]]").unwrap();
    let body = format!(
        "{head}[points.clump]\nkind = \"body\"\nbody = \"block\"\nposition_m = [0.0, 0.0, 0.5]\n\
         [points.foot]\nkind = \"body\"\nbody = \"block\"\nposition_m = [0.0, 0.0, -1.0]\nbed_area_m2 = 2.5\n{suction}\
         [bodies.block]\nkind = \"free\"\nposition_m = [0.0, 0.0, -24.0]\nmass_kg = 4000.0\ninertia_kg_m2 = [1e4, 1e4, 1e4]\n[[lines]]{line}"
    );
    for (text, bears, method) in [
        (&point, "clump", "alpha"),
        (&point, "clump", "rk4"),
        (&body, "foot", "alpha"),
    ] {
        let text = text.replacen("kind = \"fixed\"\n", lifted, 1);
        let run = moved(&format!(
            "{text}[solver]\nmethod = \"{method}\"\nduration_s = 100.0\nerror_estimate = false\n[output]\ninterval_s = 0.02\n"
        ));
        let pull = channel(&run, "tension_n[wire|b]");
        let bed = channel(&run, &format!("bed_force_n[{bears}]"));
        let greatest = pull.iter().copied().fold(0.0, f64::max);
        let least = bed.iter().copied().fold(0.0, f64::min);
        assert!((greatest / 45e3 - 1.0).abs() < 0.01, "{method}: {greatest}");
        assert!((least / -5e3 - 1.0).abs() < 0.01, "{method}: {least}");
        let late = &pull[3000..];
        let mean = late.iter().sum::<f64>() / late.len() as f64;
        // Let go with a jerk it bounces about its weight.
        assert!((mean / 40e3 - 1.0).abs() < 0.02, "{method}: {mean}");
        assert!(bed[3000..].iter().all(|force| *force == 0.0));
        assert!(
            run.balance.relative_drift() < 0.01,
            "{method}: {:?}",
            run.balance
        );
    }
}

#[test]
fn suction_that_acts_on_nothing_is_refused() {
    let suction = "mass_kg = 4000.0\nbreakout_n = 5.0\n";
    let bed = "[seabed]\ndepth_m = 25.0\nstiffness_n_per_m3 = 2e5\ndamping_n_s_per_m3 = 2e4\n";
    let held = "position_m = [0.0, 0.0, 0.0]\n";
    let area = "bed_area_m2 = 2.5\nbottom_m = 1.5\n";
    for (text, key) in [
        (
            SUNK.replace(bed, "")
                .replace("mass_kg = 4000.0\n", suction)
                .replace(area, ""),
            "points.clump.breakout_n",
        ),
        (
            SUNK.replacen(held, &format!("{held}breakout_n = 5.0\n"), 1),
            "points.top.breakout_n",
        ),
    ] {
        let text = format!("{}{text}", crate::HEAD);
        let found = seacable::case::kind::parse::<seacable::system::SystemFile>(&text, "s.toml");
        let found = found.unwrap_err();
        assert_eq!(found[0].key, key, "{found:?}");
    }
}

#[test]
fn areas_and_bottoms_that_act_on_nothing_are_refused() {
    let bed = "[seabed]\ndepth_m = 25.0\nstiffness_n_per_m3 = 2e5\ndamping_n_s_per_m3 = 2e4\n";
    let wrong = [
        (
            SUNK.replace(bed, ""),
            "points.clump.bed_area_m2",
            "there is no bed",
        ),
        (
            SUNK.replace(bed, ""),
            "points.clump.bottom_m",
            "there is no bed",
        ),
        (
            SUNK.replace(
                "position_m = [0.0, 0.0, 0.0]\n",
                "position_m = [0.0, 0.0, 0.0]\nbed_area_m2 = 1.0\n",
            ),
            "points.top.bed_area_m2",
            "no effect on a point that is held",
        ),
        (
            SUNK.replace("bed_area_m2 = 2.5", "bed_area_m2 = -2.5"),
            "points.clump.bed_area_m2",
            "0",
        ),
        (
            SUNK.replace("bed_area_m2 = 2.5", "drag_area_m2 = [1.0, 2.0]"),
            "points.clump.drag_area_m2",
            "three",
        ),
        (
            SUNK.replace("bed_area_m2 = 2.5", "added_mass_kg = [1.0, -2.0, 1.0]"),
            "points.clump.added_mass_kg",
            "0",
        ),
    ];
    for (text, key, why) in wrong {
        let found = crate::motion::refused(&text);
        assert!(found.contains(key) && found.contains(why), "{key}: {found}");
    }
}

/// What hangs on a wire of a length from the surface over a bed 24 m down, let go with the wire's end at half a second.
fn let_go(hung: &str, end: &str, length: f64) -> MotionRun {
    moved(&format!(
        "[environment]\nwater_density_kg_per_m3 = 0.0\n[seabed]\ndepth_m = 24.0\n\
         [materials.wire]\nmass_kg_per_m = 10.0\ndiameter_m = 0.03\nea_n = 5e7\naxial_damping_n_s = 1e4\n\
         [points.top]\nkind = \"fixed\"\nposition_m = [0.0, 0.0, 0.0]\n{hung}\
         [[lines]]\nname = \"wire\"\nfrom = \"{end}\"\nto = \"top\"\nmaterial = \"wire\"\nlength_m = {length:?}\nsegments = 10\nrelease_a_s = 0.5\n\
         [solver]\nduration_s = 4.0\nerror_estimate = false\n[output]\ninterval_s = 0.25\n"
    ))
}

#[test]
fn what_lands_comes_to_rest_and_loses_no_energy_unseen() {
    // Metres above the bed, it lands within a step of the line that is let go with it.
    let clump = "[points.clump]\nkind = \"free\"\nmass_kg = 2000.0\n";
    let block = "[points.eye]\nkind = \"body\"\nbody = \"block\"\nposition_m = [0.0, 0.0, 1.0]\n\
         [bodies.block]\nkind = \"free\"\nposition_m = [0.0, 0.0, -18.0]\nmass_kg = 2000.0\nbottom_m = 1.5\nbed_friction = 0.3\n\
         inertia_kg_m2 = [2e3, 2e3, 2e3]\ncentre_of_gravity_m = [0.0, 0.0, -0.5]\n";
    let cases = [
        (let_go(clump, "clump", 20.0), "z_m[clump]", -24.001),
        (let_go(block, "eye", 18.0), "z_m[block]", -22.501),
    ];
    for (run, name, rests) in cases {
        let z = channel(&run, name);
        assert!((z[z.len() - 1] - rests).abs() < 1e-4, "{:?}", z.last());
        assert!(run.balance.relative_drift() < 0.01, "{:?}", run.balance);
        assert!(run.warnings.is_empty(), "{:?}", run.warnings);
    }
}
