//! Ropes whose stiffness is not one number, against what they must do.

mod creep;
mod dynamic;
mod mooring;
mod table;
mod zhu_2017;
