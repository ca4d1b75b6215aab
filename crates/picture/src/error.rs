/// Why a picture cannot be made.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// The size is nothing, or more than memory is for.
    #[error(
        "a picture of {width} × {height} pixels cannot be made: each side can have 1 to 16384, both 134 million"
    )]
    Size {
        /// The width.
        width: f64,
        /// The height.
        height: f64,
    },
    /// The picture could not be packed.
    #[error("the picture could not be packed: {0}")]
    Png(#[from] png::EncodingError),
}
