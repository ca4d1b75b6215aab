//! What answers a script's calls.

use std::io::{Read, Write};

use katydid_component::{Cancel, Limits};

use crate::codec::{self, decode, encode};
use crate::geometry::{Waiting, endpoints};
use crate::{Cause, Fault, Handles, Value};

/// One call of a member.
#[derive(Debug, Clone, PartialEq)]
pub struct Call {
    /// `Class.Member`.
    pub member: String,
    /// The arguments; the object first where the member belongs to one.
    pub arguments: Vec<Value>,
}

impl Call {
    /// A call of `Class.Member`.
    pub fn new(member: impl Into<String>, arguments: Vec<Value>) -> Self {
        Self { member: member.into(), arguments }
    }
}

/// The components that scripts can run.
pub trait Registry: Send {
    /// All of them, with their ports.
    fn components(&self) -> Value;

    /// Runs one, by its identifier or its name; a value for each input, null for what is not given.
    ///
    /// # Errors
    /// There is no such component, or the inputs are no inputs of it.
    fn run(&self, name: &str, inputs: &[Value], limits: &Limits, cancel: &Cancel) -> Result<Value, Fault>;
}

/// Answers the calls of one script's process, and holds its geometry.
pub struct Host {
    handles: Handles,
    limits: Limits,
    cancel: Cancel,
    registry: Option<Box<dyn Registry>>,
}

impl std::fmt::Debug for Host {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Host").field("held", &self.handles.len()).finish_non_exhaustive()
    }
}

impl Default for Host {
    fn default() -> Self {
        Self::new()
    }
}

impl Host {
    /// A host that holds nothing, without limits and components.
    pub fn new() -> Self {
        Self {
            handles: Handles::default(),
            limits: Limits::default(),
            cancel: Cancel::default(),
            registry: None,
        }
    }

    /// With components that scripts can run.
    #[must_use]
    pub fn with_registry(self, registry: impl Registry + 'static) -> Self {
        Self { registry: Some(Box::new(registry)), ..self }
    }

    /// What each call may use from now on, and what stops it.
    pub fn bound(&mut self, limits: Limits, cancel: Cancel) {
        self.limits = limits;
        self.cancel = cancel;
    }

    /// The geometry that the script holds.
    pub fn handles(&mut self) -> &mut Handles {
        &mut self.handles
    }

    fn waiting(&self) -> Waiting {
        Waiting::new(&self.limits, None, &self.cancel)
    }

    /// Calls a member. An object that it changes is changed here.
    ///
    /// # Errors
    /// As [`Endpoints::call_member`](crate::geometry::Endpoints::call_member).
    pub fn call(&mut self, call: &Call) -> Result<Value, Fault> {
        let reply = endpoints().call_member(&call.member, &call.arguments, &self.waiting())?;
        if let (Some(changed), Some(Value::Geometry(object))) = (reply.changed, call.arguments.first()) {
            self.handles.set(object.id, changed);
        }
        Ok(reply.value)
    }

    /// The value that bytes are.
    ///
    /// # Errors
    /// The bytes are no value, or name geometry that is not held.
    pub fn decode(&self, bytes: &[u8]) -> Result<Value, codec::Error> {
        decode(bytes, &self.handles)
    }

    /// The bytes of a value; its geometry is held from now on.
    ///
    /// # Errors
    /// The script holds too much.
    pub fn encode(&mut self, value: &Value) -> Result<Vec<u8>, Fault> {
        encode(value, &mut self.handles)
    }

    /// Answers a message; `None` for one that has no answer.
    pub fn answer(&mut self, message: &[u8]) -> Option<Vec<u8>> {
        let outcome = match self.decode(message) {
            Ok(message) => self.respond(message)?,
            Err(error) => Err(Fault::bad_request(error.to_string())),
        };
        Some(self.reply(outcome))
    }

    /// Answers a message that is decoded already, as bytes; `None` for one that has no answer.
    pub fn respond_to(&mut self, message: Value) -> Option<Vec<u8>> {
        let outcome = match message {
            Value::Error(_, what) => Err(Fault::bad_request(what)),
            message => self.respond(message)?,
        };
        Some(self.reply(outcome))
    }

    /// An outcome as the bytes of an answer.
    fn reply(&mut self, outcome: Result<Value, Fault>) -> Vec<u8> {
        let answer = match outcome {
            Ok(value) => Value::List(vec!["ok".into(), value]),
            Err(fault) => error(&fault),
        };
        self.encode(&answer).unwrap_or_else(|fault| {
            // An error has no geometry in it: it can be written.
            encode(&error(&fault), &mut Handles::default()).unwrap_or_default()
        })
    }

    /// Answers what a script's process asks; `None` for what has no answer.
    pub fn respond(&mut self, message: Value) -> Option<Result<Value, Fault>> {
        let mut words = match message {
            Value::List(words) => words.into_iter(),
            other => return Some(Err(Fault::bad_request(format!("{} is no request", other.noun())))),
        };
        let name = match words.next() {
            Some(Value::Text(name)) => name,
            _ => return Some(Err(Fault::bad_request("a request begins with its name"))),
        };
        Some(match name.as_str() {
            "call" => match words.next() {
                Some(Value::Text(member)) => self.call(&Call { member, arguments: words.collect() }),
                _ => Err(Fault::bad_request("a call names a member")),
            },
            "release" => {
                for id in words.next().and_then(|ids| ids.items()).into_iter().flatten() {
                    if let Value::Int(id) = id {
                        self.handles.release(u64::try_from(id).unwrap_or(0));
                    }
                }
                return None;
            }
            "members" => Ok(Value::List(endpoints().members().into_iter().map(Value::Text).collect())),
            "changing" => Ok(Value::List(endpoints().changing().into_iter().map(Value::Text).collect())),
            "components" => match &self.registry {
                Some(registry) => Ok(registry.components()),
                None => Err(Fault::not_supported("components")),
            },
            "component" => match (&self.registry, words.next()) {
                (Some(registry), Some(Value::Text(name))) => {
                    let inputs = words.next().map_or(Some(Vec::new()), |inputs| inputs.items());
                    match inputs {
                        Some(inputs) => registry.run(&name, &inputs, &self.limits, &self.cancel),
                        None => Err(Fault::bad_request("the inputs of a component are a list")),
                    }
                }
                (Some(_), _) => Err(Fault::bad_request("a component is called by its name or identifier")),
                (None, _) => Err(Fault::not_supported("components")),
            },
            other => Err(Fault::not_supported(format!("the request {other}"))),
        })
    }
}

/// A fault as an error of the protocol.
pub(crate) fn error(fault: &Fault) -> Value {
    let kind = match fault.cause {
        Cause::BadRequest => "argument",
        Cause::NotFound | Cause::NotSupported(_) => "not_supported",
        Cause::Cancelled => "cancelled",
        Cause::TimedOut => "time",
        Cause::TooLarge | Cause::Busy => "memory",
        Cause::Refused | Cause::Failed => "failed",
    };
    Value::Error(kind.into(), fault.message.clone())
}

/// Answers the messages of a pipe until it ends.
///
/// # Errors
/// The pipe breaks, or a message is too large.
pub fn serve(
    host: &mut Host,
    requests: &mut impl Read,
    answers: &mut impl Write,
) -> Result<(), codec::Error> {
    while let Some(message) = codec::receive(requests)? {
        if let Some(answer) = host.answer(&message) {
            codec::send(answers, &answer)?;
        }
    }
    Ok(())
}
