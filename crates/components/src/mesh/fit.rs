//! Whether meshes of Breps fit into memory: asked before they are made, with the setting that would do.

use std::sync::Arc as Shared;

use katydid_component::{Call, Context, Message, Outcome};
use katydid_data::{MeshSettings, Tree, Value};
use katydid_geometry::{Brep, Error, Mesh, Patience};

use super::of_surface::fineness;

/// Bytes of a polygon in a mesh: its corners, and a vertex with its normal for each.
const RESULT: usize = 80;
/// Bytes of a cell while its mesh is made, the mesh itself among them: 205 to 225 were measured, on spheres and pipes.
const WORK: usize = 250;
/// From so many items on they are looked at together, before the first one is meshed.
const MANY: usize = 16;
/// So many of them tell whether it is worth while to look at all.
const SAMPLES: usize = 8;
/// Where the samples' mean stays below the limit by this factor, the others are not looked at.
const DOUBT: usize = 2;
/// How often a limit is made coarser in the search for one that fits.
const TRIES: i32 = 12;

/// The mesh of a Brep.
pub(super) fn meshed(context: &Context<'_>, brep: &Brep, settings: &MeshSettings) -> Result<Mesh, Message> {
    let (fine, stop) = (fineness(settings), context.stop());
    let fits = |cells: usize| context.bytes(cells.saturating_mul(WORK)).is_ok();
    let instead = || coarser(settings, |settings| cells_apart(brep, settings), fits);
    let plan = match brep.mesh_plan(&fine, &stop) {
        Ok(plan) => plan,
        // Of a face's cells there are too many for the kernel itself.
        Err(error @ Error::OutOfRange { what: "number of mesh cells", .. }) => {
            return Err(Message::error(format!("{error}{}", would_fit(instead()))));
        }
        Err(error) => {
            return Err(match context.refused() {
                Some(refused) => too_large("A mesh", None, &refused, instead()),
                None => context.check().err().unwrap_or_else(|| error.into()),
            });
        }
    };
    let polygons = plan.cells();
    if let Err(refused) = context.bytes(polygons.saturating_mul(WORK)) {
        drop(plan);
        return Err(too_large("A mesh", Some(polygons), &refused, instead()));
    }
    let made = plan.mesh();
    context.check()?;
    Ok(made?.to_mesh()?)
}

/// The message where all Breps of an input together would not fit; `None` where they do, or where that is not plain: each
/// is asked for again when it is its turn.
pub(super) fn beyond_memory(call: &Call<'_>) -> Option<Outcome> {
    let [shapes, settings, ..] = call.inputs else { return None };
    let settings = match (settings.item_count(), settings.column().get(0)) {
        (1, Some(Value::MeshSettings(settings))) => *settings,
        _ => return None,
    };
    let count = shapes.item_count();
    let budget = call.budget;
    // Few are asked for one by one; and there must be somebody who counts.
    if count < MANY || !budget.has_room(0) {
        return None;
    }
    let stop = move || budget.check().is_err();
    let sample = Sample::of(shapes, count.div_ceil(SAMPLES));
    let limit = usize::try_from(budget.byte_limit()).unwrap_or(usize::MAX) / RESULT;
    let about = sample.cells(count, |brep| cells(brep, &settings, &stop));
    let refused = match budget.refused() {
        Some(refused) => refused,
        None if about.saturating_mul(DOUBT) <= limit => return None,
        None => {
            // A few large ones among the samples are no proof: all are counted, as far as it takes.
            let mut polygons = 0_usize;
            let breps = (0..count).filter_map(|i| brep(&shapes.column().get(i)?));
            let all = breps.map(|brep| cells(&brep, &settings, &stop)).take_while(|cells| {
                polygons = polygons.saturating_add(*cells);
                polygons <= limit
            });
            all.for_each(drop);
            budget.asked(polygons.saturating_mul(RESULT)).err()?
        }
    };
    let fits = |cells: usize| budget.asked(cells.saturating_mul(RESULT)).is_ok();
    let setting =
        coarser(&settings, |settings| sample.cells(count, |brep| cells_apart(brep, settings)), fits);
    let message = too_large(&format!("{count} meshes together"), Some(about), &refused, setting);
    Some(Outcome { outputs: vec![Tree::empty(); call.output_count], messages: vec![message] })
}

/// The Breps among items, each standing for those up to the next one.
struct Sample {
    breps: Vec<Shared<Brep>>,
    /// The number of items that were looked at.
    looked_at: usize,
}

impl Sample {
    /// Every so many-th of the items.
    fn of(items: &Tree, every: usize) -> Self {
        let places = (0..items.item_count()).step_by(every.max(1));
        let looked_at = places.len();
        Self { breps: places.filter_map(|i| brep(&items.column().get(i)?)).collect(), looked_at }
    }

