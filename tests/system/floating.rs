//! Free bodies by what is known of ships: responses to waves, mean drift by heading, decay from where they are let go.

use std::f64::consts::TAU;

use nalgebra::Complex;
use seacable::system::motion::run::MotionRun;

use crate::motion::{channel, moved, refused};
use crate::waves::{RESPONSES, SOFT, held, solver};
use crate::{HEAD, place, solved};

const G: f64 = 9.80665;

/// A small ship afloat at this heading, damped in all directions.
fn ship(yaw: f64, keys: &str) -> String {
    format!(
        "[bodies.ship]\nkind = \"free\"\nmass_kg = 6.2e5\ninertia_kg_m2 = [6e6, 1.2e8, 1.2e8]\nvolume_m3 = {:?}\nyaw_deg = {yaw:?}
        waterplane_stiffness = [0.0, 0.0, 3.7e6, 1.2e7, 7.3e8, 0.0]\nadded_mass = [3e4, 4.5e5, 1.4e6, 1.5e6, 2.3e8, 6e7]
        damping = [6e4, 1e5, 1e6, 3e6, 2e8, 4e7]\n{keys}\n",
        6.2e5 / 1025.0
    )
}

/// The harmonic of a channel at a period of an even number of rows, over the last five; what drifts steadily, as waves of the second order
/// have it, is none.
fn harmonic(run: &MotionRun, name: &str, period: f64) -> Complex<f64> {
    let (time, values) = (&run.history.time, channel(run, name));
    let half = (0.5 * period / (time[1] - time[0])).round() as usize;
    let rows = values.len() - 10 * half..values.len();
    let count = rows.len() as f64;
    let part = |k: usize| {
        let value = 0.5 * (values[k] - values[k - half]);
        Complex::from_polar(2.0 / count * value, -TAU / period * time[k])
    };
    rows.map(part).sum()
}

#[test]
fn a_free_body_responds_to_waves_as_its_responses_say() {
    let period = 8.0;
    // The lines hold its heading.
    let (sin, cos) = f64::to_radians(30.0).sin_cos();
    let anchor = format!("[{:?}, {:?}, -5.0]", 20.0 + 150.0 * cos, 150.0 * sin);
    let held_at_20_m = held("ship")
        .replace(
            "repeat_at_deg",
            "repeat_about_m = [20.0, 0.0]\nrepeat_at_deg",
        )
        .replace("[150.0, 0.0, -5.0]", &anchor);
    let text = format!(
        "{}{}[[waves]]\nkind = \"regular\"\nheight_m = 0.1\nperiod_s = {period:?}\ndirection_deg = 75.0\nramp_s = 100.0\n{}[files.\"r.csv\"]\ntext = \"\"\"{RESPONSES}\"\"\"\n",
        ship(
            30.0,
            "response_file = \"r.csv\"\nposition_m = [20.0, 0.0, 0.0]"
        ),
        held_at_20_m,
        solver(240.0, 0.1, 0.1)
    );
    let run = moved(&text);
    // 45 degrees from the bow, half way between the tables ahead and abeam; the crest comes later by k 20 m cos 75.
    let late = TAU.powi(2) / (period * period) / G * 20.0 * f64::to_radians(75.0).cos();
    let expected = [
        ("z_m[ship]", 0.5 * 0.05, 30.0),
        ("roll_deg[ship]", 1.0 * 0.05, 0.0),
        ("pitch_deg[ship]", 0.5 * 0.05, 0.0),
        // Surge and sway of 0.2 each in axes turned by 30 degrees.
        ("x_m[ship]", 0.2 * 0.05 * (0.75_f64.sqrt() - 0.5), 90.0),
        ("y_m[ship]", 0.2 * 0.05 * (0.75_f64.sqrt() + 0.5), 90.0),
    ];
    for (name, size, lead) in expected {
        let found = harmonic(&run, name, period);
        let known = Complex::from_polar(size, f64::to_radians(lead) - late);
        let off = (found - known).norm();
        assert!(off < 0.01 * size, "{name}: off by {off} of {size}");
    }
}

#[test]
fn a_line_in_still_water_feels_neither_current_nor_waves() {
    let text = |spared: &str| {
        format!(
            "{SOFT}[points.a]\nkind = \"fixed\"\nposition_m = [0.0, 0.0, -2.0]\n[points.b]\nkind = \"fixed\"\nposition_m = [40.0, 0.0, -2.0]
            [[lines]]\nname = \"line\"\nfrom = \"a\"\nto = \"b\"\nmaterial = \"soft\"\nlength_m = 42.0\nsegments = 8
{spared}            [[waves]]\nkind = \"regular\"\nheight_m = 2.0\nperiod_s = 6.0\n[solver]\nduration_s = 12.0\nerror_estimate = false\n"
        )
    };
    let range = |text: &str| {
        let run = moved(text);
        let pull = channel(&run, "tension_n[line|a]").to_vec();
        let most = pull.iter().copied().fold(f64::MIN, f64::max);
        most - pull.iter().copied().fold(f64::MAX, f64::min)
    };
    let at_rest = |keys: &str, current: &str| {
        let system = solved(&format!("{HEAD}{current}{}", text(keys)));
        crate::tensions(&system, "line")[0]
    };
    let current = "[current]\nspeed_m_per_s = 1.0\ndirection_deg = 90.0\n";
    let still = at_rest("", "");
    assert!(at_rest("", current) > 2.0 * still);
    assert_eq!(at_rest("still_water = true\n", current), still);
    assert!(range(&text("")) > 0.1);
    assert!(range(&text("still_water = true\n")) < 1e-6);
}

