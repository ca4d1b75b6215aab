use std::fmt;

use katydid_data::Kind;

use crate::shortened;

/// How much a message matters.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Level {
    /// Something worth knowing.
    Remark,
    /// The component ran, but not on all of its data, or not as its user may think.
    Warning,
    /// The component could not do its work.
    Error,
}

impl fmt::Display for Level {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Remark => "remark",
            Self::Warning => "warning",
            Self::Error => "error",
        })
    }
}

/// What is missing of a Rhino model.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ModelLack {
    /// The type of the input that needs it.
    pub kind: Kind,
    /// How many objects are referred to and missing; 0 where the model as a whole is asked for.
    pub objects: usize,
    /// Whether there is a model, without those objects.
    pub has_model: bool,
}

/// What a component tells its user, in the user's words. Numbers of very many digits are shortened.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Message {
    /// How much it matters.
    pub level: Level,
    /// The sentence.
    pub text: String,
    /// What is missing of a Rhino model, where the sentence says so: who counts it need not read sentences.
    pub lack: Option<ModelLack>,
}

impl Message {
    fn new(level: Level, text: impl Into<String>) -> Self {
        Self { level, text: shortened(text), lack: None }
    }

    /// The same, which says that something is missing of a Rhino model.
    pub fn lacking(self, lack: ModelLack) -> Self {
        Self { lack: Some(lack), ..self }
    }

    /// The work could not be done.
    pub fn error(text: impl Into<String>) -> Self {
        Self::new(Level::Error, text)
    }

    /// Done, but with a catch.
    pub fn warning(text: impl Into<String>) -> Self {
        Self::new(Level::Warning, text)
    }

    /// Worth knowing.
    pub fn remark(text: impl Into<String>) -> Self {
        Self::new(Level::Remark, text)
    }
}

impl fmt::Display for Message {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.level, self.text)
    }
}

impl From<katydid_geometry::Error> for Message {
    fn from(error: katydid_geometry::Error) -> Self {
        Self::error(error.to_string())
    }
}

impl From<katydid_data::TransformError> for Message {
    fn from(error: katydid_data::TransformError) -> Self {
        Self::error(error.to_string())
    }
}

/// Different messages beyond this many are counted, not kept.
const KEPT: usize = 32;

/// The messages of one component, each text once with the number of times it was said.
#[derive(Debug, Clone, Default)]
pub struct Notes {
    entries: Vec<(Message, usize)>,
    beyond: usize,
}

impl Notes {
    /// Adds a message.
    pub fn add(&mut self, message: Message) {
        self.add_times(message, 1);
    }

    fn add_times(&mut self, message: Message, times: usize) {
        if let Some((_, count)) = self.entries.iter_mut().find(|(m, _)| *m == message) {
            *count += times;
        } else if self.entries.len() < KEPT {
            self.entries.push((message, times));
        } else {
            self.beyond += times;
        }
    }

    /// Adds all of another's messages behind these.
    pub fn append(&mut self, other: Self) {
        for (message, times) in other.entries {
            self.add_times(message, times);
        }
        self.beyond += other.beyond;
    }

    /// The messages as shown: what was said more than once ends with how often.
    pub fn into_messages(self) -> Vec<Message> {
        let mut messages: Vec<Message> = self
            .entries
            .into_iter()
            .map(|(message, times)| match times {
                1 => message,
                _ => Message { text: format!("{} ({times} times)", message.text), ..message },
            })
            .collect();
        if self.beyond > 0 {
            messages.push(Message::remark(format!("and {} more messages", self.beyond)));
        }
        messages
    }
}
