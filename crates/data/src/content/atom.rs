use std::sync::Arc;

use katydid_geometry::Point3;

/// An atom of a molecule, as files of the Protein Data Bank have it.
#[derive(Debug, Clone, PartialEq)]
pub struct Atom {
    /// Where it is, in ångström.
    pub point: Point3,
    /// The symbol of its element; empty when it is not known.
    pub element: Arc<str>,
    /// The chain that it belongs to.
    pub chain: Arc<str>,
    /// The residue that it belongs to.
    pub residue: Arc<str>,
    /// Its charge in elementary charges.
    pub charge: i32,
    /// How often it is found at this place, 0 to 1.
    pub occupancy: f64,
    /// Its temperature factor, in square ångström.
    pub temperature: f64,
    /// Its atomic number; 0 when it is not known.
    pub atomic_number: i32,
    /// Its number in the file.
    pub serial: i32,
    /// The number of its residue in the chain.
    pub residue_number: i32,
}
