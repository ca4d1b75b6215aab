//! Reading files of the Protein Data Bank (.pdb): atoms and the bonds between them.
//!
//! "Protein Data Bank Contents Guide: Atomic Coordinate Entry Format Description", version 3.30 (wwPDB, 2012): each line is
//! a record of fixed columns.

use std::collections::HashMap;

use katydid_geometry::Point3;

use crate::{Error, Result};

const FORMAT: &str = "PDB";

/// An atom of a molecule.
#[derive(Debug, Clone, PartialEq)]
pub struct Atom {
    /// Where it is, in ångström.
    pub point: Point3,
    /// The symbol of its element, `Fe` say; empty when the file does not tell.
    pub element: String,
    /// The chain that it belongs to.
    pub chain: String,
    /// The residue that it belongs to, `GLY` say.
    pub residue: String,
    /// Its charge in elementary charges.
    pub charge: i32,
    /// How often it is found at this place, 0 to 1.
    pub occupancy: f64,
    /// Its temperature factor, in square ångström.
    pub temperature: f64,
    /// Its number in the file.
    pub serial: i32,
    /// The number of its residue in the chain.
    pub residue_number: i32,
}

/// What such a file holds.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Molecule {
    /// The atoms, in order.
    pub atoms: Vec<Atom>,
    /// Pairs of atoms that the file says are bound, each pair once, the one that comes first first.
    pub bonds: Vec<[usize; 2]>,
}

/// The symbols of the elements, in order of their atomic numbers.
const ELEMENTS: [&str; 118] = [
    "H", "He", "Li", "Be", "B", "C", "N", "O", "F", "Ne", "Na", "Mg", "Al", "Si", "P", "S", "Cl", "Ar", "K",
    "Ca", "Sc", "Ti", "V", "Cr", "Mn", "Fe", "Co", "Ni", "Cu", "Zn", "Ga", "Ge", "As", "Se", "Br", "Kr",
    "Rb", "Sr", "Y", "Zr", "Nb", "Mo", "Tc", "Ru", "Rh", "Pd", "Ag", "Cd", "In", "Sn", "Sb", "Te", "I", "Xe",
    "Cs", "Ba", "La", "Ce", "Pr", "Nd", "Pm", "Sm", "Eu", "Gd", "Tb", "Dy", "Ho", "Er", "Tm", "Yb", "Lu",
    "Hf", "Ta", "W", "Re", "Os", "Ir", "Pt", "Au", "Hg", "Tl", "Pb", "Bi", "Po", "At", "Rn", "Fr", "Ra",
    "Ac", "Th", "Pa", "U", "Np", "Pu", "Am", "Cm", "Bk", "Cf", "Es", "Fm", "Md", "No", "Lr", "Rf", "Db",
    "Sg", "Bh", "Hs", "Mt", "Ds", "Rg", "Cn", "Nh", "Fl", "Mc", "Lv", "Ts", "Og",
];

/// The atomic number of an element by its symbol, in letters of any case; deuterium and tritium are hydrogen.
pub fn atomic_number(symbol: &str) -> Option<i32> {
    if ["D", "T"].iter().any(|isotope| symbol.eq_ignore_ascii_case(isotope)) {
        return Some(1);
    }
    let k = ELEMENTS.iter().position(|known| known.eq_ignore_ascii_case(symbol))?;
    i32::try_from(k + 1).ok()
}

/// The columns from one to another, counted from 1 as in the format's description, without blanks around.
fn columns(line: &[u8], from: usize, to: usize) -> &str {
    let end = to.min(line.len());
    let found = line.get(from - 1..end).unwrap_or_default();
    std::str::from_utf8(found).unwrap_or_default().trim()
}

