//! The `brilliance` program; what it does is in [`brilliance::cli`].

use std::process::ExitCode;

fn main() -> ExitCode {
    brilliance::cli::run()
}
