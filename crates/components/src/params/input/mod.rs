//! Params / Input: objects that hold a value for the user to change.

mod choice;
mod colours;
mod dials;
mod graph_mapper;
mod graphs;
mod panel;
