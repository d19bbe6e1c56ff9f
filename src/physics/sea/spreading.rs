//! Directional spreading: short-crested waves as components that each run in a direction of their own.
//!
//! Energy is spread about the main direction by `cos^n(theta)` within a quarter turn on either side (DNV-RP-C205 2019, section
//! 3.5.8.6; n from 2 to 10 for wind sea). All components have the same energy, so that directions at equal shares of the
//! distribution, dealt out at random, carry it.

use std::f64::consts::FRAC_PI_2;

use super::Component;
use crate::numerics::random::Random;

/// Directions that the components of a spread sea run in.
const DIRECTIONS: usize = 24;

/// Points of the integral of the distribution.
const POINTS: usize = 2000;

/// The components by direction, each with its angle from the main direction \[rad\], frequencies rising in each.
#[must_use]
pub fn spread(
    components: Vec<Component>,
    exponent: f64,
    random: &mut Random,
) -> Vec<(f64, Vec<Component>)> {
    let angles = directions(exponent);
    let mut groups: Vec<(f64, Vec<Component>)> = angles
        .into_iter()
        .map(|angle| (angle, Vec::new()))
        .collect();
    let mut waiting: Vec<usize> = Vec::new();
    for component in components {
        if waiting.is_empty() {
            waiting = (0..DIRECTIONS).collect();
        }
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a share of a short list"
        )]
        let drawn = (random.uniform() * waiting.len() as f64) as usize;
        let direction = waiting.swap_remove(drawn.min(waiting.len() - 1));
        groups[direction].1.push(component);
    }
    groups.retain(|(_, components)| !components.is_empty());
    groups
}

/// Angles \[rad\] in the middle of equal shares of `cos^n`.
fn directions(exponent: f64) -> Vec<f64> {
    let width = 2.0 * FRAC_PI_2 / POINTS as f64;
    let angle = |k: usize| -FRAC_PI_2 + width * (k as f64 + 0.5);
    let mut sum = 0.0;
    let shares: Vec<f64> = (0..POINTS)
        .map(|k| {
            sum += angle(k).cos().powf(exponent);
            sum
        })
        .collect();
    let wanted = |i: usize| (i as f64 + 0.5) / DIRECTIONS as f64 * sum;
    let at = |share: f64| {
        let next = shares.partition_point(|known| *known < share);
        let before = if next == 0 { 0.0 } else { shares[next - 1] };
        let part = (share - before) / (shares[next] - before);
        -FRAC_PI_2 + width * (next as f64 + part)
    };
    (0..DIRECTIONS).map(|i| at(wanted(i))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sea::{Spectrum, synthesise};

    #[test]
    fn directions_have_the_spread_of_the_distribution() {
        for exponent in [2.0, 6.0, 30.0] {
            let angles = directions(exponent);
            let mean: f64 = angles.iter().sum::<f64>() / DIRECTIONS as f64;
            assert!(mean.abs() < 1e-9);
            // Over cos^n the mean of cos² is (n + 1)/(n + 2).
            let square = angles.iter().map(|a| a.cos().powi(2)).sum::<f64>() / DIRECTIONS as f64;
            let exact = (exponent + 1.0) / (exponent + 2.0);
            assert!((square / exact - 1.0).abs() < 6e-3, "{square} {exact}");
        }
    }

    #[test]
    fn no_component_is_lost_and_energy_is_even() {
        let sea = synthesise(&Spectrum::jonswap(4.0, 9.0, 3.3), 240, 1, 0);
        let groups = spread(sea.clone(), 4.0, &mut Random::new(1, 5));
        assert_eq!(groups.len(), DIRECTIONS);
        assert!(groups.iter().all(|(_, part)| part.len() == 10));
        let mut all: Vec<Component> = groups.into_iter().flat_map(|(_, part)| part).collect();
        all.sort_by(|a, b| a.omega.total_cmp(&b.omega));
        assert_eq!(all, sea);
    }
}
