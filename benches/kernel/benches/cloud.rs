//! Triangulations, cells, hulls and lines of equal height, beside the crates that make them.

use criterion::Criterion;
use katydid_kernel_bench::operations;

fn main() {
    let mut criterion = Criterion::default().configure_from_args();
    operations::measure(&mut criterion, "cloud", operations::cloud);
    criterion.final_summary();
}
