//! Lines drawn at random from all that a case of a line may say.

use proptest::prelude::*;

prop_compose! {
    /// Materials from ropes lighter than water to chains, EA over eight decades.
    fn material()(
        log_ea in 4.0f64..12.0,
        log_diameter in -2.0f64..0.0,
        density in prop_oneof![100.0f64..1000.0, 1000.0f64..1100.0, 1100.0f64..8000.0],
        damping in prop_oneof![Just(0.0), 0.0f64..0.5],
        normal in prop_oneof![Just("0.0"), Just("1.2"), Just("\"jia-2019-normal\"")],
        tangential in prop_oneof![Just("0.0"), Just("0.05"), Just("\"jia-2019-tangential\"")],
        added in 0.0f64..2.0,
    ) -> String {
        let (ea, diameter) = (10f64.powf(log_ea), 10f64.powf(log_diameter));
        let mass = density * 0.785 * diameter * diameter;
        format!(
            "materials.rope = {{ ea_n = {ea:?}, diameter_m = {diameter:?}, mass_kg_per_m = {mass:?}, \
             axial_damping_ratio = {damping:?}, drag_normal = {normal}, drag_tangential = {tangential}, \
             added_mass_normal = {added:?} }}\n"
        )
    }
}

/// A lower end: free, a payload heavy or buoyant, held near or far, taut or slack, or moving.
fn foot(length: f64) -> impl Strategy<Value = String> {
    let held = (0.0f64..1.1, -180.0f64..180.0, -90.0f64..90.0).prop_map(
        move |(share, azimuth, elevation)| {
            let (a, e) = (azimuth.to_radians(), elevation.to_radians());
            let d = share * length;
            format!(
                "[{:?}, {:?}, {:?}]",
                d * e.cos() * a.cos(),
                d * e.cos() * a.sin(),
                d * e.sin()
            )
        },
    );
    let fixed = held
        .clone()
        .prop_map(|p| format!("ends.b = {{ name = \"b\", kind = \"fixed\", position_m = {p} }}\n"));
    let moving = (held, -5.0f64..5.0, 2.0f64..20.0).prop_map(|(p, a, period)| {
        format!(
            "ends.b = {{ name = \"b\", kind = \"moving\", position_m = {p}, amplitude_m = [{a:?}, 0.3, {a:?}], period_s = {period:?} }}\n"
        )
    });
    let turning = prop_oneof![
        2 => Just(None),
        1 => (-1.0f64..1.5, 0.0f64..4.0, 0.0f64..2.0, -180.0f64..180.0).prop_map(Some),
    ];
    let payload = (0.0f64..6.0, -0.9f64..0.9, 0.0f64..100.0, 0.0f64..2.0, turning).prop_map(|(log, wet, area, added, turning)| {
        let mass = 10f64.powf(log);
        let rotation = turning.map_or_else(String::new, |(log, gyration, drag, tilt)| {
            let centre = 10f64.powf(log);
            let inertia = mass * (gyration * centre).powi(2);
            format!(
                ", rotation = {{ centre_of_gravity_m = {centre:?}, inertia_kg_m2 = {inertia:?}, centre_of_drag_m = {:?}, start_tilt_deg = {tilt:?}, \
                 drag_length_m = {:?}, added_inertia_kg_m2 = {:?}, spin_deg_per_s = {tilt:?}, spin_inertia_kg_m2 = {inertia:?} }}",
                drag * centre,
                gyration * centre,
                0.3 * drag * inertia,
            )
        });
        format!(
            "ends.b = {{ name = \"b\", kind = \"payload\" }}\npayload = {{ dry_mass_kg = {mass:?}, wet_mass_kg = {:?}, drag_area_m2 = {area:?}, added_mass_kg = {:?}{rotation} }}\n",
            wet * mass,
            added * mass
        )
    });
    prop_oneof![1 => Just(String::new()), 3 => payload, 2 => fixed, 1 => moving]
}

