//! A mooring as the files of this field state it: line types, rods, bodies, points, lines, each value with its place in the file.

use std::ops::Range;

use super::beside::ReferencedFile;

/// The programs whose files are read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Program {
    /// MoorDyn of its second version, in C++ or Fortran; files of MoorPy have the same form.
    MoorDyn,
    /// MoorDyn of its first version.
    MoorDyn1,
    /// MAP++.
    MapPlusPlus,
    /// The `mooring` table of a RAFT design.
    Raft,
    /// The mooring of a turbine in the IEA ontology.
    Ontology,
    /// An array of `FAModel`.
    FaModel,
    /// `CableDyn`, whose files have the tables of MoorDyn and one of the sections of lines.
    CableDyn,
}

impl Program {
    /// Its name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::MoorDyn => "MoorDyn",
            Self::MoorDyn1 => "MoorDyn 1",
            Self::MapPlusPlus => "MAP++",
            Self::Raft => "RAFT",
            Self::Ontology => "the IEA ontology",
            Self::FaModel => "FAModel",
            Self::CableDyn => "CableDyn",
        }
    }
}

/// A value and the bytes that state it.
#[derive(Debug, Clone, PartialEq)]
pub struct Given<T> {
    /// The value.
    pub value: T,
    /// Where it stands.
    pub span: Range<usize>,
}

impl<T> Given<T> {
    /// A value at a place.
    #[must_use]
    pub fn new(value: T, span: Range<usize>) -> Self {
        Self { value, span }
    }
}

/// All that a file states.
#[derive(Debug, Clone, PartialEq)]
pub struct Mooring {
    /// The program that it is for.
    pub program: Program,
    /// Its title, if it has one.
    pub title: String,
    /// What lines are made of.
    pub line_types: Vec<MooringLineType>,
    /// What rods are made of.
    pub rod_types: Vec<RodType>,
    /// Rigid bodies.
    pub bodies: Vec<MooringBody>,
    /// How many of the bodies, the first ones, are turbines of an array, which points name by their number.
    pub turbines: usize,
    /// Rigid rods.
    pub rods: Vec<Rod>,
    /// Points.
    pub points: Vec<MooringPoint>,
    /// Lines.
    pub lines: Vec<MooringLine>,
    /// Lines that come off points.
    pub failures: Vec<LineFailure>,
    /// Past tensions of ropes whose strain depends on them.
    pub past_tensions: Vec<PastTension>,
    /// Angles \[deg\] by which the whole is repeated about the vertical axis, besides 0.
    pub repeats: Vec<Given<f64>>,
    /// Water, gravity, bed.
    pub sea: MooringSea,
    /// How the program would compute it.
    pub settings: Vec<ProgramSetting>,
    /// What is stated and not modelled here.
    pub unmodelled: Vec<Unmodelled>,
    /// Options, flags and columns that are read and have no effect here, by their names in the file.
    pub passed_over: Vec<String>,
    /// Options that are not known.
    pub not_known: Vec<String>,
    /// What was put down though the file does not say it, and what it says against itself.
    pub remarks: Vec<String>,
    /// A file beside this one that it has its lines from.
    pub beside: Option<ReferencedFile>,
}

impl Mooring {
    /// An empty mooring of a program.
    #[must_use]
    pub fn new(program: Program) -> Self {
        Self {
            program,
            title: String::new(),
            line_types: Vec::new(),
            rod_types: Vec::new(),
            bodies: Vec::new(),
            turbines: 0,
            rods: Vec::new(),
            points: Vec::new(),
            lines: Vec::new(),
            failures: Vec::new(),
            past_tensions: Vec::new(),
            repeats: Vec::new(),
            sea: MooringSea::default(),
            settings: Vec::new(),
            unmodelled: Vec::new(),
            passed_over: Vec::new(),
            not_known: Vec::new(),
            remarks: Vec::new(),
            beside: None,
        }
    }

    /// A setting by its name.
    #[must_use]
    pub fn setting(&self, name: &str) -> Option<&ProgramSetting> {
        self.settings.iter().find(|setting| setting.name == name)
    }
}

/// A line type. Masses per length in kg/m, stiffness in N, EI in N m².
#[derive(Debug, Clone, PartialEq)]
pub struct MooringLineType {
    /// Its name.
    pub name: String,
    /// Its row.
    pub span: Range<usize>,
    /// Diameter \[m\].
    pub diameter: Given<f64>,
    /// Mass in air per length \[kg/m\], or weight in water as mass where the file gives that.
    pub mass: Given<Mass>,
    /// Tension by strain.
    pub stiffness: Given<Stiffness>,
    /// Tension by strain rate.
    pub damping: Given<Damping>,
    /// Bending stiffness \[N m²\].
    pub bending: Given<f64>,
    /// Drag across, on the diameter.
    pub drag_normal: Given<f64>,
    /// Drag along, on the perimeter.
    pub drag_tangential: Given<f64>,
    /// Added mass across, on the displaced volume.
    pub added_mass_normal: Given<f64>,
    /// Added mass along, on the displaced volume.
    pub added_mass_tangential: Given<f64>,
    /// Friction on the bed that goes with the type, as in MAP++.
    pub friction: Option<Given<f64>>,
    /// Breaking load \[N\].
    pub break_load: Option<Given<f64>>,
}

