//! Why a case cannot be made into a scene.

/// Why a case cannot be made into a scene. A case that passed its checks does not meet these.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum SceneError {
    /// A section names a material that the case does not have.
    #[error("section `{section}` is made of `{material}`, which the case does not describe")]
    NoMaterial {
        /// The section.
        section: String,
        /// The material.
        material: String,
    },
    /// A key is needed and absent.
    #[error("`{key}` is needed: {why}")]
    Missing {
        /// The key path.
        key: String,
        /// Why.
        why: &'static str,
    },
    /// A file that the case names does not have what it is named for.
    #[error("{0}")]
    File(String),
    /// A number would spoil the computation.
    #[error("`{key}` makes no line: {why}")]
    Impossible {
        /// The key path.
        key: String,
        /// Why.
        why: &'static str,
    },
}
