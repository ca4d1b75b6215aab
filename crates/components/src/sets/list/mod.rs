//! Sets / List.

mod ascending;
mod edit;
mod lengths;
mod nulls;
mod order;
mod pick;
mod streams;
