//! What marine growth and corrosion change of a material.

use std::f64::consts::FRAC_PI_4;

use crate::case::Material;
use crate::numerics::interpolation::linear_clamped;
use crate::system::model::{AgeingInputs, CorrosionInputs, GrowthInputs};

/// The tables that a material ages by.
#[derive(Debug, Clone, Copy)]
pub struct MaterialAgeing<'a> {
    years: f64,
    growth: Option<&'a GrowthInputs>,
    corrosion: Option<&'a CorrosionInputs>,
}

/// What a material gained and lost at a depth.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct AgedState {
    /// Thickness of the marine growth \[m\].
    pub growth_m: f64,
    /// Loss of diameter of the bar or wire \[m\].
    pub loss_m: f64,
}

impl<'a> MaterialAgeing<'a> {
    /// The tables of a material by its name; nothing where it does not age. Growth of the material itself goes before growth of all.
    #[must_use]
    pub fn of_material(ageing: &'a AgeingInputs, material: &str) -> Option<Self> {
        let growth = |name: Option<&str>| {
            let mut tables = ageing.growth.iter();
            tables.find(|growth| growth.material.as_deref() == name)
        };
        let mut corrosion = ageing.corrosion.iter();
        let found = Self {
            years: ageing.years,
            growth: growth(Some(material)).or_else(|| growth(None)),
            corrosion: corrosion.find(|corrosion| corrosion.material == material),
        };
        let ages = found.growth.is_some() || found.corrosion.is_some();
        (ages && ageing.years > 0.0).then_some(found)
    }

    /// Whether any of its tables varies with depth.
    #[must_use]
    pub fn varies(&self) -> bool {
        let growth = self.growth.map_or(0, |growth| growth.depth_m.len());
        let corrosion = self
            .corrosion
            .map_or(0, |corrosion| corrosion.depth_m.len());
        growth.max(corrosion) > 1
    }

    /// The state at a depth below still water \[m\].
    ///
    /// Growth thickens linearly with time up to `full_after_years`; the loss of diameter is rate times time.
    #[must_use]
    pub fn at(&self, depth_m: f64) -> AgedState {
        let growth_m = self.growth.map_or(0.0, |growth| {
            let grown = match growth.full_after_years > self.years {
                true => self.years / growth.full_after_years,
                false => 1.0,
            };
            grown * by_depth(&growth.depth_m, &growth.thickness_m, depth_m)
        });
        let loss_m = self.corrosion.map_or(0.0, |corrosion| {
            self.years * by_depth(&corrosion.depth_m, &corrosion.rate_m_per_year, depth_m)
        });
        AgedState { growth_m, loss_m }
    }

    /// The material along a piece with these states, evenly spread, in water of this density \[kg/m³\].
    ///
    /// Corrosion leaves the share `r = ((d - loss)/d)²` of the steel, `d` being the nominal diameter of bar or wire: of mass, weight in
    /// water, EA, breaking load and displaced area, so that the diameter shrinks by `sqrt(r)`; of EI the share `r²`. Growth of the
    /// thickness `t` adds the mass `M = mu rho pi/4 ((d + 2t)² - d²)` and the weight in water `M (1 - rho_w/rho)`, and multiplies
    /// the drag by `(d + 2t)/d` (DNV-OS-E301, Ch. 2 Sec. 1, marine growth); here the diameter is multiplied, to which the drag
    /// coefficients refer, as does the added mass. Growth adds neither stiffness nor strength. Mass, weight, diameter and compliance
    /// are means along the piece; the breaking load is that of its weakest place.
    #[must_use]
    pub fn aged(&self, new: &Material, states: &[AgedState], water_density: f64) -> Material {
        let count = states.len().max(1) as f64;
        let left = |state: &AgedState| {
            let bar = self.corrosion.map(|corrosion| corrosion.bar_diameter_m);
            bar.map_or(1.0, |bar| 1.0 - state.loss_m / bar)
        };
        let mean = |of: &dyn Fn(&AgedState) -> f64| states.iter().map(of).sum::<f64>() / count;
        let nominal = self.growth.and_then(|growth| growth.nominal_diameter_m);
        let nominal = nominal.unwrap_or(new.diameter_m);
        let grown = |state: &AgedState| left(state) * nominal + 2.0 * state.growth_m;
        let share = mean(&|state| left(state).powi(2));
        let rings = mean(&|state| grown(state).powi(2) - (left(state) * nominal).powi(2));
        let area = self.growth.map_or(1.0, |growth| growth.mass_factor) * FRAC_PI_4 * rings;
        let density = self.growth.map_or(0.0, |growth| growth.density_kg_per_m3);
        let new_wet = new.wet_kg_per_m(water_density);
        let weakest = states.iter().map(left).fold(1.0, f64::min);
        Material {
            diameter_m: new.diameter_m * mean(&|state| grown(state) / nominal),
            mass_kg_per_m: share * new.mass_kg_per_m + density * area,
            wet_weight_kg_per_m: Some(share * new_wet + (density - water_density) * area),
            ea_n: new.ea_n.map(|ea| ea / mean(&|state| left(state).powi(-2))),
            ei_n_m2: new.ei_n_m2 / mean(&|state| left(state).powi(-4)),
            break_load_n: new.break_load_n.map(|load| weakest * weakest * load),
            ..new.clone()
        }
    }
}

/// The value of a table at a depth \[m\], constant beyond its ends; a table of one value has it at every depth.
fn by_depth(depths: &[f64], values: &[f64], depth_m: f64) -> f64 {
    if depths.len() > 1 {
        return linear_clamped(depths, values, depth_m);
    }
    values.first().copied().unwrap_or(0.0)
}
