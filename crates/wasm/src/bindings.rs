//! What JavaScript sees. Errors are thrown as `Error`s with the reason; structures travel as JSON, bytes and numbers as
//! typed arrays of their own.

use js_sys::{Array, Float64Array, Uint8Array};
use katydid_studio::{Form, Gallery, Wishes, catalogue};
use uuid::Uuid;
use wasm_bindgen::prelude::*;

use crate::{Message, Written};

#[wasm_bindgen]
extern "C" {
    /// The host hears how far a solve has come, while it is running; where it does not listen nothing happens.
    #[wasm_bindgen(js_namespace = globalThis, js_name = katydidProgress, catch)]
    fn host_progress(event: &str) -> Result<(), JsValue>;
}

#[wasm_bindgen]
extern "C" {
    #[wasm_bindgen(js_namespace = console, js_name = error)]
    fn console_error(text: &str);
}

/// What a fault says is written to the console before it ends the module, which by itself says no more than where.
#[wasm_bindgen(start)]
pub fn start() {
    std::panic::set_hook(Box::new(|fault| console_error(&fault.to_string())));
}

fn progress(event: &str) {
    let _ = host_progress(event);
}

fn thrown(reason: impl AsRef<str>) -> JsValue {
    js_sys::Error::new(reason.as_ref()).into()
}

fn json(value: &impl serde::Serialize) -> Result<String, JsValue> {
    serde_json::to_string(value).map_err(|error| thrown(error.to_string()))
}

fn form(extension: &str) -> Result<Form, JsValue> {
    Form::from_extension(extension)
        .ok_or_else(|| thrown(format!("'{extension}' is no form of a definition: gh, ghx or kd")))
}

fn wishes(text: &str) -> Result<Wishes, JsValue> {
    serde_json::from_str(text).map_err(|error| thrown(format!("this wish cannot be read: {error}")))
}

/// The version of Katydid.
#[wasm_bindgen]
pub fn version() -> String {
    env!("CARGO_PKG_VERSION").to_owned()
}

/// All components, as a JSON array.
#[wasm_bindgen]
pub fn components() -> String {
    katydid_components::link();
    catalogue::all().to_owned()
}

/// One component, or why there is none, as JSON; nothing where nobody knows it.
#[wasm_bindgen]
pub fn component(guid: &str) -> Option<String> {
    katydid_components::link();
    let found = catalogue::help(Uuid::try_parse(guid).ok()?)?;
    serde_json::to_string(&found).ok()
}

/// The definitions to start from, as a JSON array.
#[wasm_bindgen]
pub fn gallery() -> String {
    serde_json::to_string(Gallery::all()).unwrap_or_default()
}

/// The text of one of them.
#[wasm_bindgen(js_name = galleryText)]
pub fn gallery_text(id: &str) -> Option<Uint8Array> {
    Some(Uint8Array::from(Gallery::find(id)?.text()?.as_slice()))
}

/// A definition in another form.
#[wasm_bindgen]
pub fn convert(bytes: &[u8], to: &str) -> Result<Uint8Array, JsValue> {
    let opened = crate::open(crate::form_of(bytes), bytes).map_err(thrown)?;
    let (bytes, _) = katydid_studio::write(form(to)?, &opened.document).map_err(thrown)?;
    Ok(Uint8Array::from(bytes.as_slice()))
}

/// A small picture of a definition, as PNG; nothing where it makes too much.
#[wasm_bindgen]
pub fn portrait(bytes: &[u8]) -> Result<Option<Uint8Array>, JsValue> {
    let opened = crate::open(crate::form_of(bytes), bytes).map_err(thrown)?;
    let picture = katydid_studio::portrait(opened.document, crate::options(opened.rules));
    Ok(picture.map(|bytes| Uint8Array::from(bytes.as_slice())))
}

/// A definition that is opened, set, solved and read.
#[wasm_bindgen(js_name = Definition)]
#[derive(Debug)]
pub struct JsDefinition(crate::Definition);

#[wasm_bindgen(js_class = Definition)]
impl JsDefinition {
    /// Reads a definition in any of its forms.
    #[wasm_bindgen(constructor)]
    pub fn new(bytes: &[u8]) -> Result<Self, JsValue> {
        crate::Definition::open(bytes).map(Self).map_err(thrown)
    }

    /// The inputs that can be set, as JSON.
    pub fn inputs(&self) -> Result<String, JsValue> {
        json(&self.0.inputs())
    }

    /// The outputs of all objects, as JSON.
    pub fn outputs(&self) -> String {
        self.0.outputs()
    }

    /// Sets an input.
    pub fn set(&mut self, name: &str, value: &str) -> Result<String, JsValue> {
        self.0.set(name, value).map(|id| id.to_string()).map_err(thrown)
    }

    /// Solves what has changed; gives the milliseconds, and how many objects were solved and are left, as JSON.
    pub fn solve(&mut self, seconds: f64) -> String {
        self.0.limit_seconds(seconds);
        let done = self.0.solve();
        let milliseconds = done.time.as_secs_f64() * 1e3;
        serde_json::json!({"milliseconds": milliseconds, "solved": done.solved, "unfinished": done.unfinished})
            .to_string()
    }

    /// The results of all objects, as JSON.
    pub fn report(&self, values: bool) -> Result<String, JsValue> {
        json(&self.0.report(values))
    }

