//! Messages in the window.

use eframe::egui::Align;
use eframe::egui::{Align2, Area, Context, Frame, Id, Layout, Order, RichText, Stroke, Ui, vec2};

use crate::theme;

/// How long a confirmation stays, in seconds.
const CONFIRMATION_SECONDS: f64 = 5.0;

/// What a notice is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoticeKind {
    /// Something went well; goes away by itself.
    Confirmation,
    /// Something went wrong; stays until it is dismissed.
    Error,
}

/// A message for the user.
#[derive(Clone, Debug, PartialEq)]
pub struct Notice {
    /// What it is about.
    pub kind: NoticeKind,
    /// What failed or was done.
    pub title: String,
    /// The file, the fault and the remedy; may be empty.
    pub text: String,
    shown_since: Option<f64>,
}

/// The messages that are shown, the oldest first.
#[derive(Debug, Default)]
pub struct Notices {
    list: Vec<Notice>,
}

impl Notices {
    /// Shows a confirmation.
    pub fn confirm(&mut self, title: impl Into<String>, text: impl Into<String>) {
        self.push(NoticeKind::Confirmation, title.into(), text.into());
    }

    /// Shows an error.
    pub fn error(&mut self, title: impl Into<String>, text: impl Into<String>) {
        self.push(NoticeKind::Error, title.into(), text.into());
    }

    /// The messages, the oldest first.
    pub fn list(&self) -> &[Notice] {
        &self.list
    }

    /// Takes the newest message away, as its button does.
    pub fn dismiss(&mut self) {
        self.list.pop();
    }

    /// Takes messages of this title back: what they say is no longer so.
    pub fn withdraw(&mut self, title: &str) {
        self.list.retain(|notice| notice.title != title);
    }

    fn push(&mut self, kind: NoticeKind, title: String, text: String) {
        // The last try is the one that counts.
        self.withdraw(&title);
        self.list.push(Notice { kind, title, text, shown_since: None });
    }

    /// Shows the messages at the lower left.
    pub fn show(&mut self, ctx: &Context) {
        let now = ctx.time();
        for notice in &mut self.list {
            notice.shown_since.get_or_insert(now);
        }
        self.list.retain(|notice| notice.remaining_seconds(now) > 0.0);
        if self.list.is_empty() {
            return;
        }
        let soonest = self.list.iter().map(|notice| notice.remaining_seconds(now));
        let soonest = soonest.fold(f64::INFINITY, f64::min);
        if soonest.is_finite() {
            ctx.request_repaint_after_secs(soonest as f32);
        }
        let mut dismissed = None;
        Area::new(Id::unique("notices"))
            .order(Order::Foreground)
            .anchor(Align2::LEFT_BOTTOM, vec2(16.0, -44.0))
            .show(ctx, |ui| {
                for (index, notice) in self.list.iter().enumerate() {
                    if notice_ui(ui, notice) {
                        dismissed = Some(index);
                    }
                }
            });
        if let Some(index) = dismissed {
            self.list.remove(index);
        }
    }
}

impl Notice {
    fn remaining_seconds(&self, now: f64) -> f64 {
        match self.kind {
            NoticeKind::Error => f64::INFINITY,
            NoticeKind::Confirmation => {
                CONFIRMATION_SECONDS - (now - self.shown_since.unwrap_or(now))
            }
        }
    }
}

/// True when the notice was dismissed.
fn notice_ui(ui: &mut Ui, notice: &Notice) -> bool {
    let color = match notice.kind {
        NoticeKind::Confirmation => theme::ACCENT,
        NoticeKind::Error => theme::ERROR,
    };
    let frame = Frame::popup(ui.style()).stroke(Stroke::new(1.0, color)).inner_margin(12);
    frame
        .show(ui, |ui| {
            ui.set_width(380.0);
            let dismissed = ui
                .horizontal(|ui| {
                    ui.label(RichText::new(&notice.title).strong());
                    ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                        ui.small_button("Dismiss").clicked()
                    })
                    .inner
                })
                .inner;
            if !notice.text.is_empty() {
                ui.label(&notice.text);
            }
            dismissed
        })
        .inner
}

/// A text that names the file even where the fault does not.
pub fn naming(name: &str, fault: &str) -> String {
    if fault.contains(name) { fault.to_owned() } else { format!("{name}: {fault}") }
}
