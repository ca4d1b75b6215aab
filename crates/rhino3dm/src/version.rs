//! The two numbers that decide every layout: archive version and openNURBS version (section 1).

use crate::{Error, Result};

/// Under which rules bytes were written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Version {
    /// The archive version: 2, 3, 4, 5, 50, 60, 70, 80.
    pub(crate) archive: i32,
    /// The version number of the openNURBS that wrote it, as a raw integer.
    pub(crate) opennurbs: u32,
}

impl Version {
    /// Whether chunk lengths take 8 bytes; before version 50 they take 4.
    pub(crate) fn is_wide(self) -> bool {
        self.archive >= 50
    }

    /// The version of an archive that does not say by which openNURBS it was written: the first in those of
    /// versions 1 and 2, which need not say it, the newest in others.
    pub(crate) fn unstated(archive: i32) -> Self {
        let opennurbs = match archive {
            ..=2 => 200_012_210,
            3..60 => 202_410_098,
            _ => opennurbs_number(8, 12, 2026, 202),
        };
        Self { archive, opennurbs }
    }

    /// The version under which this crate writes an archive of the given number.
    pub(crate) fn for_writing(archive: i32) -> Result<Self> {
        let opennurbs = match archive {
            4 | 50 => 202_609_088,
            60 | 70 | 80 => opennurbs_number(8, 35, 2026, 251),
            other => return Err(Error::UnsupportedVersion(other)),
        };
        Ok(Self { archive, opennurbs })
    }
}

/// The openNURBS version number as archives from 60 on store it.
const fn opennurbs_number(major: u32, minor: u32, year: u32, day_of_year: u32) -> u32 {
    0x8000_0000 + ((major * 128 + minor) * 65536 + (year - 2000) * 367 + day_of_year) * 4
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_follow_the_published_layout() {
        // What rhino3dm 8.35 of day 251 of 2026 writes.
        assert_eq!(opennurbs_number(8, 35, 2026, 251), 0x908C_9904);
        assert!(Version::for_writing(1).is_err());
    }
}
