//! A case that is quick to compute.

/// A short line with a body at its end, let go from level: quick to compute.
pub(crate) const SMALL: &str = r#"
[case]
title = "A small pendulum"

[materials.rope]
diameter_m = 0.05
mass_kg_per_m = 3.0
ea_n = 1e6
axial_damping_ratio = 0.05
drag_normal = 1.2

[[line]]
name = "rope"
material = "rope"
length_m = 20.0
segments = 4

[ends.a]
name = "vessel"
kind = "fixed"
position_m = [0.0, 0.0, -10.0]

[ends.b]
name = "payload"
kind = "payload"

[payload]
dry_mass_kg = 500.0
wet_mass_kg = 400.0
drag_area_m2 = 1.0
added_mass_kg = 100.0

[start]
shape = "straight"
elevation_deg = -30.0

[solver]
duration_s = 5.0

[output]
interval_s = 0.5
shape_interval_s = 1.0
"#;
