//! Memory of this process and of the machine, on systems that have `/proc`.

use crate::diagnostic::{Faults, JsonPath};

/// Memory that every process has, bytes: to ask the system how much there is takes as long as to solve a small beam.
const ALWAYS: u64 = 64 << 20;

/// Memory that may be used, bytes: what is allowed, else what programs can have without swapping.
pub fn allowed(limit: Option<u64>) -> Option<u64> {
    limit.or_else(|| value("/proc/meminfo", "MemAvailable:"))
}

/// Memory that may be used, bytes, as far as it decides whether `needed` bytes may be.
pub(crate) fn allowed_for(needed: u64, limit: Option<u64>) -> u64 {
    let is_little = limit.is_none() && needed <= ALWAYS;
    if is_little { ALWAYS } else { allowed(limit).unwrap_or(u64::MAX - 1) }
}

/// Whether so many bytes may be used for `what`; if not, a fault at `path`. The hint is what to do instead of raising the limit.
pub(crate) fn fits(
    bytes: f64,
    (what, hint): (&str, &str),
    limit: Option<u64>,
    path: JsonPath,
    faults: &mut Faults,
) -> bool {
    let allowed = allowed_for(bytes as u64, limit);
    if bytes <= allowed as f64 {
        return true;
    }
    let [needed, allowed] = [bytes as u64, allowed].map(words);
    faults
        .error(path, format!("about {needed} of memory would be needed for {what}, {allowed} may be used"))
        .for_lack_of_memory()
        .hint(format!("{hint}, or raise `--max-memory`"));
    false
}

/// Largest resident memory of this process so far, bytes.
pub(crate) fn peak() -> Option<u64> {
    value("/proc/self/status", "VmHWM:")
}

/// A number of bytes in the unit that suits it.
pub(crate) fn words(bytes: u64) -> String {
    let units = [(1e9, "GB"), (1e6, "MB"), (1e3, "kB")];
    let unit = units.iter().find(|(size, _)| bytes as f64 >= *size);
    unit.map_or(format!("{bytes} B"), |(size, name)| format!("{:.1} {name}", bytes as f64 / size))
}

/// A value of a file of `/proc`, bytes.
fn value(file: &str, key: &str) -> Option<u64> {
    let text = std::fs::read_to_string(file).ok()?;
    let line = text.lines().find(|l| l.starts_with(key))?;
    let kilobytes: u64 = line.split_whitespace().nth(1)?.parse().ok()?;
    Some(1024 * kilobytes)
}
