//! The command as its users see it: runs the binary on small scenes in a folder of its own.

mod background;
mod bench;
mod compare;
mod failures;
mod files;
mod help;
mod models;
mod paper;
mod peers;
mod render;
mod scenes;
mod signals;
mod stdout;
mod wrong_use;
