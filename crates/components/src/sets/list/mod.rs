//! Sets / List.

mod edit;
mod lengths;
mod nulls;
mod order;
mod pick;
mod streams;
