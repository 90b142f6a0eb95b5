//! The command line: opens the window, or works without one.
//!
//! Exit codes: 0 done, 1 failed (one line on the standard error says why), 2 wrong usage.

mod arguments;
mod assignment;
mod backend;
mod draw;
mod image_size;
mod inspect;
mod picture_format;
mod pixel;
mod progress;
mod render;
mod report;
mod shown;
mod spectrum;
mod view;

use std::io::Write as _;
use std::process::ExitCode;
use std::time::Instant;

use arguments::{Arguments, Command};

/// Runs the program with the arguments of the process.
pub fn run() -> ExitCode {
    let started = Instant::now();
    env_logger::Builder::from_env(env_logger::Env::default().default_filter_or("error")).init();
    let arguments = Arguments::parse_checked();
    let result = match arguments.command {
        None => view::view(arguments.file.as_deref(), arguments.backend.into(), started),
        Some(Command::Render(render)) => render::render(&render),
        Some(Command::Draw(draw)) => draw::draw(&draw),
        Some(Command::Inspect(inspect)) => inspect::inspect(&inspect),
        Some(Command::Spectrum(spectrum)) => spectrum::spectrum(&spectrum),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            say(&error.to_string());
            ExitCode::FAILURE
        }
    }
}

/// Says something on the standard error. Nothing is left to tell where that is closed.
fn say(text: &str) {
    let _ = writeln!(std::io::stderr(), "brilliance: {text}");
}