/// Reads such a file. Lines of other records are passed over.
///
/// # Errors
/// When there is no atom, or one without coordinates.
pub fn read(bytes: &[u8]) -> Result<Molecule> {
    let mut molecule = Molecule::default();
    // A file may hold several models of one molecule, whose atoms have the same numbers.
    let mut models: Vec<HashMap<i32, usize>> = vec![HashMap::new()];
    let mut pairs: Vec<[i32; 2]> = Vec::new();
    for (number, line) in bytes.split(|byte| *byte == b'\n').enumerate() {
        match columns(line, 1, 6) {
            "ATOM" | "HETATM" => {
                let wrong = |why| Error::malformed(FORMAT, format!("line {}", number + 1), why);
                let atom = atom(line).ok_or_else(|| wrong("an atom has no coordinates"))?;
                if let Some(model) = models.last_mut() {
                    model.entry(atom.serial).or_insert(molecule.atoms.len());
                }
                molecule.atoms.push(atom);
            }
            "MODEL" => models.push(HashMap::new()),
            "CONECT" => {
                let serial = |k: usize| columns(line, 7 + 5 * k, 11 + 5 * k).parse::<i32>().ok();
                if let Some(from) = serial(0) {
                    pairs.extend((1..5).filter_map(serial).map(|to| [from, to]));
                }
            }
            _ => {}
        }
    }
    if molecule.atoms.is_empty() {
        return Err(Error::malformed(FORMAT, "the whole file", "it has no atoms"));
    }
    let partners = partners(&pairs);
    for model in &models {
        let mut bonds: Vec<[usize; 2]> = Vec::new();
        for (serial, &a) in model {
            let Some(partners) = partners.get(serial) else { continue };
            // The shorter way round: neither many models nor an atom with many bonds makes this long.
            if partners.len() <= model.len() {
                bonds.extend(partners.iter().filter_map(|other| model.get(other)).map(|&b| [a, b]));
            } else {
                let bound = model.iter().filter(|(other, _)| partners.binary_search(other).is_ok());
                bonds.extend(bound.map(|(_, &b)| [a, b]));
            }
        }
        // Both ends told of each.
        bonds.retain(|[a, b]| a < b);
        bonds.sort_unstable();
        molecule.bonds.extend(bonds);
    }
    Ok(molecule)
}

/// Those that each atom is bound to, by their numbers, each once: a bond may be told from both its ends, and a double one
/// is told twice.
fn partners(pairs: &[[i32; 2]]) -> HashMap<i32, Vec<i32>> {
    let mut partners: HashMap<i32, Vec<i32>> = HashMap::new();
    for &[a, b] in pairs {
        partners.entry(a).or_default().push(b);
        partners.entry(b).or_default().push(a);
    }
    for others in partners.values_mut() {
        others.sort_unstable();
        others.dedup();
    }
    partners
}

fn atom(line: &[u8]) -> Option<Atom> {
    let number = |from, to| columns(line, from, to).parse::<f64>().ok().filter(|x| x.is_finite());
    let whole = |from, to| columns(line, from, to).parse::<i32>().ok();
    Some(Atom {
        point: Point3::new(number(31, 38)?, number(39, 46)?, number(47, 54)?),
        element: element(line),
        chain: columns(line, 22, 22).to_owned(),
        residue: columns(line, 18, 20).to_owned(),
        charge: charge(columns(line, 79, 80)),
        occupancy: number(55, 60).unwrap_or(1.0),
        temperature: number(61, 66).unwrap_or(0.0),
        serial: whole(7, 11).unwrap_or(0),
        residue_number: whole(23, 26).unwrap_or(0),
    })
}

/// The element by its own columns; in older files by the first two of the atom's name, where it is set right.
fn element(line: &[u8]) -> String {
    let known = |symbol: &str| {
        let symbol = symbol.trim_matches(|c: char| !c.is_ascii_alphabetic());
        let k = usize::try_from(atomic_number(symbol)?).ok()?;
        Some(ELEMENTS.get(k.checked_sub(1)?)?.to_string())
    };
    if let Some(element) = known(columns(line, 77, 78)) {
        return element;
    }
    // Names of four letters begin a column early: those of hydrogens.
    let name = columns(line, 13, 16);
    let found =
        if name.len() == 4 && name.starts_with('H') { known("H") } else { known(columns(line, 13, 14)) };
    found.unwrap_or_default()
}

