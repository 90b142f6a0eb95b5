//! The progress bar: on a terminal only, silent elsewhere.

use std::time::Duration;

use indicatif::{ProgressBar, ProgressStyle};

const TEMPLATE: &str = "{bar:32} {pos}/{len} passes, {elapsed} gone, {eta} to go";

/// Shows how many passes are done.
pub(super) struct Progress {
    bar: ProgressBar,
}

impl Progress {
    /// A bar over `passes`, on the standard error where that is a terminal.
    pub(super) fn new(passes: u32) -> Self {
        let style =
            ProgressStyle::with_template(TEMPLATE).unwrap_or_else(|_| ProgressStyle::default_bar());
        let bar = ProgressBar::new(u64::from(passes)).with_style(style);
        // Passes of a large picture take seconds; the clock shows that it is alive.
        bar.enable_steady_tick(Duration::from_millis(250));
        Self { bar }
    }

    /// Shows that `passes` are done.
    pub(super) fn show(&self, passes: u32) {
        self.bar.set_position(u64::from(passes));
    }
}

impl Drop for Progress {
    /// Takes the bar off the terminal: the line that says what was done takes its place.
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}
