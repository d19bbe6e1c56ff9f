//! Names for the outputs of a scene.

/// Names for the outputs.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Labels {
    /// Names of the ends A and B.
    pub end_names: [String; 2],
    /// Where tension is reported, from A to B.
    pub joints: Vec<Joint>,
    /// Nodes of the clumps, in the order of the case.
    pub clumps: Vec<usize>,
    /// What the user should know of how the case was made into this line.
    pub remarks: Vec<String>,
}

/// A named place where the tension is reported.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Joint {
    /// As in channel names: `chain|polyester`.
    pub name: String,
    /// Its node.
    pub node: usize,
}
