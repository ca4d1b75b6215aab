//! The host's clock.

use super::{Cx, Native};
use crate::vm::value::Value;
use crate::vm::{Raise, Stop};

pub(super) fn find(key: &str) -> Option<Native> {
    (key == "Clock.Ticks()").then_some(ticks)
}

/// Ticks of 100 ns since the year 1. Without a clock the run ends: any other time would be wrong.
fn ticks(cx: &mut Cx<'_>) -> Result<Value, Raise> {
    match cx.st.host.now() {
        Some(ticks) => Ok(Value::I64(ticks)),
        None => Err(Raise::Stop(Stop::NotSupported("The clock".to_owned()))),
    }
}