prop_compose! {
    /// A case without its solver.
    pub fn any_line()(log_length in 0.5f64..3.5)(
        length in Just(10f64.powf(log_length)),
        segments in 1usize..12,
        material in material(),
        foot in foot(10f64.powf(log_length)),
        speed in prop_oneof![Just(0.0), 0.0f64..3.0],
        sheared in any::<bool>(),
        shape in prop_oneof![
            Just("shape = \"equilibrium\"".to_owned()),
            (-180.0f64..180.0, -90.0f64..90.0).prop_map(|(a, e)| format!(
                "shape = \"straight\", azimuth_deg = {a:?}, elevation_deg = {e:?}"
            )),
        ],
    ) -> String {
        let current = if sheared {
            format!("current = {{ speed_m_per_s = [{speed:?}, 0.1], direction_deg = [0.0, 120.0], depth_m = [0.0, {length:?}] }}\n")
        } else {
            format!("current.speed_m_per_s = {speed:?}\n")
        };
        format!(
            "environment.water_density_kg_per_m3 = 1025.0\nline = {{ length_m = {length:?}, segments = {segments} }}\n{material}{foot}{current}start = {{ {shape} }}\n"
        )
    }
}

prop_compose! {
    /// A line in motion with all that may happen to it at once: waves, a bed with friction, bending or a fibre rope, a surface
    /// to cross, an end that moves in a harmonic or irregularly, a body on the line, one that travels along it and one that
    /// turns at its end, an end let go.
    pub fn any_scene()(log_length in 1.0f64..2.6)(
        length in Just(10f64.powf(log_length)),
        segments in 2usize..14,
        (log_ea, density, diameter, damping) in (5.0f64..9.0, 600.0f64..4000.0, 0.02f64..0.4, 0.0f64..0.3),
        (drag, added, log_ei) in (0.0f64..2.0, 0.0f64..1.5, prop_oneof![2 => Just(None), 1 => (0.0f64..5.0).prop_map(Some)]),
        surface in prop_oneof![Just("crossed"), Just("ignored")],
        waves in prop_oneof![
            1 => Just(String::new()),
            1 => (0.1f64..6.0, 3.0f64..15.0).prop_map(|(h, t)| format!("waves = {{ kind = \"regular\", height_m = {h:?}, period_s = {t:?}, direction_deg = 30.0 }}\n")),
            1 => (0.1f64..4.0, 4.0f64..12.0, 0u64..99).prop_map(|(h, t, seed)| format!("waves = {{ kind = \"irregular\", significant_height_m = {h:?}, peak_period_s = {t:?}, components = 20, seed = {seed}, stretching = \"wheeler\" }}\n")),
        ],
        (bedded, share, friction, slope, bed_damping) in (any::<bool>(), 0.1f64..0.9, prop_oneof![Just(0.0), 0.0f64..1.2], -10.0f64..10.0, 0.0f64..1e4),
        (top, amplitude, period) in (-0.2f64..0.2, 0.0f64..3.0, 2.0f64..15.0),
        (foot, hung, travels, released) in (0usize..5, any::<bool>(), any::<bool>(), any::<bool>()),
        (fibre, irregular) in (prop_oneof![2 => Just(None), 1 => Just(Some("secant")), 1 => Just(Some("about-the-mean")), 1 => Just(Some("viscoelastic"))], any::<bool>()),
        start in prop_oneof![
            Just(String::new()),
            (-80.0f64..60.0).prop_map(|e| format!("start = {{ shape = \"straight\", elevation_deg = {e:?} }}\n")),
        ],
        speed in prop_oneof![Just(0.0), 0.0f64..1.5],
    ) -> String {
        let mass = density * 0.785 * diameter * diameter;
        let more = match (log_ei, fibre) {
            (Some(log), _) => format!(", ei_n_m2 = {:?}", 10f64.powf(log)),
            (None, Some("viscoelastic")) => format!(
                ", creep_model = \"viscoelastic\", dynamic_ea_n = {:?}, dynamic_ea_per_tension = 20.0, \
                 slow_damping_n_s = {:?}, fast_damping_n_s = {:?}",
                3.0 * 10f64.powf(log_ea), 10f64.powf(log_ea + 1.0) * damping.max(0.001), 10f64.powf(log_ea - 3.0)
            ),
            (None, Some(law)) => format!(
                ", dynamic_stiffness = \"{law}\", dynamic_alpha = 25.0, dynamic_beta = 0.3, dynamic_gamma = 0.2, break_load_n = {:?}",
                10f64.powf(log_ea) / 18.0
            ),
            (None, None) => String::new(),
        };
        // A rope that creeps has dampers of its own.
        let damped = match (log_ei, fibre) {
            (None, Some("viscoelastic")) => String::new(),
            _ => format!(", axial_damping_ratio = {damping:?}"),
        };
        let motion = if irregular {
            format!("motion = \"irregular\", rms_m = [{:?}, 0.1, {:?}], peak_period_s = {period:?}, components = 20", 0.5 * amplitude, 0.5 * amplitude)
        } else {
            format!("amplitude_m = [{amplitude:?}, 0.2, {amplitude:?}], period_s = {period:?}")
        };
        let depth = share * length;
        let mut text = format!(
            "environment = {{ water_density_kg_per_m3 = 1025.0, water_surface = \"{surface}\" }}\ncurrent.speed_m_per_s = {speed:?}\n{waves}{start}\
             materials.rope = {{ ea_n = {:?}, diameter_m = {diameter:?}, mass_kg_per_m = {mass:?}{damped}, \
             drag_normal = {drag:?}, drag_tangential = 0.05, added_mass_normal = {added:?}{more} }}\n\
             line = {{ length_m = {length:?}, segments = {segments} }}\n\
             ends.a = {{ kind = \"moving\", position_m = [0.0, 0.0, {:?}], {motion}, ramp_s = 2.0{} }}\n",
            10f64.powf(log_ea), top * length,
            if released && (2..4).contains(&foot) { ", release_s = 1.5" } else { "" },
        );
        if bedded {
            text += &format!("seabed = {{ depth_m = {depth:?}, stiffness_n_per_m3 = 1e5, damping_n_s_per_m3 = {bed_damping:?}, friction = {friction:?}, slope_deg = {slope:?} }}\n");
        }
        if hung {
            text += &format!("clumps = [{{ name = \"c\", section = \"rope\", at_m = {:?}, mass_kg = {:?}, wet_mass_kg = {:?}, drag_area_m2 = 0.5, added_mass_kg = 100.0 }}]\n", 0.4 * length, 0.2 * mass * length, -0.05 * mass * length);
        }
        if travels {
            text += &format!("traveller = {{ name = \"t\", mass_kg = {:?}, wet_mass_kg = {:?}, speed_m_per_s = 2.0, ramp_s = 1.0, drag_area_m2 = 0.3 }}\n", 0.1 * mass * length, 0.05 * mass * length);
        }
        text += &match foot {
            0 => String::new(),
            1 => format!("ends.b = {{ name = \"b\", kind = \"payload\" }}\npayload = {{ dry_mass_kg = {:?}, wet_mass_kg = {:?}, drag_area_m2 = 1.0, added_mass_kg = 50.0 }}\n", 0.5 * mass * length, 0.2 * mass * length),
            4 => format!(
                "ends.b = {{ name = \"b\", kind = \"payload\" }}\npayload = {{ dry_mass_kg = {:?}, wet_mass_kg = {:?}, drag_area_m2 = [2.0, 2.0, 1.0], \
                 added_mass_kg = [{:?}, {:?}, 10.0], rotation = {{ centre_of_gravity_m = 1.5, inertia_kg_m2 = {:?}, added_inertia_kg_m2 = {:?}, drag_length_m = 2.0, \
                 start_tilt_deg = 60.0, spin_deg_per_s = 200.0, spin_inertia_kg_m2 = {:?} }} }}\n",
                0.5 * mass * length, 0.2 * mass * length, 0.3 * mass * length, 0.3 * mass * length, 0.4 * mass * length, 0.2 * mass * length, 0.3 * mass * length
            ),
            2 => format!("ends.b = {{ name = \"b\", kind = \"anchor\", position_m = [{:?}, 3.0, {:?}] }}\n", 0.6 * length, -depth),
            _ => format!("ends.b = {{ name = \"b\", kind = \"fixed\", position_m = [{:?}, 0.0, {:?}] }}\n", 0.9 * length, 0.1 * length),
        };
        text
    }
}