/// How the mass of a line is given.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Mass {
    /// In air \[kg/m\].
    InAir(f64),
    /// Weight in water as mass, and the mass in air if it is known \[kg/m\].
    InWater(f64, Option<f64>),
}

/// Tension by strain.
#[derive(Debug, Clone, PartialEq)]
pub enum Stiffness {
    /// EA \[N\].
    Constant(f64),
    /// Strain and tension \[N\], rising from zero.
    Table(Vec<[f64; 2]>),
    /// Two springs in series, each with a damper beside it.
    Viscoelastic {
        /// EA of slow motion \[N\].
        slow: f64,
        /// EA of fast motion \[N\] at no tension.
        fast: f64,
        /// Its growth by the mean tension, N/N.
        per_tension: f64,
    },
    /// The Syrope model of polyester rope.
    Syrope(Syrope),
}

/// The Syrope model of polyester rope.
#[derive(Debug, Clone, PartialEq)]
pub struct Syrope {
    /// Strain and tension \[N\] of the first loading.
    pub first_loading: Vec<[f64; 2]>,
    /// The curve below the greatest tension.
    pub working_curve: PolyesterCurve,
    /// EA of fast motion \[N\] at no tension.
    pub fast: f64,
    /// Its growth by the mean tension, N/N.
    pub per_tension: f64,
}

/// The curve of a polyester rope below the greatest tension it has had.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PolyesterCurve {
    /// Its form.
    pub form: WorkingForm,
    /// Its first parameter.
    pub k1: f64,
    /// Its second parameter.
    pub k2: f64,
}

/// Forms of the working curve.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum WorkingForm {
    /// A straight line.
    Linear,
    /// A parabola.
    Quadratic,
    /// An exponential.
    Exponential,
}

/// Tension by strain rate.
#[derive(Debug, Clone, PartialEq)]
pub enum Damping {
    /// \[N s\].
    Coefficient(f64),
    /// Share of the critical damping of a segment.
    Ratio(f64),
    /// Dampers of the slow and the fast part of a viscoelastic rope \[N s\].
    Two(f64, f64),
}

/// A rod type.
#[derive(Debug, Clone, PartialEq)]
pub struct RodType {
    /// Its name.
    pub name: String,
    /// Its row.
    pub span: Range<usize>,
    /// Diameter \[m\].
    pub diameter: Given<f64>,
    /// Mass in air per length \[kg/m\].
    pub mass: Given<f64>,
    /// Drag across, on the diameter.
    pub drag_normal: Given<f64>,
    /// Added mass across, on the displaced volume.
    pub added_mass_normal: Given<f64>,
    /// Drag of an end.
    pub drag_end: Given<f64>,
    /// Added mass of an end.
    pub added_mass_end: Given<f64>,
}

/// What holds a point, a rod or a body.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Hold {
    /// Nothing.
    Free,
    /// The earth.
    Fixed,
    /// The program that this one is coupled to.
    Coupled,
    /// A body, by its place in the list.
    Body(usize),
    /// As another of these, but free to turn.
    Pinned(Box<Hold>),
}

impl Hold {
    /// Whether it is the program that this one is coupled to, of a pin too.
    #[must_use]
    pub fn is_coupled(&self) -> bool {
        *self.base() == Self::Coupled
    }

    /// What a pin is on, of other holds themselves.
    #[must_use]
    pub fn base(&self) -> &Self {
        match self {
            Self::Pinned(of) => of.base(),
            of => of,
        }
    }

    /// Whether a body that is held so has unknowns of its own.
    #[must_use]
    pub fn turns(&self) -> bool {
        matches!(self, Self::Free | Self::Pinned(_))
    }
}

/// A rigid body.
#[derive(Debug, Clone, PartialEq)]
pub struct MooringBody {
    /// Its identifier in the file.
    pub id: String,
    /// Its row.
    pub span: Range<usize>,
    /// What holds it.
    pub hold: Given<Hold>,
    /// Place of its origin \[m\].
    pub place: [Given<f64>; 3],
    /// Roll, pitch, yaw \[deg\].
    pub angles: [Given<f64>; 3],
    /// Mass in air \[kg\].
    pub mass: Given<f64>,
    /// Centre of gravity in its frame \[m\].
    pub centre: Given<[f64; 3]>,
    /// Moments of inertia about the centre of gravity \[kg m²\].
    pub inertia: Given<[f64; 3]>,
    /// Displaced volume \[m³\].
    pub volume: Given<f64>,
    /// Drag coefficient times area along and about its axes: m² and m⁵.
    pub drag_area: Given<[f64; 6]>,
    /// Added mass coefficients along its axes, on the volume.
    pub added_mass: Given<[f64; 3]>,
    /// Water-plane stiffness in heave, roll and pitch \[N/m, N m, N m\]; zero where the file gives none.
    pub waterplane: Given<[f64; 3]>,
    /// Loads at its origin besides.
    pub loads: Vec<BodyLoad>,
}

