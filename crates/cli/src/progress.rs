//! Progress on the terminal while work is long.

use std::io::IsTerminal;
use std::sync::Mutex;
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use lineament::mesh::Fold;
use lineament::section::{SectionParams, Sections, Stack, section_observed};
use lineament::{Cloud, Error, Extraction, Params, Progress, Stage, extract_sampled, extract_staged};

/// Work shorter than this shows nothing.
const PATIENCE: Duration = Duration::from_millis(700);
const TICK: Duration = Duration::from_millis(120);
/// Stages with their rough share of the time of an extraction.
const SHARES: [(Stage, f64); 8] = [
    (Stage::Localise, 0.03),
    (Stage::Neighbors, 0.17),
    (Stage::Surface, 0.10),
    (Stage::Detect, 0.45),
    (Stage::Link, 0.17),
    (Stage::Recover, 0.03),
    (Stage::Patches, 0.04),
    (Stage::Relations, 0.01),
];

/// Extracts the lines, and keeps the stages of the method if they are to be `staged`. On a terminal, and unless the user has asked for quiet, standard error shows the stage, the share done and
/// the time left.
pub fn observed(
    cloud: &Cloud,
    folds: &[Fold],
    params: &Params,
    staged: bool,
    quiet: bool,
) -> Result<Extraction, Error> {
    let run = |observe: &(dyn Fn(Progress) + Sync)| match staged {
        true => extract_staged(cloud, folds, params, observe),
        false => extract_sampled(cloud, folds, params, observe),
    };
    if is_silent(quiet) {
        return run(&|_| ());
    }
    let clock = Clock::start();
    shown("extract", |line| {
        run(&|progress| line.set_message(clock.text(progress.stage.name(), share(progress))))
    })
}

/// Cuts sections. On a terminal, and unless the user has asked for quiet, standard error shows the share done and the time left.
pub fn sectioned(cloud: &Cloud, params: &SectionParams, quiet: bool) -> Result<(Sections, Stack), Error> {
    if is_silent(quiet) {
        return section_observed(cloud, params, &|_| ());
    }
    let clock = Clock::start();
    shown("section", |line| {
        section_observed(cloud, params, &|share| line.set_message(clock.text("section", share)))
    })
}

/// Does work of which no share is known. On a terminal, and unless the user has asked for quiet, standard error names it.
pub fn named<R>(name: &'static str, quiet: bool, work: impl FnOnce() -> R) -> R {
    if is_silent(quiet) { work() } else { shown(name, |_| work()) }
}

fn is_silent(quiet: bool) -> bool {
    quiet || !std::io::stderr().is_terminal()
}

/// The share of an extraction that is done where a stage begins or ends.
fn share(progress: Progress) -> f64 {
    let before =
        SHARES.iter().take_while(|(stage, _)| *stage != progress.stage).map(|(_, share)| share).sum::<f64>();
    let own = SHARES.iter().find(|(stage, _)| *stage == progress.stage).map_or(0.0, |(_, share)| *share);
    before + progress.done * own
}

/// How long work has taken, and the share of it that is done; shares told late by another thread do not set it back.
struct Clock {
    start: Instant,
    share: Mutex<f64>,
}

impl Clock {
    fn start() -> Self {
        Self { start: Instant::now(), share: Mutex::new(0.0) }
    }

    /// What is done, with the share and the time left where some is known.
    fn text(&self, name: &str, share: f64) -> String {
        let mut most = self.share.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        *most = most.max(share);
        said(name, *most, self.start.elapsed().as_secs_f64())
    }
}

/// The words for work after so many seconds.
fn said(name: &str, share: f64, seconds: f64) -> String {
    if share < 0.02 {
        return name.into();
    }
    let left = (seconds * (1.0 - share) / share).ceil();
    let left = if left < 100.0 { format!("{left:.0} s") } else { format!("{:.0} min", (left / 60.0).ceil()) };
    format!("{name} {:.0} %, {left} left", (100.0 * share).floor())
}

/// Does work with a line on standard error that appears once the work is long.
fn shown<R>(name: &'static str, work: impl FnOnce(&ProgressBar) -> R) -> R {
    let line = hidden_line();
    line.set_message(name);
    let (done, is_done) = channel::<()>();
    let watched = &line;
    let result = std::thread::scope(|scope| {
        scope.spawn(move || {
            if is_done.recv_timeout(PATIENCE) == Err(RecvTimeoutError::Timeout) {
                watched.set_draw_target(ProgressDrawTarget::stderr());
                watched.enable_steady_tick(TICK);
            }
        });
        let result = work(&line);
        drop(done);
        result
    });
    line.finish_and_clear();
    result
}

fn hidden_line() -> ProgressBar {
    let line = ProgressBar::with_draw_target(None, ProgressDrawTarget::hidden());
    match ProgressStyle::with_template("{spinner} {msg} {elapsed}") {
        Ok(style) => line.with_style(style),
        Err(_) => line,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_of_stages_add_up_in_their_order() {
        assert!((SHARES.iter().map(|(_, share)| share).sum::<f64>() - 1.0).abs() < 1e-12);
        let at = |stage, done| share(Progress { stage, done });
        assert_eq!(at(Stage::Localise, 0.0), 0.0);
        assert!((at(Stage::Detect, 0.0) - 0.3).abs() < 1e-12);
        assert!((at(Stage::Relations, 1.0) - 1.0).abs() < 1e-12);
    }

    #[test]
    fn the_time_left_follows_from_the_share() {
        assert_eq!(said("link", 0.0, 5.0), "link");
        assert_eq!(said("link", 0.75, 6.0), "link 75 %, 2 s left");
        assert_eq!(said("section", 0.1, 60.0), "section 10 %, 9 min left");
    }
}
