//! Systems on a bed with depths over a grid: against level beds, the closed form on a slope, blocks on slopes, finite differences.

use std::fmt::Write as _;

use seacable::statics::catenary::{CatenaryLine, EndOffset, RigidBed, SectionProperties};
use seacable::system::SolvedSystem;
use seacable::system::equilibrium::search;
use seacable::system::line_at_rest::LineAtRest;
use seacable::system::motion::run::MotionRun;
use seacable::system::pose::Pose;
use seacable::system::start::start;
use seacable::system::stiffness::of_body;

use crate::motion::{channel, moved, refused};
use crate::stiffness::differences_by;
use crate::{HEAD, place, solved, tensions};

/// A table of depths every 50 m from -1000 to 1000 m, as a file that the system carries.
fn depths(of: impl Fn(f64, f64) -> f64) -> String {
    let mut table = "x_m,y_m,depth_m\\n".to_owned();
    for i in -20..=20 {
        for j in -20..=20 {
            let (x, y) = (50.0 * f64::from(i), 50.0 * f64::from(j));
            write!(table, "{x:?},{y:?},{:?}\\n", of(x, y)).unwrap();
        }
    }
    format!("[files.\"bed.csv\"]\ntext = \"{table}\"\n")
}

/// Keys of a bed with these depths.
fn grid(way: &str) -> String {
    format!("depth_file = \"bed.csv\"\ninterpolation = \"{way}\"\n")
}

/// A floater on three chains, two with a clump in between, at a depth of 99.7 m.
fn spread(bed: &str, more: &str) -> String {
    let mut text = format!(
        "{HEAD}[seabed]\ndepth_m = 99.7\nstiffness_n_per_m3 = 1e6\n{bed}
[materials.chain]\nmass_kg_per_m = 120.0\ndiameter_m = 0.09\nea_n = 4e8\nbreak_load_n = 8e6\n
[bodies.buoy]\nkind = \"free\"\nposition_m = [3.0, -2.0, -4.0]\nmass_kg = 2e5\nvolume_m3 = 330.0\ninertia_kg_m2 = [4e6, 4e6, 4e6]
centre_of_gravity_m = [0.0, 0.0, -2.0]\nwaterplane_stiffness = [0.0, 0.0, 5e5, 2e7, 2e7, 0.0]\n
[points.clump]\nkind = \"free\"\nmass_kg = 9e3\nvolume_m3 = 1.2\n"
    );
    for (k, (x, y)) in [(-420.0, 30.0), (260.0, 330.0), (230.0, -380.0)]
        .iter()
        .enumerate()
    {
        let angle = f64::atan2(*y, *x);
        let (sin, cos) = angle.sin_cos();
        write!(
            text,
            "[points.anchor{k}]\nkind = \"fixed\"\nposition_m = [{x:?}, {y:?}, ANCHOR{k}]\n\
             [points.fairlead{k}]\nkind = \"body\"\nbody = \"buoy\"\nposition_m = [{:?}, {:?}, -3.0]\n",
            6.0 * cos,
            6.0 * sin
        )
        .unwrap();
        let mut line = |name: &str, from: &str, to: &str, length: f64| {
            write!(
                text,
                "[[lines]]\nname = \"{name}\"\nfrom = \"{from}\"\nto = \"{to}\"\nmaterial = \"chain\"\nlength_m = {length:?}\nsegments = 60\n"
            )
            .unwrap();
        };
        let top = format!("fairlead{k}");
        if k == 0 {
            line("low", "anchor0", "clump", 250.0);
            line("high", "clump", &top, 205.0);
        } else {
            line(&format!("line{k}"), &format!("anchor{k}"), &top, 460.0);
        }
    }
    text.push_str(more);
    text
}

/// The spread with its anchors on a bed of these depths.
fn on_bed(bed: &str, depth: impl Fn(f64, f64) -> f64 + Copy, more: &str) -> String {
    let mut text = spread(bed, more);
    for (k, (x, y)) in [(-420.0, 30.0), (260.0, 330.0), (230.0, -380.0)]
        .iter()
        .enumerate()
    {
        text = text.replace(&format!("ANCHOR{k}"), &format!("{:?}", -depth(*x, *y)));
    }
    text
}

fn ends(system: &SolvedSystem) -> Vec<[f64; 2]> {
    let lines = &system.rest.balance.lines;
    lines.iter().map(LineAtRest::tensions).collect()
}

const LEVEL: f64 = 99.7;

/// Friction along lines and across them.
const ROUGH: &str = "friction = 0.3\nfriction_lateral = 0.8\n";

