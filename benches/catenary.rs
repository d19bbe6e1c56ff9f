//! Time of one line at rest, cold and from a neighbour, and of a large seeded set that must all be solved.

use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
use seacable::statics::catenary::{CatenaryLine, EndOffset, RigidBed, SectionProperties};

fn line(
    x_m: f64,
    z_m: f64,
    sections: &[SectionProperties],
    bed: Option<RigidBed>,
) -> CatenaryLine<'_> {
    CatenaryLine {
        ends: EndOffset { x_m, z_m },
        sections,
        bed,
        surface_above_a_m: None,
    }
}

const fn section(length_m: f64, weight_n_per_m: f64, ea_n: f64) -> SectionProperties {
    SectionProperties {
        length_m,
        weight_n_per_m,
        ea_n,
        clump_n: 0.0,
    }
}

const CHAIN: [SectionProperties; 1] = [section(900.0, 1_200.0, 5.0e8)];

/// Zhu et al. 2017 (doi 10.11990/jheu.201508013): 2000 m of polyester between 1525 m and 425 m of chain.
const HYBRID: [SectionProperties; 3] = [
    section(1525.0, 1375.7, 691.74e6),
    section(2000.0, 85.26, 179.523e6),
    section(425.0, 1375.7, 691.74e6),
];

fn singles(c: &mut Criterion) {
    let flat = Some(RigidBed::default());
    let slope = Some(RigidBed {
        slope_rad: 0.1,
        friction: 0.4,
        ..RigidBed::default()
    });
    let deep = Some(RigidBed {
        below_a_m: 60.0,
        ..RigidBed::default()
    });
    let lines = [
        ("hanging", line(800.0, 300.0, &CHAIN, None)),
        ("taut", line(880.0, 200.0, &CHAIN, None)),
        ("on the bed", line(840.0, 120.0, &CHAIN, flat)),
        ("lifted off the bed", line(800.0, 400.0, &CHAIN, flat)),
        ("on a rough slope", line(840.0, 180.0, &CHAIN, slope)),
        ("trough", line(840.0, 40.0, &CHAIN, deep)),
    ];
    for (name, line) in lines {
        c.bench_function(&format!("catenary/{name}"), |b| {
            b.iter(|| black_box(&line).solve());
        });
        let mut neighbour = line;
        neighbour.ends.x_m -= 0.5;
        let Ok(near) = neighbour.solve() else {
            continue;
        };
        c.bench_function(&format!("catenary/{name}, warm"), |b| {
            b.iter(|| black_box(&line).solve_from(&near));
        });
    }
}

fn hybrid(c: &mut Criterion) {
    let line = line(3569.462, 1460.0, &HYBRID, Some(RigidBed::default()));
    c.bench_function("catenary/chain-polyester-chain", |b| {
        b.iter(|| black_box(&line).solve());
    });
}

/// Numbers in 0..1 from a fixed seed (Marsaglia's xorshift).
struct Seeded(u64);

impl Seeded {
    fn next(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn decades(&mut self, from: f64, to: f64) -> f64 {
        10_f64.powf(from + (to - from) * self.next())
    }
}

fn set(c: &mut Criterion) {
    let mut r = Seeded(0x5ea_cab1e);
    let lines: Vec<_> = (0..10_000)
        .map(|i| {
            let length = r.decades(-1.0, 4.5);
            let rope = [section(length, r.decades(-4.0, 5.0), r.decades(4.0, 14.0))];
            let (x, z) = (length * 1.3 * r.next(), length * 1.2 * r.next());
            let below = [None, Some(0.0), Some(0.3 * length * r.next())][i % 3];
            let bed = below.map(|below_a_m| RigidBed {
                below_a_m,
                ..RigidBed::default()
            });
            (x, z, rope, bed)
        })
        .collect();
    let solved = |(x, z, rope, bed): &(f64, f64, [SectionProperties; 1], Option<RigidBed>)| {
        line(*x, *z, rope, *bed).solve().is_ok()
    };
    c.bench_function("catenary/ten thousand of every kind", |b| {
        b.iter(|| assert!(lines.iter().all(solved)));
    });
}

criterion_group! {
    name = benches;
    config = Criterion::default().sample_size(20);
    targets = singles, hybrid, set
}
criterion_main!(benches);
