//! The pictures that Image Samplers keep in the document.

use katydid_definition::document::{Document, Special};

/// What files of pictures that browsers show begin with, and their media types.
const BEGINNINGS: [(&[u8], &str); 4] = [
    (b"\x89PNG\r\n\x1a\n", "image/png"),
    (b"\xff\xd8\xff", "image/jpeg"),
    (b"GIF8", "image/gif"),
    (b"BM", "image/bmp"),
];

/// The media type of a picture that browsers show.
fn media_type(bytes: &[u8]) -> Option<&'static str> {
    BEGINNINGS.iter().find(|(beginning, _)| bytes.starts_with(beginning)).map(|(_, name)| *name)
}

/// The name by which faces ask for a picture; none for bytes that are no picture.
pub(crate) fn hash(bytes: &[u8]) -> Option<String> {
    media_type(bytes).map(|_| blake3::hash(bytes).to_hex().chars().take(32).collect())
}

/// The picture of that name in a document, with its media type.
pub(crate) fn find(document: &Document, name: &str) -> Option<(Vec<u8>, &'static str)> {
    document.objects.iter().find_map(|object| {
        let Some(Special::ImageSampler(sampler)) = object.special() else { return None };
        let bytes = sampler.image.filter(|bytes| hash(bytes).as_deref() == Some(name))?;
        let media_type = media_type(&bytes)?;
        Some((bytes, media_type))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_pictures_have_names() {
        assert_eq!(hash(b"GIF89a").map(|name| name.len()), Some(32));
        assert_eq!(hash(b"<svg onload='alert(1)'>"), None);
        assert_eq!(hash(b""), None);
    }
}
