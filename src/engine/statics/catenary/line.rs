//! A line as given: ends, sections, bed.

use super::error::CatenaryError;

/// End B seen from end A, in the vertical plane through both.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EndOffset {
    /// Horizontal distance from A to B \[m\]; of any sign.
    pub x_m: f64,
    /// Height of B above A \[m\]; of any sign.
    pub z_m: f64,
}

impl EndOffset {
    /// From two points in space, z up: the plane is the vertical one through both.
    #[must_use]
    pub fn between(a_m: [f64; 3], b_m: [f64; 3]) -> Self {
        Self {
            x_m: (b_m[0] - a_m[0]).hypot(b_m[1] - a_m[1]),
            z_m: b_m[2] - a_m[2],
        }
    }
}

/// A uniform section of a line and the body at its end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SectionProperties {
    /// Unstretched length \[m\].
    pub length_m: f64,
    /// Weight in water per unstretched length \[N/m\]; negative when it is buoyant.
    pub weight_n_per_m: f64,
    /// Axial stiffness EA \[N\]; infinite for a section that cannot stretch.
    pub ea_n: f64,
    /// Weight in water of a body at the section's end towards B \[N\]: a clump when positive, a buoy
    /// when negative. Must be zero on the last section, whose end is B itself.
    pub clump_n: f64,
}

impl SectionProperties {
    /// A section without a body at its end.
    #[must_use]
    pub fn new(length_m: f64, weight_n_per_m: f64, ea_n: f64) -> Self {
        Self {
            length_m,
            weight_n_per_m,
            ea_n,
            clump_n: 0.0,
        }
    }
}

/// The sea bed: rigid, flat or evenly sloping in the line's plane.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct RigidBed {
    /// Height of end A above the bed \[m\].
    pub below_a_m: f64,
    /// Slope \[rad\], positive when it rises from A towards B.
    pub slope_rad: f64,
    /// Axial Coulomb friction: tension lost per unit of weight carried by the bed \[-\]. The line
    /// slides towards B.
    pub friction: f64,
}

/// One line at rest in still water, in a vertical plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CatenaryLine<'a> {
    /// Where B is.
    pub ends: EndOffset,
    /// Sections from A to B.
    pub sections: &'a [SectionProperties],
    /// The bed under the line, if there is one in reach.
    pub bed: Option<RigidBed>,
    /// Height above A of a flat, frictionless surface against which a buoyant line comes to rest \[m\].
    pub surface_above_a_m: Option<f64>,
}

/// `Ok` when the number is valid.
fn need(
    ok: bool,
    quantity: &'static str,
    value: f64,
    needs: &'static str,
) -> Result<(), CatenaryError> {
    if ok {
        return Ok(());
    }
    Err(CatenaryError::Input {
        quantity,
        value,
        needs,
    })
}

/// Greatest magnitude of any input: squares and products of three must stay finite.
const HUGE: f64 = 1e60;

impl EndOffset {
    pub(super) fn check(&self) -> Result<(), CatenaryError> {
        let fine = |v: f64| v.abs() <= HUGE;
        need(
            fine(self.x_m),
            "x of end B [m]",
            self.x_m,
            "a finite number",
        )?;
        need(
            fine(self.z_m),
            "z of end B [m]",
            self.z_m,
            "a finite number",
        )
    }
}

impl SectionProperties {
    pub(super) fn check(&self) -> Result<(), CatenaryError> {
        let (l, w, ea) = (self.length_m, self.weight_n_per_m, self.ea_n);
        need(
            (1e-60..=HUGE).contains(&l),
            "the unstretched length [m]",
            l,
            "finite and greater than zero",
        )?;
        need(
            w.abs() <= HUGE,
            "the weight per metre [N/m]",
            w,
            "a finite number",
        )?;
        need(
            ea >= 1e-60,
            "the axial stiffness EA [N]",
            ea,
            "greater than zero",
        )?;
        let clump = self.clump_n;
        need(
            clump.abs() <= HUGE,
            "the weight of a body on the line [N]",
            clump,
            "a finite number",
        )
    }
}

impl RigidBed {
    pub(super) fn check(&self) -> Result<(), CatenaryError> {
        let Self {
            below_a_m,
            slope_rad,
            friction,
        } = *self;
        need(
            below_a_m.abs() <= HUGE,
            "the depth of the bed below A [m]",
            below_a_m,
            "a finite number",
        )?;
        need(
            slope_rad.abs() < 1.55,
            "the slope of the bed [rad]",
            slope_rad,
            "between -1.55 and 1.55 (89 degrees)",
        )?;
        need(
            (0.0..=1e6).contains(&friction),
            "the friction of the bed [-]",
            friction,
            "zero or a positive number",
        )
    }
}
