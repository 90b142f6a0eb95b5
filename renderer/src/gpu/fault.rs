//! What a graphics device does wrong, as error values.

use wgpu::{DeviceLostReason, ErrorFilter};

use super::Graphics;
use crate::error::RendererError;

/// The errors to catch. One makes others, of a later kind, where what was not made is used.
const KINDS: [ErrorFilter; 3] =
    [ErrorFilter::OutOfMemory, ErrorFilter::Validation, ErrorFilter::Internal];

impl Graphics {
    /// Does `work` and reports what the device finds wrong with it. `what` completes the sentence
    /// "the graphics device can't …".
    ///
    /// # Errors
    /// The device lacks memory, refuses or fails, or is lost.
    pub(crate) fn guard<T>(
        &self,
        what: &str,
        work: impl FnOnce(&wgpu::Device) -> T,
    ) -> Result<T, RendererError> {
        self.check_loss()?;
        let device = self.device();
        // Scopes are of this thread and are closed in reverse order.
        let scopes = KINDS.map(|kind| device.push_error_scope(kind));
        let made = work(device);
        let errors = scopes.into_iter().rev().map(|scope| pollster::block_on(scope.pop()));
        let first = errors.flatten().last();
        // Work on a lost device fails in silence; the loss itself comes to light here.
        self.poll();
        self.check_loss()?;
        match first {
            None => Ok(made),
            Some(error) => Err(self.fault(what, &error)),
        }
    }

    /// # Errors
    /// The device is lost.
    pub(super) fn check_loss(&self) -> Result<(), RendererError> {
        self.loss().map_or(Ok(()), |loss| Err(self.lost(loss)))
    }

    /// Takes the device for lost from now on.
    pub(super) fn lose(&self, reason: &str) {
        // Where the device has said why itself, that stands.
        self.shared.loss.get_or_init(|| reason.to_owned());
    }

    fn lost(&self, loss: &str) -> RendererError {
        RendererError::Graphics(format!("the graphics device {} is lost: {loss}", self.name()))
    }

    fn fault(&self, what: &str, error: &wgpu::Error) -> RendererError {
        let name = self.name();
        RendererError::Graphics(match error {
            wgpu::Error::OutOfMemory { .. } => format!(
                "the graphics device {name} can't {what}: its memory is full; close other \
                 programs or make the picture smaller"
            ),
            wgpu::Error::Validation { description, .. }
            | wgpu::Error::Internal { description, .. } => {
                format!("the graphics device {name} can't {what}: {}", one_line(description))
            }
        })
    }
}

/// wgpu's tree of causes without its headings.
fn one_line(description: &str) -> String {
    let lines = description.lines().map(str::trim);
    let lines = lines.filter(|line| !matches!(*line, "" | "Validation Error" | "Caused by:"));
    lines.collect::<Vec<_>>().join(": ")
}

/// Why a device is gone, in words.
pub(super) fn loss_text(reason: DeviceLostReason, text: &str) -> String {
    match reason {
        DeviceLostReason::Destroyed => "it was shut down".to_owned(),
        DeviceLostReason::Unknown => format!("its driver failed ({text})"),
    }
}
