//! The two lines, in the words of both programs.

use std::f64::consts::{PI, TAU};

/// Segments of the three sections, from end A.
pub(crate) type Segments = [usize; 3];

const WATER_KG_PER_M3: f64 = 1025.0;

/// What a section is of.
#[derive(Debug, Clone, Copy)]
struct Material {
    name: &'static str,
    diameter_m: f64,
    mass_kg_per_m: f64,
    ea_n: f64,
    /// 2 % of critical of a segment's highest axial mode \[N s\].
    axial_damping_n_s: f64,
    /// Across and along.
    drag: [f64; 2],
    added_mass: f64,
}

/// A body that hangs at end B.
#[derive(Debug, Clone, Copy)]
struct Body {
    place_m: [f64; 3],
    mass_kg: f64,
    volume_m3: f64,
    drag_area_m2: f64,
    added_mass: f64,
}

/// A line of three sections, from a fixed end A.
#[derive(Debug)]
pub(crate) struct Line {
    pub(crate) name: &'static str,
    sections: [(Material, f64); 3],
    /// Segments in MoorDyn.
    pub(crate) segments: Segments,
    /// Segments here.
    pub(crate) meshes: &'static [Segments],
    a_m: [f64; 3],
    /// The body at end B; without one the end is moved along x.
    body: Option<Body>,
    /// Place, amplitude \[m\] and period \[s\] of the moved end.
    moved: ([f64; 3], f64, f64),
    depth_m: f64,
    duration_s: f64,
    pub(crate) interval_s: f64,
    /// Steps of MoorDyn in each interval, the longest that are stable.
    pub(crate) steps_a_row: usize,
}

const CHAIN: Material = Material {
    name: "chain",
    diameter_m: 0.19,
    mass_kg_per_m: 222.8,
    ea_n: 9.4e8,
    axial_damping_n_s: 1.37e5,
    drag: [1.2, 0.05],
    added_mass: 1.0,
};
const POLYESTER: Material = Material {
    name: "polyester",
    diameter_m: 0.163,
    mass_kg_per_m: 28.8,
    ea_n: 4.2e7,
    axial_damping_n_s: 1.3e4,
    drag: [1.2, 0.05],
    added_mass: 1.0,
};
const WIRE: Material = Material {
    name: "wire",
    diameter_m: 0.13,
    mass_kg_per_m: 58.0,
    ea_n: 6.2e8,
    axial_damping_n_s: 8.34e4,
    drag: [1.2, 0.05],
    added_mass: 1.0,
};
const MOORING_CHAIN: Material = Material {
    name: "chain",
    diameter_m: 0.1613,
    mass_kg_per_m: 161.19,
    ea_n: 6.9174e8,
    axial_damping_n_s: 1.67e5,
    drag: [1.34, 0.2],
    added_mass: 1.0,
};
const MOORING_ROPE: Material = Material {
    name: "polyester",
    diameter_m: 0.1766,
    mass_kg_per_m: 33.8,
    ea_n: 1.795_23e8,
    axial_damping_n_s: 3.9e4,
    drag: [2.0, 0.02],
    added_mass: 1.0,
};

/// The lowered manifold of `cases/pendulous/manifold.toml` without floats, in still water and with constant drag coefficients, let go
/// from rest; and the hybrid line of `cases/mooring/hybrid_moving.toml` with its static stiffness, on a bed without friction.
pub(crate) const LINES: &[Line] = &[
    Line {
        name: "lowering",
        sections: [(CHAIN, 30.0), (POLYESTER, 1326.0), (WIRE, 44.0)],
        segments: [2, 52, 2],
        meshes: &[[2, 52, 2], [2, 26, 2], [1, 20, 1]],
        a_m: [0.0, 0.0, 0.0],
        body: Some(Body {
            place_m: [1380.0, 0.0, -50.0],
            mass_kg: 300e3,
            volume_m3: 97.56,
            drag_area_m2: 100.0,
            added_mass: 3.0,
        }),
        moved: ([0.0, 0.0, 0.0], 0.0, 1.0),
        depth_m: 3000.0,
        duration_s: 600.0,
        interval_s: 0.5,
        steps_a_row: 46,
    },
    Line {
        name: "mooring",
        sections: [
            (MOORING_CHAIN, 1525.0),
            (MOORING_ROPE, 2000.0),
            (MOORING_CHAIN, 425.0),
        ],
        segments: [61, 80, 17],
        meshes: &[[61, 80, 17], [31, 40, 9], [10, 13, 3]],
        a_m: [0.0, 0.0, -1500.0],
        body: None,
        moved: ([3569.462, 0.0, -40.0], 5.0, 10.0),
        depth_m: 1500.0,
        duration_s: 200.0,
        interval_s: 0.1,
        steps_a_row: 7,
    },
];

