//! Degree and knots, beside other kernels.

use criterion::Criterion;
use katydid_kernel_bench::operations;

fn main() {
    let mut criterion = Criterion::default().configure_from_args();
    operations::measure(&mut criterion, "raise_degree", operations::raise_degree);
    criterion.final_summary();
}
