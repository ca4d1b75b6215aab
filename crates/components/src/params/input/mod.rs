//! Params / Input: objects that hold a value for the user to change.

mod choice;
mod colours;
mod details;
mod dials;
mod files;
mod graph_mapper;
mod graphs;
mod image_sampler;
mod maps;
mod model;
mod molecules;
mod moments;
mod panel;
mod picture;
mod wheel;
