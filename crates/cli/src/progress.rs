//! Progress on the terminal while work is long.

use std::io::IsTerminal;
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::time::Duration;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use lineament::section::{SectionParams, Sections, Stack, section_observed};
use lineament::{Cloud, Error, Extraction, Params, Progress, extract, extract_observed};

/// Work shorter than this shows nothing.
const PATIENCE: Duration = Duration::from_millis(700);
const TICK: Duration = Duration::from_millis(120);

/// Extracts the lines. On a terminal, and unless the user has asked for quiet, standard error shows the stage.
pub fn observed(cloud: &Cloud, params: &Params, quiet: bool) -> Result<Extraction, Error> {
    if quiet || !std::io::stderr().is_terminal() {
        return extract(cloud, params);
    }
    shown(|line| extract_observed(cloud, params, &|progress| line.set_message(text(progress))))
}

/// Cuts sections. On a terminal, and unless the user has asked for quiet, standard error shows the share done.
pub fn sectioned(cloud: &Cloud, params: &SectionParams, quiet: bool) -> Result<(Sections, Stack), Error> {
    if quiet || !std::io::stderr().is_terminal() {
        return section_observed(cloud, params, &|_| ());
    }
    shown(|line| {
        line.set_message("section");
        section_observed(cloud, params, &|share| line.set_message(format!("section {:.0} %", 100.0 * share)))
    })
}

/// Does work with a line on standard error that appears once the work is long.
fn shown<R>(work: impl FnOnce(&ProgressBar) -> R) -> R {
    let line = hidden_line();
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

/// The stage, with the share done where it is known.
fn text(progress: Progress) -> String {
    let name = progress.stage.name();
    if progress.done > 0.0 && progress.done < 1.0 {
        format!("{name} {:.0} %", 100.0 * progress.done)
    } else {
        name.into()
    }
}