const BED_STIFFNESS_N_PER_M3: f64 = 1.235e5;
const BED_DAMPING_N_S_PER_M3: f64 = 1.235e4;

impl Line {
    /// The table of the moved end here, by its way from where it begins.
    pub(crate) fn table(&self) -> String {
        let [x, ..] = self.moved.0;
        let row = |time: f64| format!("{time},{},0,0\n", self.moved_x(time) - x);
        "time_s,x_m,y_m,z_m\n".to_owned() + &self.times(1).map(row).collect::<String>()
    }

    /// How often MoorDyn is called in an interval of so many steps: at each where it is moved.
    pub(crate) fn calls(&self, steps: usize) -> usize {
        if self.is_let_go() { 1 } else { steps }
    }

    /// A row of MoorDyn's motion for each of so many calls an interval.
    pub(crate) fn motion(&self, calls: usize) -> String {
        let [_, y, z] = self.moved.0;
        let row = |time: f64| match self.body {
            Some(_) => format!("{time}\n"),
            None => format!("{time} {} {y} {z}\n", self.moved_x(time)),
        };
        self.times(calls).map(row).collect()
    }

    fn times(&self, an_interval: usize) -> impl Iterator<Item = f64> {
        let step = self.interval_s / an_interval as f64;
        let steps = (self.duration_s / step).round() as usize;
        (0..=steps).map(move |k| k as f64 * step)
    }

    /// Where the moved end is: a sine that grows over two periods, twice continuously differentiable.
    fn moved_x(&self, time: f64) -> f64 {
        let ([x, ..], amplitude, period) = self.moved;
        let s = (0.5 * time / period).min(1.0);
        let ramp = s * s * s * (10.0 - 15.0 * s + 6.0 * s * s);
        x + amplitude * ramp * (TAU * time / period).sin()
    }

    /// Its file of MoorDyn.
    pub(crate) fn moordyn(
        &self,
        segments: Segments,
        joints: &[[f64; 3]; 2],
        step_s: f64,
    ) -> String {
        let point = |[x, y, z]: [f64; 3]| format!("{x} {y} {z}");
        let types = self.sections.iter().enumerate().map(|(i, (m, _))| {
            format!(
                "{}{i} {} {} {} {} 0 {} {} {} 0\n",
                m.name,
                m.diameter_m,
                m.mass_kg_per_m,
                m.ea_n,
                m.axial_damping_n_s,
                m.drag[0],
                m.added_mass,
                m.drag[1]
            )
        });
        let end = match &self.body {
            Some(body) => format!(
                "Free {} {} {} {} {}",
                point(body.place_m),
                body.mass_kg,
                body.volume_m3,
                body.drag_area_m2,
                body.added_mass
            ),
            None => format!("Coupled {} 0 0 0 0", point(self.moved.0)),
        };
        let lines = self.sections.iter().zip(segments).enumerate();
        let lines = lines.map(|(i, ((m, length), n))| {
            format!(
                "{} {}{i} {} {} {length} {n} -\n",
                i + 1,
                m.name,
                i + 1,
                i + 2
            )
        });
        format!(
            "--- MoorDyn ---\n{}\n--- LINE TYPES ---\nName Diam Mass/m EA BA/-zeta EI Cd Ca CdAx CaAx\n(name) (m) (kg/m) (N) (N-s/-) (N-m^2) (-) (-) (-) (-)\n{}\
             --- POINTS ---\nID Type X Y Z Mass Volume CdA Ca\n(#) (-) (m) (m) (m) (kg) (m^3) (m^2) (-)\n\
             1 Fixed {} 0 0 0 0\n2 Free {} 0 0 0 0\n3 Free {} 0 0 0 0\n4 {end}\n\
             --- LINES ---\nID Type AttachA AttachB UnstrLen NumSegs Outputs\n(#) (name) (#) (#) (m) (-) (-)\n{}\
             --- OPTIONS ---\nRK4 tScheme\n{step_s} dtM\n0 writeLog\n{} WtrDpth\n{WATER_KG_PER_M3} WtrDnsty\n9.80665 g\n{BED_STIFFNESS_N_PER_M3} kBot\n\
             {BED_DAMPING_N_S_PER_M3} cBot\n0 TmaxIC\n1000 dtOut\n--- need this line ---\n",
            self.name,
            types.collect::<String>(),
            point(self.a_m),
            point(joints[0]),
            point(joints[1]),
            lines.collect::<String>(),
            self.depth_m,
        )
    }

