//! How a server is, in the words that go over the wire.

use axum::http::StatusCode;
use serde_json::json;

use super::super::pool::Load;
use super::super::sent::Sent;

/// How a server is. Who watches over it restarts one that is unhealthy, and lets one that is busy work.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Health {
    /// It solves at once.
    Healthy,
    /// All that it can do at a time it does, within the time that was allowed.
    Busy(String),
    /// Something does not work: which part, and why.
    Unhealthy(String),
}

impl Health {
    pub(super) fn unhealthy(part: &str, reason: &str) -> Self {
        Self::Unhealthy(format!("{part}: {reason}"))
    }

    pub(super) fn stuck(workers: usize) -> Self {
        Self::unhealthy("workers", &format!("{workers} were told to stop and do not"))
    }

    pub(super) fn busy(load: Load) -> Self {
        Self::Busy(format!("{} solves run, {} wait", load.running, load.waiting))
    }

    /// What another process said of itself.
    pub(super) fn read(text: &str) -> Self {
        match text.split_once(": ") {
            None if text == "Healthy" => Self::Healthy,
            Some(("Busy", why)) => Self::Busy(why.to_owned()),
            Some(("Unhealthy", why)) => Self::Unhealthy(why.to_owned()),
            _ => Self::unhealthy("processes", "the second one does not say how it is"),
        }
    }

    pub(super) fn worse(self, other: Self) -> Self {
        if other.rank() > self.rank() { other } else { self }
    }

    fn rank(&self) -> usize {
        match self {
            Self::Healthy => 0,
            Self::Busy(_) => 1,
            Self::Unhealthy(_) => 2,
        }
    }

    fn status(&self) -> StatusCode {
        match self {
            Self::Unhealthy(_) => StatusCode::SERVICE_UNAVAILABLE,
            Self::Healthy | Self::Busy(_) => StatusCode::OK,
        }
    }

    /// One line: `Healthy`, as Rhino.Compute says it, or what is not well.
    pub(super) fn text(&self) -> Sent {
        let text = match self {
            Self::Healthy => "Healthy".to_owned(),
            Self::Busy(why) => format!("Busy: {why}"),
            Self::Unhealthy(why) => format!("Unhealthy: {why}"),
        };
        Sent::text(text).with_status(self.status())
    }

    /// The same for programs, with what this process does.
    pub(super) fn json(&self, load: Load) -> Sent {
        let (status, reason) = match self {
            Self::Healthy => ("healthy", None),
            Self::Busy(why) => ("busy", Some(why)),
            Self::Unhealthy(why) => ("unhealthy", Some(why)),
        };
        let Load { waiting, running, stuck, .. } = load;
        let told = json!({
            "status": status, "reason": reason, "running": running, "waiting": waiting, "stuck": stuck,
        });
        Sent::json(&told).with_status(self.status())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_worse_of_two_is_told() {
        let busy = Health::Busy("3 solves run, 4 wait".to_owned());
        let stuck = Health::stuck(1);
        assert_eq!(Health::Healthy.worse(busy.clone()), busy);
        assert_eq!(stuck.clone().worse(busy.clone()), stuck);
        assert_eq!(busy.clone().worse(Health::Healthy), busy);
        for (text, read) in [
            ("Healthy", Health::Healthy),
            ("Busy: 3 solves run, 4 wait", busy),
            ("Unhealthy: workers: 1 were told to stop and do not", stuck),
        ] {
            assert_eq!(Health::read(text), read);
        }
        for text in ["", "healthy", "Healthy: x", "<html>"] {
            assert_eq!(Health::read(text).status(), StatusCode::SERVICE_UNAVAILABLE, "{text}");
        }
    }
}
