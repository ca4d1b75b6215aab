//! Breps.

use katydid_3dm::{BrepSummary, RawObject};
use serde_json::{Value, json};

use crate::curve::curve;
use crate::numbers::{point, points};
use crate::surface::surface;

pub(crate) fn brep(raw: &RawObject) -> Value {
    match BrepSummary::read(raw) {
        Ok(brep) => {
            let curves: Vec<Value> = brep.curves.iter().map(curve).collect();
            let edges: Vec<Value> = (brep.edges.iter().enumerate())
                .map(|(i, e)| {
                    let points: Vec<_> =
                        [0.0, 0.3, 1.0].map(|x| brep.edge_point(i, e.domain.at(x)).map(point)).into();
                    json!({"domain": [e.domain.start, e.domain.end], "trims": e.trims, "points": points})
                })
                .collect();
            json!({"faces": brep.faces, "vertices": points(&brep.vertices), "curves": curves,
            "bare": raw.untrimmed_surface().ok().flatten().as_ref().map(surface),
            "edges": edges, "closed": brep.is_closed(), "solidity": format!("{:?}", brep.solidity)})
        }
        Err(error) => json!({"brep_error": error.to_string()}),
    }
}
