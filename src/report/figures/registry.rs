//! Every figure of a run, listed once: what it is called, when a run has data for it, how it is drawn. The screen,
//! the text report and the files written from both take figures from here. A new figure is a line in [`FigureId`] and
//! one in [`FIGURES`].

use super::contents::{
    CaseContents, bends, driven, irregular_sea, moves, response, rope, spatial, studied,
};
use super::{
    PlottedRun, ResponseMapKind, against_time, along_studies, curvature_profile, histories,
    line_from_above, line_from_ahead, line_shape, moment_profile, payload_position, places,
    published_curves, response_map, rms_profile, stated, stiffness_profile, tension_profile,
    trajectory, wave_amplitudes, wavelengths,
};
use seacable_display::chart::{Chart, extent};
use seacable_model::case::{Case, ChannelQuantity};
use seacable_runs::reference::ValidationRow;
use seacable_runs::run::Run;

/// A figure, in the order of [`FIGURES`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum FigureId {
    /// Tension at the joints against time.
    Tensions,
    /// Tension of the pipe wall against time.
    WallTension,
    /// Payload x and z against time.
    Payload,
    /// Path of the payload, z against x, to equal scale.
    Path,
    /// Speed of the payload against time.
    Speed,
    /// Tilt of a rigid payload against time.
    Tilt,
    /// Force of the bed on bodies and loose ends against time.
    BedForce,
    /// Length of lines on the bed against time.
    OnBed,
    /// Length of line that slides over it.
    Sliding,
    /// Height of the waves against time.
    Elevation,
    /// The line at an instant, z against x, to equal scale.
    Shape,
    /// The line from above, y against x, to equal scale.
    Plan,
    /// The line along the x axis, z against y, to equal scale.
    Front,
    /// Tension along the line, with its envelope.
    Profile,
    /// Curvature along the line.
    Curvature,
    /// Bending moment along the line.
    Moment,
    /// Displacement of the line over time and place.
    Map,
    /// Root mean square displacement along the line.
    Rms,
    /// Amplitudes of the waves at the driving period.
    Amplitudes,
    /// Their lengths.
    Wavelengths,
    /// Published and computed numbers along the studies.
    Study,
    /// Dynamic stiffness of fibre ropes against time.
    Stiffness,
    /// Dynamic stiffness of fibre ropes along the line.
    StiffnessAlong,
    /// Mean load of fibre ropes against time.
    MeanLoad,
    /// Deviation from the mean load of fibre ropes against time.
    Deviation,
    /// First coordinate of points and bodies of a system against time.
    X,
    /// Second coordinate, likewise.
    Y,
    /// Height, likewise.
    Z,
    /// Roll of the bodies of a system against time.
    Roll,
    /// Pitch, likewise.
    Pitch,
    /// Yaw, likewise.
    Yaw,
    /// Unstretched length of lines that are paid out against time.
    Length,
}

/// What a figure is drawn over.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FigureAxis {
    /// Time: its cursor is an instant.
    Time,
    /// Space, at an instant.
    Space,
    /// Anything else, such as the length of the line.
    Other,
}

/// The curves of one run on a figure, any one of which can be shown alone.
#[derive(Debug, Clone, Copy)]
enum CurveNames {
    /// There is no choice.
    None,
    /// One for each place where a quantity was recorded.
    Places(ChannelQuantity),
    /// These.
    Fixed(&'static [&'static str]),
    /// These, but for a line at rest, which has one.
    Envelope(&'static [&'static str]),
    /// Figures of their own: the names of the others, beside the one drawn at first.
    Variants(fn(&FigureData) -> Vec<String>),
}

/// What figures are drawn from.
#[derive(Debug, Clone, Copy)]
pub struct FigureData<'a> {
    /// The case; absent for systems of lines.
    pub case: Option<&'a Case>,
    /// Runs of it, older results first.
    pub runs: &'a [PlottedRun<'a>],
    /// Its validation table.
    pub checks: &'a [ValidationRow],
    /// The instant \[s\] of figures in space; absent: the newest.
    pub instant: Option<f64>,
    /// Number of the curve or variant that is chosen.
    pub chosen: Option<usize>,
    /// Whether limits and published values are drawn.
    pub limits: bool,
}

