//! Lines that begin a run in a shape or with a velocity of their own, against free fall.

use seacable::case::kind;
use seacable::system::SystemFile;

use crate::HEAD;
use crate::motion::{channel, moved};

/// Two chains in air, straight between fixed points and a weight in the middle, without tension; what is thrown has this velocity.
fn thrown(up: f64) -> String {
    let line = |name: &str, from: &str, to: &str| {
        format!(
            "[[lines]]\nname = \"{name}\"\nfrom = \"{from}\"\nto = \"{to}\"\nmaterial = \"chain\"\nlength_m = 50.0\nsegments = 20\n\
             [lines.start]\nshape = \"straight\"\nvelocity_m_per_s = [0.0, 0.0, {up:?}]\n"
        )
    };
    format!(
        "[environment]\nwater_density_kg_per_m3 = 0.0\ngravity_m_per_s2 = 10.0\n[materials.chain]\nmass_kg_per_m = 100.0\ndiameter_m = 0.1\nea_n = 1e7\n\
         [points.left]\nkind = \"fixed\"\nposition_m = [-50.0, 0.0, 10.0]\n[points.right]\nkind = \"fixed\"\nposition_m = [50.0, 0.0, 10.0]\n\
         [points.middle]\nkind = \"free\"\nposition_m = [0.0, 0.0, 10.0]\nmass_kg = 500.0\nstart_velocity_m_per_s = [0.0, 0.0, {up:?}]\n\
         {}{}[start]\nplacement = \"given\"\n\
         [solver]\nduration_s = 0.5\ntime_step_s = 0.002\nerror_estimate = false\n[output]\ninterval_s = 0.05\n",
        line("west", "left", "middle"),
        line("east", "middle", "right")
    )
}

#[test]
fn what_is_thrown_without_tension_falls_freely() {
    for up in [0.0, 2.0] {
        let run = moved(&thrown(up));
        // Until the held ends are felt in the middle.
        for (t, z) in run.history.time.iter().zip(channel(&run, "z_m[middle]")) {
            let known = 10.0 + up * t - 5.0 * t * t;
            assert!((z - known).abs() < 1e-6, "{up} m/s, {t} s: {z} {known}");
        }
        let x = channel(&run, "x_m[middle]");
        assert!(x.iter().all(|x| x.abs() < 1e-9), "{x:?}");
    }
}

#[test]
fn a_shape_that_is_given_is_the_straight_one_where_it_is_straight() {
    let straight = thrown(2.0);
    let west = "from = \"left\"";
    let given = |x: [f64; 2]| {
        let [a, b] = x;
        format!(
            "shape = \"given\"\narc_m = [0.0, 50.0]\nx_m = [{a:?}, {b:?}]\nz_m = [10.0, 10.0]\n"
        )
    };
    let mut parts = straight.split("shape = \"straight\"\n");
    let [head, middle, tail] = std::array::from_fn(|_| parts.next().unwrap());
    assert!(head.contains(west));
    let written = [
        head,
        &given([-50.0, 0.0]),
        middle,
        &given([0.0, 50.0]),
        tail,
    ]
    .concat();
    let (one, other) = (moved(&straight), moved(&written));
    for name in ["z_m[middle]", "tension_n[west|a]", "tension_n[east|b]"] {
        let pairs = channel(&one, name).iter().zip(channel(&other, name));
        let apart = pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(apart < 1e-6, "{name}: {apart}");
    }
}

#[test]
fn a_start_that_a_line_of_a_system_cannot_have_is_refused() {
    let good = format!("{HEAD}{}", thrown(0.0));
    let shape = "shape = \"straight\"";
    for (from, to, words) in [
        (
            shape,
            "azimuth_deg = 3.0",
            "the line goes from one of its points to the other",
        ),
        (shape, "shape = \"given\"", "arc_m"),
        (
            shape,
            "shape = \"given\"\narc_m = [0.0, 40.0]\nx_m = [-50.0, 0.0]\nz_m = [10.0, 10.0]",
            "the line is 50 m long",
        ),
        (shape, "arc_m = [0.0, 50.0]", "searches its own equilibrium"),
        (
            "length_m = 50.0",
            "length_m = 50.0\nbreak_at_m = 20.0\nbreak_s = 0.1",
            "may break begins at rest",
        ),
        (
            "length_m = 50.0",
            "length_m = 50.0\nrepeat_at_deg = [0.0, 90.0]",
            "has copies begins at rest",
        ),
    ] {
        let text = good.replacen(from, to, 1);
        let found = kind::parse::<SystemFile>(&text, "system.toml").unwrap_err();
        let said: String = found
            .iter()
            .map(|one| format!("{one} {}\n", one.remedy))
            .collect();
        assert!(said.contains(words), "{words}: {said}");
    }
}
