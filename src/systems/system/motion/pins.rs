//! The force at the pin of a body: what its inertia takes, less what loads and lines bring.

use super::body_equation::MovingBody;
use super::joints::Role;
use super::moving_system::MovingSystem;
use super::system_state::SystemState;
use crate::numerics::{M3, V3};
use crate::solve::Factors;

/// Force of the pin on a body in a state \[N\], in the earth's directions; zero for a body that is not among those that turn.
#[must_use]
pub fn pin_force(
    system: &MovingSystem,
    bodies: &[MovingBody],
    state: &SystemState,
    body: usize,
) -> V3 {
    const STILL: Factors = Factors {
        mass: 0.0,
        damping: 0.0,
        stiffness: 0.0,
    };
    let Some(moving) = bodies.iter().find(|moving| moving.number == body) else {
        return V3::zeros();
    };
    let motion = system.body(state, body);
    let around = system.water_around(state, body);
    let (residual, _) = moving.residual(&system.network, &motion, &around, &M3::identity(), STILL);
    residual.fixed_rows::<3>(0) - of_lines(system, state, body)
}

/// Force of all lines on a body \[N\].
fn of_lines(system: &MovingSystem, state: &SystemState, body: usize) -> V3 {
    let mut sum = V3::zeros();
    for (number, ends) in state.attached.iter().enumerate() {
        let (scene, line) = (system.scene(number, state), &state.lines[number]);
        for (end, joint) in ends.iter().enumerate() {
            if matches!(system.joints.roles[*joint], Role::OnBody(on, _) if on == body) {
                sum += scene.end_force(end * (line.x.len() - 1), line);
            }
        }
    }
    sum
}
