//! Builds a mooring line on the sea bed in code, starts it from rest in regular waves that move its upper end, and
//! follows its tension with a sink that sees every step.
//!
//! ```sh
//! cargo run --release --example moored_line_in_waves
//! ```

use std::error::Error;
use std::io::{self, Write};

use seacable::case::{Case, DragCoefficient, End, EndKind, Ends, Material, Seabed, Section, Waves};
use seacable::dynamics::March;
use seacable::dynamics::generalized_alpha::GeneralizedAlpha;
use seacable::scene;
use seacable::solve::{AcceptedStep, ExplicitRhs, Kinematics, Progressing};
use seacable::statics::equilibrium::EquilibriumSearch;

const WAVE_HEIGHT_M: f64 = 4.0;
const WAVE_PERIOD_S: f64 = 9.0;
const DEPTH_M: f64 = 80.0;

/// 300 m of chain from an anchor to a vessel that heaves with the waves.
fn case() -> Case {
    let mut vessel = End::new("vessel", EndKind::Moving, Some([270.0, 0.0, -5.0]));
    vessel.amplitude_m = [0.0, 0.0, 0.4 * WAVE_HEIGHT_M];
    vessel.period_s = Some(WAVE_PERIOD_S);
    vessel.ramp_s = WAVE_PERIOD_S;
    let ends = Ends {
        a: End::new("anchor", EndKind::Anchor, Some([0.0, 0.0, -DEPTH_M])),
        b: vessel,
    };
    let mut case = Case::new("A mooring line in waves", ends);
    case.seabed = Some(Seabed::level(DEPTH_M));
    let mut waves = Waves::regular(WAVE_HEIGHT_M, WAVE_PERIOD_S);
    waves.ramp_s = WAVE_PERIOD_S;
    case.waves = Some(waves);
    let mut chain = Material::new(0.14, 97.0, 8.0e8);
    chain.axial_damping_ratio = Some(0.02);
    chain.drag_normal = DragCoefficient::Constant(1.6);
    case.materials.insert("chain".to_owned(), chain);
    case.line.push(Section {
        name: "chain".to_owned(),
        material: "chain".to_owned(),
        length_m: 300.0,
        segments: 60,
    });
    case
}

/// Tension at the vessel at rest, and its greatest and least value in four periods \[N\].
pub(crate) fn tension_at_vessel() -> Result<[f64; 3], Box<dyn Error>> {
    let scene = scene::build(&case(), 1)?;
    let mut state = scene.initial_state();
    EquilibriumSearch::default().run(&scene, 0.0, &mut state)?;
    scene.accelerate(0.0, &mut state);
    let node = scene.nodes() - 1;
    let at_rest = scene.tension_at(node, &state);

    let (mut greatest, mut least) = (at_rest, at_rest);
    let mut sink = |instant: AcceptedStep<'_>| {
        let tension = scene.tension_at(node, instant.state);
        greatest = greatest.max(tension);
        least = least.min(tension);
        Progressing::Continue
    };
    let march = March {
        duration: 4.0 * WAVE_PERIOD_S,
        step: 0.02,
    };
    let (rho_inf, tolerance_m, max_iterations) = (0.4, 1e-5, 30);
    let mut method = GeneralizedAlpha::new(&scene, &state, rho_inf, tolerance_m, max_iterations);
    march.run(&mut method, &scene, &mut state, &mut sink)?;
    Ok([at_rest, greatest, least])
}

/// Prints the tensions.
pub(crate) fn main() -> Result<(), Box<dyn Error>> {
    let [at_rest, greatest, least] = tension_at_vessel()?.map(|tension| tension / 1e3);
    let mut out = io::stdout().lock();
    writeln!(out, "at rest:  {at_rest:.1} kN")?;
    writeln!(out, "greatest: {greatest:.1} kN")?;
    writeln!(out, "least:    {least:.1} kN")?;
    Ok(())
}
