//! Charts as data (axes, series, marks, cursor) and their drawing in characters.
