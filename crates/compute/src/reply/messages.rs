use katydid_component::Level;
use katydid_definition::document::Object;
use katydid_solver::{Engine, ObjectReport, Status};

/// The most messages of a sort that are told: a definition of ten thousand unknown components says enough with these.
const MOST: usize = 200;

/// What the components of a solved definition said, in the words of the protocol.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub(crate) struct Messages {
    pub(crate) warnings: Vec<String>,
    pub(crate) errors: Vec<String>,
    /// Whether a component reported an error or is not supported.
    pub(crate) failed: bool,
    /// How many warnings and errors are not told.
    more: [usize; 2],
}

impl Messages {
    /// The messages of all objects, in their order, behind what is wrong with the definition itself.
    pub(crate) fn of(engine: &Engine, problems: &[String]) -> Self {
        let mut messages = Self { errors: problems.to_vec(), ..Self::default() };
        for (index, object) in engine.document().objects.iter().enumerate() {
            if let Some(report) = engine.report(index) {
                messages.add(object, report);
            }
        }
        for (list, more) in [&mut messages.warnings, &mut messages.errors].into_iter().zip(messages.more) {
            if more > 0 {
                list.push(format!("and {more} more"));
            }
        }
        messages
    }

    fn add(&mut self, object: &Object, report: &ObjectReport) {
        for message in &report.messages {
            let refused = report.status == Status::Unsupported && message.level == Level::Warning;
            let text = || format!("{}: component \"{}\" ({})", message.text, object.name, object.id);
            match message.level {
                Level::Warning if !refused => push(&mut self.warnings, &mut self.more[0], text),
                Level::Error | Level::Warning => {
                    self.failed = true;
                    push(&mut self.errors, &mut self.more[1], text);
                }
                Level::Remark => {}
            }
        }
        // A cluster passes its objects' warnings on: that one of them cannot run is more than a warning.
        if report.inside.as_deref().is_some_and(holds_unsupported) {
            self.failed = true;
            let text = || {
                let what = "The cluster holds a component that is not supported";
                format!("{what}: component \"{}\" ({})", object.name, object.id)
            };
            push(&mut self.errors, &mut self.more[1], text);
        }
    }
}

/// Whether one of the objects, or of those in clusters among them, is not supported.
fn holds_unsupported(reports: &[ObjectReport]) -> bool {
    let mut stack: Vec<&ObjectReport> = reports.iter().collect();
    while let Some(report) = stack.pop() {
        if report.status == Status::Unsupported {
            return true;
        }
        stack.extend(report.inside.as_deref().unwrap_or_default());
    }
    false
}

fn push(list: &mut Vec<String>, more: &mut usize, text: impl FnOnce() -> String) {
    if list.len() < MOST { list.push(text()) } else { *more += 1 }
}
