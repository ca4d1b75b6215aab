//! The tab.

mod text;
