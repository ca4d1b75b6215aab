//! What one solve may use.

use std::time::Duration;

use katydid_component::Limits;
use katydid_solver::{Engine, Status, Summary};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::errors::LimitError;

/// How the message of a component ends that would take more memory than it may.
const MEMORY: &str = ": raise the memory limit if that much is wanted";

/// The limits that a call names.
pub(super) struct Bounds {
    pub(super) limits: Limits,
    has_bytes: bool,
}

impl Bounds {
    pub(super) fn new(seconds: Option<f64>, bytes: Option<u64>, items: Option<u64>) -> PyResult<Self> {
        let mut limits = Limits::default();
        if let Some(seconds) = seconds {
            let time = Duration::try_from_secs_f64(seconds);
            limits.time =
                Some(time.map_err(|_| PyValueError::new_err("time_limit is a number of seconds, above 0"))?);
        }
        limits.items = items.unwrap_or(limits.items);
        if let Some(bytes) = bytes {
            limits = limits.with_bytes(bytes);
        }
        Ok(Self { limits, has_bytes: bytes.is_some() })
    }

    /// An error where a limit of time or memory ended the work of a component.
    pub(super) fn check(&self, engine: &Engine, summary: &Summary) -> PyResult<()> {
        let reports = (0..engine.document().objects.len()).filter_map(|at| engine.report(at));
        let mut failed = reports.filter(|report| report.status == Status::Error);
        match self.limits.time {
            Some(time) if summary.time >= time && failed.clone().next().is_some() => {
                return Err(LimitError::new_err(format!(
                    "the time limit of {} seconds is over",
                    time.as_secs_f64()
                )));
            }
            _ if !self.has_bytes => return Ok(()),
            _ => {}
        }
        let of_memory =
            failed.find_map(|report| report.messages.iter().find(|message| message.text.ends_with(MEMORY)));
        of_memory.map_or(Ok(()), |message| Err(LimitError::new_err(message.text.to_string())))
    }
}