#[test]
fn a_level_grid_is_the_level_bed_to_the_last_bit() {
    let level = solved(&on_bed("", |_, _| LEVEL, ""));
    // Depths may differ elsewhere.
    let hill = |x: f64, _: f64| if x > 700.0 { 20.0 } else { LEVEL };
    let tables = [depths(|_, _| LEVEL), depths(hill)];
    for way in ["smooth", "bilinear"] {
        for table in &tables {
            let found = solved(&on_bed(&grid(way), |_, _| LEVEL, table));
            assert!(!found.is_discretised());
            assert_eq!(ends(&found), ends(&level), "{way}");
            assert_eq!(found.rest.placement, level.rest.placement);
            assert_eq!(found.stiffness, level.stiffness);
        }
    }
}

#[test]
fn divided_lines_on_a_level_grid_are_those_on_the_level_bed() {
    let current = "[current]\nspeed_m_per_s = 0.6\ndirection_deg = 20.0\n";
    for (rough, way) in [
        ("", "smooth"),
        ("", "bilinear"),
        (ROUGH, "smooth"),
        (ROUGH, "bilinear"),
    ] {
        let level = solved(&on_bed(rough, |_, _| LEVEL, current));
        let more = format!("{current}{}", depths(|_, _| LEVEL));
        let bed = format!("{}{rough}", grid(way));
        let found = solved(&on_bed(&bed, |_, _| LEVEL, &more));
        assert!(found.is_discretised());
        for (one, other) in ends(&found).iter().zip(ends(&level)) {
            for k in 0..2 {
                assert!((one[k] / other[k] - 1.0).abs() < 1e-9, "{one:?} {other:?}");
            }
        }
    }
}

#[test]
fn motion_on_a_level_grid_is_that_on_the_level_bed() {
    let solver = "[solver]\nduration_s = 4.0\ntime_step_s = 0.05\nerror_estimate = false\n[output]\ninterval_s = 0.5\n";
    let aside = "start_offset_m = [2.0, 1.0, 0.3]\n[points.clump]";
    let text = |bed: &str, more: &str| {
        let text = on_bed(bed, |_, _| LEVEL, more).replace("[points.clump]", aside);
        text.replace(HEAD, "")
    };
    for rough in ["", ROUGH] {
        let level = moved(&text(rough, solver));
        let found = moved(&text(
            &format!("{}{rough}", grid("smooth")),
            &format!("{solver}{}", depths(|_, _| LEVEL)),
        ));
        for name in [
            "x_m[buoy]",
            "z_m[clump]",
            "tension_n[low|b]",
            "tension_n[line1|a]",
        ] {
            let (one, other) = (channel(&found, name), channel(&level, name));
            for (a, b) in one.iter().zip(other) {
                assert!((a - b).abs() < 1e-9 * b.abs().max(1.0), "{name}: {a} {b}");
            }
        }
    }
}

#[test]
fn a_mooring_down_a_slope_meets_the_closed_form() {
    let (length, slope) = (620.0, 0.06_f64);
    let depth = |x: f64, _: f64| 120.0 - slope * x;
    for (way, x_m, friction) in [
        ("smooth", 585.0, 0.0),
        ("bilinear", 585.0, 0.0),
        ("smooth", 600.0, 0.0),
        ("smooth", 585.0, 0.4),
        ("bilinear", 600.0, 0.4),
    ] {
        let found = solved(&format!(
            "{HEAD}[seabed]\ndepth_m = 120.0\nstiffness_n_per_m3 = 1e7\nfriction = {friction:?}\n{}\
             [materials.chain]\nmass_kg_per_m = 120.0\ndiameter_m = 0.09\nea_n = 4e8\n\
             [points.anchor]\nkind = \"fixed\"\nposition_m = [0.0, 0.0, -120.0]\n\
             [points.top]\nkind = \"fixed\"\nposition_m = [{x_m:?}, 0.0, -5.0]\n\
             [[lines]]\nname = \"line\"\nfrom = \"anchor\"\nto = \"top\"\nmaterial = \"chain\"\nlength_m = {length:?}\nsegments = 400\n{}",
            grid(way),
            depths(depth)
        ));
        assert!(found.is_discretised());
        let displaced = 1025.0 * 0.25 * std::f64::consts::PI * 0.09 * 0.09;
        let sections = [SectionProperties::new(
            length,
            (120.0 - displaced) * 9.80665,
            4e8,
        )];
        let exact = CatenaryLine {
            ends: EndOffset { x_m, z_m: 115.0 },
            sections: &sections,
            bed: Some(RigidBed {
                below_a_m: 0.0,
                slope_rad: slope.atan(),
                friction,
            }),
            surface_above_a_m: None,
        }
        .solve()
        .unwrap();
        let wanted = exact.at(length).tension_n;
        let [anchor, top] = tensions(&found, "line");
        assert!((top / wanted - 1.0).abs() < 2e-4, "{way}: {top} {wanted}");
        let held = exact.at(0.0).tension_n;
        let off = (anchor - held).abs();
        assert!(off < 1e-3 * wanted, "{way} {friction}: {anchor} {held}");
        let on_bed = found.rest.balance.lines[0].on_bed();
        assert!(
            (on_bed - exact.on_bed_m).abs() < 5.0,
            "{on_bed} {}",
            exact.on_bed_m
        );
    }
}

