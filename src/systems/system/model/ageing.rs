//! How lines age at sea: marine growth and corrosion.

use crate::case::fields::ValueType::Name;
use crate::case::fields::{of, positive};
use crate::case::schema::table;

table! {
    /// Marine growth and corrosion of the lines, by depth and years.
    #[derive(Debug, Clone, PartialEq)]
    pub struct AgeingInputs => AgeingKeys {
        /// Time since the lines were new; 0 leaves them new.
        years: f64, "time at sea", unit "years", range of(0.0, 1e3);
        /// Pieces of equal length of a section whose state varies with depth, each with the mean of its state along it.
        pieces: usize = 12, "pieces", range of(1.0, 200.0);
    }
    tables {
        /// Marine growth on a material, or on all of them.
        growth: Vec<GrowthInputs>;
        /// Corrosion and wear of a material.
        corrosion: Vec<CorrosionInputs>;
    }
}

table! {
    /// Marine growth by depth: linear between the depths, constant beyond them.
    #[derive(Debug, Clone, PartialEq)]
    pub struct GrowthInputs => GrowthKeys {
        /// Material that it grows on.
        material: Option<String>, "material", kind Name, absent "all without growth of their own";
        /// Depths below still water, increasing; negative above it.
        depth_m: Vec<f64>, "depths", range of(-1e3, 2e4), absent "one thickness at every depth";
        /// Thickness at these depths.
        thickness_m: Vec<f64>, "thickness", range of(0.0, 2.0);
        /// Density of the growth, by DNV-OS-E301 1325.
        density_kg_per_m3: f64 = 1325.0, "density", range positive(1e4);
        /// Time over which the thickness grows linearly to that of the table; 0 has all of it at once.
        full_after_years: f64 = 0.0, "full after", unit "years", range of(0.0, 1e3);
        /// Diameter of the bar of a chain, which it grows on; thickness and drag refer to it.
        nominal_diameter_m: Option<f64>, "nominal diameter", range positive(10.0), absent "the diameter of the material";
        /// Mass by that of a layer on one cylinder of the nominal diameter: by DNV-OS-E301 2 for chain, 1 for rope.
        mass_factor: f64 = 1.0, "mass factor", range positive(10.0);
    }
}

table! {
    /// Corrosion and wear by depth: linear between the depths, constant beyond them.
    #[derive(Debug, Clone, PartialEq)]
    pub struct CorrosionInputs => CorrosionKeys {
        /// Material that corrodes.
        material: String, "material", kind Name;
        /// Nominal diameter of its bar or wire as new.
        bar_diameter_m: f64, "bar diameter", range positive(10.0);
        /// Depths below still water, increasing; negative above it.
        depth_m: Vec<f64>, "depths", range of(-1e3, 2e4), absent "one rate at every depth";
        /// Loss of that diameter a year at these depths, corrosion and wear together.
        rate_m_per_year: Vec<f64>, "rate", unit "m/year", range of(0.0, 1.0);
    }
}
