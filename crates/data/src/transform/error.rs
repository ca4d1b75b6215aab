/// Why a value has no image under a map.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum TransformError {
    /// A type, or a class of the archive, that no map is applied to.
    #[error("A {0} cannot be transformed")]
    Unsupported(String),
    /// An object of the archive that cannot be read, or not be made anew.
    #[error("A {class} cannot be transformed: {reason}")]
    Unreadable {
        /// The class of the archive.
        class: String,
        /// Why.
        reason: String,
    },
    /// A value that stands for no Brep where one is needed.
    #[error("{0}")]
    NoBrep(String),
    /// Groups in groups in groups.
    #[error("Groups are nested too deep to be transformed")]
    TooDeep,
    /// The kernel's own reason.
    #[error(transparent)]
    Geometry(#[from] katydid_geometry::Error),
}
