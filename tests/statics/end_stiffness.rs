//! The change of a line's end forces with its ends against central differences of solved lines.

use proptest::prelude::*;
use seacable::statics::catenary::{CatenaryLine, EndOffset, RigidBed, SectionProperties, Solution};

struct Given {
    x: f64,
    heights: [f64; 2],
    sections: Vec<SectionProperties>,
    friction: f64,
    bed: bool,
}

impl Given {
    fn solve(&self, [dx, da, db]: [f64; 3]) -> Option<Solution> {
        let line = CatenaryLine {
            ends: EndOffset {
                x_m: self.x + dx,
                z_m: self.heights[1] + db - self.heights[0] - da,
            },
            sections: &self.sections,
            bed: self.bed.then_some(RigidBed {
                below_a_m: self.heights[0] + da,
                friction: self.friction,
                ..RigidBed::default()
            }),
            surface_above_a_m: None,
        };
        line.solve().ok()
    }
}

fn forces(line: &Solution) -> [f64; 4] {
    [line.h_a_n, line.v_a_n, line.h_b_n, line.v_b_n]
}

/// Compares all columns; those where a step changes the shape are left out. Returns how many were compared.
fn compare(given: &Given) -> Result<usize, TestCaseError> {
    let Some(here) = given.solve([0.0; 3]) else {
        return Ok(0);
    };
    let k = here.end_stiffness(given.friction);
    let rows = [k.h_a, k.v_a, k.h_b, k.v_b];
    let size = given.x + here.length_m();
    // What a difference of forces rounds to; those of a slack line without weight, of 1e-200 N, by the stiffness.
    let of_section = |section: &SectionProperties| section.ea_n / section.length_m;
    let softest = given
        .sections
        .iter()
        .map(of_section)
        .fold(f64::INFINITY, f64::min);
    let greatest = forces(&here)
        .iter()
        .fold(0.0, |most: f64, force| most.max(force.abs()));
    let rounding = f64::EPSILON * (softest + greatest / (1e-5 * size));
    let mut compared = 0;
    for column in 0..3 {
        if column > 0 && given.bed && given.heights[column - 1] == 0.0 {
            continue; // It cannot go down, and begins to rise as a root.
        }
        let slope = |step: f64| {
            let mut motion = [0.0; 3];
            motion[column] = step;
            let up = given.solve(motion)?;
            motion[column] = -step;
            let down = given.solve(motion)?;
            let same = up.shape == here.shape && down.shape == here.shape;
            let (up, down) = (forces(&up), forces(&down));
            same.then(|| [0, 1, 2, 3].map(|i| (up[i] - down[i]) / (2.0 * step)))
        };
        let (Some(coarse), Some(fine)) = (slope(2e-5 * size), slope(1e-5 * size)) else {
            continue;
        };
        let scale = rows.iter().map(|row| row[column].abs()).fold(0.0, f64::max);
        for i in 0..4 {
            // Differences that do not agree between themselves say nothing: a kink is near.
            let noise = 2.0 * (coarse[i] - fine[i]).abs() + 1e-5 * scale + rounding;
            let off = (rows[i][column] - fine[i]).abs();
            prop_assert!(
                off <= noise,
                "{} force {i} by {column}: {} {}",
                here.shape_name(),
                rows[i][column],
                fine[i]
            );
        }
        compared += 1;
    }
    Ok(compared)
}

fn section() -> impl Strategy<Value = SectionProperties> {
    (
        20.0..200.0_f64,
        -200.0..1000.0_f64,
        5.0..9.0_f64,
        -2e4..4e4_f64,
    )
        .prop_map(|(length, weight, log_ea, clump)| SectionProperties {
            clump_n: clump,
            ..SectionProperties::new(length, weight, 10_f64.powf(log_ea))
        })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, ..ProptestConfig::default() })]

    #[test]
    fn one_section(
        section in section(),
        share in 0.1..1.02_f64,
        heights in [0.0..60.0_f64, 0.0..150.0],
        (ground_a, bed, friction) in (any::<bool>(), any::<bool>(), 0.0..1.0_f64),
    ) {
        let a = if ground_a { 0.0 } else { heights[0] };
        let given = Given {
            x: share * section.length_m,
            heights: [a, heights[1]],
            sections: vec![SectionProperties { clump_n: 0.0, ..section }],
            friction: if ground_a { friction } else { 0.0 },
            bed,
        };
        compare(&given)?;
    }

    #[test]
    fn several_sections(
        mut sections in prop::collection::vec(section(), 2..5),
        share in 0.1..1.02_f64,
        heights in [0.0..60.0_f64, 0.0..150.0],
        (ground_a, bed, friction) in (any::<bool>(), any::<bool>(), 0.0..1.0_f64),
    ) {
        let a = if ground_a { 0.0 } else { heights[0] };
        sections.last_mut().unwrap().clump_n = 0.0;
        let given = Given {
            x: share * sections.iter().map(|s| s.length_m).sum::<f64>(),
            heights: [a, heights[1]],
            sections,
            friction: if ground_a && friction > 0.5 { friction } else { 0.0 },
            bed,
        };
        compare(&given)?;
    }
}

/// Every shape is met, and compared in every direction in which it can move.
#[test]
fn each_shape_by_name() {
    let chain = |length| vec![SectionProperties::new(length, 1000.0, 5e8)];
    let with_clump = vec![
        SectionProperties {
            clump_n: 3e4,
            ..SectionProperties::new(60.0, 300.0, 1e8)
        },
        SectionProperties::new(60.0, 300.0, 1e8),
    ];
    let cases = [
        (chain(120.0), 100.0, [50.0, 60.0], 0.0, 3, "hanging"),
        (chain(120.0), 100.0, [0.0, 40.0], 0.3, 2, "partly on bed"),
        (chain(140.0), 100.0, [20.0, 30.0], 0.0, 3, "U on bed"),
        (chain(170.0), 100.0, [0.0, 60.0], 0.0, 2, "slack on bed"),
        (chain(99.0), 100.0, [0.0, 0.0], 0.0, 1, "wholly on bed"),
        (with_clump, 100.0, [20.0, 25.0], 0.0, 3, "U on bed"),
    ];
    for (sections, x, heights, friction, columns, shape) in cases {
        let given = Given {
            x,
            heights,
            sections,
            friction,
            bed: true,
        };
        assert_eq!(given.solve([0.0; 3]).unwrap().shape_name(), shape);
        assert_eq!(compare(&given).unwrap(), columns, "{shape}");
    }
}
