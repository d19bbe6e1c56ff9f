//! What is fuzzed: a plain function for each kind of input, on public functions of the library alone. `cargo test --test fuzz` and the
//! package in `fuzz` call the same ones.

mod cases;
mod foreign;
mod long;
mod place;
mod runs;
mod settings;
mod stored;
mod tables;

pub(crate) use place::enter;

/// Inputs are cut to so many bytes.
pub(crate) const LONGEST: usize = 64 << 10;

/// A kind of input.
pub(crate) struct Target {
    /// Its name: that of its folder in the corpus.
    pub(crate) name: &'static str,
    /// Reads an input, whatever it is: whether it is read, rather than refused. Both are right; a panic is not.
    pub(crate) run: fn(&[u8]) -> bool,
    /// Inputs that are read, from what is shipped.
    pub(crate) seeds: fn() -> Vec<Vec<u8>>,
    /// How many inputs it gets beside others: cheap ones get more.
    pub(crate) share: u64,
}

impl Target {
    /// Reads an input, cut to the length that is looked at.
    pub(crate) fn read(&self, data: &[u8]) -> bool {
        (self.run)(&data[..data.len().min(LONGEST)])
    }
}

/// All kinds of input.
pub(crate) fn all() -> impl Iterator<Item = &'static Target> {
    let rooms = [
        cases::ALL,
        tables::ALL,
        foreign::ALL,
        settings::ALL,
        long::ALL,
    ];
    let rooms = rooms.into_iter().chain(stored::ALL.iter().copied());
    rooms.flatten()
}
