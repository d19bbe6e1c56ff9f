//! The tension of a very stiff line that swings fast, read at the ends of steps: no share of the step squared in it,
//! although generalized-alpha balances forces between two states.

use std::path::Path;
use std::sync::atomic::AtomicBool;

use seacable::case;
use seacable::run::RunState;
use seacable::run::job::{Request, execute};

/// Greatest distance of the tension at the bob from `m g (3 cos a - 2 cos a0)`, the closed form at the angle where the bob is
/// then, as a share of its weight; once the bounce of the start has died away.
fn worst(rho: f64, step: f64) -> f64 {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("cases/basics/pendulum.toml");
    let mut case = case::load(&path).unwrap().case;
    case.start.elevation_deg = -60.0;
    case.materials.get_mut("wire").unwrap().ea_n = Some(6e9);
    case.solver.duration_s = 10.0;
    case.solver.time_step_s = Some(step);
    case.solver.rho_inf = rho;
    case.solver.error_estimate = false;
    let (gravity, mass) = (
        case.environment.gravity_m_per_s2,
        case.payload.as_ref().unwrap().dry_mass_kg,
    );
    let request = Request {
        case,
        text: String::new(),
        file: "swing.toml".to_owned(),
        overrides: Vec::new(),
        id: "swing".to_owned(),
    };
    let run = execute(&request, &AtomicBool::new(false), &mut |_| {});
    assert_eq!(run.info.state, RunState::Done, "{:?}", run.info.failure);
    let channel = |name: &str| &run.history.channel(name).unwrap().values;
    let (x, z, tension) = (
        channel("x_m[bob]"),
        channel("z_m[bob]"),
        channel("tension_n[wire|bob]"),
    );
    let apart = (0..x.len())
        .filter(|i| run.history.time[*i] > 3.0)
        .map(|i| {
            let cos = -z[i] / x[i].hypot(z[i]);
            let exact = 3.0 * cos - 2.0 * 60f64.to_radians().sin();
            (tension[i] / (mass * gravity) - exact).abs()
        });
    apart.fold(0.0, f64::max)
}

#[test]
fn a_stiff_swinging_line_has_its_tension() {
    // By the stretch of the end state alone it would be off by 10 % (rho 0.4, 0.03 s): EA s (1 - s) (omega h)² / 2.
    for rho in [0.0, 0.4] {
        for step in [0.02, 0.03] {
            let worst = worst(rho, step);
            assert!(
                worst < 5e-3,
                "rho {rho}, step {step} s: off by {worst:.1e} of the weight"
            );
        }
    }
}
