//! The operations that are measured, each by all kernels that have it, on the same inputs.

mod closest;
mod cloud;
mod evaluate;
mod interpolate;
mod intersect;
mod length;
mod raise_degree;
mod surface;
mod transform;

pub use closest::closest;
pub use cloud::cloud;
pub use evaluate::evaluate;
pub use interpolate::interpolate;
pub use intersect::intersect;
pub use length::length;
pub use raise_degree::raise_degree;
pub use surface::surface;
pub use transform::transform;

use std::error::Error;

use crate::Inputs;
use crate::timing::Contender;

/// One operation and those who compete in it.
pub struct Operation {
    /// What is done.
    pub name: String,
    /// The most that this kernel may take, as a part of the peer's time.
    pub wanted: f64,
    /// Whom it is compared with.
    pub peer: &'static str,
    /// All who do it; this kernel is `katydid`.
    pub contenders: Vec<Contender<'static>>,
}

fn operation(
    name: impl Into<String>,
    wanted: f64,
    peer: &'static str,
    contenders: Vec<Contender<'static>>,
) -> Operation {
    Operation { name: name.into(), wanted, peer, contenders }
}

/// Lets no result be optimised away.
fn keep<T>(result: T) {
    std::hint::black_box(result);
}

/// What gives the operations of one kind.
pub type Operations = fn(&Inputs) -> Result<Vec<Operation>, Box<dyn Error>>;

/// All of them.
///
/// # Errors
/// The inputs lack something, or a kernel refuses it.
pub fn all(inputs: &Inputs) -> Result<Vec<Operation>, Box<dyn Error>> {
    let kinds: [Operations; 9] =
        [evaluate, surface, closest, length, intersect, interpolate, raise_degree, transform, cloud];
    let mut out = Vec::new();
    for kind in kinds {
        out.extend(kind(inputs)?);
    }
    Ok(out)
}

/// Measures the operations of one kind by criterion, under the group's name. Without the inputs it says so and
/// measures nothing.
pub fn measure(criterion: &mut criterion::Criterion, group: &str, kind: Operations) {
    let operations = match Inputs::read().and_then(|inputs| kind(&inputs)) {
        Ok(operations) => operations,
        Err(e) => {
            eprintln!("{group} is not measured: {e}");
            return;
        }
    };
    for operation in operations {
        let mut group = criterion.benchmark_group(format!("{group}: {}", operation.name));
        group.sample_size(20).measurement_time(std::time::Duration::from_secs(2));
        for mut contender in operation.contenders {
            group.throughput(criterion::Throughput::Elements(contender.items as u64));
            group.bench_function(contender.name, |b| b.iter(|| (contender.run)()));
        }
        group.finish();
    }
}