    /// The cells of `count` items, about.
    fn cells(&self, count: usize, cells: impl Fn(&Brep) -> usize) -> usize {
        let found: usize = self.breps.iter().map(|brep| cells(brep)).fold(0, usize::saturating_add);
        (found as f64 * (count as f64 / self.looked_at.max(1) as f64)) as usize
    }
}

fn brep(value: &Value) -> Option<Shared<Brep>> {
    match value {
        Value::Surface(surface) => Brep::from_surface((**surface).clone()).ok().map(Shared::new),
        other => other.brep()?.ok(),
    }
}

/// The cells of a Brep; none where it cannot be meshed, which is told when it is its turn.
fn cells(brep: &Brep, settings: &MeshSettings, stop: &(dyn Fn() -> bool + Sync)) -> usize {
    brep.mesh_plan(&fineness(settings), stop).map_or(0, |plan| plan.cells())
}

/// The same whatever was given up before, to find what would have done.
fn cells_apart(brep: &Brep, settings: &MeshSettings) -> usize {
    Patience::default().during(|| cells(brep, settings, &|| false))
}

/// A coarser setting that fits, by name: the first of the limits in force that alone does, or those for speed.
fn coarser(
    settings: &MeshSettings,
    cells: impl Fn(&MeshSettings) -> usize,
    fits: impl Fn(usize) -> bool,
) -> Option<String> {
    /// A quarter of a turn.
    const WIDEST: f64 = std::f64::consts::FRAC_PI_2;
    let does = |settings: &MeshSettings| {
        let count = cells(settings);
        count > 0 && fits(count)
    };
    // From the coarsest on, so that no try takes much more than there is room for.
    let first = |start: f64, step: f64, with: &dyn Fn(f64) -> MeshSettings| {
        let tries = (1..=TRIES).rev().map(|k| rounded_up(start * step.powi(k)));
        tries.take_while(|x| start > 0.0 && does(&with(*x))).last()
    };
    if let Some(x) = first(settings.max_edge, 2.0, &|max_edge| MeshSettings { max_edge, ..*settings }) {
        return Some(format!("a Max Edge of {x}"));
    }
    if let Some(x) = first(settings.tolerance, 4.0, &|tolerance| MeshSettings { tolerance, ..*settings }) {
        return Some(format!("a Max Distance of {x}"));
    }
    let turned = |degrees: f64| MeshSettings { refine_angle: degrees.to_radians().min(WIDEST), ..*settings };
    if let Some(x) =
        first(settings.refine_angle.to_degrees(), 1.5, &turned).filter(|x| *x <= WIDEST.to_degrees())
    {
        return Some(format!("a Max Angle of {x}"));
    }
    (*settings != MeshSettings::SPEED && does(&MeshSettings::SPEED)).then(|| "Settings (Speed)".into())
}

/// A number of two digits, not below `x`.
fn rounded_up(x: f64) -> f64 {
    let unit = 10_f64.powf(x.abs().log10().floor() - 1.0);
    let digits = (x / unit * (1.0 - f64::EPSILON)).ceil();
    // By its text: a tenth of a power of ten is no short number.
    format!("{:.1e}", digits * unit).parse().unwrap_or(x)
}

fn too_large(meshes: &str, polygons: Option<usize>, refused: &Message, setting: Option<String>) -> Message {
    let size = polygons.map_or("so fine".to_owned(), |polygons| format!("of about {polygons} polygons"));
    let (limit, instead) = (&refused.text, would_fit(setting));
    Message::error(format!("{meshes} {size} would not fit into memory: {limit}{instead}"))
}

fn would_fit(setting: Option<String>) -> String {
    setting.map_or(String::new(), |setting| format!("; {setting} would fit"))
}

#[cfg(test)]
mod tests {
    use katydid_data::MeshSettings;

    use super::{coarser, rounded_up};

    #[test]
    fn two_digits() {
        for (x, wanted) in
            [(0.2, 0.2), (0.123, 0.13), (160.0, 160.0), (0.0999, 0.1), (1e-7, 1e-7), (2048.0, 2100.0)]
        {
            assert_eq!(rounded_up(x), wanted);
        }
    }

    #[test]
    fn the_limit_in_force_is_named() {
        // As many cells as sides of that length fit into a square of 100.
        let cells =
            |s: &MeshSettings| if s.max_edge > 0.0 { (100.0 / s.max_edge).powi(2) as usize } else { 16 };
        let fine = MeshSettings { max_edge: 0.01, ..MeshSettings::SPEED };
        let found = coarser(&fine, cells, |cells| cells <= 100_000);
        assert_eq!(found.unwrap(), "a Max Edge of 0.32");
        let finer = MeshSettings { max_edge: 1e-4, ..MeshSettings::SPEED };
        assert_eq!(coarser(&finer, cells, |cells| cells <= 16).unwrap(), "Settings (Speed)");
        assert_eq!(coarser(&fine, |_| 17, |cells| cells <= 16), None);
        assert_eq!(coarser(&MeshSettings::SPEED, |_| 17, |cells| cells <= 16), None);
    }
}
