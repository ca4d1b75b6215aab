//! The functions of Graph Mappers, by their handles.

use katydid_data::Value;
use katydid_definition::archive::Chunk;
use katydid_definition::document::special::{Graph, GraphMapper};
use katydid_definition::document::{Document, Object, Persistent, Special, Stored, ids};
use katydid_elementary::Elementary;
use katydid_solver::{Engine, Options};
use uuid::{Uuid, uuid};

use super::{FACE, Row, finite};
use crate::Refusal;
use crate::protocol::{Control, GraphView};

/// How many points a function is drawn with.
const DRAWN: i32 = 64;

/// The most waves of a sum.
const MOST_WAVES: usize = 100;

pub(super) const GRAPH_MAPPER: Row = Row {
    components: &[ids::GRAPH_MAPPER],
    begin: |container| {
        let mut domain = Chunk::new("Domain");
        for (name, x) in [("x0", 0.0), ("x1", 1.0), ("y0", 0.0), ("y1", 1.0)] {
            domain.set(name, x);
        }
        let mut graph = Chunk::new("LocalGraph");
        graph.set("LockGrips", false);
        graph.set_child(domain);
        container.set_child(graph);
    },
    view: |object, special| {
        let Special::GraphMapper(mapper) = special else { return None };
        Some(Control::Graph {
            x: [mapper.x.start, mapper.x.end],
            y: [mapper.y.start, mapper.y.end],
            graph: view(&mapper),
            drawn: drawn(object, &mapper),
        })
    },
    shape: |object, control| {
        let Control::Graph { x, y, graph, .. } = control else { return Ok(false) };
        shape(object, *x, *y, graph)?;
        Ok(true)
    },
    size: |_, _| Some([150.0, 150.0]),
    ..FACE
};

/// Gives a Graph Mapper its ranges and its function.
fn shape(object: &mut Object, x: [f64; 2], y: [f64; 2], graph: &GraphView) -> Result<(), Refusal> {
    finite(&x)?;
    finite(&y)?;
    finite(graph.handles.as_flattened())?;
    let unfit =
        |reason: &str| Refusal::Unfit { object: object.title().to_owned(), reason: reason.to_owned() };
    let mut local =
        object.container().child("LocalGraph").cloned().unwrap_or_else(|| Chunk::new("LocalGraph"));
    let mut domain = local.child("Domain").cloned().unwrap_or_else(|| Chunk::new("Domain"));
    for (name, value) in [("x0", x[0]), ("x1", x[1]), ("y0", y[0]), ("y1", y[1])] {
        if domain.f64(name) != Some(value) {
            domain.set(name, value);
        }
    }
    local.set_child(domain);
    let name = local.child("Graph").and_then(|graph| graph.str("container_name")).unwrap_or_default();
    if graph.name.is_empty() {
        local.remove_children("Graph");
    } else {
        let mut chunk = match (local.child("Graph"), container(&graph.name)) {
            (Some(same), _) if name == graph.name => same.clone(),
            (_, Some(id)) => {
                let mut chunk = Chunk::new("Graph");
                chunk.set("container_id", id);
                chunk.set("container_name", graph.name.as_str());
                chunk
            }
            _ => return Err(unfit(&format!("how files name the function {} is not known", graph.name))),
        };
        let handles = if graph.handles.is_empty() { first(&graph.name) } else { graph.handles.clone() };
        // A function of another kind is kept as it is.
        if !handles.is_empty() {
            fill(&mut chunk, &graph.name, &handles).ok_or_else(|| unfit("the function has other handles"))?;
        }
        local.set_child(chunk);
    }
    object.container_mut().set_child(local);
    Ok(())
}

/// The id that Grasshopper has for a function: those that real files show.
fn container(name: &str) -> Option<Uuid> {
    Some(match name {
        "Bezier" => uuid!("7026a6d2-9b94-4314-b6d3-6850eff942fe"),
        "Gaussian" => uuid!("fc8a272c-7c77-4916-90d8-926409e00b74"),
        "Linear" => uuid!("71629651-0343-46d7-ac9e-d6041f9fe66b"),
        "Parabola" => uuid!("30d3a94f-e362-43f1-9ce1-2e2dabbf7265"),
        "Sine" => uuid!("7d54f77a-a866-49ed-95eb-b1f9fb25a1f1"),
        _ => return None,
    })
}

/// The handles of a function that was just chosen.
fn first(name: &str) -> Vec<[f64; 2]> {
    match name {
        "Bezier" => vec![[0.0, 0.0], [0.5, 0.0], [0.5, 1.0], [1.0, 1.0]],
        "Gaussian" => vec![[0.5, 0.9], [0.65, 0.45]],
        "Linear" => vec![[0.0, 0.0], [1.0, 1.0]],
        "Parabola" => vec![[0.5, 0.1], [0.9, 0.9]],
        "Sine" => vec![[0.25, 0.9], [0.75, 0.1]],
        _ => Vec::new(),
    }
}

