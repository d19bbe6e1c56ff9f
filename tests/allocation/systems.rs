//! A step of a system in motion allocates nothing: lines on a bed, a free point, a body with members through the surface.

use allocation_counter::measure;
use seacable::case::kind;
use seacable::dynamics::generalized_alpha::GeneralizedAlpha;
use seacable::dynamics::{March, Stepper};
use seacable::solve::{AcceptedStep, Marched, Progressing};
use seacable::system::SystemFile;
use seacable::system::motion::SystemState;
use seacable::system::motion::start::start;

const SYSTEM: &str = "
[system]
title = \"test\"
[seabed]
depth_m = 60.0
friction = 0.3
[materials.chain]
mass_kg_per_m = 50.0
diameter_m = 0.1
ea_n = 2e8
drag_normal = 1.2
added_mass_normal = 1.0
[bodies.buoy]
kind = \"free\"
position_m = [0.0, 0.0, 0.0]
mass_kg = 4e4
inertia_kg_m2 = [3e5, 3e5, 2e5]
centre_of_gravity_m = [0.0, 0.0, -3.0]
quadratic_damping = [0.0, 0.0, 1e4, 1e4, 1e4, 1e4]
[[bodies.buoy.members]]
from_m = [0.0, 0.0, -6.0]
to_m = [0.5, 0.0, 3.0]
diameter_m = 3.0
drag_normal = 1.0
added_mass_normal = 1.0
[points.fairlead]
kind = \"body\"
body = \"buoy\"
position_m = [1.5, 0.0, -5.0]
[points.clump]
kind = \"free\"
position_m = [40.0, 0.0, -50.0]
mass_kg = 1e3
volume_m3 = 0.2
drag_area_m2 = 0.5
[points.anchor]
kind = \"fixed\"
position_m = [120.0, 0.0, -60.0]
[[lines]]
name = \"upper\"
from = \"clump\"
to = \"fairlead\"
repeat_at_deg = [0.0, 120.0, 240.0]
[[lines.sections]]
material = \"chain\"
length_m = 35.0
segments = 6
clump_kg = -20.0
clump_drag_area_normal_m2 = 0.6
clump_drag_area_tangential_m2 = 0.2
clump_added_mass_normal_kg = 12.0
clump_added_mass_tangential_kg = 3.0
[[lines.sections]]
material = \"chain\"
length_m = 30.0
segments = 4
[[lines]]
name = \"lower\"
from = \"anchor\"
to = \"clump\"
material = \"chain\"
length_m = 82.0
segments = 14
repeat_at_deg = [0.0, 120.0, 240.0]
";

/// A winch, and a bead on a wire.
const PAID_OUT: &str = "
[system]
title = \"test\"
[materials.wire]
mass_kg_per_m = 10.0
diameter_m = 0.05
ea_n = 6e7
[points.winch]
kind = \"fixed\"
position_m = [0.0, 0.0, 0.0]
[points.anchor]
kind = \"fixed\"
position_m = [40.0, 0.0, -30.0]
[points.bead]
kind = \"free\"
mass_kg = 500.0
position_m = [20.0, 0.0, -20.0]
[[lines]]
name = \"one\"
from = \"winch\"
to = \"bead\"
material = \"wire\"
length_m = 28.0
segments = 7
[[lines]]
name = \"two\"
from = \"bead\"
to = \"anchor\"
material = \"wire\"
length_m = 25.0
segments = 6
[[payouts]]
line = \"one\"
tension_n = 1e4
[[sliding_points]]
point = \"bead\"
line = \"one\"
other = \"two\"
friction = 0.1
";

#[test]
fn a_step_of_a_system_allocates_nothing() {
    allocates_nothing(SYSTEM, 4.0);
}

#[test]
fn a_step_of_ropes_that_creep_allocates_nothing() {
    let creep = "strain = [0.0, 0.01, 0.1]\ntension_n = [0.0, 1e6, 1.5e7]\ncreep_model = \"syrope\"\ndynamic_ea_n = 4e8\n\
         slow_damping_n_s = 1e10\nfast_damping_n_s = 1e6\npermanent_strain_ratio = 0.1";
    allocates_nothing(&SYSTEM.replace("ea_n = 2e8", creep), 4.0);
}

#[test]
fn a_step_of_lines_clamped_on_a_body_allocates_nothing() {
    let bending = SYSTEM.replace("ea_n = 2e8", "ea_n = 2e8\nei_n_m2 = 2e4");
    let clamp = "length_m = 65.0\nclamp_b_elevation_deg = 45.0\nclamp_b_azimuth_deg = 180.0";
    allocates_nothing(&bending.replacen("length_m = 65.0", clamp, 1), 4.0);
}

#[test]
fn a_step_of_lines_paid_out_allocates_nothing() {
    // Shorter than to where the mesh of an end changes.
    allocates_nothing(PAID_OUT, 1.0);
}

fn allocates_nothing(text: &str, until: f64) {
    let solved = kind::parse::<SystemFile>(text, "system.toml").unwrap();
    let begun = start(&solved, 1.0).unwrap();
    let (system, mut state) = (begun.system, begun.state);
    // Pushed, so that it moves.
    if let Some(origin) = system.joints.bodies.first() {
        state.joints.v[*origin].x = 0.5;
    }
    let mut method = GeneralizedAlpha::new(&system, &state, 0.4, 1e-7, 30);
    method.accelerate(&system, 0.0, &mut state).unwrap();
    system.commit(0.0, 0.0, &mut state);
    let march = |duration: f64| March {
        duration,
        step: 0.02,
    };
    let mut ignore = |_: AcceptedStep<'_, SystemState>| Progressing::Continue;
    march(0.1)
        .run(&mut method, &system, &mut state, &mut ignore)
        .unwrap();
    let mut ended = None;
    let info = measure(|| {
        ended = Some(march(until).run(&mut method, &system, &mut state, &mut ignore));
    });
    assert!(ended.unwrap().unwrap().steps as f64 >= until / 0.02);
    assert_eq!(info.count_total, 0);
}
