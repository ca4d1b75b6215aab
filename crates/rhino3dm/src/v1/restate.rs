//! Objects of version 1 restated as class objects of version 50, and read as those are.
//!
//! So what the kernel refuses of them is kept as bytes that later archives can carry, and no class is read in two
//! ways.

use uuid::Uuid;

use crate::Result;
use crate::chunk::{Context, Reader, Writer};
use crate::class_object::{ClassObject, write_class};
use crate::object::Object;
use crate::version::Version;

/// The version restated to: the first whose chunk lengths later ones share.
const VERSION: i32 = 50;

/// The object of a class whose body `body` writes; `offset` is where it stands in the archive.
pub(super) fn object(
    class: Uuid,
    offset: usize,
    context: &Context,
    body: impl FnOnce(&mut Writer) -> Result<()>,
) -> Result<Object> {
    let mut w = writer()?;
    write_class(&mut w, class, &[], body)?;
    let version = w.version();
    let bytes = w.into_bytes();
    // Offsets in these bytes say nothing about the archive.
    let own = Context::new(&context.limits);
    let class = ClassObject::read(&mut Reader::new(&bytes, version, &own))?;
    Ok(Object::from_class(&class).unwrap_or_else(|error| {
        context.kept(offset, "an object", error.moved_to(offset));
        Object::Kept(class.to_raw())
    }))
}

fn writer() -> Result<Writer> {
    Ok(Writer::new(Version::for_writing(VERSION)?))
}
