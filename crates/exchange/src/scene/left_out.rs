use std::fmt;

/// Things of one class that could not be carried over, and why.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LeftOut {
    /// The class.
    pub class: String,
    /// How many.
    pub count: usize,
    /// The reason, in words.
    pub why: String,
}

impl LeftOut {
    /// Some things of a class.
    pub fn new(class: impl Into<String>, count: usize, why: impl Into<String>) -> Self {
        Self { class: class.into(), count, why: why.into() }
    }

    /// Adds to a list, where the same class with the same reason is counted together.
    pub fn add(list: &mut Vec<Self>, one: Self) {
        match list.iter_mut().find(|known| known.class == one.class && known.why == one.why) {
            Some(known) => known.count += one.count,
            None => list.push(one),
        }
    }
}

impl fmt::Display for LeftOut {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} × {}: {}", self.count, self.class, self.why)
    }
}