impl<'a> FigureData<'a> {
    /// Of runs of a system of lines.
    #[must_use]
    pub const fn of_system(runs: &'a [PlottedRun<'a>]) -> Self {
        Self {
            case: None,
            runs,
            checks: &[],
            instant: None,
            chosen: None,
            limits: true,
        }
    }

    fn instant(&self) -> f64 {
        let ends = histories(self.runs).filter_map(|history| history.time.last().copied());
        let newest = ends.reduce(f64::max);
        self.instant.or(newest).unwrap_or(0.0)
    }
}

/// When a run of a system has a figure.
#[derive(Debug, Clone, Copy, PartialEq)]
enum InSystems {
    /// Only line cases have it.
    Never,
    /// Where it records a quantity.
    Recording(ChannelQuantity),
    /// Where it has lines.
    WithLines,
    /// Where lines bend.
    WithBending,
    /// Where it records the response of its lines.
    WithResponse,
    /// Where that response has a period.
    Driven,
}

/// What decides which figures runs of a system have.
#[derive(Debug, Clone, PartialEq)]
pub struct SystemContents {
    /// Whether it is of a run in time, and not of its rest.
    pub dynamic: bool,
    /// The quantities of its channels.
    pub recorded: Vec<ChannelQuantity>,
    /// Whether its lines bend.
    pub bends: bool,
    /// Whether the response of its lines is recorded.
    pub responds: bool,
    /// Whether that response has a period.
    pub driven: bool,
}

/// A figure.
#[derive(Debug, Clone, Copy)]
pub struct Figure {
    /// Its name.
    pub id: FigureId,
    /// Its title on a tab and in file names.
    pub title: &'static str,
    /// What it is drawn over.
    pub axis: FigureAxis,
    curves: CurveNames,
    /// Whether a run of a case has data for it.
    available: fn(&CaseContents) -> bool,
    /// When a run of a system has it.
    in_systems: InSystems,
    draw: fn(&FigureData) -> Chart,
    /// Position in the text report; absent: not in it.
    report: Option<u8>,
}

const ENVELOPE: CurveNames = CurveNames::Envelope(&["at the end", "smallest", "greatest"]);
const END_AND_GREATEST: CurveNames = CurveNames::Envelope(&["at the end", "greatest"]);

/// A figure that every case has, not in the report.
const fn figure(
    id: FigureId,
    title: &'static str,
    axis: FigureAxis,
    draw: fn(&FigureData) -> Chart,
) -> Figure {
    Figure {
        id,
        title,
        axis,
        curves: CurveNames::None,
        available: |_| true,
        in_systems: InSystems::Never,
        draw,
        report: None,
    }
}

impl Figure {
    /// The same, of cases that have data for it.
    const fn when(self, available: fn(&CaseContents) -> bool) -> Self {
        Self { available, ..self }
    }

    /// The same, with curves that can be shown alone.
    const fn curves(self, curves: CurveNames) -> Self {
        Self { curves, ..self }
    }

    /// The same, one curve for each place where a quantity was recorded.
    const fn at_places(self, quantity: ChannelQuantity) -> Self {
        self.curves(CurveNames::Places(quantity))
    }

    /// The same, also of systems of lines that record a quantity.
    const fn also_in_systems(self, quantity: ChannelQuantity) -> Self {
        Self {
            in_systems: InSystems::Recording(quantity),
            ..self
        }
    }

    /// The same, also along the lines of systems.
    const fn also_along_lines(self, of: InSystems) -> Self {
        Self {
            in_systems: of,
            ..self
        }
    }

    /// The same, of systems of lines that record a quantity, at the places where they do.
    const fn only_in_systems(self, quantity: ChannelQuantity) -> Self {
        let figure = self.when(|_| false).at_places(quantity);
        figure.also_in_systems(quantity)
    }

    /// The same, at a position of the text report.
    const fn in_report(self, position: u8) -> Self {
        Self {
            report: Some(position),
            ..self
        }
    }
}

use ChannelQuantity as Quantity;
use FigureAxis::{Other, Space, Time};
use FigureId as Id;

