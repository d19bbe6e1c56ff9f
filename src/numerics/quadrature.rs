//! Integrals by the trapezoidal rule.

/// The area of each interval of an ascending grid.
fn areas(grid: &[f64], values: &[f64]) -> impl Iterator<Item = f64> {
    let pieces = grid.windows(2).zip(values.windows(2));
    pieces.map(|(x, y)| 0.5 * (x[1] - x[0]) * (y[0] + y[1]))
}

/// The integral over the whole grid.
#[must_use]
pub fn trapezoid(grid: &[f64], values: &[f64]) -> f64 {
    areas(grid, values).sum()
}

/// The integral from the first point of the grid to each.
#[must_use]
pub fn cumulative_trapezoid(grid: &[f64], values: &[f64]) -> Vec<f64> {
    let mut sum = 0.0;
    let mut all = vec![0.0; grid.len().min(1)];
    all.extend(areas(grid, values).map(|area| {
        sum += area;
        sum
    }));
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_for_straight_lines() {
        let (grid, values) = ([0.0, 1.0, 3.0], [0.0, 2.0, 6.0]);
        assert_eq!(trapezoid(&grid, &values), 9.0);
        assert_eq!(cumulative_trapezoid(&grid, &values), [0.0, 1.0, 9.0]);
        assert!(cumulative_trapezoid(&[], &[]).is_empty());
    }
}
