//! What the Galapagos object of a definition asks for.

use katydid_definition::document::{Document, Object, Special};

use super::goals::Goal;
use crate::reach::title_or_id;
use crate::{Output, StudyError, Variable};

/// The inputs that the definition's Galapagos object moves, the output that it looks at, and what that is to be.
///
/// # Errors
/// There is none, there are several, or it names no inputs or no output that is there.
pub fn galapagos(document: &Document) -> Result<(Vec<Variable>, Output, Goal), StudyError> {
    let unfit = |why: &str| StudyError::Unfit(why.to_owned());
    let mut all = document.objects.iter().filter_map(|object| match object.special() {
        Some(Special::Galapagos(galapagos)) => Some((object, galapagos)),
        _ => None,
    });
    let (solver, found) = all.next().ok_or_else(|| {
        unfit("nothing says what is to be small or large: name outputs, or add a Galapagos object to the definition")
    })?;
    if all.next().is_some() {
        return Err(unfit("the definition has several Galapagos objects: name the outputs instead"));
    }
    let lookup = document.lookup();
    let mut variables = Vec::new();
    for id in &found.genes {
        let of_port = || lookup.output(*id).map(|port| port.object);
        let index = lookup.object(*id).or_else(of_port);
        let index = index.ok_or_else(|| unfit("the Galapagos object moves a slider that is not there"))?;
        let Some(object) = document.objects.get(index) else { continue };
        let name = title_or_id(document, object);
        match object.special() {
            Some(Special::GenePool(pool)) => {
                for gene in 0..pool.values.len() {
                    variables.push(Variable::of(document, index, Some(gene), format!("{name}.{gene}"))?);
                }
            }
            _ => variables.push(Variable::of(document, index, None, name)?),
        }
    }
    if variables.is_empty() {
        return Err(unfit("the Galapagos object moves nothing: wire sliders to its genome"));
    }
    let fitness = found.fitness.ok_or_else(|| unfit("the Galapagos object has no fitness wired"))?;
    let output = Output::of_id(document, fitness)
        .ok_or_else(|| unfit("what the Galapagos object has for its fitness is not there"))?;
    let goal = match target(solver) {
        // What it stands at when nobody touched it.
        None => Goal::Most,
        Some(x) if x == f64::INFINITY => Goal::Most,
        Some(x) if x == f64::NEG_INFINITY => Goal::Least,
        Some(x) => Goal::Near(x),
    };
    Ok((variables, output, goal))
}

/// What the number is driven to, in the settings of a solver, which are a text in XML: `<Target>-Infinity</Target>`. An infinity is
/// for as large or as small as can be.
fn target(solver: &Object) -> Option<f64> {
    let settings = solver.container().child("GalapagosData")?.item("solver_settings")?.as_bytes()?;
    read_target(settings)
}

fn read_target(settings: &[u8]) -> Option<f64> {
    let text = String::from_utf8_lossy(settings);
    let (_, rest) = text.split_once("<Target>")?;
    let (number, _) = rest.split_once("</Target>")?;
    // Newer runtimes write the sign of infinity.
    let number: f64 = number.trim().replace('\u{221e}', "Infinity").parse().ok()?;
    (!number.is_nan()).then_some(number)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn targets_are_read() {
        let of =
            |text: &str| read_target(format!("<Galapagos><Target>{text}</Target></Galapagos>").as_bytes());
        assert_eq!(of("-Infinity"), Some(f64::NEG_INFINITY));
        assert_eq!(of("Infinity"), Some(f64::INFINITY));
        assert_eq!(of("-\u{221e}"), Some(f64::NEG_INFINITY));
        assert_eq!(of(" 2.5 "), Some(2.5));
        assert_eq!(of("NaN"), None);
        assert_eq!(of(""), None);
    }
}
