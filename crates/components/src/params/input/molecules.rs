//! Molecules from files of the Protein Data Bank.

use std::sync::Arc;

use katydid_component::{Context, Message, component};
use katydid_data::{Atom, Content, Tree, Value};
use katydid_exchange::pdb;
use katydid_geometry::{Line, Point3};

parameters! {
    /// Atoms of molecules, unchanged.
    atom, "a80395af-f134-4d6a-9b89-15edf3161619", "Atom", "Atom", "Params/Geometry", Generic;
}

/// Reads the atoms and bonds of a molecule from a file of the Protein Data Bank (.pdb). Lengths are in ångström.
///
/// Bonds are those that the file names; most files name those of small molecules only, since those of proteins follow
/// from their residues. A path that is not absolute starts where the definition lies.
#[component("383929c0-6515-4899-8b4b-3bd0d0b32471", name = "Import PDB", nick = "PDB", at = "Params/Input")]
#[output("Atoms", "A", "The atoms, in order.", kind = Generic)]
#[output("Bonds", "B", "The bonds, each a line between two atoms.")]
fn import_pdb(
    context: &Context<'_>,
    /// The path of the file.
    #[port("File", "F")]
    file: Arc<str>,
) -> Result<(Vec<Value>, Vec<Line>), Message> {
    let bytes = context.read_file(&file)?;
    let molecule = pdb::read(&bytes).map_err(|error| Message::error(format!("{file}: {error}")))?;
    context.items(molecule.atoms.len())?;
    context.items(molecule.bonds.len())?;
    if molecule.bonds.is_empty() {
        context.tell(Message::remark("The file names no bonds"));
    }
    let place = |k: usize| molecule.atoms.get(k).map(|atom| atom.point);
    let bonds = molecule.bonds.iter().filter_map(|[a, b]| Some(Line::new(place(*a)?, place(*b)?))).collect();
    Ok((molecule.atoms.iter().map(value).collect(), bonds))
}

fn value(atom: &pdb::Atom) -> Value {
    Value::from(Atom {
        point: atom.point,
        element: Arc::from(atom.element.as_str()),
        chain: Arc::from(atom.chain.as_str()),
        residue: Arc::from(atom.residue.as_str()),
        charge: atom.charge,
        occupancy: atom.occupancy,
        temperature: atom.temperature,
        atomic_number: pdb::atomic_number(&atom.element).unwrap_or(0),
        serial: atom.serial,
        residue_number: atom.residue_number,
    })
}

/// What is known of an atom.
///
/// What the file does not tell is an empty text or 0.
#[component("7b371d04-53e3-47d8-b3dd-7b113c48bc59", name = "Atom Data", nick = "Atom", at = "Params/Input")]
#[output("Point", "P", "Where it is, in ångström.")]
#[output("Element", "E", "The symbol of its element.")]
#[output("Chain", "C", "The chain that it belongs to.")]
#[output("Residue", "R", "The residue that it belongs to.")]
#[output("Charge", "e", "Its charge in elementary charges.")]
#[output("Occupancy", "O", "How often it is found at this place, 0 to 1.")]
#[output("Temperature", "T", "Its temperature factor, in square ångström.")]
#[output("Atomic Number", "AN", "The number of its element.")]
#[output("Serial Number", "SN", "Its number in the file.")]
#[output("Residue Number", "RN", "The number of its residue in the chain.")]
#[expect(clippy::type_complexity, reason = "the outputs of the component")]
fn atom_data(
    /// The atom, from Import PDB.
    #[port("Atom", "A")]
    atom: Value,
) -> Result<(Point3, Arc<str>, Arc<str>, Arc<str>, i32, f64, f64, i32, i32, i32), Message> {
    let found = match &atom {
        Value::Content(content) => match &**content {
            Content::Atom(atom) => Some(atom),
            _ => None,
        },
        _ => None,
    };
    let atom = found.ok_or_else(|| Message::error(format!("A {} is no atom", atom.kind())))?;
    Ok((
        atom.point,
        atom.element.clone(),
        atom.chain.clone(),
        atom.residue.clone(),
        atom.charge,
        atom.occupancy,
        atom.temperature,
        atom.atomic_number,
        atom.serial,
        atom.residue_number,
    ))
}

#[cfg(test)]
mod tests {
    use katydid_component::Files;
    use katydid_component::testing::{Trial, texts};

    #[test]
    fn a_molecule_comes_apart() {
        let folder = std::env::temp_dir().join(format!("katydid-molecule-{}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        let file = "\
ATOM      1  N   GLY A   5      11.104   6.134  -6.504  1.00 12.50           N  
HETATM    2 FE   HEM B 142      -1.000   0.000   2.500  0.50  0.00          FE2+
CONECT    1    2
";
        std::fs::write(folder.join("m.pdb"), file).unwrap();
        let trial = || Trial::of("Import PDB").files(Files::Inside(folder.clone())).item("m.pdb");
        let out = trial().run();
        assert_eq!(texts(&out.outputs[0]), ["{0;0}: Atom (N), Atom (Fe)"]);
        assert_eq!(out.outputs[1].item_count(), 1);
        let data = Trial::of("Atom Data").tree(out.outputs[0].clone()).run();
        let shown: Vec<String> = data.outputs.iter().flat_map(texts).collect();
        let expected = [
            "{0;0}: {11.104, 6.134, -6.504}, {-1, 0, 2.5}",
            "{0;0}: N, Fe",
            "{0;0}: A, B",
            "{0;0}: GLY, HEM",
            "{0;0}: 0, 2",
            "{0;0}: 1, 0.5",
            "{0;0}: 12.5, 0",
            "{0;0}: 7, 26",
            "{0;0}: 1, 2",
            "{0;0}: 5, 142",
        ];
        assert_eq!(shown, expected);
        assert_eq!(Trial::of("Atom").tree(out.outputs[0].clone()).texts(0), ["{0;0}: Atom (N), Atom (Fe)"]);
        assert_eq!(Trial::of("Atom Data").item(1.0).message(), "A Number is no atom");
        std::fs::remove_dir_all(&folder).unwrap();
    }
}
