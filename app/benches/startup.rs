//! Seconds from the start of the process to the first traced picture in the window.
//!
//! Needs a display; `xvfb-run -a cargo bench --bench startup` lends one.
#![expect(clippy::print_stdout, reason = "a benchmark prints what it measured")]

use std::io::{self, BufRead as _, BufReader};
use std::process::{Child, Command, Stdio};
use std::sync::mpsc;
use std::time::{Duration, Instant};

const RUNS: usize = 5;
/// What the window logs when it shows its first traced picture.
const MARK: &str = "first picture after";
const PATIENCE: Duration = Duration::from_mins(1);

fn main() -> io::Result<()> {
    let mut seconds = Vec::new();
    for _ in 0..RUNS {
        match first_picture()? {
            Ok(time) => seconds.push(time.as_secs_f64()),
            Err(output) => {
                println!("startup: the window showed no picture; it said:\n{output}");
                return Ok(());
            }
        }
    }
    seconds.sort_by(f64::total_cmp);
    println!(
        "startup: {:.2} s from process start to the first traced picture (median of {RUNS}; \
         fastest {:.2} s, slowest {:.2} s)",
        seconds[RUNS / 2],
        seconds[0],
        seconds[RUNS - 1]
    );
    Ok(())
}

/// The time until the window logs its first picture, or all it said if it never does.
fn first_picture() -> io::Result<Result<Duration, String>> {
    let start = Instant::now();
    let window = Window::open()?;
    let mut said = String::new();
    loop {
        let Ok(line) = window.lines.recv_timeout(PATIENCE.saturating_sub(start.elapsed())) else {
            return Ok(Err(said));
        };
        if line.contains(MARK) {
            return Ok(Ok(start.elapsed()));
        }
        said.push_str(&line);
        said.push('\n');
    }
}

/// The program with its window, ended when dropped.
struct Window {
    child: Child,
    lines: mpsc::Receiver<String>,
}

impl Window {
    fn open() -> io::Result<Self> {
        let mut child = Command::new(env!("CARGO_BIN_EXE_brilliance"))
            .env("RUST_LOG", "brilliance=info")
            .stdin(Stdio::null())
            .stdout(Stdio::null())
            .stderr(Stdio::piped())
            .spawn()?;
        let (sender, lines) = mpsc::channel();
        if let Some(stderr) = child.stderr.take() {
            std::thread::Builder::new().name("window output".into()).spawn(move || {
                for line in BufReader::new(stderr).lines().map_while(Result::ok) {
                    if sender.send(line).is_err() {
                        break;
                    }
                }
            })?;
        }
        Ok(Self { child, lines })
    }
}

impl Drop for Window {
    fn drop(&mut self) {
        // It may have ended by itself.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}
