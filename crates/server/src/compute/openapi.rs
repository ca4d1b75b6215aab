//! The description of the addresses that programs read, and the page that people read and try.

use axum::http::header::{CACHE_CONTROL, CONTENT_SECURITY_POLICY};
use serde_json::{Map, Value, json};

use super::route::{ADDRESSES, Address, Route};
use super::sent::{HTML, JSON, Page, Sent};

const PAGE: &str = include_str!("docs.html");
/// The page loads nothing, from nowhere; it asks only the server that it came from.
const POLICY: &str = "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; \
    connect-src 'self'; img-src data:; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

/// The page.
pub(crate) fn page(packs: bool) -> Sent {
    static KEPT: Page = Page::new();
    let make = || Sent::new(HTML, PAGE).with(CONTENT_SECURITY_POLICY, POLICY).with(CACHE_CONTROL, "no-cache");
    KEPT.sent(packs, make)
}

/// The OpenAPI document.
pub(crate) fn document(packs: bool) -> Sent {
    static KEPT: Page = Page::new();
    KEPT.sent(packs, || Sent::new(JSON, written().to_string()))
}

fn written() -> Value {
    let mut paths: Map<String, Value> = Map::new();
    for address in ADDRESSES {
        let path = address.path.replace("**", "{path}");
        let operations = paths.entry(path).or_insert_with(|| json!({}));
        for method in address.methods {
            operations[method.to_ascii_lowercase()] = operation(address, method);
        }
    }
    json!({
        "openapi": "3.1.0",
        "info": {
            "title": "Katydid compute",
            "version": env!("CARGO_PKG_VERSION"),
            "description": "Solves Grasshopper definitions and calls functions of geometry, as Rhino.Compute does. \
                Paths and names are matched in any case; no content type is needed; bodies may be packed with gzip.",
            "license": {"name": "MIT OR Apache-2.0"},
        },
        "security": [{"key": []}, {}],
        "paths": paths,
        "components": {
            "securitySchemes": {"key": {"type": "apiKey", "in": "header", "name": "RhinoComputeKey"}},
            "schemas": schemas(),
        },
    })
}

fn operation(address: &Address, method: &str) -> Value {
    let mut answers = Map::new();
    let mut parameters: Vec<Value> = Vec::new();
    if address.path.contains('{') {
        parameters.push(parameter("id", "path", "The job, as POST /jobs has named it", "string"));
    }
    if address.path.contains("**") {
        parameters.push(parameter("path", "path", "The rest of the path", "string"));
    }
    let solves = matches!(address.route, Route::Grasshopper | Route::Jobs);
    if matches!(address.route, Route::Grasshopper | Route::JobResult) {
        let text = "A file in place of JSON: glb, gltf, obj, ply, step, stl, svg or 3dm";
        parameters.push(parameter("format", "query", text, "string"));
    }
    if address.route == Route::Health {
        let text =
            "json for an object with the status, the reason, and how many solves run, wait and do not stop";
        parameters.push(parameter("format", "query", text, "string"));
    }
    if solves {
        for (name, text) in [
            ("seconds", "The most time that the solve may take, when less than the server allows"),
            ("items", "The most items that one object may put out, when fewer than the server allows"),
            (
                "bytes",
                "The most bytes that the items of one object may take, when fewer than the server allows",
            ),
        ] {
            parameters.push(parameter(name, "query", text, "number"));
        }
    }
    if address.route == Route::Io && method == "GET" {
        parameters.push(parameter(
            "pointer",
            "query",
            "A key from an earlier reply, or an address",
            "string",
        ));
    }
    let (status, content) = answer(address.route, method);
    answers.insert(status.to_owned(), json!({"description": address.what, "content": content}));
    for (status, text) in [
        ("400", "The request makes no sense"),
        ("408", "The time limit is over"),
        ("413", "The request is too large, or too much came out"),
        ("503", "Too much waits; Retry-After tells when to try again"),
    ] {
        if solves || (address.methods.contains(&"POST") && method == "POST") {
            answers.insert(status.to_owned(), refused(text));
        }
    }
    if !address.is_open {
        let content = json!({"text/plain": {"schema": {"type": "string"}}});
        answers.insert(
            "401".to_owned(),
            json!({"description": "The key is missing or wrong", "content": content}),
        );
    }
    if solves {
        let content = json!({"application/json": {"schema": {"$ref": "#/components/schemas/Reply"}}});
        let text = "A component reported an error: the results are there all the same";
        answers.insert("500".to_owned(), json!({"description": text, "content": content}));
    }
    let mut operation = json!({
        "operationId": format!("{}{:?}", method.to_ascii_lowercase(), address.route),
        "summary": address.what,
        "parameters": parameters,
        "responses": answers,
    });
    if method == "POST" {
        let schema = match address.route {
            Route::Grasshopper | Route::Io | Route::Jobs => json!({"$ref": "#/components/schemas/Request"}),
            Route::Geometry => json!({"type": "array", "items": {}}),
            _ => json!({}),
        };
        operation["requestBody"] =
            json!({"required": true, "content": {"application/json": {"schema": schema}}});
    }
    if address.is_open {
        operation["security"] = json!([]);
    }
    operation
}

