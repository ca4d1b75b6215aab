//! Reads an archive and writes it as another version: `convert IN.3dm OUT.3dm VERSION`.
//!
//! Prints the places of the objects that were carried over, as a JSON array (lights count on behind the objects),
//! or null when the archive cannot be read; what could not be carried goes to the error stream.

use katydid_3dm::{Limits, Model, ModelObject};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [input, output, version] = arguments.as_slice() else {
        return Err("usage: convert IN.3dm OUT.3dm VERSION".into());
    };
    let version = version.parse()?;
    let mut model = match Model::read(&std::fs::read(input)?, &Limits::default()) {
        Ok(model) => model,
        Err(error) => {
            eprintln!("{input}: {error}");
            println!("null");
            return Ok(());
        }
    };
    let mut carried: Vec<usize> = Vec::new();
    let mut place = 0;
    let mut keep = |object: &ModelObject| {
        let fits = object.geometry.check_writable(version);
        match &fits {
            Ok(()) => carried.push(place),
            Err(error) => eprintln!("object {place}: {error}"),
        }
        place += 1;
        fits.is_ok()
    };
    model.objects.retain(&mut keep);
    model.lights.retain(&mut keep);
    model.write_to(version, &mut std::fs::File::create(output)?)?;
    println!("{carried:?}");
    Ok(())
}
