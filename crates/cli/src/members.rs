//! `katydid members`: what a script's process calls when it has the kernel in no other way.

use std::io::{BufReader, BufWriter, stdin, stdout};

use katydid_data::cast::Rules;

use crate::args::MembersArgs;

/// Answers the calls on the standard input until it ends.
pub(crate) fn members(_: &MembersArgs) -> Result<u8, String> {
    let (mut requests, mut answers) = (BufReader::new(stdin().lock()), BufWriter::new(stdout().lock()));
    match katydid_members::serve(&mut katydid_script::host(Rules::default()), &mut requests, &mut answers) {
        Ok(()) => Ok(0),
        Err(error) => Err(error.to_string()),
    }
}