fn parameter(name: &str, place: &str, text: &str, kind: &str) -> Value {
    json!({
        "name": name, "in": place, "required": place == "path", "description": text, "schema": {"type": kind},
    })
}

fn refused(text: &str) -> Value {
    let content = json!({"application/json": {"schema": {"$ref": "#/components/schemas/Refusal"}}});
    json!({"description": text, "content": content})
}

/// The status and the content of what is answered when all is well.
fn answer(route: Route, method: &str) -> (&'static str, Value) {
    let json_of = |name: &str| json!({"application/json": {"schema": {"$ref": format!("#/components/schemas/{name}")}}});
    let text = json!({"text/plain": {"schema": {"type": "string"}}});
    match route {
        Route::Grasshopper | Route::JobResult => ("200", json_of("Reply")),
        Route::Io => ("200", json_of("Description")),
        Route::Jobs => ("202", json_of("Job")),
        Route::Job => ("200", json_of("Job")),
        Route::JobEvents => ("200", json!({"text/event-stream": {"schema": {"type": "string"}}})),
        Route::Sdk | Route::Docs => ("200", json!({"text/html": {"schema": {"type": "string"}}})),
        Route::Geometry if method == "GET" => ("200", json!({"text/html": {"schema": {"type": "string"}}})),
        Route::Script => ("403", json_of("Refusal")),
        Route::SdkSource => ("501", json_of("Refusal")),
        Route::Version | Route::Time | Route::RhinoPlugins | Route::GrasshopperPlugins => {
            ("200", json!({"application/json": {"schema": {}}}))
        }
        Route::Geometry | Route::OpenApi => ("200", json!({"application/json": {"schema": {}}})),
        _ => ("200", text),
    }
}

fn schemas() -> Value {
    let text = json!({"type": "string"});
    let texts = json!({"type": "array", "items": text});
    let tree = json!({"$ref": "#/components/schemas/Tree"});
    json!({
        "Tree": {
            "type": "object",
            "description": "The values of one input or output: branches by their paths",
            "properties": {
                "ParamName": text,
                "InnerTree": {
                    "type": "object",
                    "description": "Paths as 0, 0;1 or {0;1}",
                    "additionalProperties": {"type": "array", "items": {
                        "type": "object",
                        "properties": {
                            "type": {"type": "string", "description": "Not looked at in requests"},
                            "data": {"description": "JSON, as it is or in a text"},
                        },
                    }},
                },
            },
        },
        "Request": {
            "type": "object",
            "properties": {
                "algo": {"type": ["string", "null"], "description": "A .gh or .ghx file in base64"},
                "pointer": {"type": ["string", "null"],
                    "description": "md5_… from an earlier reply, an address of a host that the server may ask, or the path of a file below its folders of definitions"},
                "values": {"type": "array", "items": tree},
                "absolutetolerance": {"type": "number"},
                "angletolerance": {"type": "number", "description": "In degrees"},
                "modelunits": {"type": "string", "examples": ["Millimeters"]},
                "model": {"type": ["string", "null"],
                    "description": "The .3dm file that the definition looks into, in base64; its unit and tolerances count"},
                "alltypes": {"type": "boolean",
                    "description": "Replies with items of types too that clients of Rhino.Compute do not know"},
                "dataversion": {"type": "integer", "enum": [6, 7, 8]},
                "cachesolve": {"type": "boolean"},
                "recursionlevel": {"type": "integer"},
            },
        },
        "Reply": {
            "type": "object",
            "properties": {
                "modelunits": text, "dataversion": {"type": "integer"}, "algo": text,
                "pointer": {"type": "string", "description": "Names the definition in later requests"},
                "cachesolve": {"type": "boolean"},
                "values": {"type": "array", "items": tree},
                "warnings": texts, "errors": texts,
            },
        },
        "Description": {
            "type": "object",
            "properties": {
                "Description": text, "CacheKey": text, "InputNames": texts, "OutputNames": texts,
                "Inputs": {"type": "array", "items": {"type": "object"}},
                "Outputs": {"type": "array", "items": {"type": "object"}},
                "Warnings": texts, "Errors": texts,
            },
        },
        "Job": {
            "type": "object",
            "required": ["id", "state", "seconds"],
            "properties": {
                "id": text,
                "state": {"type": "string", "enum": ["waiting", "running", "done", "failed", "cancelled"]},
                "seconds": {"type": "number"},
                "progress": {"type": "object", "properties": {
                    "done": {"type": "integer"}, "total": {"type": "integer"}, "name": text,
                }},
                "hasErrors": {"type": "boolean"}, "result": text, "error": text, "cause": text,
            },
        },
        "Refusal": {
            "type": "object",
            "required": ["error"],
            "properties": {"error": text, "cause": text, "errors": texts},
        },
    })
}