/// A block on a plane that rises by 0.2 towards +x, held by a light wire from above along the slope; by its name in the file.
fn block(kind: &str) -> SolvedSystem {
    let (end, wire_z) = (if kind == "point" { "block" } else { "eye" }, 0.0);
    let part = match kind {
        "point" => {
            "[points.block]\nkind = \"free\"\nmass_kg = 5e3\nposition_m = [-30.0, 0.0, -50.0]\n"
        }
        _ => {
            "[bodies.block]\nkind = \"free\"\nmass_kg = 5e3\nposition_m = [-30.0, 0.0, -50.0]\nbottom_m = 0.0\ninertia_kg_m2 = [1e3, 1e3, 1e3]\ncentre_of_gravity_m = [0.0, 0.0, -0.5]\n\
             [points.eye]\nkind = \"body\"\nbody = \"block\"\nposition_m = [0.0, 0.0, 0.0]\n"
        }
    };
    solved(&format!(
        "{HEAD}[environment]\nwater_density_kg_per_m3 = 0.0\ngravity_m_per_s2 = 10.0\n[seabed]\ndepth_m = 100.0\nstiffness_n_per_m3 = 1e6\n{}\
         [materials.wire]\nmass_kg_per_m = 1e-3\ndiameter_m = 0.01\nea_n = 1e7\n{part}\
         [points.post]\nkind = \"fixed\"\nposition_m = [40.0, 30.0, {:?}]\n\
         [[lines]]\nname = \"wire\"\nfrom = \"{end}\"\nto = \"post\"\nmaterial = \"wire\"\nlength_m = 50.0\nsegments = 10\n{}",
        grid("smooth"),
        -92.0 + wire_z,
        depths(|x, _| 100.0 - 0.2 * x)
    ))
}

#[test]
fn a_block_hangs_on_its_wire_down_the_slope() {
    let slope = 0.2_f64.atan();
    for kind in ["point", "body"] {
        let found = block(kind);
        let [low, _] = tensions(&found, "wire");
        let wanted = 5e4 * slope.sin();
        assert!((low / wanted - 1.0).abs() < 1e-4, "{kind}: {low} {wanted}");
        let [x, y, z] = match kind {
            "point" => place(&found, "block"),
            _ => found.rest.placement.bodies[0].origin.into(),
        };
        // Straight down from the post, and on the bed.
        assert!((y - 30.0).abs() < 1e-4, "{kind} {y}");
        let stretched = 50.0 * (1.0 + wanted / 1e7);
        assert!(
            (x - (40.0 - stretched * slope.cos())).abs() < 1e-3,
            "{kind} {x}"
        );
        assert!((z - (-100.0 + 0.2 * x)).abs() < 1e-9, "{kind} {z}");
        assert!(found.rest.residual < 1e-6, "{}", found.rest.residual);
    }
}

/// Ridges under the spread.
fn ridges(x: f64, y: f64) -> f64 {
    101.0 + 5.0 * (x / 130.0).sin() * (y / 170.0).cos() - 0.02 * x
}

#[test]
fn stiffness_over_ridges_is_that_of_differences() {
    let mut network = solved(&on_bed(&grid("smooth"), ridges_on_grid, &depths(ridges))).network;
    network.bodies[0].free = false;
    network.bodies[0].pose = Pose::new([6.0, -4.0, -3.5].into(), 0.02, -0.03, 0.05);
    let rest = search(&network, &start(&network)).unwrap();
    let clump = network.point("clump").unwrap();
    assert_eq!(
        rest.contact(clump),
        seacable::system::bounds::Contact::Bed,
        "the clump is off the bed"
    );
    let exact = of_body(&network, &rest, 0).unwrap();
    let numeric = differences_by(&network, 0, [1e-3, 1e-4]);
    for (i, j) in [(0, 0), (0, 3), (3, 0), (3, 3)] {
        let block = |matrix: &nalgebra::Matrix6<f64>| matrix.fixed_view::<3, 3>(i, j).into_owned();
        let off = (block(&exact) - block(&numeric)).amax() / block(&exact).amax();
        assert!(off < 1e-6, "block {i}, {j}: {off:.1e}");
    }
}

