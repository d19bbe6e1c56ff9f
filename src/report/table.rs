//! Tables as data, drawn the same on screen, in the report and on the command line.