/// The figures, in the order in which the screen shows them.
#[rustfmt::skip] // a table: one figure an entry
pub const FIGURES: [Figure; 32] = [
    figure(Id::Tensions, "Tensions", Time, tensions)
        .when(|c| c.dynamic).at_places(Quantity::Tension).also_in_systems(Quantity::Tension).in_report(1),
    figure(Id::WallTension, "Pipe wall", Time, |d| against_time(d.runs, Quantity::WallTension))
        .when(|c| c.records(Quantity::WallTension)).at_places(Quantity::WallTension).also_in_systems(Quantity::WallTension).in_report(2),
    figure(Id::Payload, "Payload", Time, |d| payload_position(d.runs))
        .when(moves).curves(CurveNames::Fixed(&["x", "z"])).in_report(3),
    figure(Id::Path, "Path", Space, |d| trajectory(d.runs, d.instant))
        .when(moves).in_report(8),
    figure(Id::Speed, "Speed", Time, |d| against_time(d.runs, Quantity::Speed))
        .when(|c| c.records(Quantity::Speed)).at_places(Quantity::Speed).also_in_systems(Quantity::Speed).in_report(4),
    figure(Id::Tilt, "Tilt", Time, |d| against_time(d.runs, Quantity::Tilt))
        .when(|c| c.records(Quantity::Tilt)).at_places(Quantity::Tilt).in_report(5),
    figure(Id::BedForce, "Bed force", Time, |d| against_time(d.runs, Quantity::BedForce))
        .when(|c| c.records(Quantity::BedForce)).at_places(Quantity::BedForce).also_in_systems(Quantity::BedForce).in_report(6),
    figure(Id::OnBed, "On the bed", Time, |d| against_time(d.runs, Quantity::OnBed))
        .when(|c| c.records(Quantity::OnBed)).at_places(Quantity::OnBed).also_in_systems(Quantity::OnBed),
    figure(Id::Sliding, "Sliding on the bed", Time, |d| against_time(d.runs, Quantity::Sliding))
        .when(|c| c.records(Quantity::Sliding)).at_places(Quantity::Sliding).also_in_systems(Quantity::Sliding),
    figure(Id::Elevation, "Sea", Time, |d| against_time(d.runs, Quantity::WaveElevation))
        .when(irregular_sea).also_in_systems(Quantity::WaveElevation).in_report(7),
    figure(Id::Shape, "Shape", Space, |d| line_shape(d.runs, d.instant()))
        .also_along_lines(InSystems::WithLines).in_report(12),
    figure(Id::Plan, "Plan", Space, |d| line_from_above(d.runs, d.instant()))
        .when(spatial).also_along_lines(InSystems::WithLines).in_report(13),
    figure(Id::Front, "Front", Space, |d| line_from_ahead(d.runs, d.instant()))
        .when(spatial).also_along_lines(InSystems::WithLines).in_report(14),
    figure(Id::Profile, "Profile", Other, |d| tension_profile(d.runs))
        .curves(ENVELOPE).also_along_lines(InSystems::WithLines).in_report(15),
    figure(Id::Curvature, "Curvature", Other, |d| curvature_profile(d.runs))
        .when(bends).curves(END_AND_GREATEST).also_along_lines(InSystems::WithBending).in_report(16),
    figure(Id::Moment, "Moment", Other, |d| moment_profile(d.runs))
        .when(bends).curves(END_AND_GREATEST).also_along_lines(InSystems::WithBending).in_report(17),
    figure(Id::Map, "Map", Time, map)
        .when(response).curves(CurveNames::Variants(map_names)).in_report(22),
    figure(Id::Rms, "Rms", Other, |d| rms_profile(d.runs))
        .when(response).also_along_lines(InSystems::WithResponse).in_report(19),
    figure(Id::Amplitudes, "Waves", Other, |d| wave_amplitudes(d.runs)).when(driven)
        .curves(CurveNames::Fixed(&["motion", "towards A", "towards B", "WKB, no drag"])).also_along_lines(InSystems::Driven).in_report(20),
    figure(Id::Wavelengths, "Wavelength", Other, |d| wavelengths(d.runs))
        .when(driven).curves(CurveNames::Fixed(&["computed", "WKB"])).also_along_lines(InSystems::Driven).in_report(21),
    figure(Id::Study, "Study", Other, study)
        .when(studied).curves(CurveNames::Variants(study_names)),
    figure(Id::Stiffness, "Stiffness", Time, |d| against_time(d.runs, Quantity::Stiffness))
        .when(|c| c.records(Quantity::Stiffness)).at_places(Quantity::Stiffness).also_in_systems(Quantity::Stiffness).in_report(11),
    figure(Id::StiffnessAlong, "Along rope", Other, |d| stiffness_profile(d.runs))
        .when(rope).curves(ENVELOPE).in_report(18),
    figure(Id::MeanLoad, "Mean load", Time, |d| against_time(d.runs, Quantity::MeanLoad))
        .when(|c| c.records(Quantity::Stiffness)).at_places(Quantity::MeanLoad).also_in_systems(Quantity::MeanLoad).in_report(9),
    figure(Id::Deviation, "Deviation", Time, |d| against_time(d.runs, Quantity::LoadDeviation))
        .when(|c| c.records(Quantity::Stiffness)).at_places(Quantity::LoadDeviation).also_in_systems(Quantity::LoadDeviation).in_report(10),
    figure(Id::X, "x", Time, |d| against_time(d.runs, Quantity::X)).only_in_systems(Quantity::X),
    figure(Id::Y, "y", Time, |d| against_time(d.runs, Quantity::Y)).only_in_systems(Quantity::Y),
    figure(Id::Z, "z", Time, |d| against_time(d.runs, Quantity::Z)).only_in_systems(Quantity::Z),
    figure(Id::Roll, "Roll", Time, |d| against_time(d.runs, Quantity::Roll)).only_in_systems(Quantity::Roll),
    figure(Id::Pitch, "Pitch", Time, |d| against_time(d.runs, Quantity::Pitch)).only_in_systems(Quantity::Pitch),
    figure(Id::Yaw, "Yaw", Time, |d| against_time(d.runs, Quantity::Yaw)).only_in_systems(Quantity::Yaw),
    figure(Id::Length, "Paid out", Time, |d| against_time(d.runs, Quantity::Length)).only_in_systems(Quantity::Length),
];

