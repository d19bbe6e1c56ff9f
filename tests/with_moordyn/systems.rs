//! The files, and how what they are coupled to moves.

/// A system of lines in the form of MoorDyn, and its motion.
#[derive(Debug)]
pub(crate) struct System {
    /// Its name.
    pub(crate) name: &'static str,
    /// Rows of the line types.
    types: &'static [&'static str],
    /// Rows of the points, coupled ones left out.
    points: &'static [&'static str],
    /// Rows of the lines: type, ends, length, and the segments.
    rows: &'static [(&'static str, usize)],
    /// How many lines there are.
    pub(crate) lines: usize,
    /// Places of the coupled points \[m\], which have the last numbers, and amplitudes of their motion \[m\].
    pub(crate) coupled: &'static [([f64; 3], [f64; 3])],
    /// Period of the motion \[s\].
    pub(crate) period: f64,
    /// Depth of the water \[m\].
    depth: f64,
}

impl System {
    /// The file with so many times the segments.
    pub(crate) fn text(&self, finer: usize) -> String {
        let mut text = format!(
            "----- MoorDyn Input File -----\n{}\n--- LINE TYPES ---\n\
             TypeName Diam Mass/m EA BA/-zeta EI Cd Ca CdAx CaAx\n(name) (m) (kg/m) (N) (N-s/-) (N-m^2) (-) (-) (-) (-)\n",
            self.name
        );
        for row in self.types {
            text += &format!("{row}\n");
        }
        text += "--- POINTS ---\nID Attachment X Y Z Mass Volume CdA Ca\n(#) (-) (m) (m) (m) (kg) (m^3) (m^2) (-)\n";
        let mut number = 0;
        for row in self.points {
            number += 1;
            text += &format!("{number} {row}\n");
        }
        for ([x, y, z], _) in self.coupled {
            number += 1;
            text += &format!("{number} Coupled {x} {y} {z} 0 0 0 0\n");
        }
        text += "--- LINES ---\nID LineType AttachA AttachB UnstrLen NumSegs LineOutputs\n(#) (name) (#) (#) (m) (-) (-)\n";
        for (number, (row, segments)) in (1..).zip(self.rows) {
            text += &format!("{number} {row} {} -\n", finer * segments);
        }
        text += &format!(
            "--- OPTIONS ---\n{} dtM\nRK4 tScheme\n{} WtrDpth\n1025 WtrDnsty\n9.80665 g\n1e5 kBot\n1e4 cBot\n1 ICgenDynamic\n20 dtIC\n\
             300 TmaxIC\n80 CdScaleIC\n1e-7 threshIC\n--- need this line ---\n",
            0.001 / finer as f64,
            self.depth
        );
        text
    }
}

/// Chain with a damping that holds the modes of single segments down.
const CHAIN: &str = "chain 0.18 115 5e8 4e5 0 1.2 1.0 0.2 0.0";
/// Polyester rope.
const ROPE: &str = "rope 0.16 24 3e7 5e4 0 1.6 1.1 0.1 0.0";
/// Wire rope.
const WIRE: &str = "wire 0.08 27 4e8 2e5 0 1.2 1.0 0.05 0.0";

/// The systems.
pub(crate) const SYSTEMS: &[System] = &[
    System {
        name: "chain_in_surge",
        types: &[CHAIN],
        points: &["Fixed 500 0 -150 0 0 0 0"],
        rows: &[("chain 1 2 530", 30)],
        lines: 1,
        coupled: &[([0.0, 0.0, -10.0], [1.5, 0.0, 0.0])],
        period: 10.0,
        depth: 150.0,
    },
    System {
        name: "chain_in_heave",
        types: &[CHAIN],
        points: &["Fixed 500 0 -150 0 0 0 0"],
        rows: &[("chain 1 2 530", 30)],
        lines: 1,
        coupled: &[([0.0, 0.0, -10.0], [0.0, 0.0, 2.5])],
        period: 9.0,
        depth: 150.0,
    },
    System {
        name: "hanging_wire",
        types: &[WIRE],
        points: &["Fixed 120 0 -180 0 0 0 0"],
        rows: &[("wire 1 2 235", 30)],
        lines: 1,
        coupled: &[([0.0, 0.0, -10.0], [2.0, 2.0, 1.0])],
        period: 8.0,
        depth: 300.0,
    },
    System {
        name: "taut_polyester",
        types: &[ROPE],
        points: &["Fixed 350 0 -300 0 0 0 0"],
        rows: &[("rope 1 2 444", 30)],
        lines: 1,
        coupled: &[([0.0, 0.0, -15.0], [3.0, 0.0, 1.0])],
        period: 11.0,
        depth: 300.0,
    },
    System {
        name: "chain_and_rope",
        types: &[CHAIN, ROPE],
        points: &[
            "Fixed 450 0 -250 0 0 0 0",
            "Free 222.7 0 -180.9 2000 0.5 1.0 1.0",
        ],
        rows: &[("chain 1 2 245", 20), ("rope 2 3 278", 20)],
        lines: 2,
        coupled: &[([0.0, 0.0, -15.0], [3.0, 0.0, 1.0])],
        period: 10.0,
        depth: 250.0,
    },
    System {
        name: "crowfoot",
        types: &[CHAIN, WIRE],
        points: &["Fixed 400 0 -150 0 0 0 0", "Free 50 0 -36 1500 0.3 0.8 1.0"],
        rows: &[
            ("chain 1 2 375", 24),
            ("wire 2 3 58", 10),
            ("wire 2 4 58", 10),
        ],
        lines: 3,
        coupled: &[
            ([0.0, -15.0, -12.0], [0.8, 0.0, 0.3]),
            ([0.0, 15.0, -12.0], [0.8, 0.0, -0.3]),
        ],
        period: 9.0,
        depth: 150.0,
    },
    System {
        name: "shared_line",
        types: &[WIRE],
        points: &["Free 75 0 -45 6000 1.5 2.0 1.0"],
        rows: &[("wire 2 1 90", 16), ("wire 1 3 90", 16)],
        lines: 2,
        coupled: &[
            ([0.0, 0.0, -10.0], [2.0, 0.0, 1.0]),
            ([150.0, 0.0, -10.0], [-2.0, 1.0, 1.0]),
        ],
        period: 10.0,
        depth: 200.0,
    },
    System {
        name: "buoy_on_tether",
        types: &[ROPE, CHAIN],
        points: &["Fixed 0 0 -120 0 0 0 0", "Free 5 0 -45 4000 30 6.0 1.0"],
        rows: &[("rope 1 2 74", 16), ("chain 2 3 95", 20)],
        lines: 2,
        coupled: &[([70.0, 0.0, -10.0], [1.5, 0.0, 1.0])],
        period: 10.0,
        depth: 120.0,
    },
];
