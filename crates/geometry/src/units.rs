/// The length unit of a model.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Units {
    /// No unit.
    None,
    /// µm.
    Microns,
    /// mm.
    #[default]
    Millimeters,
    /// cm.
    Centimeters,
    /// m.
    Meters,
    /// km.
    Kilometers,
    /// 1/12 foot.
    Inches,
    /// 0.3048 m.
    Feet,
    /// 3 feet.
    Yards,
    /// 1760 yards.
    Miles,
}

impl Units {
    /// The name in full, as Rhino writes it.
    pub const fn name(self) -> &'static str {
        match self {
            Self::None => "None",
            Self::Microns => "Microns",
            Self::Millimeters => "Millimeters",
            Self::Centimeters => "Centimeters",
            Self::Meters => "Meters",
            Self::Kilometers => "Kilometers",
            Self::Inches => "Inches",
            Self::Feet => "Feet",
            Self::Yards => "Yards",
            Self::Miles => "Miles",
        }
    }

    /// The short sign behind a length, `mm` say; empty when there is no unit.
    pub const fn abbreviation(self) -> &'static str {
        match self {
            Self::None => "",
            Self::Microns => "µm",
            Self::Millimeters => "mm",
            Self::Centimeters => "cm",
            Self::Meters => "m",
            Self::Kilometers => "km",
            Self::Inches => "in",
            Self::Feet => "ft",
            Self::Yards => "yd",
            Self::Miles => "mi",
        }
    }
}
