//! Lines in pieces that age each by the depths of places along it.

use super::material::{AgedState, MaterialAgeing};
use crate::system::build::{AgedParts, angles, copy_name};
use crate::system::equilibrium::SystemEquilibrium;
use crate::system::model::{AgeingInputs, LineInputs, SystemFile};
use crate::system::network::Network;
use crate::system::parts::{Part, parts};

/// Places along a piece whose state varies with depth, in the middles of as many equal parts of it.
const PLACES: usize = 8;

/// A line, or a copy of it, any of whose materials ages.
#[derive(Debug, Clone)]
pub struct AgeingLine<'a> {
    /// Its name in the network.
    pub name: String,
    pieces: Vec<Piece<'a>>,
}

/// A stretch of a line with one state.
#[derive(Debug, Clone)]
struct Piece<'a> {
    /// As new.
    part: Part,
    /// Nothing where its material does not age.
    ageing: Option<MaterialAgeing<'a>>,
    /// Unstretched arc lengths of its places from A over that of the line, 0 to 1; none where its material does not age.
    places: Vec<f64>,
}

/// All lines of a system that age, copy by copy.
#[must_use]
pub fn lines<'a>(file: &'a SystemFile, ageing: &'a AgeingInputs) -> Vec<AgeingLine<'a>> {
    let copies = |line: &'a LineInputs| {
        let pieces = pieces(file, ageing, line);
        let ages = pieces.iter().any(|piece| piece.ageing.is_some());
        let angles = angles(&line.repeat_at_deg).iter().filter(move |_| ages);
        angles.map(move |angle| AgeingLine {
            name: copy_name(&line.name, *angle),
            pieces: pieces.clone(),
        })
    };
    file.lines.iter().flat_map(copies).collect()
}

/// The pieces of a line as new: of equal length in a part whose state varies with depth.
fn pieces<'a>(
    file: &'a SystemFile,
    ageing: &'a AgeingInputs,
    line: &'a LineInputs,
) -> Vec<Piece<'a>> {
    let parts = parts(file, line);
    let whole: f64 = parts.iter().map(|part| part.length_m).sum();
    let mut found = Vec::new();
    let mut before = 0.0;
    for part in parts {
        let of = MaterialAgeing::of_material(ageing, &part.name);
        let varies = of.is_some_and(|of| of.varies());
        let count = if varies { ageing.pieces } else { 1 };
        let length_m = part.length_m / count as f64;
        let places = match of {
            None => 0,
            Some(_) if varies => PLACES,
            Some(_) => 1,
        };
        for k in 0..count {
            let (last, begin) = (k + 1 == count, k as f64 * length_m);
            let place = |j: usize| k as f64 + (j as f64 + 0.5) / places as f64;
            let share = |j: usize| (before + place(j) * length_m) / whole;
            found.push(Piece {
                ageing: of,
                places: (0..places).map(share).collect(),
                part: Part {
                    length_m,
                    pieces: count,
                    ..part.piece([
                        begin,
                        if last {
                            part.length_m
                        } else {
                            begin + length_m
                        },
                    ])
                },
            });
        }
        before += part.length_m;
    }
    found
}

/// Depths below still water \[m\] of the places of all pieces that age, line by line.
#[must_use]
pub fn depths(lines: &[AgeingLine<'_>], network: &Network, rest: &SystemEquilibrium) -> Vec<f64> {
    let mut found = Vec::new();
    let points = &rest.placement.points;
    for aged in lines {
        let Some(index) = network.line(&aged.name) else {
            continue;
        };
        let line = &network.lines[index];
        let ends = [&points[line.from], &points[line.to]];
        let places = aged.pieces.iter().flat_map(|piece| &piece.places);
        found.extend(places.map(|share| -rest.balance.lines[index].at(*share, ends).0.z));
    }
    found
}

/// Which of these depths matter: those of pieces whose tables vary with depth.
#[must_use]
pub fn varying(lines: &[AgeingLine<'_>]) -> Vec<bool> {
    let pieces = lines.iter().flat_map(|line| &line.pieces);
    let each = pieces.flat_map(|piece| {
        let varies = piece.ageing.is_some_and(|ageing| ageing.varies());
        piece.places.iter().map(move |_| varies)
    });
    each.collect()
}

/// The lines with their places at these depths as parts, in water of this density \[kg/m³\], and the states at the places.
#[must_use]
pub fn aged(
    lines: &[AgeingLine<'_>],
    depths: &[f64],
    water_density: f64,
) -> (AgedParts, Vec<AgedState>) {
    let mut parts = AgedParts::new();
    let mut all = Vec::new();
    let mut depths = depths.iter();
    for line in lines {
        let pieces = line.pieces.iter().map(|piece| {
            let Some(ageing) = &piece.ageing else {
                return piece.part.clone();
            };
            let here = depths.by_ref().take(piece.places.len());
            let states: Vec<AgedState> = here.map(|depth| ageing.at(*depth)).collect();
            all.extend_from_slice(&states);
            Part {
                material: ageing.aged(&piece.part.material, &states, water_density),
                ..piece.part.clone()
            }
        });
        let pieces: Vec<Part> = pieces.collect();
        parts.insert(line.name.clone(), pieces);
    }
    (parts, all)
}
