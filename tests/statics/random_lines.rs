//! Lines of every kind at random, from a fixed seed: the discretised line finds its equilibrium, and in still water it is
//! the catenary's, to the order of the mesh.

use crate::lines::line;
use seacable::numerics::V3;
use seacable::scene::{self, Scene};
use seacable::solve::{State, StaticSearch};
use seacable::statics::catenary::{CatenaryLine, EndOffset, SectionProperties};
use seacable::statics::equilibrium::{Equilibrium, EquilibriumSearch, instabilities};

/// Numbers from a fixed seed (Marsaglia's xorshift).
struct Seeded(u64);

impl Seeded {
    fn between(&mut self, from: f64, to: f64) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        from + (to - from) * (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn decades(&mut self, from: f64, to: f64) -> f64 {
        10_f64.powf(self.between(from, to))
    }
}

/// A line between two fixed ends.
#[derive(Debug)]
struct Random {
    length: f64,
    diameter: f64,
    weight_kg_per_m: f64,
    ea: f64,
    end: V3,
    current: String,
    end_b: &'static str,
}

/// What the lines of a set have in common.
struct Kind {
    /// Chord by length.
    chord: (f64, f64),
    /// Decades of EA \[N\].
    stiff: (f64, f64),
    /// 1, or -1 for lines that float.
    sinks: f64,
    current: bool,
    /// End B is free instead of fixed.
    free: bool,
}

const ANY: Kind = Kind {
    chord: (0.05, 0.999),
    stiff: (5.0, 9.5),
    sinks: 1.0,
    current: false,
    free: false,
};

fn random(r: &mut Seeded, kind: &Kind) -> Random {
    let length = r.decades(1.0, 3.5);
    let diameter = r.decades(-2.0, -0.3);
    let (azimuth, elevation) = (r.between(-3.0, 3.0), r.between(-1.5, 1.5));
    let chord = length * r.between(kind.chord.0, kind.chord.1);
    let across = V3::new(azimuth.cos(), azimuth.sin(), 0.0) * elevation.cos();
    let speed = r.between(0.1, 2.5);
    let current = format!(
        "current = {{ depth_m = [0.0, {}, {length}], speed_m_per_s = [{speed}, {}, {}], direction_deg = [{}, {}, {}] }}",
        0.3 * length,
        speed * r.between(0.0, 1.0),
        speed * r.between(-0.5, 0.5),
        r.between(0.0, 360.0),
        r.between(0.0, 360.0),
        r.between(0.0, 360.0),
    );
    Random {
        length,
        diameter,
        weight_kg_per_m: kind.sinks * diameter * r.decades(-0.5, 3.5),
        ea: r.decades(kind.stiff.0, kind.stiff.1),
        end: (across + V3::z() * elevation.sin()) * chord,
        current: if kind.current { current } else { String::new() },
        end_b: if kind.free { "free" } else { "fixed" },
    }
}

fn build(l: &Random, segments: usize) -> Scene {
    let changes = format!(
        r#"
        environment.water_density_kg_per_m3 = 1025.0
        line = {{ length_m = {}, segments = {segments} }}
        materials.rope = {{ diameter_m = {}, mass_kg_per_m = {}, wet_weight_kg_per_m = {}, ea_n = {}, drag_normal = 1.2, drag_tangential = 0.01 }}
        ends.b = {{ name = "b", kind = "{}", position_m = [{}, {}, {}] }}
        {}
        "#,
        l.length,
        l.diameter,
        l.weight_kg_per_m.abs() + 1.0,
        l.weight_kg_per_m,
        l.ea,
        l.end_b,
        l.end.x,
        l.end.y,
        l.end.z,
        l.current,
    );
    scene::build(&line(&changes), 1).unwrap()
}

fn at_rest(scene: &Scene) -> (State, Equilibrium) {
    let mut state = scene.initial_state();
    let found = EquilibriumSearch::default().run(scene, 0.0, &mut state);
    (state, found.unwrap())
}

#[test]
fn hanging_lines_pull_on_their_ends_as_the_catenary_does() {
    let mut r = Seeded(0x5eac_ab1e_5000);
    let mut close = 0;
    for sinks in [1.0, -1.0] {
        for stiff in [(5.0, 9.5), (9.5, 12.0)] {
            let kind = Kind {
                sinks,
                stiff,
                chord: (0.3, 1.001),
                ..ANY
            };
            for _ in 0..40 {
                close += usize::from(check(&random(&mut r, &kind)));
            }
        }
    }
    assert!(close >= 136, "{close} of 160");
}

/// Force on both ends, extrapolated from two meshes, against the closed form. It is never farther off than the mesh error
/// estimated; whether it is much closer, as it must be unless the line turns too sharply for its segments.
fn check(l: &Random) -> bool {
    let weight = l.weight_kg_per_m * 9.80665;
    let sections = [SectionProperties::new(l.length, weight, l.ea)];
    let exact = CatenaryLine {
        ends: EndOffset::between([0.0; 3], l.end.into()),
        sections: &sections,
        bed: None,
        surface_above_a_m: None,
    }
    .solve()
    .unwrap();
    let along = V3::new(l.end.x, l.end.y, 0.0).normalize();
    let expected = [
        along * exact.h_a_n + V3::z() * exact.v_a_n,
        along * -exact.h_b_n - V3::z() * exact.v_b_n,
    ];
    let size = exact.tension_a_n().max(exact.tension_b_n());
    let forces = |segments: usize| {
        let scene = build(l, segments);
        let (state, found) = at_rest(&scene);
        assert!(found.iterations < 60, "{l:?}: {found:?}");
        let forces = [0, segments].map(|node| scene.end_force(node, &state));
        (forces, scene.sharpest_turn(&state).0)
    };
    let ((coarse, turn), (fine, _)) = (forces(60), forces(120));
    if turn > 0.8 {
        return false;
    }
    // A stiff line makes forces of the last digits of its positions.
    let rounding = build(l, 120).rounding_force();
    let mut close = true;
    for end in 0..2 {
        let step = (fine[end] - coarse[end]) / 3.0;
        let off = (fine[end] + step - expected[end]).norm();
        let step = step.norm();
        assert!(
            off < 1.5 * step + 1e-6 * size + rounding,
            "{l:?}: {off:.3e} N of {size:.3e} N, step {step:.3e} N"
        );
        close &= off < 0.1 * step + 1e-7 * size + rounding;
    }
    close
}

#[test]
fn lines_in_sheared_currents_come_to_rest() {
    let mut r = Seeded(0x00c0_ffee_1234);
    let any = Kind {
        current: true,
        ..ANY
    };
    let kinds = [
        Kind {
            stiff: (9.0, 12.0),
            ..any
        },
        Kind {
            chord: (0.999, 1.001),
            ..any
        },
        Kind { free: true, ..any },
        Kind { sinks: -1.0, ..any },
        any,
    ];
    let mut stable = 0;
    for kind in &kinds {
        for _ in 0..40 {
            let l = random(&mut r, kind);
            let scene = build(&l, 40);
            let (state, found) = at_rest(&scene);
            assert!(
                found.residual <= 1e-8 * scene.force_scale().max(1e8 * scene.rounding_force()),
                "{l:?}"
            );
            stable += usize::from(instabilities(&scene, 0.0, &state) == Some(0));
        }
    }
    // A rope pulled by weight and current alike has one shape; where it hangs in two strands it may be slack between.
    assert!(stable > 180, "{stable} of 200");
}
