//! Definitions kept for the next request, within a bound of memory.