    /// Whether it is let go with its body at the start.
    pub(crate) fn is_let_go(&self) -> bool {
        self.body.is_some()
    }

    /// Its case with end B held where it begins.
    pub(crate) fn held(&self, segments: Segments) -> String {
        let place_m = self.body.as_ref().map_or(self.moved.0, |body| body.place_m);
        let held = Self {
            body: None,
            moved: (place_m, 0.0, 1.0),
            sections: self.sections,
            ..*self
        };
        held.case(segments, &[], "")
    }

    /// Its case here. One that is let go begins with its nodes in these places, another at rest.
    pub(crate) fn case(&self, segments: Segments, start: &[[f64; 3]], solver: &str) -> String {
        let materials = self.sections.iter().enumerate().map(|(i, (m, _))| {
            let displaced = 0.25 * PI * m.diameter_m.powi(2) * WATER_KG_PER_M3;
            format!(
                "materials.{}{i} = {{ diameter_m = {:?}, mass_kg_per_m = {:?}, wet_weight_kg_per_m = {:?}, ea_n = {:?}, axial_damping_n_s = {:?}, \
                 drag_normal = {:?}, drag_tangential = {:?}, drag_tangential_width = \"perimeter\", added_mass_normal = {:?} }}\n",
                m.name, m.diameter_m, m.mass_kg_per_m, m.mass_kg_per_m - displaced, m.ea_n, m.axial_damping_n_s, m.drag[0], m.drag[1], m.added_mass
            )
        });
        let sections = self.sections.iter().zip(segments).enumerate();
        let sections = sections.map(|(i, ((m, length), n))| {
            format!("{{ name = \"s{i}\", material = \"{}{i}\", length_m = {length:?}, segments = {n} }}, ", m.name)
        });
        let end = match &self.body {
            Some(body) => {
                let displaced = body.volume_m3 * WATER_KG_PER_M3;
                format!(
                    "ends.b = {{ name = \"b\", kind = \"payload\" }}\npayload = {{ dry_mass_kg = {:?}, wet_mass_kg = {:?}, drag_area_m2 = {:?}, added_mass_kg = {:?} }}\n",
                    body.mass_kg,
                    body.mass_kg - displaced,
                    body.drag_area_m2,
                    body.added_mass * displaced
                )
            }
            None if self.moved.1 == 0.0 => format!(
                "ends.b = {{ name = \"b\", kind = \"fixed\", position_m = {:?} }}\n",
                self.moved.0
            ),
            None => format!(
                "ends.b = {{ name = \"b\", kind = \"moving\", position_m = {:?}, motion = \"table\", motion_file = \"motion.csv\" }}\n",
                self.moved.0
            ),
        };
        let end_a = if self.body.is_some() {
            "fixed"
        } else {
            "anchor"
        };
        format!(
            "case.title = \"{}\"\nenvironment = {{ gravity_m_per_s2 = 9.80665, water_density_kg_per_m3 = {WATER_KG_PER_M3:?}, drag_length = \"unstretched\" }}\n\
             seabed = {{ depth_m = {:?}, stiffness_n_per_m3 = {BED_STIFFNESS_N_PER_M3:?}, damping_n_s_per_m3 = {BED_DAMPING_N_S_PER_M3:?} }}\n{}\
             line = [{}]\nends.a = {{ name = \"a\", kind = \"{end_a}\", position_m = {:?} }}\n{end}{}\
             [solver]\nmethod = \"alpha\"\nduration_s = {:?}\n{solver}\n[output]\ninterval_s = {:?}\nshape_interval_s = 10.0\n",
            self.name,
            self.depth_m,
            materials.collect::<String>(),
            sections.collect::<String>(),
            self.a_m,
            self.start(segments, start),
            self.duration_s,
            self.interval_s,
        )
    }

    /// The shape at the start.
    fn start(&self, segments: Segments, places: &[[f64; 3]]) -> String {
        if !self.is_let_go() {
            return String::new();
        }
        let (mut arc, mut behind) = (vec![0.0], 0.0);
        for ((_, length), n) in self.sections.iter().zip(segments) {
            arc.extend((1..=n).map(|k| behind + length * k as f64 / n as f64));
            behind += length;
        }
        let axis = |axis: usize| places.iter().map(|place| place[axis]).collect::<Vec<f64>>();
        format!(
            "start = {{ shape = \"given\", arc_m = {arc:?}, x_m = {:?}, z_m = {:?} }}\n",
            axis(0),
            axis(2)
        )
    }
}
