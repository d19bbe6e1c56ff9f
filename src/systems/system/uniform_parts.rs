//! Parts of a line with floats and modules on stretches of them, and bodies within them, as parts each of one material, with bodies where they meet: as
//! closed forms and other programs have them.

use std::f64::consts::{FRAC_PI_4, PI};

use super::parts::Part;
use crate::case::{DragCoefficient, DragWidth, Environment, Material};
use crate::scene::{Segment, spread};

/// Lengths of a part that are shorter than this share of it are rounding.
const ROUNDING: f64 = 1e-9;

impl Part {
    /// Itself where its material is all that is along it; else its stretches, each of a material that has what is attached to it by
    /// unstretched length, in this water; `bears` where a bed bears modules on their width.
    #[must_use]
    pub fn uniform(&self, water: &Environment, bears: bool) -> Vec<Self> {
        let places = self.borders();
        let stretches = places.windows(2).map(|pair| {
            let piece = match places.len() {
                2 => self.clone(),
                _ => self.piece([pair[0], pair[1]]),
            };
            if piece.floats.is_empty() && piece.modules.is_empty() {
                return piece;
            }
            let attached = (&piece.floats[..], &piece.modules[..]);
            let whole = spread(water, &piece.material, piece.length_m, attached);
            let material = with_attached(&piece.material, &whole, piece.length_m, (water, bears));
            Self {
                material,
                floats: Vec::new(),
                modules: Vec::new(),
                ..piece
            }
        });
        stretches.collect()
    }

    /// Its ends, and where floats and modules begin and end and bodies hang between them \[m\].
    fn borders(&self) -> Vec<f64> {
        let whole = self.length_m;
        let end = |to: Option<f64>| to.unwrap_or(whole);
        let floats = self.floats.iter().map(|of| [of.from_m, end(of.to_m)]);
        let modules = self.modules.iter().map(|of| [of.from_m, end(of.to_m)]);
        let clumps = self.clumps.iter().map(|clump| clump.at_m);
        let places = floats.chain(modules).flatten().chain(clumps);
        let within = |place: &f64| *place > ROUNDING * whole && *place < (1.0 - ROUNDING) * whole;
        let mut found: Vec<f64> = places.filter(within).chain([0.0, whole]).collect();
        found.sort_by(f64::total_cmp);
        found.dedup_by(|next, before| *next - *before <= ROUNDING * whole);
        found
    }
}

/// A material with what a segment of this length \[m\] has beside it.
fn with_attached(
    bare: &Material,
    whole: &Segment,
    length_m: f64,
    (water, bears): (&Environment, bool),
) -> Material {
    let by_length = 2.0 / length_m;
    let density = water.water_density_kg_per_m3;
    let area = |diameter: f64| FRAC_PI_4 * diameter * diameter;
    let mass = by_length * whole.half_mass;
    let weight = by_length * whole.half_weight;
    let wet = match water.gravity_m_per_s2 > 0.0 {
        true => weight / water.gravity_m_per_s2,
        false => mass,
    };
    let diameter = if bears {
        whole.bearing_width
    } else {
        bare.diameter_m
    };
    let displaced = density * area(diameter);
    let added = |half: f64, own: f64| match displaced > 0.0 {
        true => by_length * half / displaced,
        false => own,
    };
    let widths = DragWidths::of(bare, whole, density);
    let along = match bare.drag_tangential_width {
        DragWidth::Diameter => diameter,
        DragWidth::Perimeter => PI * diameter,
    };
    let is_law = matches!(bare.drag_normal, DragCoefficient::Named(_));
    Material {
        diameter_m: diameter,
        mass_kg_per_m: mass,
        wet_weight_kg_per_m: Some(wet),
        drag_normal: match is_law {
            true => bare.drag_normal.clone(),
            false => DragCoefficient::Constant((widths.normal + widths.attached) / diameter),
        },
        attached_drag_width_m: if is_law { widths.attached } else { 0.0 },
        drag_tangential: match bare.drag_tangential {
            DragCoefficient::Named(_) => bare.drag_tangential.clone(),
            DragCoefficient::Constant(_) => DragCoefficient::Constant(widths.tangential / along),
        },
        added_mass_normal: added(whole.added.normal, bare.added_mass_normal),
        added_mass_tangential: added(whole.added.tangential, bare.added_mass_tangential),
        // Its damping is that of the bare line: the ratio goes with the root of the mass.
        axial_damping_ratio: bare
            .axial_damping_ratio
            .map(|ratio| ratio * (bare.mass_kg_per_m / mass).sqrt()),
        ..bare.clone()
    }
}

/// Drag coefficients times widths \[m\]: of the line across it, of what is attached across it, of all along it.
struct DragWidths {
    normal: f64,
    attached: f64,
    tangential: f64,
}

impl DragWidths {
    fn of(bare: &Material, whole: &Segment, density: f64) -> Self {
        if density <= 0.0 {
            return Self {
                normal: 0.0,
                attached: 0.0,
                tangential: 0.0,
            };
        }
        let constant = |drag: &DragCoefficient| match drag {
            DragCoefficient::Constant(value) => *value,
            DragCoefficient::Named(_) => 0.0,
        };
        let (drag, half) = (&whole.drag, 0.5 * density);
        Self {
            normal: drag.normal * constant(&bare.drag_normal) / half,
            attached: drag.floats / half,
            tangential: (drag.tangential * constant(&bare.drag_tangential)
                + drag.floats_tangential)
                / half,
        }
    }
}
