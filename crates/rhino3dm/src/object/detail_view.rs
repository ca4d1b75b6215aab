//! Class DetailView (section 8): a window of a page into the model.

use super::curve::{self, CurveForm};
use crate::chunk::{Reader, Writer};
use crate::{Error, Result, class_ids};

/// A window of a page into the model.
#[derive(Debug, Clone, PartialEq)]
pub struct DetailView {
    /// Its frame on the page: a closed NURBS curve.
    pub boundary: CurveForm,
    /// Lengths on the page as a part of those in the model; 0 when that is not fixed.
    pub page_per_model: f64,
    /// What it shows: the chunks of a view, as they were.
    pub view: Vec<u8>,
    /// Whether those chunks have lengths of 8 bytes, as archives from version 50 on.
    pub view_is_wide: bool,
}

const WHAT: &str = "detail view";

impl DetailView {
    /// Whether an archive of the given version can carry it.
    pub(super) fn check_writable(&self, version: i32) -> Result<()> {
        if self.view_is_wide == (version >= 50) {
            return Ok(());
        }
        Err(Error::CannotWrite {
            what: "a DetailView".into(),
            version,
            why: "the chunk lengths of its view are of another width".into(),
        })
    }
}

pub(super) fn read(body: &mut Reader<'_>) -> Result<DetailView> {
    let (mut body, minor) = body.versioned_1(WHAT)?;
    let (mut inner, _) = body.versioned_1(WHAT)?;
    let view = inner.rest().to_vec();
    let view_is_wide = inner.version().is_wide();
    let (mut inner, _) = body.versioned_1(WHAT)?;
    let boundary = curve::read(class_ids::NURBS_CURVE, &mut inner)?;
    inner.finish();
    let page_per_model = if minor >= 1 { body.f64(WHAT)? } else { 0.0 };
    body.finish();
    Ok(DetailView { boundary, page_per_model, view, view_is_wide })
}

pub(super) fn write(detail: &DetailView, w: &mut Writer) -> Result<()> {
    detail.check_writable(w.version().archive)?;
    w.versioned(1, 1, |w| {
        w.versioned(1, 0, |w| {
            w.chunks(&detail.view);
            Ok(())
        })?;
        w.versioned(1, 0, |w| curve::write(&detail.boundary, w))?;
        w.f64(detail.page_per_model);
        Ok(())
    })
}
