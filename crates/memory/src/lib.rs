//! Memory counted where it is allocated.
//!
//! A program that has [`Counting`] as its allocator knows at any time how much its threads have taken. An [`Account`]
//! collects what one piece of work takes, on all threads that do it, whatever it takes it for: results, copies, what
//! is needed on the way. So a limit of memory holds for every kind of geometry, and nobody has to guess sizes.
//!
//! ```
//! use katydid_memory::{Account, Counting};
//!
//! #[global_allocator]
//! static ALLOCATOR: Counting = Counting;
//!
//! let account = Account::new(1 << 20);
//! account.begin();
//! let small = vec![0_u8; 1000];
//! account.settle();
//! assert!(account.bytes() >= 1000 && !account.is_over());
//! let large = vec![0_u8; 1 << 20];
//! account.settle();
//! assert!(account.is_over());
//! drop((small, large));
//! account.settle();
//! assert!(!account.is_over());
//! ```

mod account;
mod counting;
mod pages;

pub use account::Account;
pub use counting::{Counting, is_counting};
