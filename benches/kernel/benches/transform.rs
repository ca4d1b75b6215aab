//! Transforms, beside other kernels.

use criterion::Criterion;
use katydid_kernel_bench::operations;

fn main() {
    let mut criterion = Criterion::default().configure_from_args();
    operations::measure(&mut criterion, "transform", operations::transform);
    criterion.final_summary();
}