impl MooringBody {
    /// Whether damping along the axes of a load is damping along the axes of the body: these are meant, or the same, or it is that of all.
    #[must_use]
    pub fn damps_along_own_axes(&self, load: &BodyLoad) -> bool {
        let [x, y, z] = load.linear.value;
        let is_even = x == y && y == z && load.quadratic.value == [0.0; 3];
        let is_level = self.angles.iter().all(|angle| angle.value == 0.0);
        load.is_local || is_even || is_level
    }
}

/// A steady load at the origin of a body, and damping of its velocity there.
#[derive(Debug, Clone, PartialEq)]
pub struct BodyLoad {
    /// Its row.
    pub span: Range<usize>,
    /// Force \[N\].
    pub force: Given<[f64; 3]>,
    /// Damping along the axes \[N s/m\].
    pub linear: Given<[f64; 3]>,
    /// The same by the squares of the velocities, each with its sign \[N s²/m²\].
    pub quadratic: Given<[f64; 3]>,
    /// Whether the axes are those of the body rather than of the earth.
    pub is_local: bool,
}

/// A rigid rod.
#[derive(Debug, Clone, PartialEq)]
pub struct Rod {
    /// Its identifier in the file.
    pub id: String,
    /// Its row.
    pub span: Range<usize>,
    /// Its type, by its place in the list.
    pub of_type: Given<usize>,
    /// What holds it.
    pub hold: Given<Hold>,
    /// Its ends \[m\].
    pub ends: [[Given<f64>; 3]; 2],
    /// Segments; a rod of none is a joint without length.
    pub segments: Given<usize>,
    /// Steady loads at its end A along the axes of the earth, and damping of it, of which two numbers count: across it and along it.
    pub loads: Vec<BodyLoad>,
}

impl Rod {
    /// Its ends \[m\].
    #[must_use]
    pub fn end(&self, end: usize) -> [f64; 3] {
        std::array::from_fn(|axis| self.ends[end][axis].value)
    }

    /// Its length \[m\].
    #[must_use]
    pub fn length(&self) -> f64 {
        let [a, b] = [self.end(0), self.end(1)];
        (0..3)
            .map(|axis| (b[axis] - a[axis]).powi(2))
            .sum::<f64>()
            .sqrt()
    }

    /// The sum of the steady loads at its end A \[N\].
    #[must_use]
    pub fn load(&self) -> [f64; 3] {
        let sum = |axis: usize| self.loads.iter().map(|load| load.force.value[axis]).sum();
        std::array::from_fn(sum)
    }

    /// Whether it is a joint without length.
    #[must_use]
    pub fn is_joint(&self) -> bool {
        self.segments.value == 0 || self.length() == 0.0
    }
}

/// A point.
#[derive(Debug, Clone, PartialEq)]
pub struct MooringPoint {
    /// Its identifier in the file.
    pub id: String,
    /// Its row.
    pub span: Range<usize>,
    /// What holds it.
    pub hold: Given<Hold>,
    /// Its place \[m\].
    pub place: [Given<f64>; 3],
    /// Mass in air \[kg\].
    pub mass: Given<f64>,
    /// Displaced volume \[m³\].
    pub volume: Given<f64>,
    /// Drag coefficient times area \[m²\].
    pub drag_area: Given<f64>,
    /// Added mass coefficient, on the volume.
    pub added_mass: Given<f64>,
    /// Steady load \[N\].
    pub load: [Given<f64>; 3],
}

/// What an end of a line is attached to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Attachment {
    /// A point, by its place in the list.
    Point(usize),
    /// A rod, and which end of it.
    Rod(usize, usize),
    /// A place inside a line of the file, where two of its sections meet; each has a number of its own.
    Inside(usize),
}

/// A line.
#[derive(Debug, Clone, PartialEq)]
pub struct MooringLine {
    /// Its identifier in the file.
    pub id: String,
    /// Its row.
    pub span: Range<usize>,
    /// Its type, by its place in the list.
    pub of_type: Given<usize>,
    /// What its ends are attached to.
    pub ends: [Given<Attachment>; 2],
    /// Unstretched length \[m\].
    pub length: Given<f64>,
    /// Segments; 0 where the file has none.
    pub segments: Given<usize>,
    /// Where the file says that the bed does not bear the line.
    pub without_bed: Option<Range<usize>>,
}

