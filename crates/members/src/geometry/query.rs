//! What the query of a call says.

use crate::Fault;

/// What the query of a call says.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Query {
    /// Whether the body is a list of lists of arguments.
    pub multiple: bool,
    /// The members that are wanted of results of a type, by its full name.
    pub wanted: Vec<(String, Vec<String>)>,
    /// The stage at which to stop and give the seconds until then: 1 the body is read, 2 and 3 the function has run.
    pub stop_at: Option<u8>,
}

impl Query {
    /// Reads names and values as a URL has them. Names that mean nothing here are ignored.
    ///
    /// # Errors
    /// A value that makes no sense.
    pub fn read<'a>(pairs: impl IntoIterator<Item = (&'a str, &'a str)>) -> Result<Self, Fault> {
        let mut query = Self::default();
        for (name, value) in pairs {
            if name.eq_ignore_ascii_case("multiple") {
                query.multiple = match value.trim() {
                    yes if yes.eq_ignore_ascii_case("true") || yes == "1" => true,
                    no if no.eq_ignore_ascii_case("false") || no == "0" || no.is_empty() => false,
                    other => {
                        return Err(Fault::bad_request(format!("multiple is {other}, not true or false")));
                    }
                };
            } else if name.eq_ignore_ascii_case("stopat") {
                query.stop_at = match value.trim() {
                    "" | "0" => None,
                    "1" => Some(1),
                    "2" => Some(2),
                    "3" => Some(3),
                    other => return Err(Fault::bad_request(format!("stopat is {other}, not 0 to 3"))),
                };
            } else if let Some(type_name) = name.to_ascii_lowercase().strip_prefix("return.") {
                let members = value.split(',').map(str::trim).filter(|name| !name.is_empty());
                query.wanted.push((type_name.to_owned(), members.map(str::to_owned).collect()));
            }
        }
        Ok(query)
    }
}
