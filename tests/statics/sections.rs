//! Lines of several sections: rows of reference tables, and what is asked of every line.

use seacable::statics::catenary::{CatenaryLine, EndOffset, RigidBed, SectionProperties, Solution};

/// The sections of a cell: `length,weight,ea,clump` of each, with `|` between them.
pub(crate) fn sections(cell: &str) -> Vec<SectionProperties> {
    let section = |text: &str| {
        let n: Vec<f64> = text.split(',').map(|n| n.parse().unwrap()).collect();
        SectionProperties {
            clump_n: n[3],
            ..SectionProperties::new(n[0], n[1], n[2])
        }
    };
    cell.split('|').map(section).collect()
}

pub(crate) fn line(
    ends: EndOffset,
    sections: &[SectionProperties],
    bed: impl Into<Option<RigidBed>>,
) -> CatenaryLine<'_> {
    CatenaryLine {
        ends,
        sections,
        bed: bed.into(),
        surface_above_a_m: None,
    }
}

pub(crate) fn total(sections: &[SectionProperties]) -> f64 {
    sections.iter().map(|s| s.length_m).sum()
}

pub(crate) fn forces(rest: &Solution) -> [f64; 4] {
    [rest.h_b_n, rest.v_b_n, rest.h_a_n, rest.v_a_n]
}

/// The stiffness of end B is the central difference of its force over steps that are small for this tension, and for the
/// horizontal force where that is small.
pub(crate) fn check_stiffness(
    kind: &str,
    ends: EndOffset,
    tension: fn(&Solution) -> f64,
    solve: impl Fn(EndOffset) -> Solution,
) {
    let at = |x: f64, z: f64| {
        solve(EndOffset {
            x_m: ends.x_m + x,
            z_m: ends.z_m + z,
        })
    };
    let rest = at(0.0, 0.0);
    let k = rest.stiffness_n_per_m;
    let stiff = k.iter().flatten().fold(0.0_f64, |m, v| m.max(v.abs()));
    let step = (1e-5 * tension(&rest) / stiff).min(1e-4 * rest.h_b_n / k[0][0].max(k[0][1].abs()));
    for (column, (x, z)) in [(step, 0.0), (0.0, step)].into_iter().enumerate() {
        let (up, down) = (at(x, z), at(-x, -z));
        for (i, row) in k.iter().enumerate() {
            let found = (forces(&up)[i] - forces(&down)[i]) / (2.0 * step);
            let error = (found - row[column]).abs() / stiff;
            assert!(error < 1e-4, "{kind} [{i}][{column}] {error:e}");
        }
    }
}
