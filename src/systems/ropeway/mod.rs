//! The ropeway between a ship and a fixed platform: tension of its rope, sag and clearance of the cargo, and duty of the
//! winch on the ship.
//!
//! The source is a paper of the Military Transportation Institute and Tianjin University on supplying a platform from an
//! anchored ship over a ropeway (about 2016; its text is at hand without title and names, so that it is
//! cited here as the Tianjin paper). Models of the rope at rest:
//!
//! * [`inextensible`]: the model behind the tables of the paper, on the catenary of the [`unloaded`] rope;
//! * [`loaded`]: two inextensible catenaries that meet at the cargo, for the mean tensions;
//! * [`parabola`]: parabola theory;
//! * [`elastic`]: the elastic catenary with the cargo on it, in closed form;
//! * [`line`](mod@line): a discretised line.
//!
//! In motion: the [rope with its cargo](rope_system) as a system ([`dynamic_crossing`],
//! [`rope_motion`]), [`winch`] with the ship's motion as given, [`oscillator`] for the cargo with one degree of freedom.
//!
//! [`model`] declares the keys of a ropeway file.

mod cargo_motion;
pub mod dynamic_crossing;
pub mod elastic;
mod error;
mod file;
pub mod hauling;
pub mod inextensible;
pub mod line;
pub mod loaded;
pub mod model;
pub mod oscillator;
pub mod parabola;
pub mod quantities;
mod roots;
pub mod rope_motion;
pub mod rope_system;
pub mod ship_motion;
mod solve;
pub mod unloaded;
pub mod validation;
pub mod weight_check;
pub mod winch;
mod winch_run;

pub use cargo_motion::MARGIN;
pub use error::RopewayError;
pub use file::ROPEWAY;
pub use model::Ropeway;
pub use rope_motion::RopeMotion;
pub use solve::{ModelResults, SolvedRopeway, solve};
pub use winch_run::WinchRun;
