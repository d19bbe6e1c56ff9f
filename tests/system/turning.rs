//! A payload that turns, as the element of a single line and as a body of a system: one physics.

use std::sync::atomic::AtomicBool;

use seacable::case;
use seacable::run::Run;
use seacable::run::job::{Request, execute};

use crate::motion::{channel, moved};

const WATER: &str = "
[environment]
gravity_m_per_s2 = 9.81
water_density_kg_per_m3 = 1025.0
[current]
speed_m_per_s = 0.4
[materials.wire]
mass_kg_per_m = 12.0
diameter_m = 0.05
ea_n = 5e7
drag_normal = 1.2
added_mass_normal = 1.0
axial_damping_n_s = 2e4
";

const SOLVER: &str = "[solver]\nduration_s = 40.0\ntime_step_s = 0.01\nrho_inf = 0.4\nerror_estimate = false\n[output]\ninterval_s = 0.1\n";

/// A body of 20 t in air and 8 m³ on 60 m of wire, its centre 3 m below the hang point; the wire's upper end goes to and fro.
fn line() -> Run {
    let text = format!(
        "[case]\ntitle = \"t\"\n{WATER}
        [[line]]\nname = \"wire\"\nmaterial = \"wire\"\nlength_m = 60.0\nsegments = 12
        [ends.a]\nname = \"top\"\nkind = \"moving\"\nposition_m = [0.0, 0.0, 0.0]\namplitude_m = [1.5, 0.5, 0.8]\nperiod_s = 7.0\nramp_s = 10.0
        [ends.b]\nname = \"body\"\nkind = \"payload\"
        [payload]\ndry_mass_kg = 20e3\nvolume_m3 = 8.0\ndrag_area_m2 = 0.0\nadded_mass_kg = 5e3
        [payload.rotation]\ncentre_of_gravity_m = 3.0\ninertia_kg_m2 = 6e4\nadded_inertia_kg_m2 = 1e4
        {SOLVER}"
    );
    let case = case::parse(&text, "t.toml").map_err(|all| all[0].to_string());
    computed(case.unwrap(), &text)
}

/// The run of a case.
pub(crate) fn computed(case: case::Case, text: &str) -> Run {
    let request = Request {
        case,
        text: text.to_owned(),
        file: "t.toml".to_owned(),
        overrides: Vec::new(),
        id: "t".to_owned(),
    };
    execute(&request, &AtomicBool::new(false), &mut |_| {})
}

#[test]
fn a_body_that_turns_on_a_line_is_the_element_of_the_line() {
    let alone = line();
    assert_eq!(alone.info.failure, None);
    let system = moved(&format!(
        "{WATER}
        [points.top]\nkind = \"moved\"\nposition_m = [0.0, 0.0, 0.0]\namplitude_m = [1.5, 0.5, 0.8]\nperiod_s = 7.0\nramp_s = 10.0
        [points.eye]\nkind = \"body\"\nbody = \"body\"\nposition_m = [0.0, 0.0, 3.0]
        [bodies.body]\nkind = \"free\"\nposition_m = [0.0, 0.0, -63.0]\nmass_kg = 20e3\nvolume_m3 = 8.0\ninertia_kg_m2 = [6e4, 6e4, 2e4]
        added_mass = [5e3, 5e3, 5e3, 1e4, 1e4, 0.0]
        [[lines]]\nname = \"wire\"\nfrom = \"top\"\nto = \"eye\"\nmaterial = \"wire\"\nlength_m = 60.0\nsegments = 12
        {SOLVER}"
    ));
    let pairs = [
        ("tension_n[top|wire]", "tension_n[wire|a]"),
        ("tension_n[wire|body]", "tension_n[wire|b]"),
        ("x_m[body]", "x_m[body]"),
        ("y_m[body]", "y_m[body]"),
        ("z_m[body]", "z_m[body]"),
    ];
    for (name, other) in pairs {
        let one = &alone.history.channel(name).unwrap().values;
        let two = channel(&system, other);
        let change = one.iter().map(|v| (v - one[0]).abs()).fold(0.0, f64::max);
        let off = one.iter().zip(two).map(|(a, b)| (a - b).abs());
        let off = off.fold(0.0, f64::max);
        assert!(off < 1e-4 * change, "{name}: {off} of {change}");
    }
    // The angle from straight down, of roll and pitch.
    let tilt = &alone.history.channel("tilt_deg[body]").unwrap().values;
    let angles = ["roll_deg[body]", "pitch_deg[body]"].map(|name| channel(&system, name));
    let greatest = tilt.iter().copied().fold(0.0, f64::max);
    assert!(greatest > 1.0, "{greatest}");
    for (k, tilt) in tilt.iter().enumerate() {
        let [roll, pitch] = angles.map(|angle| angle[k].to_radians());
        let found = (roll.cos() * pitch.cos()).acos().to_degrees();
        assert!((found - tilt).abs() < 1e-4 * greatest, "{tilt} {found}");
    }
}
