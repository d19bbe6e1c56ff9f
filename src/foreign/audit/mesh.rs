//! What the segments of lines cost in tension and curvature, and which tension the program gives.

use super::Audit;
use super::exact::ExactLine;
use super::finding::{AuditFinding, Topic};
use super::lumped::{LumpedModel, build, equilibrium};
use crate::import::mooring::Mooring;
use crate::import::to_case::sea::SeaOfCase;
use crate::number::{percent, si};
use crate::numerics::V3;

/// Error of a tension by the segments that is a finding.
const TENSION: f64 = 0.02;
/// Error of the greatest curvature that is a finding.
const CURVATURE: f64 = 0.1;
/// How much finer the mesh is with which a remedy is tried, and what it must leave of an error.
const TWICE: usize = 2;
const HALVED: f64 = 0.7;
/// The same of curvatures, below that of the mesh by which they are judged.
const TRIED: [usize; 2] = [2, 4];
/// How much finer the mesh is by which curvatures are judged.
const FINER: usize = 8;
/// Nodes of that mesh at most.
const MOST_NODES: usize = 12_000;
/// Least curvature that counts \[1/m\].
const STRAIGHT: f64 = 1e-5;

/// A line at rest.
#[derive(Debug, Clone, PartialEq)]
pub struct LineAudit {
    /// Its identifier in the file.
    pub id: String,
    /// Its segments; 0 where the file has none.
    pub segments: usize,
    /// Tension at its end B \[N\], and its error.
    pub tension: Option<f64>,
    /// See `tension`.
    pub error: Option<f64>,
    /// Tension in the middle of its last segment \[N\], which `MoorDyn` gives as that of end B, before any error of the segments.
    pub mid_segment: Option<f64>,
    /// What the lumped masses have there at rest \[N\].
    pub lumped: Option<f64>,
    /// Greatest curvature of a line that bends \[1/m\]: of the segments, and of a finer mesh.
    pub curvature: Option<[f64; 2]>,
}

impl LineAudit {
    /// Error of the tension by the segments, by the tension.
    #[must_use]
    pub fn by_segments(&self) -> Option<f64> {
        Some(self.lumped? / self.mid_segment? - 1.0)
    }

    /// Error of the greatest curvature by the segments where it is a finding, by that of the finer mesh.
    fn off_in_curvature(&self) -> Option<f64> {
        let [coarse, fine] = self.curvature?;
        let off = coarse / fine - 1.0;
        (fine > STRAIGHT && off.abs() > CURVATURE).then_some(off)
    }
}

/// So many times the segments, and the greatest curvature of each line with them \[1/m\]; nothing where they were not brought to rest.
type TriedMesh = (usize, Option<Vec<Option<f64>>>);

