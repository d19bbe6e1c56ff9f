//! The mesh: division of a section into segments, and the coarser mesh for the mesh error estimate.

use crate::case::{Case, OnSection};

/// Start and length of each segment of a section \[m\], from the end of the section nearer to A. Segments are equal; coarsened,
/// they are equal between the clumps on the section, which keep their places on the fine mesh: a clump moved by half a segment
/// would be an error of first order.
pub(super) fn of_section(case: &Case, index: usize, coarsening: usize) -> Vec<(f64, f64)> {
    let section = &case.line[index];
    let fine = section.segments;
    let mut places = vec![0, fine];
    if coarsening > 1 {
        let hung = case
            .clumps
            .iter()
            .filter(|clump| clump.is_on(Some(&section.name)));
        let node = |at: f64| (at / section.length_m * fine as f64).round().max(0.0) as usize;
        places.extend(hung.map(|clump| node(clump.at_m).min(fine)));
        places.sort_unstable();
        places.dedup();
    }
    let stretch = |ends: &[usize]| {
        let count = (ends[1] - ends[0]).div_ceil(coarsening.max(1));
        let share = (ends[1] - ends[0]) as f64 / fine as f64;
        let length = section.length_m * share / count as f64;
        let begin = section.length_m * (ends[0] as f64 / fine as f64);
        (0..count).map(move |k| (begin + length * k as f64, length))
    };
    places.windows(2).flat_map(stretch).collect()
}

/// Number of segments of the whole line.
#[must_use]
pub fn segments(case: &Case, coarsening: usize) -> usize {
    let sections = 0..case.line.len();
    sections
        .map(|i| of_section(case, i, coarsening).len())
        .sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn case(at: &[f64]) -> Case {
        let clumps: String = at
            .iter()
            .enumerate()
            .map(|(i, at)| {
                format!("[[clumps]]\nname = \"c{i}\"\nsection = \"rope\"\nat_m = {at}\nmass_kg = 1.0\nwet_mass_kg = 1.0\n")
            })
            .collect();
        let text = format!(
            "[case]\ntitle = \"t\"\n[materials.r]\ndiameter_m = 0.1\nmass_kg_per_m = 1.0\nea_n = 1.0\n[[line]]\nname = \"rope\"\nmaterial = \"r\"\nlength_m = 90.0\nsegments = 9\n{clumps}[ends.a]\nname = \"a\"\nkind = \"free\"\n[ends.b]\nname = \"b\"\nkind = \"free\"\n"
        );
        crate::case::parse_keys(&text).unwrap()
    }

    #[test]
    fn bodies_stay_where_they_hang() {
        let begins = |at: &[f64], coarsening| -> Vec<f64> {
            of_section(&case(at), 0, coarsening)
                .iter()
                .map(|s| s.0)
                .collect()
        };
        assert_eq!(begins(&[], 2), [0.0, 18.0, 36.0, 54.0, 72.0]);
        assert_eq!(begins(&[29.0, 70.0], 1).len(), 9);
        assert_eq!(begins(&[29.0, 70.0], 2), [0.0, 15.0, 30.0, 50.0, 70.0]);
        assert_eq!(segments(&case(&[50.0]), 2), 5);
    }
}