impl FigureId {
    /// The figure of this name.
    #[must_use]
    pub fn figure(self) -> Figure {
        FIGURES[self.index()]
    }

    /// Its position in [`FIGURES`].
    #[must_use]
    pub fn index(self) -> usize {
        self as usize
    }

    /// The figures that a run of this case has data for.
    #[must_use]
    pub fn of_case(case: &Case) -> Vec<Self> {
        let contents = CaseContents::new(case);
        let available = FIGURES
            .iter()
            .filter(|figure| (figure.available)(&contents));
        available.map(|figure| figure.id).collect()
    }

    /// The figures of runs of a system.
    #[must_use]
    pub fn of_system(contents: &SystemContents) -> Vec<Self> {
        let recorded = &contents.recorded;
        let has_lines = recorded.contains(&ChannelQuantity::Tension);
        let records = |figure: &&Figure| match figure.in_systems {
            InSystems::Never => false,
            InSystems::Recording(quantity) => contents.dynamic && recorded.contains(&quantity),
            InSystems::WithLines => has_lines,
            InSystems::WithBending => contents.bends,
            InSystems::WithResponse => contents.responds,
            InSystems::Driven => contents.driven,
        };
        let available = FIGURES.iter().filter(records);
        available.map(|figure| figure.id).collect()
    }

    /// The next or previous one of a list, around its end; the first where it is not among them.
    #[must_use]
    pub fn beside(self, list: &[Self], forward: bool) -> Self {
        let Some(at) = list.iter().position(|id| *id == self) else {
            return list.first().copied().unwrap_or(self);
        };
        let step = if forward { 1 } else { list.len() - 1 };
        list[(at + step) % list.len()]
    }
}

impl Figure {
    /// The figure with all of its curves, and the limits and published values that the case states for them.
    #[must_use]
    pub fn draw(&self, data: &FigureData) -> Chart {
        let mut chart = (self.draw)(data);
        let names = self.curve_names(data);
        let shown = match data
            .chosen
            .and_then(|i| names.get(i.min(names.len().saturating_sub(1))))
        {
            Some(one) => std::slice::from_ref(one),
            None => &names,
        };
        stated::add(&mut chart, self.id, data, shown);
        chart
    }

    /// Whether a choice among its names is another figure, not a curve of this one.
    #[must_use]
    pub fn has_variants(&self) -> bool {
        matches!(self.curves, CurveNames::Variants(_))
    }

    /// Names of the curves of one run, or of the variants.
    #[must_use]
    pub fn curve_names(&self, data: &FigureData) -> Vec<String> {
        let owned = |names: &[&str]| names.iter().map(|name| (*name).to_owned()).collect();
        match self.curves {
            CurveNames::None => Vec::new(),
            CurveNames::Places(quantity) => owned(&places(histories(data.runs), quantity)),
            CurveNames::Fixed(names) => owned(names),
            CurveNames::Envelope(_) if data.runs.iter().all(PlottedRun::at_rest) => Vec::new(),
            CurveNames::Envelope(names) => owned(names),
            CurveNames::Variants(names) => names(data),
        }
    }
}

