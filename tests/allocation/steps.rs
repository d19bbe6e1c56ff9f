//! A step allocates nothing, whatever the method, and also when it is refused and halved: all memory is taken
//! when the method is made, or at its first step (what a line remembers from step to step).

use std::ops::Range;
use std::path::Path;
use std::sync::atomic::{AtomicU64, Ordering};

use allocation_counter::measure;
use seacable::case::{self, Case, Rotation, Seabed};
use seacable::dynamics::quasi_static::QuasiStatic;
use seacable::dynamics::rk4::Rk4;
use seacable::dynamics::{ErrorLimits, generalized_alpha::GeneralizedAlpha};
use seacable::dynamics::{March, Stepper, TimeStep};
use seacable::numerics::{BlockBand, V3};
use seacable::scene::{self, Scene};
use seacable::solve::{
    AcceptedStep, ExplicitRhs, Factors, Hysteresis, Kinematics, MidstepBalance, Progressing,
    Residual, State,
};

/// A line whose force is not finite at two successive calls of many (a quasi-static step tries twice), so that a step
/// is refused.
struct Spoilt {
    scene: Scene,
    calls: AtomicU64,
    spoilt: u64,
}

impl Spoilt {
    fn spoils(&self) -> bool {
        (self.spoilt..self.spoilt + 2).contains(&self.calls.fetch_add(1, Ordering::Relaxed))
    }
}

impl Kinematics for Spoilt {
    fn nodes(&self) -> usize {
        self.scene.nodes()
    }

    fn free(&self) -> Range<usize> {
        self.scene.free()
    }

    fn prescribe(&self, t: f64, state: &mut State) {
        self.scene.prescribe(t, state);
    }
}

impl Residual for Spoilt {
    fn is_pentadiagonal(&self) -> bool {
        self.scene.is_pentadiagonal()
    }

    fn residual(&self, t: f64, state: &State, r: &mut [V3]) {
        self.scene.residual(t, state, r);
    }

    fn linearise(&self, t: f64, state: &State, c: Factors, r: &mut [V3], tangent: &mut BlockBand) {
        self.scene.linearise(t, state, c, r, tangent);
        if self.spoils() {
            r[3].x = f64::NAN;
        }
    }
}

impl ExplicitRhs for Spoilt {
    fn accelerate(&self, t: f64, state: &mut State) {
        self.scene.accelerate(t, state);
        if self.spoils() {
            state.a[3].x = f64::NAN;
        }
    }
}

impl Hysteresis for Spoilt {
    fn commit(&self, t: f64, dt: f64, state: &mut State) {
        self.scene.commit(t, dt, state);
    }

    fn freeze_drag_coefficients(&self, state: &mut State) {
        self.scene.freeze_drag_coefficients(state);
    }
}

impl MidstepBalance for Spoilt {}

/// Marches the manifold's line, two calls spoilt, and counts what is allocated meanwhile.
fn check<M: Stepper<Spoilt>>(method: impl Fn(&Spoilt, &State) -> M, spoilt: u64, step: f64) {
    check_changed(|_| {}, method, spoilt, step);
}

/// The same with the case changed.
fn check_changed<M: Stepper<Spoilt>>(
    change: impl Fn(&mut Case),
    method: impl Fn(&Spoilt, &State) -> M,
    spoilt: u64,
    step: f64,
) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("cases/pendulous/manifold.toml");
    let mut case = case::load(&path).unwrap().case;
    change(&mut case);
    let system = Spoilt {
        scene: scene::build(&case, 1).unwrap(),
        calls: AtomicU64::new(0),
        spoilt,
    };
    let mut state = system.scene.initial_state();
    system.scene.accelerate(0.0, &mut state);
    let mut method = method(&system, &state);
    let march = March {
        duration: 400.0 * step,
        step,
    };
    let first = TimeStep {
        t: 0.0,
        // Short: the line begins straight and without tension.
        dt: 0.1 * step,
        reject: false,
    };
    method.step(&system, first, &mut state).unwrap();
    let mut seen = 0_u64;
    let mut ended = None;
    let info = measure(|| {
        ended = Some(
            march.run(&mut method, &system, &mut state, &mut |_: AcceptedStep<
                '_,
            >| {
                seen += 1;
                Progressing::Continue
            }),
        );
    });
    let outcome = ended.unwrap().unwrap();
    assert!(
        outcome.rejections >= 1 && outcome.steps > 400,
        "{outcome:?}"
    );
    assert_eq!(seen, outcome.steps + 1);
    assert_eq!((info.count_total, info.bytes_total), (0, 0), "{info:?}");
}

fn alpha(system: &Spoilt, state: &State) -> GeneralizedAlpha {
    GeneralizedAlpha::new(system, state, 0.4, 1e-6, 30)
}

fn quasi_static(system: &Spoilt, state: &State) -> QuasiStatic {
    QuasiStatic::new(system, state, 1e-6, 30)
}

#[test]
fn a_step_of_runge_kutta_allocates_nothing() {
    check(Rk4::new, 1000, 0.003);
}

#[test]
fn a_step_of_generalized_alpha_allocates_nothing() {
    check(alpha, 500, 0.1);
    let control = ErrorLimits {
        position: 1e-3,
        velocity: 1e-3,
    };
    let controlled = |system: &_, state: &_| alpha(system, state).controlled(control);
    check(controlled, 500, 0.25);
}

#[test]
fn a_quasi_static_step_allocates_nothing() {
    check(quasi_static, 500, 0.25);
}

#[test]
fn a_bed_with_friction_allocates_nothing() {
    let bed = |case: &mut Case| {
        case.seabed = Some(Seabed {
            depth_m: 1000.0,
            friction: Some(0.5),
            friction_lateral: Some(0.8),
            slope_deg: 3.0,
            ..Seabed::default()
        });
    };
    check_changed(bed, Rk4::new, 1000, 0.003);
    check_changed(bed, alpha, 500, 0.1);
    check_changed(bed, quasi_static, 500, 0.25);
}

#[test]
fn a_step_with_a_payload_that_turns_allocates_nothing() {
    let turning = |case: &mut Case| {
        if let Some(payload) = &mut case.payload {
            payload.rotation = Some(Rotation {
                centre_of_gravity_m: 4.0,
                inertia_kg_m2: 5e6,
                centre_of_buoyancy_m: None,
                centre_of_drag_m: None,
                drag_length_m: 6.0,
                added_inertia_kg_m2: 1e5,
                start_tilt_deg: 0.0,
                start_azimuth_deg: 0.0,
                spin_deg_per_s: 10.0,
                spin_inertia_kg_m2: Some(4e6),
            });
        }
    };
    check_changed(turning, Rk4::new, 1000, 2e-4);
    check_changed(turning, alpha, 200, 0.05);
}

#[test]
fn the_counter_counts() {
    let info = measure(|| drop(std::hint::black_box(vec![1_u8; 100])));
    assert_eq!(info.count_total, 1);
}