/// A body that rises again from a start aside: k z + c v + m a = 0.
#[test]
fn a_body_let_go_aside_decays_by_its_closed_form() {
    let decay = |(mass, damping, stiffness): (f64, f64, f64), t: f64| {
        let rate = 0.5 * damping / mass;
        let omega = (stiffness / mass - rate * rate).sqrt();
        (-rate * t).exp() * ((omega * t).cos() + rate / omega * (omega * t).sin())
    };
    // One by one: what heaves and rolls at once feels the moment of its added mass too.
    let cases = [
        (
            "start_offset_m = [0.0, 0.0, 0.5]",
            "z_m[ship]",
            0.5,
            (6.2e5 + 1.4e6, 1e6, 3.7e6),
        ),
        (
            "start_offset_deg = [2.0, 0.0, 0.0]",
            "roll_deg[ship]",
            2.0,
            (6e6 + 1.5e6, 3e6, 1.2e7),
        ),
    ];
    for (keys, name, size, of) in cases {
        let run = moved(&format!(
            "{}{}{}",
            ship(0.0, keys),
            held("ship"),
            solver(20.0, 0.05, 0.1)
        ));
        for (t, found) in run.history.time.iter().zip(channel(&run, name)) {
            let known = size * decay(of, *t);
            assert!(
                (found - known).abs() < 2e-3 * size,
                "{name} at {t}: {found} {known}"
            );
        }
        // Of soft lines and a light ship: what it held is lost to damping.
        assert!(run.balance.relative_drift() < 1e-3, "{:?}", run.balance);
    }
}

#[test]
fn mean_drift_turns_with_the_heading() {
    // Held at its bow it lies in the drift, which pulls with its load from astern and from ahead.
    let loads = [
        (0.0, 0.0, 2e3, 0.0),
        (90.0, 4e3, 0.0, 0.0),
        (180.0, 0.0, -2e3, 0.0),
        (270.0, -4e3, 0.0, 0.0),
    ];
    let rows: String = loads
        .iter()
        .map(|(heading, sway, surge, yaw)| {
            format!("[[bodies.ship.drift_loads]]\nheading_deg = {heading:?}\nsurge_n = {surge:?}\nsway_n = {sway:?}\nyaw_n_m = {yaw:?}\n")
        })
        .collect();
    let text = format!(
        "{HEAD}{}{rows}{SOFT}[points.anchor]\nkind = \"fixed\"\nposition_m = [60.0, 0.0, 0.0]\n[points.bow]\nkind = \"body\"\nbody = \"ship\"\nposition_m = [26.0, 0.0, 0.0]
        [materials.wire]\nmass_kg_per_m = 0.02\ndiameter_m = 0.005\nea_n = 1e6\n[[lines]]\nname = \"hawser\"\nfrom = \"anchor\"\nto = \"bow\"\nmaterial = \"wire\"\nlength_m = 30.0\n",
        ship(30.0, "drift_towards_deg = 230.0")
    );
    let system = solved(&text);
    let yaw = system.rest.placement.bodies[0].angles()[2].to_degrees();
    assert!((yaw - 50.0).abs() < 0.01, "{yaw}");
    let [x, y, _] = place(&system, "bow");
    let away = (y / (x - 60.0)).atan().to_degrees();
    assert!((away - 50.0).abs() < 0.01, "{away}");
    let pull = crate::tensions(&system, "hawser")[1];
    assert!((pull / 2e3 - 1.0).abs() < 1e-3, "{pull}");
}

#[test]
fn loads_that_are_given_twice_are_refused() {
    let files = format!("[files.\"r.csv\"]\ntext = \"\"\"{RESPONSES}\"\"\"\n");
    let waves = "[[waves]]\nkind = \"regular\"\nheight_m = 2.0\nperiod_s = 10.0\n";
    let with = |keys: &str| {
        let text = format!(
            "{}{}{waves}{}{files}",
            ship(0.0, keys),
            held("ship"),
            solver(10.0, 0.1, 0.1)
        );
        refused(&text)
    };
    let member = "response_file = \"r.csv\"\n[[bodies.ship.members]]\nfrom_m = [0.0, 0.0, -2.0]\nto_m = [0.0, 0.0, 1.0]\ndiameter_m = 1.0";
    assert!(with(member).contains("counts the waves twice"));
    let both = with("response_file = \"r.csv\"\nexcitation_file = \"h.3\"");
    assert!(both.contains("both say how waves load the body"), "{both}");
    let headings = with(
        "response_file = \"r.csv\"\n[[bodies.ship.drift_loads]]\nheading_deg = 20.0\n[[bodies.ship.drift_loads]]\nheading_deg = 10.0",
    );
    assert!(headings.contains("does not follow"), "{headings}");
}