fn tensions(data: &FigureData) -> Chart {
    let chart = against_time(data.runs, Quantity::Tension);
    match data.case {
        Some(_) => chart,
        None => Chart {
            title: "Tension at the ends of the lines".to_owned(),
            ..chart
        },
    }
}

fn map(data: &FigureData) -> Chart {
    let kind = data.chosen.and_then(|i| ResponseMapKind::ALL.get(i + 1));
    let kind = kind.copied().unwrap_or(ResponseMapKind::Steady);
    let from = data.case.and_then(|case| case.output.response_from_s);
    response_map(data.runs, from, kind)
}

fn map_names(_: &FigureData) -> Vec<String> {
    let others = ResponseMapKind::ALL[1..].iter();
    others.map(|kind| kind.name().to_owned()).collect()
}

/// What the case states: along its studies, then its published curves.
fn stated(data: &FigureData) -> Vec<Chart> {
    let of_case = |case| along_studies(case, data.checks);
    let mut charts = data.case.map(of_case).unwrap_or_default();
    charts.extend(published_curves(data.checks));
    charts
}

fn study(data: &FigureData) -> Chart {
    let mut charts = stated(data);
    if charts.is_empty() {
        return Chart {
            title: "Along the studies".to_owned(),
            ..Chart::default()
        };
    }
    let chosen = data.chosen.unwrap_or(0).min(charts.len() - 1);
    charts.swap_remove(chosen)
}

fn study_names(data: &FigureData) -> Vec<String> {
    let charts = stated(data).into_iter();
    charts.map(|chart| chart.title).collect()
}

/// The figures of the text report of a run: all that show something, then the published curves with the run.
#[must_use]
pub fn report_figures(run: &Run, case: &Case, checks: &[ValidationRow]) -> Vec<Chart> {
    let runs = [PlottedRun::whole(run, "")];
    let data = FigureData {
        case: Some(case),
        runs: &runs,
        checks,
        instant: None,
        chosen: None,
        limits: true,
    };
    let mut figures: Vec<&Figure> = FIGURES.iter().filter(|f| f.report.is_some()).collect();
    figures.sort_by_key(|figure| figure.report);
    let mut charts = Vec::new();
    for figure in figures {
        match figure.id {
            FigureId::Shape if run.shapes.is_empty() => {}
            FigureId::Plan | FigureId::Front if !out_of_plane(run) => {}
            FigureId::Map if case.output.response_from_s.is_none() => {}
            FigureId::Map => charts.extend(
                [None, Some(0), Some(1)].map(|chosen| figure.draw(&FigureData { chosen, ..data })),
            ),
            _ => charts.push(figure.draw(&data)),
        }
    }
    let published = published_curves(checks).into_iter();
    charts.extend(published.filter(|chart| chart.series.len() > 1));
    charts.retain(shows_something);
    charts
}

/// Whether the line leaves the plane y = const by more than it is worth to look at.
fn out_of_plane(run: &Run) -> bool {
    let nodes = || run.shapes.iter().flat_map(|shape| &shape.nodes);
    let span = |axis: usize| {
        let reach = extent(nodes().map(|p| p[axis]));
        reach.map_or(0.0, |(low, high)| high - low)
    };
    span(1) > 1e-3 * (span(0) + span(2))
}

fn shows_something(chart: &Chart) -> bool {
    if chart.map.is_some() {
        return true;
    }
    let finite = |(x, y): &&(f64, f64)| x.is_finite() && y.is_finite();
    let mut series = chart.series.iter();
    series.any(|series| series.points.iter().filter(finite).count() > 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn figures_are_in_the_order_of_their_names_and_reported_at_most_once() {
        for (i, figure) in FIGURES.iter().enumerate() {
            assert_eq!(figure.id.index(), i, "{}", figure.title);
        }
        let mut positions: Vec<u8> = FIGURES.iter().filter_map(|f| f.report).collect();
        let count = positions.len();
        positions.sort_unstable();
        positions.dedup();
        assert_eq!(positions.len(), count);
    }
}
