//! A second opinion on a file of another program: its system computed to a known error, and what that program would get wrong with it.
//!
//! The file is read as `run` reads it and solved at rest. Files of `MoorDyn` are then divided into lumped masses as that program divides them
//! ([`lumped`]), brought to rest as it does, and held against the equilibrium.

pub mod contradictions;
pub mod exact;
pub mod finding;
pub mod lumped;
pub mod mesh;
pub mod settings;
pub mod start;
pub mod step;
pub mod wave_pressure;

use self::exact::ExactLine;
use self::finding::{AuditFinding, Topic};
use self::lumped::LumpedModel;
use self::mesh::LineAudit;
use self::start::StartAudit;
use self::step::StepAudit;
use crate::case::{Diagnostic, kind};
use crate::import::mooring::{Mooring, Program};
use crate::import::to_case::sea::{SeaOfCase, sea_of};
use crate::import::{self, ImportOptions};
use crate::numerics::V3;
use crate::system::{SolvedSystem, SystemFile};

/// Most segments of a file that are repeated as lumped masses.
const MOST_SEGMENTS: f64 = 12_000.0;

/// What an audit of a file says.
#[derive(Debug, Clone)]
pub struct Audit {
    /// The file.
    pub file: String,
    /// Its text.
    pub text: String,
    /// The program that it is for.
    pub program: Program,
    /// What was left out, as asked for.
    pub left_out: Vec<String>,
    /// The lines at rest, with what their segments and the program's convention cost.
    pub lines: Vec<LineAudit>,
    /// Where the program's ways to rest stop.
    pub starts: Vec<StartAudit>,
    /// The time step.
    pub step: Option<StepAudit>,
    /// What was not judged, and why.
    pub not_judged: Vec<String>,
    /// What was found, in the order of its topics.
    pub findings: Vec<AuditFinding>,
}

/// Audits a file with this text.
///
/// # Errors
/// All that is wrong with the file or not modelled, each at its row and column.
pub fn audit(text: &str, file: &str, options: &ImportOptions) -> Result<Audit, Vec<Diagnostic>> {
    let imported = import::read(text, file, options)?;
    let to_diagnostics = |faults| import::fault::diagnostics(faults, file, text);
    let mooring = import::mooring(text, file)?;
    let sea = sea_of(&mooring, options).map_err(to_diagnostics)?;
    let mut audit = Audit {
        file: file.to_owned(),
        text: text.to_owned(),
        program: mooring.program,
        left_out: options.without.clone(),
        lines: Vec::new(),
        starts: Vec::new(),
        step: None,
        not_judged: Vec::new(),
        findings: Vec::new(),
    };
    contradictions::find(&mooring, &sea, &mut audit.findings);
    let solved = match kind::parse::<SystemFile>(&imported.text, file) {
        Ok(solved) => Some(solved),
        Err(found) => {
            for one in &found {
                let one = imported.at_its_row(one, file, text);
                audit.findings.push(
                    AuditFinding::new(Topic::Equilibrium, &one.key, &one.problem, &*one.remedy)
                        .at(&one.span),
                );
            }
            None
        }
    };
    if let Some(solved) = &solved {
        contradictions::find_at_rest(&mooring, solved, &mut audit.findings);
    }
    if matches!(mooring.program, Program::MoorDyn | Program::MoorDyn1) {
        settings::find(&mooring, &sea, text, &mut audit.findings);
    }
    divided(&mooring, &sea, solved.as_ref(), &mut audit);
    audit
        .findings
        .sort_by_key(|finding| (finding.topic, finding.span.as_ref().map(|span| span.start)));
    Ok(audit)
}

/// What the division into lumped masses costs, where the file is divided.
fn divided(mooring: &Mooring, sea: &SeaOfCase, solved: Option<&SolvedSystem>, audit: &mut Audit) {
    let exact: Vec<Option<ExactLine<'_>>> = match solved {
        Some(solved) => ExactLine::all(mooring, solved),
        None => Vec::new(),
    };
    let is_divided = matches!(mooring.program, Program::MoorDyn | Program::MoorDyn1);
    if mooring.lines.is_empty() {
        audit
            .not_judged
            .push("Start, time step and segments: there are no lines.".to_owned());
    }
    if !is_divided || mooring.lines.is_empty() {
        audit.lines = mesh::exact_lines(mooring, &exact);
        return;
    }
    let given = &mooring.sea;
    let flows = given.current.is_some() || given.current_file.is_some();
    if flows || given.waves.is_some() || given.elevation.is_some() {
        audit
            .not_judged
            .push("Currents and waves during the relaxation.".to_owned());
    }
    let (model, rest) = match lumped_at_rest(mooring, sea, &exact) {
        Ok(found) => found,
        Err(why) => {
            audit
                .not_judged
                .push(format!("Start, time step and segments: {why}."));
            audit.lines = mesh::exact_lines(mooring, &exact);
            return;
        }
    };
    audit.lines = mesh::lines(mooring, sea, &exact, (&model, &rest), audit);
    start::find(mooring, &model, &rest, audit);
    step::find(mooring, &model, &rest, audit);
}

/// The lumped masses of a mooring, and where they are at rest.
///
/// # Errors
/// Why they are not found, in words.
fn lumped_at_rest(
    mooring: &Mooring,
    sea: &SeaOfCase,
    exact: &[Option<ExactLine<'_>>],
) -> Result<(LumpedModel, Vec<V3>), String> {
    if mooring.sea.depth_file.is_some() {
        return Err("the bed is a grid of depths".to_owned());
    }
    let segments = mooring.lines.iter().map(|line| line.segments.value as f64);
    let segments: f64 = segments.sum();
    if segments > MOST_SEGMENTS {
        return Err(format!(
            "{segments} segments are more than the {MOST_SEGMENTS} that are repeated here"
        ));
    }
    let model = lumped::build::lumped(mooring, sea, 1)?;
    let near = near_rest(&model, exact);
    let rest = lumped::equilibrium::at_rest(&model, &near)
        .map_err(|why| format!("the lumped masses were not brought to rest ({why})"))?;
    Ok((model, rest))
}

/// The nodes of a model where the lines are at rest; of lines without equilibrium where the file has them.
fn near_rest(model: &LumpedModel, exact: &[Option<ExactLine<'_>>]) -> Vec<V3> {
    let mut near = model.start.clone();
    for (line, exact) in model.lines.iter().zip(exact) {
        let Some(exact) = exact else { continue };
        let last = line.nodes.len() - 1;
        for (k, node) in line.nodes.iter().enumerate() {
            if model.free[*node] || model.holds_bodies {
                near[*node] = exact.at(k as f64 / last as f64).0;
            }
        }
    }
    near
}
