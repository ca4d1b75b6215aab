//! Names that lead into clusters: `Tower/height` is what the cluster Tower calls height.

use katydid_definition::archive::Limits;
use katydid_definition::document::{Document, Object};
use katydid_session::cluster_content;
use katydid_solver::{Engine, ObjectReport};
use uuid::Uuid;

use crate::StudyError;

/// The document inside a cluster.
///
/// # Errors
/// It is locked, lies in another file or is broken.
pub(crate) fn content(cluster: &Object) -> Result<Document, StudyError> {
    cluster_content(cluster).map_err(|refusal| StudyError::Unfit(refusal.to_string()))
}

/// Whether an object is a cluster, one that cannot be opened too.
pub(crate) fn is_cluster(object: &Object) -> bool {
    object.cluster(&Limits::default()).is_some()
}

/// The cluster whose name or id is before a slash of `name`: its place, what is inside, and the rest of the name. `None` where no
/// cluster is called so. Names may have slashes themselves: the shortest goes first.
///
/// # Errors
/// Several clusters are called so, or the one cannot be opened.
pub(crate) fn entered<'a>(
    document: &Document,
    name: &'a str,
) -> Result<Option<(usize, Document, &'a str)>, StudyError> {
    for (slash, _) in name.match_indices('/') {
        let (Some(title), Some(rest)) = (name.get(..slash), name.get(slash + 1..)) else { continue };
        let id = Uuid::parse_str(title.trim_matches(['{', '}'])).ok();
        let is_meant = |object: &&Object| object.title() == title || Some(object.id) == id;
        let mut found = document.objects.iter().filter(is_meant).filter(|object| is_cluster(object));
        let Some(cluster) = found.next() else { continue };
        if let Some(other) = found.next() {
            return Err(StudyError::Unfit(format!(
                "several clusters are called '{title}': use one of their ids, {}, {}",
                cluster.id, other.id
            )));
        }
        let at = document.objects.iter().position(|object| object.id == cluster.id).unwrap_or_default();
        return Ok(Some((at, content(cluster)?, rest)));
    }
    Ok(None)
}

/// The report of an object: `path` is the places of the clusters that it is inside of, and its own at the end.
pub(crate) fn report_at<'a>(engine: &'a Engine, path: &[usize]) -> Option<&'a ObjectReport> {
    let (&outermost, deeper) = path.split_first()?;
    deeper.iter().try_fold(engine.report(outermost)?, |report, at| report.inside.as_ref()?.get(*at))
}
