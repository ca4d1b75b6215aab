/// How a surface is laid through section curves.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct LoftOptions {
    /// Whether the last section is joined to the first.
    pub closed: bool,
    /// Whether sections that run against the others are turned round.
    pub adjust: bool,
    /// 0 smooth, 1 loose, 2 tight, 3 straight, 4 developable, 5 uniform.
    pub kind: i32,
    /// Control points of every section when they are rebuilt first; 0 leaves them.
    pub rebuild: i32,
    /// The tolerance when sections are refitted first, in units; 0 leaves them.
    pub refit: f64,
}
