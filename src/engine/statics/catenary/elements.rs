//! A line of several sections with bodies between them, cut where it rests on the bed.
//!
//! On a flat, frictionless bed the horizontal force is one number H along the whole line, and where the
//! line is grounded its vertical force is zero. Between two grounded runs the line is a suspended *bay*: there
//! V(s) = offset + W(s), with W the weight from A up to s, as long as the line is off the bed. In the run
//! of sinking sections where a bay begins, V counts only while positive; in the run where it ends, only
//! while negative: that clipping is the touchdown point, and the unknowns are H and one offset a bay.
//!
//! The line's complementary energy `Σ ∫ T + T²/(2EA) ds`, with that clipping, is a convex function of
//! those unknowns; its derivatives are the reach in x (by H) and the rise of each bay (by its
//! offset). Equilibrium is its minimum less the work of the given positions: it is unique, and every
//! bay is coupled to the others only through H (an arrow-shaped Hessian, solved by elimination).

use super::span::Span;
use crate::numerics::double_double::DoubleDouble;

/// A section, or a body (length zero) between sections.
#[derive(Debug, Clone, Copy)]
pub(super) struct LineElement {
    pub length: f64,
    /// Weight per unstretched length.
    pub weight: f64,
    pub ea: f64,
    /// Weight of the body.
    pub load: f64,
}

impl LineElement {
    /// Weight of the whole element.
    pub(super) fn total(&self) -> f64 {
        self.weight * self.length + self.load
    }

    fn span(&self, length: f64) -> Span {
        Span {
            length,
            weight: self.weight,
            ea: self.ea,
        }
    }
}

/// Elements from the first to the last, both included.
pub(super) type ElementRange = (usize, usize);

/// A suspended bay: from where the line leaves one grounded run (or A) to the next (or B).
#[derive(Debug, Clone, Copy)]
pub(super) struct Bay {
    /// Elements it can extend over.
    pub over: ElementRange,
    /// Run it rises from, and run it comes down on; none at A and at B.
    pub from: Option<ElementRange>,
    pub onto: Option<ElementRange>,
    /// Height of its end above its beginning.
    pub rise: f64,
}

/// The line with W at the beginning of every element.
#[derive(Debug, Clone)]
pub(super) struct LineElements {
    pub elements: Vec<LineElement>,
    pub weight_before: Vec<f64>,
    pub length: f64,
    /// Σ L/EA
    pub compliance: f64,
    pub weight: f64,
}

/// The suspended part of an element in a bay.
#[derive(Debug, Clone, Copy)]
pub(super) struct SuspendedPart {
    pub element: usize,
    /// Where in the element it begins.
    pub begin: f64,
    pub length: f64,
    /// Vertical force at its beginning.
    pub va: f64,
}

/// Reach and rise of one bay with their derivatives; reach beyond that of line on the bed.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct BayReach {
    /// Σ dx - s (1 + H/EA)
    pub x: f64,
    pub z: f64,
    pub hh: f64,
    pub hv: f64,
    pub vv: f64,
}

fn within(run: Option<ElementRange>, element: usize) -> bool {
    run.is_some_and(|(first, last)| (first..=last).contains(&element))
}

impl LineElements {
    pub(super) fn new(elements: Vec<LineElement>) -> Self {
        let mut weight = 0.0;
        let weight_before = elements
            .iter()
            .map(|element| {
                let before = weight;
                weight += element.total();
                before
            })
            .collect();
        Self {
            length: elements.iter().map(|e| e.length).sum(),
            compliance: elements
                .iter()
                .filter(|e| e.length > 0.0)
                .map(|e| e.length / e.ea)
                .sum(),
            elements,
            weight_before,
            weight,
        }
    }

    /// Sum of the magnitudes of the elements' weights.
    pub(super) fn absolute_weight(&self) -> f64 {
        self.elements.iter().map(|e| e.total().abs()).sum()
    }

    /// The suspended parts of a bay in order.
    pub(super) fn parts<'a>(
        &'a self,
        bay: &'a Bay,
        offset: f64,
    ) -> impl Iterator<Item = SuspendedPart> + 'a {
        (bay.over.0..=bay.over.1).filter_map(move |index| {
            let element = &self.elements[index];
            let va = offset + self.weight_before[index];
            let whole = SuspendedPart {
                element: index,
                begin: 0.0,
                length: element.length,
                va,
            };
            if element.length <= 0.0 {
                return None;
            }
            let vb = va + element.total();
            if within(bay.from, index) && va < 0.0 {
                let length = if vb > 0.0 { vb / element.weight } else { 0.0 };
                return (length > 0.0).then_some(SuspendedPart {
                    begin: element.length - length,
                    length,
                    va: 0.0,
                    ..whole
                });
            }
            if within(bay.from, index) && element.weight <= 0.0 && va <= 0.0 {
                return None;
            }
            if within(bay.onto, index) && vb > 0.0 {
                let length = if va < 0.0 { -va / element.weight } else { 0.0 };
                return (length > 0.0).then_some(SuspendedPart { length, ..whole });
            }
            if within(bay.onto, index) && element.weight <= 0.0 && va >= 0.0 {
                return None;
            }
            Some(whole)
        })
    }

    pub(super) fn part_span(&self, part: &SuspendedPart) -> Span {
        self.elements[part.element].span(part.length)
    }

    pub(super) fn bay_reach(&self, bay: &Bay, h: f64, offset: f64) -> BayReach {
        let mut sum = BayReach::default();
        for part in self.parts(bay, offset) {
            let span = self.part_span(&part);
            let (dx, dz) = span.reach(h, part.va);
            let c = span.compliance(h, part.va);
            let stretch = span.length / span.ea;
            sum.x += dx - span.length - h * stretch;
            sum.z += dz;
            sum.hh += c.hh - stretch;
            sum.hv += c.hv;
            sum.vv += c.vv;
        }
        sum
    }

    /// Reach of the whole line and rises of its bays with 30 digits: given positions minus those reached.
    pub(super) fn residuals(
        &self,
        bays: &[Bay],
        h: f64,
        offsets: &[f64],
        x: f64,
    ) -> (f64, Vec<f64>) {
        let one_more = |ea: f64| DoubleDouble::from(h) / DoubleDouble::from(ea) + 1.0;
        let mut reach = DoubleDouble::from(-x);
        for element in self.elements.iter().filter(|e| e.length > 0.0) {
            reach = reach + one_more(element.ea) * element.length;
        }
        let mut rises = Vec::with_capacity(bays.len());
        for (bay, offset) in bays.iter().zip(offsets) {
            let mut rise = DoubleDouble::from(-bay.rise);
            for part in self.parts(bay, *offset) {
                let span = self.part_span(&part);
                let (dx, dz) = span.reach_exactly(h, part.va.into());
                reach = reach + dx + -(one_more(span.ea) * span.length);
                rise = rise + dz;
            }
            rises.push(-rise.value());
        }
        (-reach.value(), rises)
    }
}
