//! The drawing that is shown: made in the background, again whenever the stone changes.

use brilliance_renderer::drawing::{Sheet, facet_diagram};
use brilliance_renderer::error::RendererError;
use brilliance_renderer::scene::Object;

use crate::task::{Task, TaskState};
use crate::waker::Waker;

/// A drawing being made.
#[derive(Debug)]
struct Running {
    object: Object,
    task: Task<Result<Sheet, RendererError>>,
}

/// A drawing, or why there is none, and what it is of.
#[derive(Debug)]
struct Drawn {
    object: Object,
    sheet: Result<Sheet, String>,
}

/// The newest drawing there is, and the one that is on its way.
#[derive(Debug, Default)]
pub(super) struct Draughting {
    running: Option<Running>,
    drawn: Option<Drawn>,
}

impl Draughting {
    /// The newest drawing, or why it could not be made.
    pub(super) fn newest(&self) -> Option<&Result<Sheet, String>> {
        self.drawn.as_ref().map(|drawn| &drawn.sheet)
    }

    /// Whether another is on its way.
    pub(super) fn is_running(&self) -> bool {
        self.running.is_some()
    }

    /// Takes over a drawing that has been made, and has another made where `object` is no longer
    /// what is shown. One is made at a time, so that the newest follows the one in progress.
    pub(super) fn update(&mut self, object: Option<&Object>, waker: &Waker) {
        self.poll();
        let Some(object) = object else {
            *self = Self::default();
            return;
        };
        let is_shown = self.drawn.as_ref().is_some_and(|drawn| looks_alike(&drawn.object, object));
        if self.running.is_none() && !is_shown {
            self.start(object.clone(), waker);
        }
    }

    fn poll(&mut self) {
        let Some(running) = self.running.take() else { return };
        let sheet = match running.task.poll() {
            TaskState::Running => {
                self.running = Some(running);
                return;
            }
            TaskState::Finished(sheet) => sheet.map_err(|fault| fault.to_string()),
            TaskState::Broken => Err("the thread that draws has failed".to_owned()),
        };
        self.drawn = Some(Drawn { object: running.object, sheet });
    }

    fn start(&mut self, object: Object, waker: &Waker) {
        let copy = object.clone();
        match Task::spawn("draw", waker, move || facet_diagram(&copy)) {
            Ok(task) => self.running = Some(Running { object, task }),
            Err(error) => {
                let sheet = Err(format!("the system gives no thread to draw on: {error}"));
                self.drawn = Some(Drawn { object, sheet });
            }
        }
    }
}

/// Whether two objects have the same drawing.
fn looks_alike(a: &Object, b: &Object) -> bool {
    a.name == b.name && a.transform.scale == b.transform.scale && a.shape == b.shape
}
