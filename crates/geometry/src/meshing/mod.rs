//! Meshes of surfaces and breps within tolerances.

mod bend;
mod brep;
mod clip;
mod corner_cutting;
mod edges;
mod extent;
mod fill;
mod grid;
mod kinks;
mod mend;
mod need;
mod net;
mod outline;
mod patch;
mod plan;
mod probes;
mod result;
mod ring;
mod settings;
mod side;
mod surface;
mod thresholds;
mod track;

pub use plan::MeshPlan;
pub use result::{BrepMesh, FaceMesh};
pub use settings::MeshSettings;
