//! The laboratory: experiments that measure, and write what they found as tables and pages.

mod csv_text;
mod embedded;
pub mod paper;
pub mod peers;
mod plot;
