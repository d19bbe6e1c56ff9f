//! Free points that land on the bed and slide along it.

use seacable::system::motion::run::MotionRun;

use crate::motion::{channel, moved};

/// The block as a point, and as a body that bears on the bed by its foot.
const POINT: &str = "[points.block]\nkind = \"free\"\nposition_m = [0.0, 0.0, -20.0]\n";
const BODY: &str = "[points.eye]\nkind = \"body\"\nbody = \"block\"\nposition_m = [0.0, 0.0, 0.0]\n\
    [bodies.block]\nkind = \"free\"\nposition_m = [0.0, 0.0, -18.5]\nbottom_m = 1.5\ncentre_of_gravity_m = [0.0, 0.0, -0.5]\ninertia_kg_m2 = [200.0, 200.0, 200.0]\n";

/// A block on the bed under a side load of 1 kN, held by a stay until 1 s.
fn block(kind: &str, friction: f64) -> MotionRun {
    let (end, height) = match kind {
        POINT => ("block", -20.0),
        _ => ("eye", -18.5),
    };
    moved(&format!(
        "[environment]\nwater_density_kg_per_m3 = 0.0\ngravity_m_per_s2 = 10.0\n[seabed]\ndepth_m = 20.0\n\
         [materials.wire]\nmass_kg_per_m = 0.1\ndiameter_m = 0.01\nea_n = 1e6\naxial_damping_n_s = 1e3\n\
         [points.post]\nkind = \"fixed\"\nposition_m = [-30.0, 0.0, {height:?}]\n\
         {kind}mass_kg = 500.0\nload_n = [1000.0, 0.0, 0.0]\nbed_friction = {friction:?}\n\
         [[lines]]\nname = \"stay\"\nfrom = \"post\"\nto = \"{end}\"\nmaterial = \"wire\"\nlength_m = 30.0\nsegments = 10\nrelease_b_s = 1.0\n\
         [solver]\nduration_s = 5.0\nerror_estimate = false\n[output]\ninterval_s = 0.25\n"
    ))
}

#[test]
fn a_block_stays_where_friction_holds_it() {
    for kind in [POINT, BODY] {
        let run = block(kind, 0.3);
        let x = channel(&run, "x_m[block]");
        // The bed gives way along itself as much as under the weight: a millimetre by 5 kN.
        let given = x[x.len() - 1] - x[0];
        assert!((given - 0.2e-3).abs() < 0.02e-3, "{given}");
        assert!(run.balance.relative_drift() < 0.02, "{:?}", run.balance);
    }
}

#[test]
fn a_block_slides_where_friction_does_not_hold_it() {
    for (kind, friction) in [(POINT, 0.0), (POINT, 0.1), (BODY, 0.0), (BODY, 0.1)] {
        let run = block(kind, friction);
        // Of the centre of gravity, half a metre below the origin of the body, which swings.
        let swung = (kind == BODY).then(|| channel(&run, "pitch_deg[block]"));
        let below = |k: usize| swung.map_or(0.0, |pitch| 0.5 * pitch[k].to_radians().sin());
        let x = channel(&run, "x_m[block]").iter().enumerate();
        let x: Vec<f64> = x.map(|(k, x)| x - below(k)).collect();
        let acceleration = (1000.0 - friction * 5000.0) / 500.0;
        for (x_now, time) in x.iter().zip(&run.history.time) {
            let since = (time - 1.0).max(0.0);
            let expected = 0.5 * acceleration * since * since;
            let off = x_now - x[0] - expected;
            assert!(
                off.abs() < 5e-3 * expected.max(1.0),
                "{friction} {time}: {off}"
            );
        }
        assert!(run.balance.relative_drift() < 0.01, "{:?}", run.balance);
    }
}

/// What hangs on a wire of a length from the surface over a bed 24 m down, let go with the wire's end at half a second.
fn let_go(hung: &str, end: &str, length: f64) -> MotionRun {
    moved(&format!(
        "[environment]\nwater_density_kg_per_m3 = 0.0\n[seabed]\ndepth_m = 24.0\n\
         [materials.wire]\nmass_kg_per_m = 10.0\ndiameter_m = 0.03\nea_n = 5e7\naxial_damping_n_s = 1e4\n\
         [points.top]\nkind = \"fixed\"\nposition_m = [0.0, 0.0, 0.0]\n{hung}\
         [[lines]]\nname = \"wire\"\nfrom = \"{end}\"\nto = \"top\"\nmaterial = \"wire\"\nlength_m = {length:?}\nsegments = 10\nrelease_a_s = 0.5\n\
         [solver]\nduration_s = 4.0\nerror_estimate = false\n[output]\ninterval_s = 0.25\n"
    ))
}

#[test]
fn what_lands_comes_to_rest_and_loses_no_energy_unseen() {
    // Metres above the bed, it lands within a step of the line that is let go with it.
    let clump = "[points.clump]\nkind = \"free\"\nmass_kg = 2000.0\n";
    let block = "[points.eye]\nkind = \"body\"\nbody = \"block\"\nposition_m = [0.0, 0.0, 1.0]\n\
         [bodies.block]\nkind = \"free\"\nposition_m = [0.0, 0.0, -18.0]\nmass_kg = 2000.0\nbottom_m = 1.5\nbed_friction = 0.3\n\
         inertia_kg_m2 = [2e3, 2e3, 2e3]\ncentre_of_gravity_m = [0.0, 0.0, -0.5]\n";
    let cases = [
        (let_go(clump, "clump", 20.0), "z_m[clump]", -24.001),
        (let_go(block, "eye", 18.0), "z_m[block]", -22.501),
    ];
    for (run, name, rests) in cases {
        let z = channel(&run, name);
        assert!((z[z.len() - 1] - rests).abs() < 1e-4, "{:?}", z.last());
        assert!(run.balance.relative_drift() < 0.01, "{:?}", run.balance);
        assert!(run.warnings.is_empty(), "{:?}", run.warnings);
    }
}
