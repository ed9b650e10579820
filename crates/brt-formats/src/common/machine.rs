//! What the machine has.

use sysinfo::{MemoryRefreshKind, System};

/// Memory that this process may have, in bytes: that of the machine, its container or its limit, whichever is least.
pub(crate) fn memory() -> u64 {
    // A system that tells nothing has some.
    let known = |bytes: u64| if bytes == 0 { u64::MAX } else { bytes };
    let Ok(mut system) = System::new() else { return address_space() };
    system.refresh_memory_specifics(MemoryRefreshKind::nothing().with_ram());
    let container = system.cgroup_limits().map_or(0, |limits| limits.total_memory);
    known(system.total_memory()).min(known(container)).min(address_space())
}

/// `ulimit -v`
#[cfg(unix)]
fn address_space() -> u64 {
    use nix::sys::resource::{Resource, getrlimit};
    getrlimit(Resource::RLIMIT_AS).map_or(u64::MAX, |(soft, _)| soft)
}

#[cfg(not(unix))]
fn address_space() -> u64 {
    u64::MAX
}
