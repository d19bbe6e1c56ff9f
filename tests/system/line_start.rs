//! Lines that begin a run in a shape or with a velocity of their own, against free fall.

use seacable::case::kind;
use seacable::system::SystemFile;
use seacable::system::warnings::warnings;

use crate::motion::{channel, moved};
use crate::{HEAD, solved};

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

/// A chain thrown across its plane in a bent shape, at a place (x, y, z) \[m\] for each of its corners.
fn bent(place: impl Fn([f64; 3]) -> [f64; 3], is_reversed: bool) -> String {
    let mut corners = [[0.0, 0.0, 0.0], [20.0, 5.0, -12.0], [40.0, 0.0, -10.0]].map(&place);
    let [left, _, right] = corners;
    let origin = place([0.0; 3]);
    let toss = place([0.5, 1.5, 1.0]);
    let toss = [0, 1, 2].map(|axis| toss[axis] - origin[axis]);
    let mut arc = [0.0, 24.0, 46.0];
    let mut ends = ["left", "right"];
    if is_reversed {
        corners.reverse();
        ends.reverse();
        arc = [0.0, 22.0, 46.0];
    }
    let column = |axis: usize| corners.map(|corner| corner[axis]);
    format!(
        "[environment]\nwater_density_kg_per_m3 = 1000.0\n[materials.chain]\nmass_kg_per_m = 100.0\ndiameter_m = 0.1\nea_n = 1e7\ndrag_normal = 1.0\n\
         [points.left]\nkind = \"fixed\"\nposition_m = {left:?}\n[points.right]\nkind = \"fixed\"\nposition_m = {right:?}\n\
         [[lines]]\nname = \"line\"\nfrom = \"{}\"\nto = \"{}\"\nmaterial = \"chain\"\nlength_m = 46.0\nsegments = 23\n\
         [lines.start]\nshape = \"given\"\narc_m = {arc:?}\nx_m = {:?}\ny_m = {:?}\nz_m = {:?}\nvelocity_m_per_s = {toss:?}\n\
         [solver]\nduration_s = 3.0\ntime_step_s = 0.005\nerror_estimate = false\n[output]\ninterval_s = 0.1\n",
        ends[0],
        ends[1],
        column(0),
        column(1),
        column(2)
    )
}

#[test]
fn a_start_turned_mirrored_and_reversed_is_the_same() {
    let own = moved(&bent(|place| place, false));
    let turned = moved(&bent(|[x, y, z]| [7.0 - y, x - 3.0, z], false));
    let mirrored = moved(&bent(|[x, y, z]| [x, -y, z], false));
    let reversed = moved(&bent(|place| place, true));
    let tension = |run, end: &str| channel(run, &format!("tension_n[line|{end}]")).to_vec();
    for (other, ends) in [
        (&turned, ["a", "b"]),
        (&mirrored, ["a", "b"]),
        (&reversed, ["b", "a"]),
    ] {
        for (end, same) in ["a", "b"].into_iter().zip(ends) {
            let own = tension(&own, end);
            let greatest = own.iter().copied().fold(0.0, f64::max);
            assert!(greatest > 1e4, "{greatest}");
            for (own, other) in own.iter().zip(tension(other, same)) {
                assert!(
                    (own - other).abs() < 1e-8 * greatest,
                    "{end}: {own} {other}"
                );
            }
        }
    }
}

#[test]
fn a_start_without_a_run_is_said_to_have_no_effect() {
    let said = |text: &str| warnings(&solved(&format!("{HEAD}{text}"))).join("\n");
    let still = thrown(0.0);
    let (still, _) = still.split_once("[solver]").unwrap();
    let found = said(still);
    assert!(
        found.contains("Line west is at rest: how it starts is of a run in time"),
        "{found}"
    );
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
        (shape, "arc_m = [0.0, 50.0]", "x_m"),
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

/// A rod pressed together between two hinges to where its ends turn by 20 degrees, to the side of this sign.
fn buckled(side: f64, more: &str) -> String {
    let z = [0.0, 0.339, 0.6448, 0.8875, 1.0434, 1.0971].map(|z| side * z);
    let z: Vec<f64> = z.iter().chain(z[..5].iter().rev()).copied().collect();
    let along: Vec<f64> = (0..=10).map(f64::from).collect();
    let x: Vec<f64> = along.iter().map(|s| 0.9697309074 * s).collect();
    format!(
        "[environment]\nwater_density_kg_per_m3 = 0.0\n[materials.rod]\ndiameter_m = 0.05\nmass_kg_per_m = 10.0\nwet_weight_kg_per_m = 0.0\nea_n = 1e9\nei_n_m2 = 1e4\n\
         [points.a]\nkind = \"fixed\"\nposition_m = [0.0, 0.0, 0.0]\n[points.b]\nkind = \"fixed\"\nposition_m = [9.697309074, 0.0, 0.0]\n\
         [[lines]]\nname = \"rod\"\nfrom = \"a\"\nto = \"b\"\nmaterial = \"rod\"\nlength_m = 10.0\nsegments = 80\n\
         [lines.start]\narc_m = {along:?}\nx_m = {x:?}\nz_m = {z:?}\n{more}"
    )
}

#[test]
fn a_buckled_rod_rests_on_the_side_that_its_search_begins_on() {
    for side in [1.0, -1.0] {
        let system = solved(&format!("{HEAD}{}", buckled(side, "")));
        let line = &system.rest.balance.lines[0];
        // The elastica between hinges: (2 K(k))^2 EI / L^2 and a rise of k L / K(k), k = sin 10 deg.
        let (force, at_rest) = (line.force_b.x, line.discretised.as_ref().unwrap());
        assert!((force / 1002.156537 - 1.0).abs() < 2e-3, "{force}");
        let rise = side * at_rest.found.position_m[40].z;
        assert!((rise / 1.097065212 - 1.0).abs() < 2e-3, "{rise}");
    }
}

#[test]
fn where_the_search_of_a_closed_form_begins_has_no_effect() {
    let rope = buckled(1.0, "").replace("ei_n_m2 = 1e4\n", "");
    let rope = rope.replace("wet_weight_kg_per_m = 0.0\n", "");
    let said = warnings(&solved(&format!("{HEAD}{rope}"))).join("\n");
    assert!(
        said.contains("where its search begins has no effect"),
        "{said}"
    );
}
