//! The laboratory: experiments that measure, and write what they found as tables and pages.

pub mod paper;
pub mod peers;
mod plot;
