//! The finite-element check of the Tianjin paper: its heavier rope explains the difference to the model.

use super::inextensible::InextensibleModel;
use super::solve::SolvedRopeway;
use super::unloaded::UnloadedRope;

/// The inextensible model with the rope of the ropeway, and with the heavier bar of the finite-element check.
#[derive(Debug, Clone, PartialEq)]
pub struct WeightCheck {
    /// End tension of the check \[N\].
    pub tension_n: f64,
    /// The model with the weight of the rope.
    pub lighter: InextensibleModel,
    /// The model with the weight of the bar, in the same shape: horizontal tension in proportion to weight.
    pub model: InextensibleModel,
}

impl WeightCheck {
    /// The check of a ropeway.
    ///
    /// # Errors
    /// As a sentence: there is no check, or the model has no solution.
    pub fn of_ropeway(ropeway: &SolvedRopeway) -> Result<Self, String> {
        let none = || "The ropeway has no finite-element check.".to_owned();
        let check = ropeway.ropeway.finite_element.as_ref().ok_or_else(none)?;
        let unsolved = |error: &super::RopewayError| {
            format!("The inextensible model has no solution: {error}.")
        };
        let lighter = *ropeway.inextensible.as_ref().map_err(unsolved)?;
        let area = std::f64::consts::PI * check.radius_m * check.radius_m;
        let weight = area * check.density_kg_per_m3 * ropeway.ropeway.about.gravity_m_per_s2;
        let horizontal = lighter.rope.horizontal_n * weight / lighter.rope.weight_n_per_m;
        let geometry = ropeway.rope.geometry;
        let rope = UnloadedRope::with_horizontal_tension(geometry, weight, horizontal)
            .map_err(|error| unsolved(&error))?;
        Ok(Self {
            tension_n: check.tension_n,
            lighter,
            model: InextensibleModel::new(rope, ropeway.rope.cargo_n),
        })
    }

    /// Increase of the greatest end tension by the heavier rope \[N\].
    #[must_use]
    pub fn by_weight_n(&self) -> f64 {
        self.model.max_tension_n - self.lighter.max_tension_n
    }

    /// Difference that remains with the same weight \[N\].
    #[must_use]
    pub fn remainder_n(&self) -> f64 {
        self.tension_n - self.model.max_tension_n
    }
}

#[cfg(test)]
mod tests {
    /// The radius of the shipped checks, 9.4963 mm: a solid circle of 9.5 mm meshed by eight cells with parabolic edges.
    #[test]
    fn a_solid_circle_of_eight_parabolic_cells() {
        let half = std::f64::consts::PI / 8.0;
        let triangle = 0.5 * (2.0 * half).sin();
        let segment = 2.0 / 3.0 * 2.0 * half.sin() * (1.0 - half.cos());
        let area = 8.0 * (triangle + segment);
        let radius = 9.5 * (area / std::f64::consts::PI).sqrt();
        assert!((radius - 9.4963).abs() < 1e-4, "{radius}");
    }
}
