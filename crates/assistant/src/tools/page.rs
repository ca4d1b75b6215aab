//! Lists that are cut, with a note how to ask for the rest.

use serde_json::{Value, json};

use crate::thresholds::{MOST_LETTERS, MOST_ROWS, USUAL_ROWS};

/// Which part of a list is asked for.
#[derive(Debug, Clone, Copy)]
pub(super) struct Part {
    from: usize,
    most: usize,
}

impl Part {
    pub(super) fn new(from: Option<usize>, most: Option<usize>) -> Self {
        Self { from: from.unwrap_or(0), most: most.unwrap_or(USUAL_ROWS).clamp(1, MOST_ROWS) }
    }

    /// The part of the list, made entry by entry: only what is given is made. The list stands under `key`, with how many
    /// there are in all, and where the next part begins.
    pub(super) fn of<T>(self, key: &str, all: &[T], mut made: impl FnMut(&T) -> Value) -> Value {
        let (mut rows, mut letters) = (Vec::new(), 0);
        for one in all.iter().skip(self.from).take(self.most) {
            let row = made(one);
            letters += row.to_string().len();
            // One that is long by itself is given all the same, or nobody would ever see it.
            if letters > MOST_LETTERS && !rows.is_empty() {
                break;
            }
            rows.push(row);
        }
        let next = self.from.saturating_add(rows.len());
        let mut told = json!({ "total": all.len(), "from": self.from });
        told[key] = json!(rows);
        if next < all.len() {
            told["next"] = json!(next);
            told["note"] = json!(format!("{} more: call again with \"from\": {next}", all.len() - next));
        }
        told
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_make_up_the_whole() {
        let all: Vec<usize> = (0..250).collect();
        let (mut from, mut seen) = (Some(0), Vec::new());
        while let Some(at) = from {
            let told = Part::new(Some(at), Some(100)).of("rows", &all, |n| json!(n));
            seen.extend(told["rows"].as_array().into_iter().flatten().filter_map(Value::as_u64));
            from = told["next"].as_u64().map(|n| n as usize);
        }
        assert_eq!(seen, (0..250).collect::<Vec<u64>>());
        let long = vec!["x".repeat(MOST_LETTERS / 2); 5];
        let told = Part::new(None, None).of("rows", &long, |text| json!(text));
        assert_eq!((told["rows"].as_array().map(Vec::len), told["next"].as_u64()), (Some(1), Some(1)));
        assert!(Part::new(Some(900), None).of("rows", &all, |n| json!(n)).get("next").is_none());
    }
}
