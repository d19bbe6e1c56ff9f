//! What acts on the line: the current's table over depth, the bed and its friction; output that fits into memory.

use crate::case::diagnostic::Finding;
use crate::case::fields::quantity;
use crate::case::model::{
    BedInterpolation, CaseKeys, CurrentKeys, FrictionLaw, OneOrMany, SeabedKeys,
};
use crate::case::schema::{Key, KeyValue};
use crate::limits::{ROWS, STEPS};

/// Checks of current, bed and output.
pub(super) fn check(case: &CaseKeys<'_>) -> Vec<Finding> {
    let mut found: Vec<Finding> = case.current.iter().flat_map(current).collect();
    found.extend(case.current.iter().filter_map(without_file));
    if let Some(bed) = &case.seabed {
        found.extend(friction(bed));
        found.extend(shape(bed));
    }
    found.extend(work(case));
    found
}

/// Keys of the bed's friction that have no effect.
fn friction(bed: &SeabedKeys<'_>) -> Vec<Finding> {
    FrictionKeys {
        law: &bed.friction_law,
        of_grip: vec![&bed.friction_lateral, &bed.grip_stiffness_n_per_m3],
        slip_speed: &bed.slip_speed_m_per_s,
    }
    .without_effect(bed.friction.is_given())
}

/// Keys of the bed's shape that have no effect.
fn shape(bed: &SeabedKeys<'_>) -> Vec<Finding> {
    BedShapeKeys {
        depth_at: &bed.depth_at_m,
        slope: &bed.slope_deg,
        azimuth: &bed.slope_azimuth_deg,
        depth_file: &bed.depth_file,
        interpolation: &bed.interpolation,
    }
    .without_effect()
}

/// Keys of friction beside its coefficient along lines.
#[derive(Debug)]
pub struct FrictionKeys<'k, 'a> {
    /// The law.
    pub law: &'k Key<'a, FrictionLaw>,
    /// Coefficients across lines and the stiffness of the grip, which that law has alone.
    pub of_grip: Vec<&'k Key<'a, f64>>,
    /// The slip speed, which the other law has.
    pub slip_speed: &'k Key<'a, f64>,
}

impl FrictionKeys<'_, '_> {
    /// Those that have no effect; `is_rough`: a coefficient along lines is given.
    #[must_use]
    pub fn without_effect(&self, is_rough: bool) -> Vec<Finding> {
        let slip = |problem: &str, remedy: &str| self.slip_speed.if_given(problem, remedy);
        let grip = |problem: &str, remedy: &str| -> Vec<Finding> {
            let keys = self.of_grip.iter();
            keys.filter_map(|key| key.if_given(problem, remedy))
                .collect()
        };
        if !is_rough {
            let problem = "has no effect: the bed has no friction";
            let remedy = "add `friction = ...`, its coefficient along the line, or remove this key";
            let others = [slip(problem, remedy), self.law.if_given(problem, remedy)];
            let mut found = grip(problem, remedy);
            found.extend(others.into_iter().flatten());
            return found;
        }
        let remedy = "remove it, or choose the other law";
        let problem =
            |law: FrictionLaw| format!("has no effect with the friction law `{}`", law.name());
        match self.law.get() {
            Some(FrictionLaw::Zhu2017) => grip(&problem(FrictionLaw::Zhu2017), remedy),
            Some(FrictionLaw::Grip) => slip(&problem(FrictionLaw::Grip), remedy)
                .into_iter()
                .collect(),
            None => Vec::new(),
        }
    }
}

/// The keys that give a bed its shape.
#[derive(Debug)]
pub struct BedShapeKeys<'k, 'a> {
    /// Where it has its depth.
    pub depth_at: &'k Key<'a, [f64; 2]>,
    /// How steeply it rises.
    pub slope: &'k Key<'a, f64>,
    /// Which way.
    pub azimuth: &'k Key<'a, f64>,
    /// The file of its depths.
    pub depth_file: &'k Key<'a, String>,
    /// How the depth goes between the places of that.
    pub interpolation: &'k Key<'a, BedInterpolation>,
}

impl BedShapeKeys<'_, '_> {
    /// Those that have no effect, or say the same otherwise.
    #[must_use]
    pub fn without_effect(&self) -> Vec<Finding> {
        let mut found = self.of_level();
        found.extend(self.of_grid());
        found
    }

    /// Keys of a bed with a grid of depths that say the same otherwise, or are not computed with it.
    fn of_grid(&self) -> Option<Finding> {
        if !self.depth_file.is_given() {
            let problem = "has no effect: the bed has no file of depths";
            let remedy = "add `depth_file = ...`, or remove this key";
            let given = self.interpolation.if_given(problem, remedy);
            let differs = !self.interpolation.is(&BedInterpolation::Smooth);
            return given.filter(|_| differs);
        }
        let problem = "has no effect: the bed has the depths of depth_file";
        self.slope.if_given(problem, "remove it, or depth_file")
    }