/// The ridges as the grid has them between its places.
fn ridges_on_grid(x: f64, y: f64) -> f64 {
    use seacable::numerics::{DepthGrid, DepthInterpolation};
    let axis: Vec<f64> = (-20..=20).map(|k| 50.0 * f64::from(k)).collect();
    let pairs = axis.iter().flat_map(|x| axis.iter().map(move |y| (*x, *y)));
    let all = pairs.map(|(x, y)| ridges(x, y)).collect();
    let grid = DepthGrid::new(axis.clone(), axis.clone(), all, DepthInterpolation::Smooth).unwrap();
    grid.at(x, y).depth
}

#[test]
fn a_spread_over_ridges_rests_and_moves() {
    let solver = "[solver]\nduration_s = 6.0\nerror_estimate = false\n[output]\ninterval_s = 0.5\n";
    let aside = "start_offset_m = [3.0, 1.0, 0.5]\n[points.clump]";
    let more = format!("{solver}{}", depths(ridges));
    let text = on_bed(&grid("smooth"), ridges_on_grid, &more).replace("[points.clump]", aside);
    let run = moved(&text.replace(HEAD, ""));
    assert!(run.balance.relative_drift() < 5e-3, "{:?}", run.balance);
    let x = channel(&run, "x_m[buoy]");
    assert!(x.iter().all(|x| x.is_finite()));
}

/// A clump that is let go from its wire on a plane that rises by 0.2 towards +x.
fn clump_let_go(way: &str, friction: f64) -> MotionRun {
    moved(&format!(
        "[environment]\nwater_density_kg_per_m3 = 0.0\ngravity_m_per_s2 = 10.0\n[seabed]\ndepth_m = 100.0\n{}\
         [materials.wire]\nmass_kg_per_m = 0.1\ndiameter_m = 0.01\nea_n = 1e6\naxial_damping_n_s = 1e3\n\
         [points.post]\nkind = \"fixed\"\nposition_m = [30.0, 0.0, -94.0]\n\
         [points.clump]\nkind = \"free\"\nmass_kg = 500.0\nbed_friction = {friction:?}\n\
         [[lines]]\nname = \"stay\"\nfrom = \"post\"\nto = \"clump\"\nmaterial = \"wire\"\nlength_m = 30.0\nsegments = 10\nrelease_b_s = 1.0\n\
         [solver]\nduration_s = 5.0\nerror_estimate = false\n[output]\ninterval_s = 0.25\n{}",
        grid(way),
        depths(|x, _| 100.0 - 0.2 * x)
    ))
}

/// Down the plane a = g (sin - mu cos) cos along x.
#[test]
fn a_clump_slides_down_a_slope() {
    let tan: f64 = 0.2;
    for (way, friction) in [("smooth", 0.0), ("smooth", 0.1), ("bilinear", 0.1)] {
        let run = clump_let_go(way, friction);
        let x = channel(&run, "x_m[clump]");
        let a = 10.0 * (tan - friction) / (1.0 + tan * tan);
        for (x_now, time) in x.iter().zip(&run.history.time) {
            let since = (time - 1.0).max(0.0);
            let expected = -0.5 * a * since * since;
            let off = x_now - x[0] - expected;
            let what = format!("{way} {friction} {time}: {off}");
            assert!(off.abs() < 5e-3 * expected.abs().max(1.0), "{what}");
        }
        assert!(run.balance.relative_drift() < 0.01, "{:?}", run.balance);
    }
}

#[test]
fn friction_holds_a_clump_on_a_slope_from_where_it_balances_without() {
    let run = clump_let_go("smooth", 0.3);
    let x = channel(&run, "x_m[clump]");
    // The bed gives way along itself as much as under the weight: a millimetre by 5 kN.
    let given = x[0] - x[x.len() - 1];
    assert!((0.0..0.3e-3).contains(&given), "{given}");
    let said = "At rest the friction of the bed is left out of point clump:";
    let warned = run.warnings.iter().filter(|text| text.starts_with(said));
    assert_eq!(warned.count(), 1, "{:?}", run.warnings);
}

#[test]
fn what_a_grid_cannot_have_is_refused() {
    let text = |bed: &str, more: &str| on_bed(bed, |_, _| LEVEL, more).replace(HEAD, "");
    let table = depths(|_, _| LEVEL);
    // Friction of lines it has.
    let rough = format!("{}friction = 0.5\n", grid("smooth"));
    solved(&on_bed(&rough, |_, _| LEVEL, &table));
    let found = refused(&text("interpolation = \"bilinear\"\n", ""));
    assert!(found.contains("the bed has no file of depths"), "{found}");
    let found = refused(&text(&grid("smooth"), &depths(|_, _| 90.0)));
    assert!(
        found.contains("\"anchor0\" lies 9.700 m below the bed")
            && found.contains("-90.000 or more"),
        "{found}"
    );
    let broken = table.replace("0.0,0.0,99.7", "0.0,0.0,deep");
    let found = refused(&text(&grid("smooth"), &broken));
    assert!(found.contains("bed.csv:"), "{found}");
}