/// Lines that come off a point.
#[derive(Debug, Clone, PartialEq)]
pub struct LineFailure {
    /// Its row.
    pub span: Range<usize>,
    /// What they come off.
    pub from: Given<Attachment>,
    /// The lines, by their places in the list.
    pub lines: Vec<usize>,
    /// Time \[s\]; none where it is 0.
    pub time: Option<Given<f64>>,
    /// Tension \[N\]; none where it is 0.
    pub tension: Option<Given<f64>>,
}

/// The past of a rope.
#[derive(Debug, Clone, PartialEq)]
pub struct PastTension {
    /// Its row.
    pub span: Range<usize>,
    /// The lines, by their places in the list.
    pub lines: Vec<usize>,
    /// Greatest mean tension so far \[N\].
    pub greatest: Given<f64>,
    /// Mean tension at the start \[N\].
    pub mean: Given<f64>,
}

/// Water, gravity, bed, as far as they are given.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct MooringSea {
    /// \[m/s²\].
    pub gravity: Option<Given<f64>>,
    /// \[kg/m³\].
    pub density: Option<Given<f64>>,
    /// \[m\].
    pub depth: Option<Given<f64>>,
    /// A file of depths over a grid.
    pub depth_file: Option<Given<String>>,
    /// Its text.
    pub depth_text: Option<String>,
    /// Push of the bed by area and depth below it \[Pa/m\].
    pub bed_stiffness: Option<Given<f64>>,
    /// Push of the bed by area and speed into it \[Pa s/m\].
    pub bed_damping: Option<Given<f64>>,
    /// Friction of the bed, in every direction unless one of the two below is given.
    pub friction: Option<Given<f64>>,
    /// Friction along lines; that of `friction` is then across them.
    pub friction_along: Option<Given<f64>>,
    /// Friction across lines; that of `friction` is then along them.
    pub friction_across: Option<Given<f64>>,
    /// Current by height.
    pub current: Option<Given<MooringCurrent>>,
    /// First row of that profile in a file that does not list it from below.
    pub current_first: Option<[f64; 3]>,
    /// Current by a file of times and places.
    pub current_file: Option<Given<CurrentFile>>,
    /// Waves by a history of their elevation.
    pub elevation: Option<Given<Elevation>>,
    /// Components of the waves.
    pub waves: Option<Given<Vec<WaveComponent>>>,
}

/// A steady current by height.
#[derive(Debug, Clone, PartialEq)]
pub struct MooringCurrent {
    /// The file that it is from; empty where it is in the file itself.
    pub file: String,
    /// Rows z, x, y \[m, m/s, m/s\] from the surface down.
    pub rows: Vec<[f64; 3]>,
}

/// A file of the current over time and place, which the case carries.
#[derive(Debug, Clone, PartialEq)]
pub struct CurrentFile {
    /// Its name.
    pub name: &'static str,
    /// Its text.
    pub text: String,
    /// Whether it changes with time.
    pub varies: bool,
}

/// Waves by a history of their elevation.
#[derive(Debug, Clone, PartialEq)]
pub struct Elevation {
    /// Regular waves that run together: angular frequency \[rad/s\], amplitude \[m\], phase \[rad\].
    pub components: Vec<[f64; 3]>,
    /// Mean of the history \[m\], which the components do not have.
    pub mean: f64,
    /// Length of the record, after which it repeats \[s\].
    pub period: f64,
    /// Share of the variance of the samples that the components do not have.
    pub lost: f64,
}

/// A setting of the program.
#[derive(Debug, Clone, PartialEq)]
pub struct ProgramSetting {
    /// Its name here, in small letters: `dtm`, `threshic`.
    pub name: String,
    /// Its name in the file.
    pub written: String,
    /// What it is set to.
    pub value: String,
    /// Where that stands.
    pub span: Range<usize>,
}

impl ProgramSetting {
    /// As a number.
    #[must_use]
    pub fn number(&self) -> Option<f64> {
        super::words::Word {
            text: &self.value,
            start: 0,
        }
        .number()
    }
}

/// A component of waves, whose elevation is the cosine `amplitude cos(frequency t - k x + phase)`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WaveComponent {
    /// \[rad/s\].
    pub frequency: f64,
    /// \[m\].
    pub amplitude: f64,
    /// \[rad\].
    pub phase: f64,
    /// Where it runs, from the x axis \[rad\].
    pub direction: f64,
}

/// What a file states and is not modelled here.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Unmodelled {
    /// By which `--without` leaves it out.
    pub name: &'static str,
    /// Where it stands.
    pub span: Range<usize>,
    /// The column or key meant.
    pub key: String,
    /// What is not modelled.
    pub what: String,
}