/// The lines alone.
#[must_use]
pub fn exact_lines(mooring: &Mooring, exact: &[Option<ExactLine<'_>>]) -> Vec<LineAudit> {
    let all = mooring.lines.iter().enumerate();
    all.map(|(k, line)| {
        let exact = exact.get(k).and_then(Option::as_ref);
        let segments = line.segments.value;
        LineAudit {
            id: line.id.clone(),
            segments,
            tension: exact.map(|exact| exact.at(1.0).1),
            error: exact.and_then(|exact| exact.error),
            mid_segment: exact
                .filter(|_| segments > 0)
                .map(|exact| exact.at(1.0 - 0.5 / segments as f64).1),
            lumped: None,
            curvature: None,
        }
    })
    .collect()
}

/// The lines with what their segments cost; findings go to the audit.
pub fn lines(
    mooring: &Mooring,
    sea: &SeaOfCase,
    exact: &[Option<ExactLine<'_>>],
    (model, rest): (&LumpedModel, &[V3]),
    audit: &mut Audit,
) -> Vec<LineAudit> {
    let mut lines = exact_lines(mooring, exact);
    for (k, line) in lines.iter_mut().enumerate() {
        line.lumped = Some(model.end_tension(k, rest));
    }
    let curvatures = (!model.bends.is_empty()).then(|| curvatures(mooring, sea, model, rest));
    match curvatures {
        Some(Ok(curvatures)) => {
            for (line, curvature) in lines.iter_mut().zip(curvatures) {
                line.curvature = curvature;
            }
        }
        Some(Err(why)) => audit.not_judged.push(format!("Curvatures: {why}.")),
        None => {}
    }
    let is_coarse = lines
        .iter()
        .any(|line| line.by_segments().is_some_and(is_off));
    let finer = is_coarse.then(|| divided_further(mooring, sea, exact, model, rest));
    let tried: Vec<TriedMesh> = match lines.iter().any(|line| line.off_in_curvature().is_some()) {
        true => TRIED
            .into_iter()
            .filter(|by| *by < judged_by(model))
            .map(|by| (by, curvatures_with(mooring, sea, (model, rest), by).ok()))
            .collect(),
        false => Vec::new(),
    };
    findings(mooring, &lines, (finer.as_deref(), &tried), audit);
    lines
}

/// Whether segments cost so much of a tension that it is a finding.
fn is_off(by_segments: f64) -> bool {
    by_segments.abs() > TENSION
}

/// What is left of the error of each tension where lines have twice their segments; nothing where that is not known.
fn divided_further(
    mooring: &Mooring,
    sea: &SeaOfCase,
    exact: &[Option<ExactLine<'_>>],
    model: &LumpedModel,
    rest: &[V3],
) -> Vec<Option<f64>> {
    let fine = build::lumped(mooring, sea, TWICE).ok();
    let at_rest = fine.and_then(|fine| {
        let near = refined(model, &fine, rest, TWICE);
        let at_rest = equilibrium::at_rest(&fine, &near).ok()?;
        Some((fine, at_rest))
    });
    let lines = mooring.lines.iter().enumerate();
    lines
        .map(|(k, line)| {
            let (fine, at_rest) = at_rest.as_ref()?;
            let exact = exact.get(k)?.as_ref()?;
            let segments = (TWICE * line.segments.value) as f64;
            Some(fine.end_tension(k, at_rest) / exact.at(1.0 - 0.5 / segments).1 - 1.0)
        })
        .collect()
}

/// Segments that are too long. Lines of the same figures share a finding.
fn findings(
    mooring: &Mooring,
    lines: &[LineAudit],
    (finer, tried): (Option<&[Option<f64>]>, &[TriedMesh]),
    audit: &mut Audit,
) {
    let mut found: Vec<(AuditFinding, Vec<&str>)> = Vec::new();
    for (k, (line, of)) in lines.iter().zip(&mooring.lines).enumerate() {
        let finer = finer.and_then(|finer| *finer.get(k)?);
        for finding in [of_tension(line, finer), of_curvature(line, k, tried)]
            .into_iter()
            .flatten()
        {
            match found.iter_mut().find(|(one, _)| one.what == finding.what) {
                Some((_, ids)) => ids.push(&line.id),
                None => found.push((finding.at(&of.segments.span), vec![&line.id])),
            }
        }
    }
    for (mut finding, ids) in found {
        finding.subject = match ids.as_slice() {
            [one] => format!("line {one}"),
            all => format!("lines {}", all.join(", ")),
        };
        audit.findings.push(finding);
    }
}

/// A tension that is off, by what is left of it with twice the segments.
fn of_tension(line: &LineAudit, finer: Option<f64>) -> Option<AuditFinding> {
    let off = line.by_segments()?;
    let (lumped, mid) = (line.lumped?, line.mid_segment?);
    if !is_off(off) {
        return None;
    }
    let what = format!(
        "{} {} at end B where the line has {} ({} off)",
        give(line.segments),
        si(lumped, "N"),
        si(mid, "N"),
        percent(off.abs())
    );
    let twice = TWICE * line.segments;
    let remedy = match finer {
        Some(left) if left.abs() <= HALVED * off.abs() => format!(
            "divide it into {twice} or more segments, with which {} are left",
            percent(left.abs())
        ),
        Some(left) => format!(
            "none by the segments: with {twice} it is still {} off; look for what the two compute otherwise",
            percent(left.abs())
        ),
        None => format!(
            "none that was tried: {twice} segments were not brought to rest; look for what the two compute otherwise"
        ),
    };
    let finding = AuditFinding::new(Topic::Mesh, "", what, remedy);
    Some(finding.figure(lumped, mid, "N"))
}

/// So many segments and their verb.
fn give(segments: usize) -> String {
    match segments {
        1 => "1 segment gives".to_owned(),
        count => format!("{count} segments give"),
    }
}

/// A greatest curvature that is off, by what the meshes that were tried leave of it at this line.
fn of_curvature(line: &LineAudit, number: usize, tried: &[TriedMesh]) -> Option<AuditFinding> {
    let off = line.off_in_curvature()?;
    let [coarse, fine] = line.curvature?;
    let what = format!(
        "{} a greatest curvature of {}, {} {} that of a fine mesh, {}",
        give(line.segments),
        si(coarse, "1/m"),
        percent(off.abs()),
        if off < 0.0 { "below" } else { "above" },
        si(fine, "1/m")
    );
    let left = tried.iter().filter_map(|(by, found)| {
        let found = (*found.as_ref()?.get(number)?)?;
        Some((by * line.segments, (found / fine - 1.0).abs()))
    });
    let left: Vec<(usize, f64)> = left.collect();
    let remedy = match (
        left.iter().find(|(_, left)| *left <= CURVATURE),
        left.last(),
    ) {
        (Some((segments, left)), _) => format!(
            "divide it into {segments} or more segments, with which {} are left",
            percent(*left)
        ),
        (None, Some((segments, left))) => format!(
            "none by the segments that were tried: with {segments} it is still {} off",
            percent(*left)
        ),
        (None, None) => {
            "none that was tried: no mesh between the two was brought to rest".to_owned()
        }
    };
    let finding = AuditFinding::new(Topic::Mesh, "", what, remedy);
    Some(finding.figure(coarse, fine, "1/m"))
}

/// How much finer the mesh is by which curvatures of a model are judged.
fn judged_by(model: &LumpedModel) -> usize {
    let nodes: usize = model.lines.iter().map(|line| line.nodes.len()).sum();
    FINER.min(MOST_NODES / nodes.max(1))
}

/// Greatest curvature inside each line that bends: by its segments, and by a mesh several times finer.
fn curvatures(
    mooring: &Mooring,
    sea: &SeaOfCase,
    model: &LumpedModel,
    rest: &[V3],
) -> Result<Vec<Option<[f64; 2]>>, String> {
    let finer = judged_by(model);
    if finer < 2 {
        return Err("the lines have too many segments for a finer mesh".to_owned());
    }
    let fine = curvatures_with(mooring, sea, (model, rest), finer)?;
    let both = greatest_curvatures(model, rest).into_iter().zip(fine);
    Ok(both
        .map(|(coarse, fine)| Some([coarse.unwrap_or(0.0), fine?]))
        .collect())
}

/// The greatest curvatures of a model with so many times its segments.
fn curvatures_with(
    mooring: &Mooring,
    sea: &SeaOfCase,
    (model, rest): (&LumpedModel, &[V3]),
    finer: usize,
) -> Result<Vec<Option<f64>>, String> {
    let fine = build::lumped(mooring, sea, finer)?;
    let near = refined(model, &fine, rest, finer);
    let at_rest = equilibrium::at_rest(&fine, &near)
        .map_err(|why| format!("the finer mesh was not brought to rest ({why})"))?;
    Ok(greatest_curvatures(&fine, &at_rest))
}

/// The greatest curvature of each line that bends \[1/m\].
fn greatest_curvatures(model: &LumpedModel, x: &[V3]) -> Vec<Option<f64>> {
    let mut all = vec![None; model.lines.len()];
    for bend in &model.bends {
        let greatest: &mut f64 = all[bend.line].get_or_insert(0.0);
        *greatest = greatest.max(LumpedModel::curvature(bend, x));
    }
    all
}

/// The nodes of a finer mesh on the segments of a coarse one.
fn refined(model: &LumpedModel, fine: &LumpedModel, rest: &[V3], finer: usize) -> Vec<V3> {
    let mut near = fine.start.clone();
    for (coarse, line) in model.lines.iter().zip(&fine.lines) {
        for (k, node) in line.nodes.iter().enumerate() {
            let (segment, t) = (k / finer, (k % finer) as f64 / finer as f64);
            let last = coarse.nodes.len() - 1;
            let at = |node: usize| rest[coarse.nodes[node.min(last)]];
            let [before, from, to, behind] = [
                at(segment.saturating_sub(1)),
                at(segment),
                at(segment + 1),
                at(segment + 2),
            ];
            // A cubic through the nodes, so that what bends has no corners.
            let slopes = [0.5 * (to - before), 0.5 * (behind - from)];
            let (square, cube) = (t * t, t * t * t);
            near[*node] = from * (2.0 * cube - 3.0 * square + 1.0)
                + slopes[0] * (cube - 2.0 * square + t)
                + to * (3.0 * square - 2.0 * cube)
                + slopes[1] * (cube - square);
        }
    }
    near
}
