//! The numeric inputs of a case, each with the values that its tolerance gives it.

use super::values::{KeyNumber, parts};
use crate::case::fields::ValueType;
use crate::case::file_kind::FileKind;
use crate::case::{FieldRow, Mark, StudyValue, kind};
use crate::study::points::Setting;

/// Tolerance of an input that states none, as a share of its value.
pub const USUAL_TOLERANCE: f64 = 0.1;

/// Tables of settings, which are no inputs of the model.
const SETTINGS: [&str; 3] = ["solver.", "output.", "modes."];

/// An input and the values it is varied to.
#[derive(Debug, Clone, PartialEq)]
pub struct VariedInput {
    /// Key path, with the axis of a coordinate: `ends.b.position_m.x`.
    pub path: String,
    /// Unit as shown; empty for pure numbers.
    pub unit: &'static str,
    /// Value in the case; of a list that is scaled as a whole its greatest by size.
    pub value: f64,
    /// Whether it is such a list.
    pub is_list: bool,
    /// Lower and upper value.
    pub ends: [f64; 2],
    /// Where its tolerance comes from.
    pub tolerance: InputTolerance,
    /// Whether the lower and the upper value are those of the key's range, because the tolerance reaches beyond.
    pub clipped: [bool; 2],
    /// The key itself.
    key: String,
    part: KeyNumber,
}

/// Where the tolerance of an input comes from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum InputTolerance {
    /// From its mark.
    Stated,
    /// [`USUAL_TOLERANCE`] of its value.
    Usual,
}

/// An input that is not varied.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SkippedInput {
    /// Key path.
    pub path: String,
    /// Why.
    pub reason: &'static str,
}

impl VariedInput {
    /// The settings that give it its lower and its upper value.
    #[must_use]
    pub fn settings(&self) -> [Setting; 2] {
        self.ends
            .map(|end| Setting::new(&self.key, StudyValue::Word(self.part.written(end))))
    }
}

/// The numeric inputs that a case gives and that apply, and those of them that are not varied: settings, counts and seeds, tables over
/// arc length, depth or strain, and zeros without a tolerance of their own.
#[must_use]
pub fn varied_inputs<K: FileKind>(text: &str) -> (Vec<VariedInput>, Vec<SkippedInput>) {
    let (mut varied, mut skipped) = (Vec::new(), Vec::new());
    for row in kind::rows::<K>(text) {
        let is_setting = SETTINGS.iter().any(|table| row.path.starts_with(table));
        if !row.given || !row.applies || is_setting {
            continue;
        }
        for part in parts(&row.value, row.field.kind) {
            let path = format!("{}{}", row.path, part.suffix);
            match input(&row, &path, part) {
                Ok(input) => varied.push(input),
                Err(reason) => skipped.push(SkippedInput { path, reason }),
            }
        }
    }
    (varied, skipped)
}

fn input(row: &FieldRow, path: &str, part: KeyNumber) -> Result<VariedInput, &'static str> {
    match row.field.kind {
        ValueType::Integer => return Err("a count or a seed"),
        ValueType::List | ValueType::Pair => return Err("a table or a pair of numbers"),
        _ => {}
    }
    let stated = row
        .standing
        .as_ref()
        .and_then(|mark| stated(mark, part.value));
    let (by, tolerance) = match stated {
        Some(by) => (by, InputTolerance::Stated),
        None => (USUAL_TOLERANCE * part.value.abs(), InputTolerance::Usual),
    };
    if by <= 0.0 {
        return Err("0, of which there is no share; its mark may state tolerance_abs");
    }
    if part.is_scaled_list() && part.value == 0.0 {
        return Err("a list of zeros");
    }
    let range = row.field.range;
    let wanted = [part.value - by, part.value + by];
    let mut ends = wanted.map(|end| end.clamp(range.min, range.max));
    if range.min_excluded && ends[0] <= range.min {
        // A tolerance beyond an excluded bound ends half-way to it.
        ends[0] = 0.5 * (range.min + part.value);
    }
    Ok(VariedInput {
        path: path.to_owned(),
        unit: if row.unit == "-" { "" } else { row.unit },
        value: part.value,
        is_list: part.is_scaled_list(),
        clipped: [ends[0] > wanted[0], ends[1] < wanted[1]],
        ends,
        tolerance,
        key: row.path.clone(),
        part,
    })
}

/// The tolerance that a mark states, in the unit of the key; the wider one where it states both.
fn stated(mark: &Mark, value: f64) -> Option<f64> {
    let share = mark.tolerance_rel.map(|share| share * value.abs());
    [share, mark.tolerance_abs]
        .into_iter()
        .flatten()
        .reduce(f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::Case;

    const CASE: &str = r#"
        [case]
        title = "a rope"
        [current]
        speed_m_per_s = [0.5, 0.0]
        depth_m = [0.0, 10.0]
        [materials.m]
        diameter_m = 0.1
        mass_kg_per_m = 10.0
        ea_n = 1e8
        drag_normal = "jia-2019-normal"
        [[line]]
        name = "s"
        material = "m"
        length_m = 10.0
        segments = 2
        [ends.a]
        name = "a"
        kind = "fixed"
        position_m = [0.0, 0.0, -5.0]
        [ends.b]
        name = "b"
        kind = "free"
        period_s = 3.0
        [start]
        azimuth_deg = 350.0
        shape = "straight"
        [solver]
        duration_s = 5.0
        [marks]
        "materials.m.ea_n" = { status = "assumed", reason = "r", tolerance_rel = 0.5 }
        "ends.a.position_m" = { status = "assumed", reason = "r", tolerance_abs = 2.0 }
    "#;

    #[test]
    fn inputs_have_their_own_tolerance_or_the_usual_one() {
        let (varied, skipped) = varied_inputs::<Case>(CASE);
        let of = |path: &str| varied.iter().find(|input| input.path == path).unwrap();
        assert_eq!(of("materials.m.mass_kg_per_m").ends, [9.0, 11.0]);
        let stiffness = of("materials.m.ea_n");
        assert_eq!(
            (stiffness.ends, stiffness.tolerance),
            ([5e7, 1.5e8], InputTolerance::Stated)
        );
        assert_eq!(of("ends.a.position_m.x").ends, [-2.0, 2.0]);
        let settings = of("ends.a.position_m.z").settings();
        assert_eq!(settings[0].written(), "[0, 0, -7]");
        let speeds = of("current.speed_m_per_s");
        assert!(speeds.is_list);
        assert_eq!(speeds.settings()[1].written(), "[0.55, 0]");
        let azimuth = of("start.azimuth_deg");
        assert_eq!(
            (azimuth.ends, azimuth.clipped),
            ([315.0, 360.0], [false, true])
        );
        let names: Vec<&str> = skipped.iter().map(|input| input.path.as_str()).collect();
        assert_eq!(names, ["current.depth_m", "line.s.segments"]);
        // Neither settings nor what has no effect: the period of an end that does not move.
        assert!(
            varied
                .iter()
                .all(|input| !input.path.starts_with("solver") && !input.path.contains("period"))
        );
    }
}
