//! Colours: archives store transparency (0 opaque) where everything else stores alpha (255 opaque) (section 3).

/// Red, green, blue, alpha from what an archive stores.
pub(crate) fn from_archive([r, g, b, transparency]: [u8; 4]) -> [u8; 4] {
    [r, g, b, 255 - transparency]
}

/// What an archive stores for red, green, blue, alpha.
pub(crate) fn to_archive([r, g, b, alpha]: [u8; 4]) -> [u8; 4] {
    [r, g, b, 255 - alpha]
}
