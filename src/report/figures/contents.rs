//! What a case has, by which its figures are chosen.

use seacable_model::case::{
    self, Case, ChannelLocation, ChannelQuantity, ChannelSpec, End, Method, OneOrMany, WaveKind,
};
use seacable_runs::run::response as driven_response;

/// What decides which figures a case has.
pub(super) struct CaseContents<'a> {
    case: &'a Case,
    channels: Vec<ChannelSpec>,
    pub(super) dynamic: bool,
}

impl<'a> CaseContents<'a> {
    /// Of a case.
    pub(super) fn new(case: &'a Case) -> Self {
        Self {
            case,
            channels: case::channels(case),
            dynamic: case.solver.method != Method::Static,
        }
    }

    /// Whether a quantity is recorded over time.
    pub(super) fn records(&self, quantity: ChannelQuantity) -> bool {
        self.dynamic && self.channels.iter().any(|c| c.id.quantity == quantity)
    }
}

/// Whether an end moves.
pub(super) fn moves(c: &CaseContents) -> bool {
    let of_end = |spec: &ChannelSpec| {
        matches!(
            (spec.id.quantity, spec.site),
            (ChannelQuantity::X, ChannelLocation::End(_))
        )
    };
    c.dynamic && c.channels.iter().any(of_end)
}

/// Whether there is a fibre rope.
pub(super) fn rope(c: &CaseContents) -> bool {
    let of_rope = |spec: &ChannelSpec| spec.id.quantity == ChannelQuantity::Stiffness;
    c.channels.iter().any(of_rope)
}

/// Whether the steady response is recorded.
pub(super) fn response(c: &CaseContents) -> bool {
    c.dynamic && c.case.output.response_from_s.is_some()
}

/// Whether that response has a period.
pub(super) fn driven(c: &CaseContents) -> bool {
    response(c) && driven_response::period(c.case).is_some()
}

/// Whether waves are irregular; a regular wave is a sine, which need not be drawn.
pub(super) fn irregular_sea(c: &CaseContents) -> bool {
    let waves = c.case.waves.as_ref();
    c.dynamic && waves.is_some_and(|waves| waves.kind == WaveKind::Irregular)
}

/// Whether the case states anything along a study.
pub(super) fn studied(c: &CaseContents) -> bool {
    let mut published = c.case.published.iter();
    !c.case.trend.is_empty()
        || !c.case.published_curve.is_empty()
        || published.any(|p| p.at.is_some())
}

/// Whether any section has a bending stiffness.
pub(super) fn bends(c: &CaseContents) -> bool {
    c.case.line.iter().any(|section| {
        let material = c.case.materials.get(&section.material);
        material.is_some_and(|material| material.ei_n_m2 > 0.0)
    })
}

/// Whether the line may leave a plane along x; a line at rest is always seen from three sides.
pub(super) fn spatial(c: &CaseContents) -> bool {
    let aside = |end: &End| {
        let y = |p: &[f64; 3]| p[1].abs() > 0.0;
        end.position_m.as_ref().is_some_and(y) || y(&end.amplitude_m)
    };
    let oblique = c.case.current.as_ref().is_some_and(|current| {
        let turns = |degrees: &f64| degrees.to_radians().sin().abs() > 1e-9;
        match &current.direction_deg {
            OneOrMany::One(one) => turns(one),
            OneOrMany::Many(many) => many.iter().any(turns),
        }
    });
    let ends = &c.case.ends;
    !c.dynamic || aside(&ends.a) || aside(&ends.b) || oblique
}