/// A charge such as `2+` or `1-`.
fn charge(text: &str) -> i32 {
    let digits = text.trim_end_matches(['+', '-']);
    let size = digits.parse().unwrap_or(0);
    if text.ends_with('-') { -size } else { size }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two atoms of a glycine, an iron ion, and the bond between the first two, set by the format's description.
    const FILE: &str = "\
HEADER    A TEST
ATOM      1  N   GLY A   5      11.104   6.134  -6.504  1.00 12.50           N  
ATOM      2  CA  GLY A   5      11.639   6.071  -5.147  0.50 13.25           C  
HETATM    3 FE   HEM B 142      -1.000   0.000   2.500  1.00  0.00          FE2+
CONECT    1    2    2
CONECT    2    1    9
END
";

    #[test]
    fn atoms_and_bonds() {
        let molecule = read(FILE.as_bytes()).unwrap();
        let [n, ca, fe] = molecule.atoms.as_slice() else { panic!("{molecule:?}") };
        assert_eq!(n.point, Point3::new(11.104, 6.134, -6.504));
        assert_eq!((n.element.as_str(), n.chain.as_str(), n.residue.as_str()), ("N", "A", "GLY"));
        assert_eq!((n.serial, n.residue_number, n.charge), (1, 5, 0));
        assert_eq!((ca.occupancy, ca.temperature, ca.element.as_str()), (0.5, 13.25, "C"));
        assert_eq!((fe.element.as_str(), fe.charge, fe.residue_number), ("Fe", 2, 142));
        assert_eq!(molecule.bonds, [[0, 1]]);
    }

    #[test]
    fn models_are_bound_each_in_itself() {
        let atoms: String =
            FILE.lines().filter(|line| line.contains("GLY")).map(|l| format!("{l}\n")).collect();
        let file =
            format!("MODEL        1\n{atoms}ENDMDL\nMODEL        2\n{atoms}ENDMDL\nCONECT    1    2\n");
        let molecule = read(file.as_bytes()).unwrap();
        assert_eq!((molecule.atoms.len(), molecule.bonds), (4, vec![[0, 1], [2, 3]]));
    }

    #[test]
    fn old_and_broken_lines() {
        // Without the columns of the element, its symbol stands in the first two of the name.
        let line = "ATOM     10  CA  ALA     1       0.000   0.000   0.000\n";
        let calcium = "HETATM   11 CA    CA     2       0.000   0.000   0.000\n";
        let molecule = read(format!("{line}{calcium}").as_bytes()).unwrap();
        assert_eq!(molecule.atoms[0].element, "C");
        assert_eq!(molecule.atoms[1].element, "Ca");
        let hydrogen = "ATOM     12 HG21 VAL     3       0.000   0.000   0.000\n";
        assert_eq!(read(hydrogen.as_bytes()).unwrap().atoms[0].element, "H");
        assert_eq!(molecule.atoms[0].occupancy, 1.0);
        let error = |text: &str| read(text.as_bytes()).unwrap_err().to_string();
        assert!(error("ATOM      1\n").contains("line 1: an atom has no coordinates"));
        let endless = "ATOM      1  N   GLY A   5         inf   6.134  -6.504\n";
        assert!(error(endless).contains("no coordinates"));
        assert!(error("").contains("no atoms"));
        assert_eq!((charge("3-"), charge(""), charge("+")), (-3, 0, 0));
    }

    #[test]
    fn elements_by_number() {
        assert_eq!(["H", "he", "FE", "U", "Og", "d"].map(atomic_number), [1, 2, 26, 92, 118, 1].map(Some));
        assert_eq!((atomic_number(""), atomic_number("Xx")), (None, None));
    }
}
