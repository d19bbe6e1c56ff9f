//! The forces on the line, listed once.
//!
//! A new force is a file here with its data, its construction from the case, and its `Element`; a field of [`Elements`], and
//! a row of `Elements::iter` and `Elements::of_case`. Residual, tangent, convergence norm, explicit right-hand side, step
//! limits, energy balance and end forces follow from the list.
//!
//! The forces of the segments themselves are no element: `scene/segment_kernel.rs` computes tension, drag, added mass and
//! weight of the whole line in one pass in lanes, which a list of forces would take apart. The kernel sets the residual, the
//! elements add to it. Dispatch is dynamic, once an element and call, which costs nothing measurable against a pass over the
//! nodes.

mod bed;
mod bed_end;
mod body_contact;
mod body_loads;
mod clump_drag;
mod current_slope;
mod fed_end;
mod flexure;
mod mass_damping;
mod rigid_payload;
mod traveller;
mod water_loads;

use super::LumpedLine;
use super::element::Element;
use crate::case::Case;

pub use bed::BedContact;
pub(super) use bed::HalfSegment;
pub use body_contact::{BearingBody, BodyContact};
use body_loads::BodyLoads;
use clump_drag::ClumpDrag;
use current_slope::CurrentSlope;
pub use fed_end::{DrumPull, FedEnd, PaidOut};
pub use flexure::Flexure;
pub(super) use flexure::clamps_without_effect;
pub use mass_damping::MassDamping;
pub use rigid_payload::RigidPayload;
pub use traveller::TravellingBody;
use water_loads::WaterLoads;

/// The forces on the line beside those of its segments.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Elements {
    /// Contact with the sea bed, and its friction.
    pub bed: Option<BedContact>,
    /// Contact of the bodies with it.
    pub body_contact: Option<BodyContact>,
    /// Drag of the clumps that have one across and one along the line.
    pub(super) clump_drag: Option<ClumpDrag>,
    /// Bending, where any material has a bending stiffness.
    pub flexure: Option<Flexure>,
    /// Damping by mass, where any material has it.
    pub mass_damping: Option<MassDamping>,
    /// A body that travels along the line.
    pub traveller: Option<TravellingBody>,
    /// A payload that rotates about the last node of the line.
    pub rigid_payload: Option<RigidPayload>,
    /// Ends A and B where the line is paid out.
    pub fed_ends: [Option<FedEnd>; 2],
}

impl Elements {
    /// The elements of a case on its line of such a mesh, with clumps at these nodes. The payload is built before the line, whose last segment is its rod.
    pub(super) fn of_case(
        case: &Case,
        coarsening: usize,
        line: &LumpedLine,
        clumps: &[usize],
        rigid_payload: Option<RigidPayload>,
    ) -> Self {
        let last = line.line_nodes - 1;
        Self {
            body_contact: BodyContact::of_case(case, clumps, rigid_payload.as_ref(), last),
            clump_drag: ClumpDrag::of_case(case, line, clumps),
            bed: case
                .seabed
                .as_ref()
                .map(|bed| BedContact::new((bed, &case.files), &line.segments)),
            flexure: Flexure::of_case(case, line),
            mass_damping: MassDamping::of_case(case, coarsening),
            traveller: TravellingBody::of_case(case),
            rigid_payload,
            fed_ends: [None, None],
        }
    }

    /// All elements, in the order in which they are summed. [`Flexure`] sets the far blocks of the tangent, so that elements
    /// which add to these come after it.
    pub(super) fn iter(&self) -> impl Iterator<Item = &dyn Element> {
        fn some<E: Element>(element: &Option<E>) -> Option<&dyn Element> {
            element.as_ref().map(|element| element as &dyn Element)
        }
        let list: [Option<&dyn Element>; 12] = [
            some(&self.bed),
            some(&self.body_contact),
            Some(&WaterLoads),
            some(&self.flexure),
            some(&self.mass_damping),
            some(&self.traveller),
            Some(&BodyLoads),
            some(&self.clump_drag),
            Some(&CurrentSlope),
            some(&self.rigid_payload),
            some(&self.fed_ends[0]),
            some(&self.fed_ends[1]),
        ];
        list.into_iter().flatten()
    }
}