    /// What an output holds, without its items, as JSON.
    pub fn data(&self, name: &str) -> Result<String, JsValue> {
        json(&self.0.data(name).map_err(thrown)?)
    }

    /// The items of an output as texts, as a JSON array.
    pub fn texts(&self, name: &str) -> Result<String, JsValue> {
        self.0.texts(name).map_err(thrown)
    }

    /// The items of an output as numbers.
    pub fn numbers(&self, name: &str) -> Result<Float64Array, JsValue> {
        self.0.numbers(name).map(|all| Float64Array::from(all.as_slice())).map_err(thrown)
    }

    /// A file of what the definition makes, by wishes in JSON.
    pub fn export(&self, wish: &str) -> Result<Uint8Array, JsValue> {
        let (bytes, _) = self.0.export(&wishes(wish)?).map_err(thrown)?;
        Ok(Uint8Array::from(bytes.as_slice()))
    }

    /// The definition in a form.
    pub fn save(&self, to: &str) -> Result<Uint8Array, JsValue> {
        let bytes = self.0.save(form(to)?).map_err(thrown)?;
        Ok(Uint8Array::from(bytes.as_slice()))
    }
}

/// A document that one client works on, in the words of the studio's protocol.
#[wasm_bindgen(js_name = Document)]
#[derive(Debug)]
pub struct JsDocument(crate::Document);

#[wasm_bindgen(js_class = Document)]
impl JsDocument {
    /// Opens a definition, or an empty document; the journal is what was left of unsaved edits.
    #[wasm_bindgen(constructor)]
    pub fn new(name: &str, bytes: Option<Vec<u8>>, journal: Vec<u8>, locked: bool) -> Result<Self, JsValue> {
        crate::Document::open(name, bytes.as_deref(), journal, locked).map(Self).map_err(thrown)
    }

    /// The client joins.
    pub fn join(&mut self) {
        self.0.join();
    }

    /// Carries out a request.
    pub fn ask(&mut self, request: &str) {
        self.0.ask(request, progress);
    }

    /// Whether there is something to be done.
    #[wasm_bindgen(js_name = isDue)]
    pub fn is_due(&self) -> bool {
        self.0.is_due()
    }

    /// Does what is due.
    pub fn work(&mut self) {
        self.0.work(progress);
    }

    /// What the client is to be told: texts, and bytes of geometry.
    pub fn take(&mut self) -> Array {
        let message = |message| match message {
            Message::Text(text) => JsValue::from(text),
            Message::Binary(bytes) => Uint8Array::from(bytes.as_slice()).into(),
        };
        self.0.take().into_iter().map(message).collect()
    }

    /// What is to be written into the journal: `[isMore, bytes]` each.
    #[wasm_bindgen(js_name = takeWritten)]
    pub fn take_written(&mut self) -> Array {
        let write = |written| {
            let (is_more, bytes) = match written {
                Written::More(bytes) => (true, bytes),
                Written::Instead(bytes) => (false, bytes),
            };
            Array::of2(&is_more.into(), &Uint8Array::from(bytes.as_slice()))
        };
        self.0.take_written().into_iter().map(write).collect()
    }

    /// Writes what the journal has waiting long enough.
    pub fn tick(&mut self) {
        self.0.tick();
    }

    /// Writes all that the journal has waiting.
    pub fn flush(&mut self) {
        self.0.flush();
    }

    /// The name that is shown.
    pub fn name(&self) -> String {
        self.0.name().to_owned()
    }

    /// Whether it is other than it was saved.
    #[wasm_bindgen(js_name = isChanged)]
    pub fn is_changed(&self) -> bool {
        self.0.is_changed()
    }

    /// The document in a form.
    pub fn bytes(&self, to: &str) -> Result<Uint8Array, JsValue> {
        let bytes = self.0.bytes(form(to)?).map_err(thrown)?;
        Ok(Uint8Array::from(bytes.as_slice()))
    }

    /// It was saved in a file of that name.
    pub fn saved(&mut self, name: &str) {
        self.0.saved(name);
    }

    /// It is kept in a file of that name.
    #[wasm_bindgen(js_name = isKeptIn)]
    pub fn is_kept_in(&mut self, name: &str) {
        self.0.is_kept_in(name);
    }

    /// What was restored stays.
    #[wasm_bindgen(js_name = keepRestored)]
    pub fn keep_restored(&mut self) {
        self.0.keep_restored();
    }

    /// Puts a Rhino model beside it.
    pub fn attach(&mut self, name: &str, bytes: &[u8]) -> Result<(), JsValue> {
        self.0.attach(name, bytes).map_err(thrown)
    }

    /// A file of what it makes, by wishes in JSON. What is due is done first.
    pub fn export(&mut self, wish: &str) -> Result<Uint8Array, JsValue> {
        let wishes = wishes(wish)?;
        self.0.work(progress);
        let (bytes, _) = katydid_studio::export(self.0.engine(), &wishes).map_err(thrown)?;
        Ok(Uint8Array::from(bytes.as_slice()))
    }

    /// Geometry that is shown, by its hash.
    pub fn geometry(&self, hash: &str) -> Option<Uint8Array> {
        self.0.geometry(hash).map(Uint8Array::from)
    }

    /// A picture that it holds, with its media type: `[bytes, type]`.
    pub fn picture(&self, name: &str) -> Option<Array> {
        let (bytes, kind) = self.0.picture(name)?;
        Some(Array::of2(&Uint8Array::from(bytes.as_slice()), &kind.into()))
    }
}
