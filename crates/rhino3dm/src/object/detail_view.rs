//! Class DetailView (section 8): a window of a page into the model.

use katydid_geometry::{Curve, Point3, PolylineCurve, Vector3};

use super::curve::{self, CurveForm};
use crate::chunk::{Reader, Writer};
use crate::recode::recode;
use crate::version::Version;
use crate::views::PlainView;
use crate::{Error, Result, class_ids, typecode};

/// A window of a page into the model.
#[derive(Debug, Clone, PartialEq)]
pub struct DetailView {
    /// Its frame on the page: a closed NURBS curve.
    pub boundary: CurveForm,
    /// Lengths on the page as a part of those in the model; 0 when that is not fixed.
    pub page_per_model: f64,
    /// What it shows: the body of the chunk that holds the view, as it was.
    pub view: Vec<u8>,
    /// Whether chunks in it have lengths of 8 bytes, as in archives from version 50 on.
    pub view_is_wide: bool,
}

const WHAT: &str = "detail view";
/// Bytes of typecode and length before a body in archives from version 50 on.
const WIDE_HEADER: usize = 12;

impl DetailView {
    /// A window onto the model from above. Its frame on the page has the given sides; `centre` of the model is seen
    /// in the middle, and lengths on the page are `page_per_model` of those in the model.
    ///
    /// # Errors
    /// Numbers that are not finite, a side or a scale that is not above 0.
    pub fn from_above(frame: [[f64; 2]; 2], centre: Point3, page_per_model: f64) -> Result<Self> {
        let [[left, bottom], [right, top]] = frame;
        let [half, upright] = [(right - left) / 2.0 / page_per_model, (top - bottom) / 2.0 / page_per_model];
        let numbers = [left, bottom, right, top, centre.x, centre.y, centre.z, half, upright];
        if !numbers.iter().all(|x| x.is_finite()) || half <= 0.0 || upright <= 0.0 || page_per_model <= 0.0 {
            return Err(Error::malformed(0, WHAT, "its frame or its scale shows nothing"));
        }
        let away = half.max(upright) * 2.0;
        let view = PlainView {
            nested: true,
            camera: Point3::new(centre.x, centre.y, centre.z + away),
            direction: Vector3::new(0.0, 0.0, -away),
            target: Some(centre),
            frustum: [-half, half, -upright, upright, away / 1000.0, away * 4.0],
            ..PlainView::default()
        };
        let mut w = Writer::new(Version::for_writing(50)?);
        w.versioned(1, 0, |w| view.write(w))?;
        let corners = [[left, bottom], [right, bottom], [right, top], [left, top], [left, bottom]];
        let outline = PolylineCurve::new(corners.map(|[x, y]| Point3::new(x, y, 0.0)).to_vec());
        let boundary = outline.and_then(|outline| Curve::from(outline).to_nurbs());
        let boundary = boundary.map_err(|error| Error::geometry(0, WHAT, error))?;
        Ok(Self {
            boundary: CurveForm::of(&boundary.into(), curve::SPACE),
            page_per_model,
            view: w.into_bytes().split_off(WIDE_HEADER),
            view_is_wide: true,
        })
    }

    /// Whether an archive of the given version can carry it.
    pub(super) fn check_writable(&self, version: i32) -> Result<()> {
        self.view_for(Version { archive: version, opennurbs: 0 }).map(|_| ())
    }

    /// The view with chunk lengths as an archive has them.
    fn view_for(&self, version: Version) -> Result<Vec<u8>> {
        let own = Version { archive: if self.view_is_wide { 50 } else { 4 }, opennurbs: 0 };
        recode(typecode::ANONYMOUS, &self.view, own, version).ok_or_else(|| Error::CannotWrite {
            what: "a DetailView".into(),
            version: version.archive,
            why: "the chunk lengths of its view are of another width".into(),
        })
    }
}

pub(super) fn read(body: &mut Reader<'_>) -> Result<DetailView> {
    let (mut body, minor) = body.versioned_1(WHAT)?;
    let chunk = body.chunk()?;
    if chunk.typecode != typecode::ANONYMOUS {
        return Err(Error::malformed(chunk.offset, WHAT, "it has no view"));
    }
    let view = chunk.whole.to_vec();
    let view_is_wide = body.version().is_wide();
    let (mut inner, _) = body.versioned_1(WHAT)?;
    let boundary = curve::read(class_ids::NURBS_CURVE, &mut inner)?;
    inner.finish();
    let page_per_model = if minor >= 1 { body.f64(WHAT)? } else { 0.0 };
    body.finish();
    Ok(DetailView { boundary, page_per_model, view, view_is_wide })
}

pub(super) fn write(detail: &DetailView, w: &mut Writer) -> Result<()> {
    let view = detail.view_for(w.version())?;
    w.versioned(1, 1, |w| {
        w.foreign_chunk(typecode::ANONYMOUS, &view)?;
        w.versioned(1, 0, |w| curve::write(&detail.boundary, w))?;
        w.f64(detail.page_per_model);
        Ok(())
    })
}
