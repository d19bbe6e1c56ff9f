//! An effect of a scene, and a scene without it.

use crate::study::studied::Studied;

/// An effect of a scene that can be left out, or a part of it that can be changed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct EffectName {
    /// What it is: "drag of the line".
    pub name: &'static str,
    /// What is done to the scene, by its keys.
    pub how: &'static str,
}

/// How an effect is left out.
#[derive(Debug, Clone, Copy)]
pub struct ScenePart<K> {
    /// The effect.
    pub effect: EffectName,
    /// Leaves it out; leaves a scene as it is that does not have it.
    pub leave_out: fn(&mut K),
}

impl<K> ScenePart<K> {
    pub(super) const fn new(name: &'static str, how: &'static str, leave_out: fn(&mut K)) -> Self {
        Self {
            effect: EffectName { name, how },
            leave_out,
        }
    }
}

/// A kind of file whose effects can be left out.
pub trait HasEffects: Studied + PartialEq {
    /// Effects that cannot be left out, and why.
    const KEPT: &'static [(&'static str, &'static str)];

    /// All effects that can be, in the order of the table.
    fn parts() -> Vec<ScenePart<Self>>;

    /// Leaves out what it says about itself that may not hold without an effect: published values, marks, studies.
    fn forget_what_it_says_of_itself(&mut self);
}