    /// Where a level bed is how deep, and which way it does not rise. Zero says no more than nothing.
    fn of_level(&self) -> Vec<Finding> {
        if self.slope.is_given() {
            return Vec::new();
        }
        let problem = "has no effect: the bed is level";
        let remedy = "add `slope_deg = ...`, how steeply it rises, or remove this key";
        let azimuth = self.azimuth.if_given(problem, remedy);
        let place = self.depth_at.if_given(problem, remedy);
        let found = [
            azimuth.filter(|_| !self.azimuth.is(&0.0)),
            place.filter(|_| !self.depth_at.is(&[0.0, 0.0])),
        ];
        found.into_iter().flatten().collect()
    }
}

/// A current by a file is computed in systems alone.
fn without_file(current: &CurrentKeys<'_>) -> Option<Finding> {
    current.file.if_given(
        "is for systems of lines: a case of one line has a current by depth",
        "give `speed_m_per_s`, `direction_deg` and `depth_m`, or state the line as a [system]",
    )
}

/// Lists of the current go with a list of depths, as long, increasing; a file has all of it.
pub fn current(current: &CurrentKeys<'_>) -> Vec<Finding> {
    if current.file.is_given() {
        let problem = "has no effect: the current is that of its file";
        let remedy = "remove it, or leave `file` out";
        let keys = [
            current.speed_m_per_s.if_given(problem, remedy),
            current.direction_deg.if_given(problem, remedy),
            current.depth_m.if_given(problem, remedy),
        ];
        return keys.into_iter().flatten().collect();
    }
    if !current.speed_m_per_s.is_given() {
        let remedy = "add `speed_m_per_s = ...` in m/s";
        return vec![current.speed_m_per_s.missing(remedy)];
    }
    let depth = &current.depth_m;
    let lists = [&current.speed_m_per_s, &current.direction_deg].into_iter();
    let lists: Vec<(&Key<'_, OneOrMany>, usize)> = lists
        .filter_map(|key| match key.get()? {
            OneOrMany::Many(values) => Some((key, values.len())),
            OneOrMany::One(_) => None,
        })
        .collect();
    if !depth.is_given() {
        let without = lists.iter().map(|(key, count)| {
            let remedy = format!("add `depth_m = [...]` with {count} depths in m, increasing");
            key.finding(
                "is a list, and the depths it belongs to are missing",
                remedy,
            )
        });
        return without.collect();
    }
    let Some(depths) = depth.get() else {
        return Vec::new();
    };
    let uneven = lists.iter().filter(|(_, count)| *count != depths.len());
    let mut found: Vec<Finding> = uneven
        .map(|(key, count)| {
            let problem = format!("has {count} values for {} depths", depths.len());
            key.finding(problem, "give one value for each depth of depth_m")
        })
        .collect();
    if lists.is_empty() && current.speed_m_per_s.get().is_some() {
        found.push(depth.finding(
            "has no effect: speed and direction are the same at every depth",
            "give a list of speeds, one for each depth, or remove depth_m",
        ));
    }
    found.extend(increasing(
        depth,
        "depths",
        "list the depths from the surface down, each once",
    ));
    found
}

/// A list of lengths must increase.
pub fn increasing(key: &Key<'_, Vec<f64>>, what: &str, remedy: &str) -> Option<Finding> {
    let values = key.get()?;
    let at = values.windows(2).position(|pair| pair[1] <= pair[0])?;
    let problem = format!(
        "the {what} must increase: {} follows {}",
        quantity(values[at + 1], "m"),
        quantity(values[at], "m")
    );
    Some(key.finding_at_item(at + 1, problem, remedy))
}

/// The work that steps and output of these lengths make, where a limit is exceeded.
fn work(case: &CaseKeys<'_>) -> Vec<Finding> {
    let solver = case.solver.as_ref();
    let duration = solver.map_or(Some(600.0), |solver| solver.duration_s.value());
    let interval = case.output.as_ref().map(|output| &output.interval_s);
    let step = solver.map(|solver| &solver.time_step_s);
    let rows = interval.and_then(|key| too_many_rows(key, key.given().copied(), duration?));
    let steps = step.and_then(|key| too_many_steps(key, key.given().copied(), duration?));
    rows.into_iter().chain(steps).collect()
}

/// An interval \[s\] of output that would fill memory and disk before it helps anyone; `duration` in s.
pub fn too_many_rows<T: KeyValue>(
    key: &Key<'_, T>,
    interval: Option<f64>,
    duration: f64,
) -> Option<Finding> {
    let rows = duration / interval?;
    ROWS.is_exceeded_by(rows).then(|| {
        let least = quantity(duration / ROWS.greatest(), "s");
        key.finding(
            format!("would write {rows:.1e} rows in {}", quantity(duration, "s")),
            ROWS.remedy(&format!("give at least {least}"), rows),
        )
    })
}

/// A time step \[s\] that would take very many steps; `duration` in s.
pub fn too_many_steps<T: KeyValue>(
    key: &Key<'_, T>,
    step: Option<f64>,
    duration: f64,
) -> Option<Finding> {
    let steps = duration / step?;
    STEPS.is_exceeded_by(steps).then(|| {
        let least = quantity(duration / STEPS.greatest(), "s");
        key.finding(
            format!(
                "would take {steps:.1e} steps in {}",
                quantity(duration, "s")
            ),
            STEPS.remedy(&format!("give at least {least}"), steps),
        )
    })
}
