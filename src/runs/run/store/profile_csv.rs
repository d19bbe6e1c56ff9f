//! The columns of `profile.csv` and `ropes.csv`.

use super::columns::{CsvColumn, column};
use crate::run::{Profile, RopeProfile};

fn bends(profile: &Profile) -> bool {
    profile.bends()
}

fn has_bed(profile: &Profile) -> bool {
    !profile.bed_clearance.is_empty()
}

fn responds(profile: &Profile) -> bool {
    !profile.rms.is_empty()
}

/// The number of a node, which is not kept.
const NODE: CsvColumn<Profile> = CsvColumn {
    name: "node",
    required: true,
    written: |_| true,
    values: |profile| (0..profile.nodes.len()).map(|i| i as f64).collect(),
    set: |_, _| (),
};

/// A coordinate of the nodes.
const fn coordinate<const AXIS: usize>(name: &'static str) -> CsvColumn<Profile> {
    CsvColumn {
        name,
        required: true,
        written: |_| true,
        values: |profile| profile.nodes.iter().map(|x| x[AXIS]).collect(),
        set: |profile, values| {
            profile.nodes.resize(values.len(), [0.0; 3]);
            for (node, value) in profile.nodes.iter_mut().zip(values) {
                node[AXIS] = value;
            }
        },
    }
}

/// Phase of the motion at the driving period, which follows from its amplitudes.
const PHASE: CsvColumn<Profile> = CsvColumn {
    name: "wave_phase_deg",
    required: false,
    written: responds,
    values: |profile| {
        let amplitudes = profile.wave_sin.iter().zip(&profile.wave_cos);
        amplitudes.map(|(s, c)| s.atan2(*c).to_degrees()).collect()
    },
    set: |_, _| (),
};

/// Columns of `profile.csv`; those of bending and of the response are written where a run has them.
pub(super) const PROFILE_COLUMNS: [CsvColumn<Profile>; 29] = [
    NODE,
    column!(Profile, "arc_m", arc, required),
    coordinate::<0>("x_m"),
    coordinate::<1>("y_m"),
    coordinate::<2>("z_m"),
    column!(Profile, "tension_n", tension, required),
    column!(Profile, "tension_min_n", tension_min, required),
    column!(Profile, "tension_max_n", tension_max, required),
    column!(Profile, "z_min_m", z_min, required),
    column!(Profile, "z_max_m", z_max, required),
    column!(Profile, "bed_clearance_m", bed_clearance, has_bed),
    column!(Profile, "bed_clearance_min_m", bed_clearance_min, has_bed),
    column!(Profile, "curvature_per_m", curvature, bends),
    column!(Profile, "curvature_max_per_m", curvature_max, bends),
    column!(Profile, "moment_nm", moment, bends),
    column!(Profile, "moment_max_nm", moment_max, bends),
    column!(Profile, "rms_displacement_m", rms, responds),
    column!(Profile, "rms_displacement_d", rms_diameters, responds),
    column!(Profile, "rms_vertical_d", rms_vertical, responds),
    column!(Profile, "rms_horizontal_d", rms_horizontal, responds),
    column!(Profile, "wave_cos_m", wave_cos, responds),
    column!(Profile, "wave_sin_m", wave_sin, responds),
    PHASE,
    column!(Profile, "rms_error_m", rms_error, responds),
    column!(Profile, "wave_number_per_m", wave_number, responds),
    column!(Profile, "wkb_number_per_m", wkb_number, responds),
    column!(Profile, "wkb_amplitude", wkb_amplitude, responds),
    column!(Profile, "towards_a_m", towards_a, responds),
    column!(Profile, "towards_b_m", towards_b, responds),
];

/// Columns of `ropes.csv`.
pub(super) const ROPE_COLUMNS: [CsvColumn<RopeProfile>; 7] = [
    column!(RopeProfile, "arc_m", arc, required),
    column!(RopeProfile, "mean_load_percent", mean_load, required),
    column!(
        RopeProfile,
        "deviation_min_percent",
        deviation_min,
        required
    ),
    column!(
        RopeProfile,
        "deviation_max_percent",
        deviation_max,
        required
    ),
    column!(RopeProfile, "stiffness_k", stiffness, required),
    column!(RopeProfile, "stiffness_min_k", stiffness_min, required),
    column!(RopeProfile, "stiffness_max_k", stiffness_max, required),
];
