//! What a program is run for: the types that it may use, where it prints, when it must end.

use crate::library::Cx;
use crate::vm::value::Value;
use crate::vm::{Raise, Stop};

/// The host of a program.
///
/// Types and members are declared in C#: classes, structs, enums, with signatures, and `extern` before what the host does itself.
/// Struct members may also be written out. An `extern` member is called by its key, such as
/// `Vec3.DistanceTo(Vec3)`, `Vec3.get_Length()` or `Curve.new(Vec3,Vec3)`. Classes whose objects the host holds have the
/// attribute `[Native]`; their objects are [`crate::vm::heap::Obj::Host`].
pub trait Host: Send {
    /// Declarations in C#.
    fn declarations(&self) -> &str {
        ""
    }

    /// The number of a member by its key; none where the host does not have it: its use says that it is not supported.
    fn member(&self, _key: &str) -> Option<u32> {
        None
    }

    /// Calls a member: its number and its arguments, the object first.
    ///
    /// # Errors
    /// An exception for the program, or a stop.
    fn call(&mut self, _member: u32, _cx: &mut Cx<'_>) -> Result<Value, Raise> {
        Err(Raise::Stop(Stop::NotSupported("This member".to_owned())))
    }

    /// Takes what the program prints.
    fn write(&mut self, _text: &str) {}

    /// Whether the run must end.
    fn cancelled(&mut self) -> bool {
        false
    }

    /// The time in ticks of 100 ns since the year 1, where the host lets programs know.
    fn now(&mut self) -> Option<i64> {
        None
    }
}

/// A host without types of its own that collects what is printed.
#[derive(Debug, Default)]
pub struct Printing {
    /// What was printed.
    pub text: std::sync::Arc<std::sync::Mutex<String>>,
}

impl Host for Printing {
    fn write(&mut self, text: &str) {
        if let Ok(mut all) = self.text.lock() {
            all.push_str(text);
        }
    }
}
