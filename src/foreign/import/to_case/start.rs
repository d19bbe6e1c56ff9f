//! Where a run in time begins: with `TmaxIC 0` where the file puts what is free. Free points at which nothing ends.

use super::case_text::CaseText;
use super::context::Context;
use crate::import::mooring::{Attachment, Hold, Mooring, Program, ProgramSetting};

/// The option by which `MoorDyn` does not bring the system to rest first.
fn without_rest(mooring: &Mooring) -> Option<&ProgramSetting> {
    let is_of_moordyn = matches!(mooring.program, Program::MoorDyn | Program::MoorDyn1);
    let setting = mooring.setting("tmaxic").filter(|_| is_of_moordyn);
    setting.filter(|setting| setting.number() == Some(0.0))
}

/// Whether a run begins where the file puts what is free, by an option of `MoorDyn`.
#[must_use]
pub fn is_given(context: &Context<'_>) -> bool {
    without_rest(context.mooring).is_some() && has_unknowns(context)
}

/// Whether a point is free and no line ends at it.
fn is_loose(context: &Context<'_>, point: usize) -> bool {
    let is_free = context.mooring.points[point].hold.value == Hold::Free;
    is_free && !context.is_used(Attachment::Point(point))
}

/// Whether a point at which no line ends falls or rises from where it is: it has a mass, and the run begins there.
#[must_use]
pub fn is_dropped(context: &Context<'_>, point: usize) -> bool {
    let has_mass = context.mooring.points[point].mass.value > 0.0;
    is_loose(context, point) && has_mass && without_rest(context.mooring).is_some()
}

/// Whether anything of the case is free.
fn has_unknowns(context: &Context<'_>) -> bool {
    let mooring = context.mooring;
    let bodies = mooring.bodies.iter().map(|body| &body.hold.value);
    let rods = mooring.rods.iter().map(|rod| &rod.hold.value);
    let free_points = mooring.points.iter();
    let free_points = free_points.filter(|point| point.hold.value == Hold::Free);
    bodies.chain(rods).any(Hold::turns) || free_points.count() > 0
}

/// Writes where the run begins.
pub fn write(case: &mut CaseText<'_>, context: &Context<'_>) {
    let Some(setting) = without_rest(context.mooring).filter(|_| has_unknowns(context)) else {
        return;
    };
    case.table("[start]", Some(&setting.span));
    let what = format!("{} 0", setting.written);
    case.given("placement", "\"given\"", &setting.span, &what);
}

/// What of this the notes of the case say.
#[must_use]
pub fn remarks(context: &Context<'_>) -> Vec<String> {
    let mut found = Vec::new();
    if let Some(setting) = without_rest(context.mooring).filter(|_| has_unknowns(context)) {
        found.push(format!(
            "{} 0: in motion what is free begins where the file puts it.",
            setting.written
        ));
    }
    let points = context.mooring.points.iter().enumerate();
    let left_out =
        points.filter(|(number, _)| is_loose(context, *number) && !is_dropped(context, *number));
    found.extend(left_out.map(|(_, point)| {
        let why = match point.mass.value > 0.0 {
            true => "nothing holds it (with TmaxIC 0 it falls or rises in motion)",
            false => "it has no mass",
        };
        format!(
            "Point {} is free and no line ends at it: it is left out, since {why}.",
            point.id
        )
    }));
    found
}
