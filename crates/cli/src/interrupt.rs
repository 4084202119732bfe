//! Ctrl-C and the signal to terminate, for runs that can be resumed.

use super::{INTERRUPTED, note};
use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::flag;
use std::io;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// Whether the user wants the run to end.
#[derive(Clone, Debug, Default)]
pub(super) struct Interrupt(Arc<AtomicBool>);

impl Interrupt {
    /// Takes the first SIGINT or SIGTERM from now on as the wish to end the run after the current solve, or after the next
    /// load case where that is solved meanwhile; a second one ends the process at once.
    ///
    /// # Errors
    /// The system does not let signals be handled.
    pub(super) fn listen(quiet: bool) -> io::Result<Self> {
        let interrupt = Self::default();
        for signal in [SIGINT, SIGTERM] {
            // In this order: the first signal finds the flag down and raises it.
            flag::register_conditional_shutdown(signal, INTERRUPTED.into(), interrupt.0.clone())?;
            flag::register(signal, interrupt.0.clone())?;
        }
        if !quiet {
            tell()?;
        }
        Ok(interrupt)
    }

    /// Whether there was a signal.
    pub(super) fn is_asked(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }
}

/// Says at the first signal what comes: a solve may take long, and a handler itself must not write.
#[cfg(unix)]
fn tell() -> io::Result<()> {
    let mut signals = signal_hook::iterator::Signals::new([SIGINT, SIGTERM])?;
    std::thread::Builder::new().name("interrupt".into()).spawn(move || {
        if signals.forever().next().is_some() {
            note("\nending after a solve; once more ends it at once\n");
        }
    })?;
    Ok(())
}

#[cfg(not(unix))]
fn tell() -> io::Result<()> {
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_signal_asks_and_the_process_lives() {
        let interrupt = Interrupt::listen(true).unwrap();
        assert!(!interrupt.is_asked());
        signal_hook::low_level::raise(SIGTERM).unwrap();
        assert!(interrupt.is_asked());
        assert!(!Interrupt::default().is_asked());
    }
}
