//! The chunks at the top of an archive, found again where a length is wrong or the bytes end too soon.

use crate::chunk::{Chunk, Context, Reader};
use crate::version::Version;
use crate::{Error, Result, typecode};

/// Gives out the chunks of an archive one after the other.
pub(super) struct TopChunks<'a> {
    file: Reader<'a>,
}

impl<'a> TopChunks<'a> {
    pub(super) fn new(file: Reader<'a>) -> Self {
        Self { file }
    }

    pub(super) fn set_version(&mut self, version: Version) {
        self.file.set_version(version);
    }

    /// The next chunk; nothing at the end. What is not a chunk is passed over up to the next table.
    ///
    /// # Errors
    /// When strict: whatever was broken so far.
    pub(super) fn next(&mut self) -> Result<Option<Chunk<'a>>> {
        let context = self.file.context();
        context.check()?;
        context.forget(0);
        while !self.file.is_at_end() {
            let start = self.file.clone();
            let error = match self.file.chunk() {
                Ok(chunk) if chunk.typecode == 0 => {
                    Error::malformed(chunk.offset, "chunk", "0 is the typecode of no chunk")
                }
                Ok(chunk) => return self.with_true_end(start, chunk).map(Some),
                Err(error) => error,
            };
            context.left_out(start.offset(), "what stands here is", error);
            context.check()?;
            self.file = start;
            let offset = self.file.offset();
            if self.file.peek_typecode().is_some_and(is_table) {
                let start = self.file.clone();
                if let Some(chunk) = self.file.cut_chunk() {
                    return self.with_true_end(start, chunk).map(Some);
                }
            }
            self.find_table(offset + 1);
        }
        Ok(None)
    }

    /// Goes to the next place from `offset` on where a table could begin, or to the end.
    fn find_table(&mut self, offset: usize) {
        self.file.go_to(offset);
        let bytes = self.file.clone().rest();
        let found =
            bytes.windows(4).position(|four| four.try_into().is_ok_and(|b| is_table(u32::from_le_bytes(b))));
        self.file.go_to(offset + found.unwrap_or(bytes.len()));
    }

    /// The chunk with the length that its records have, where that is not the one it states.
    fn with_true_end(&mut self, start: Reader<'a>, chunk: Chunk<'a>) -> Result<Chunk<'a>> {
        if !is_table(chunk.typecode) {
            return Ok(chunk);
        }
        let stated = self.file.offset();
        let Some(found) = end_of_records(&start, chunk.body.offset()) else { return Ok(chunk) };
        if found == stated {
            return Ok(chunk);
        }
        let context: &Context = self.file.context();
        let why = format!("it states that it ends at byte {stated}, but its records end at byte {found}");
        context.left_out(
            chunk.offset,
            "the length of a table is",
            Error::malformed(chunk.offset, "table", why),
        );
        context.check()?;
        self.file = start.clone();
        self.file.go_to(found);
        let mut whole = start;
        whole.go_to(chunk.body.offset());
        let (_, bytes) = (whole.offset(), whole.between(chunk.body.offset(), found));
        let body = chunk.body.over(bytes);
        Ok(Chunk { body, whole: bytes, value: i64::try_from(bytes.len()).unwrap_or(i64::MAX), ..chunk })
    }
}

/// Where the records that begin at `body` end, going from header to header; nothing when there is no end mark.
fn end_of_records(file: &Reader<'_>, body: usize) -> Option<usize> {
    let mut records = file.clone();
    records.go_to(body);
    loop {
        let typecode = records.hop()?;
        if typecode == typecode::END_OF_TABLE {
            return Some(records.offset());
        }
        if is_table(typecode) || typecode == typecode::END_OF_FILE {
            return None;
        }
    }
}

fn is_table(typecode: u32) -> bool {
    typecode::table_name(typecode).is_some()
}