/// Writes a function by its handles; none when it has other ones.
fn fill(chunk: &mut Chunk, name: &str, handles: &[[f64; 2]]) -> Option<()> {
    match (name, handles) {
        ("Bezier", [_, _, _, _]) => {
            for (k, [x, y]) in (0..).zip(handles) {
                chunk.set_at("cpx", k, *x);
                chunk.set_at("cpy", k, *y);
            }
        }
        ("Linear", [[_, y0], [_, y1]]) => {
            for (item, x) in [("A", y1 - y0), ("B", *y0), ("x0", 0.0), ("x1", 1.0), ("y0", *y0), ("y1", *y1)]
            {
                chunk.set(item, x);
            }
        }
        ("Parabola", [[ox, oy], [px, py]]) => {
            for (item, x) in [("Ox", ox), ("Oy", oy), ("Px", px), ("Py", py)] {
                chunk.set(item, *x);
            }
        }
        ("Sine", [_, _]) => {
            let mut equation = chunk.child("Equation").cloned().unwrap_or_else(|| Chunk::new("Equation"));
            wave(&mut equation, handles);
            chunk.set_child(equation);
        }
        ("Sine Summation", _)
            if !handles.is_empty() && handles.len().is_multiple_of(2) && handles.len() <= 2 * MOST_WAVES =>
        {
            chunk.remove_children("Equation");
            for (k, pair) in (0..).zip(handles.chunks(2)) {
                let mut equation = Chunk::indexed("Equation", k);
                wave(&mut equation, pair);
                chunk.set_child(equation);
            }
        }
        ("Gaussian", [[mean, factor], [side, _]]) => {
            for (item, x) in [("factor", *factor), ("mean", *mean), ("sdev", (side - mean).abs().max(1e-6))] {
                chunk.set(item, x);
            }
        }
        ("Perlin", [[frequency, amplitude], [decay, _], [x, y]]) => {
            for (item, value) in [
                ("amplitude", amplitude),
                ("decay", decay),
                ("frequency", frequency),
                ("x_offset", x),
                ("y_offset", y),
            ] {
                chunk.set(item, *value);
            }
        }
        ("Power", [[x, y], ..]) => {
            let power = power(*x, *y)?;
            for (item, value) in [("Gx", *x), ("Gy", *y), ("power", power)] {
                chunk.set(item, value);
            }
        }
        _ => return None,
    }
    Some(())
}

/// The exponent of the power through a point of the unit square.
fn power(x: f64, y: f64) -> Option<f64> {
    let power = y.logarithm() / x.logarithm();
    (x > 0.0 && x < 1.0 && y > 0.0 && y < 1.0 && power.is_finite()).then_some(power)
}

fn wave(equation: &mut Chunk, extremes: &[[f64; 2]]) {
    for (k, [x, y]) in (0..).zip(extremes) {
        equation.set_at("px", k, *x);
        equation.set_at("py", k, *y);
    }
}

/// The function of a Graph Mapper by the places of its handles.
fn view(mapper: &GraphMapper) -> GraphView {
    let (name, handles) = match &mapper.graph {
        None => ("", Vec::new()),
        Some(Graph::Bezier(points)) => ("Bezier", points.to_vec()),
        Some(Graph::Linear([start, end])) => ("Linear", vec![[0.0, *start], [1.0, *end]]),
        Some(Graph::Parabola { origin, point }) => ("Parabola", vec![*origin, *point]),
        Some(Graph::Sine(extremes)) => ("Sine", extremes.to_vec()),
        Some(Graph::SineSummation(waves)) => ("Sine Summation", waves.iter().flatten().copied().collect()),
        Some(Graph::Gaussian { mean, deviation, factor }) => {
            ("Gaussian", vec![[*mean, *factor], [mean + deviation, 0.5 * factor]])
        }
        Some(Graph::Perlin { amplitude, frequency, decay, offset }) => {
            ("Perlin", vec![[*frequency, *amplitude], [*decay, 0.0], *offset])
        }
        Some(Graph::Power { point, power }) => ("Power", vec![*point, [*power, 0.0]]),
        Some(Graph::Other(name, _)) => (name.as_str(), Vec::new()),
        Some(_) => ("Other", Vec::new()),
    };
    GraphView { name: name.to_owned(), handles }
}

/// The function as points of the unit square: the mapper itself is asked for them.
fn drawn(object: &Object, mapper: &GraphMapper) -> Vec<[f64; 2]> {
    let (x, y) = (mapper.x, mapper.y);
    let height = y.end - y.start;
    if mapper.graph.is_none() || !(x.end - x.start).is_finite() || !height.is_finite() || height == 0.0 {
        return Vec::new();
    }
    let at: Vec<f64> = (0..=DRAWN).map(|k| f64::from(k) / f64::from(DRAWN)).collect();
    let mut alone = object.clone();
    let values = at.iter().map(|t| Stored::Number(x.start + t * (x.end - x.start))).collect();
    let cleared =
        alone.set_sources(0, &[]).and_then(|()| alone.set_persistent(0, Some(&Persistent::list(values))));
    alone.set_locked(false);
    let mut document = Document::new();
    document.objects.push(alone);
    let mut engine = Engine::new(document, Options::default());
    engine.solve();
    let Some(tree) = engine.report(0).filter(|_| cleared.is_ok()).and_then(|report| report.outputs.first())
    else {
        return Vec::new();
    };
    let number = |value: Option<Value>| match value {
        Some(Value::Number(v)) => Some((v - y.start) / height),
        _ => None,
    };
    let points = at.iter().zip(tree.column().iter());
    points.filter_map(|(t, value)| Some([*t, number(value).filter(|v| v.is_finite())?])).collect()
}
