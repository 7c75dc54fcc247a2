//! A bar on the terminal while work is long.

use std::io::IsTerminal;
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use lineament::{Cloud, Error, Extraction, Params, Progress, extract, extract_observed};

/// Work shorter than this shows nothing.
const PATIENCE: Duration = Duration::from_millis(700);
const STEPS: u64 = 1000;

/// Extracts the lines with a bar on standard error, if that is a terminal and the user has not asked for quiet.
pub fn observed(cloud: &Cloud, params: &Params, quiet: bool) -> Result<Extraction, Error> {
    if quiet || !std::io::stderr().is_terminal() {
        return extract(cloud, params);
    }
    let start = Instant::now();
    let bar: Mutex<Option<ProgressBar>> = Mutex::new(None);
    let result = extract_observed(cloud, params, &|progress: Progress| {
        if start.elapsed() >= PATIENCE {
            let mut bar = bar.lock().unwrap_or_else(PoisonError::into_inner);
            show(bar.get_or_insert_with(new_bar), progress);
        }
    });
    if let Some(bar) = bar.into_inner().unwrap_or_else(PoisonError::into_inner) {
        bar.finish_and_clear();
    }
    result
}

fn new_bar() -> ProgressBar {
    let bar = ProgressBar::with_draw_target(Some(STEPS), ProgressDrawTarget::stderr());
    if let Ok(style) = ProgressStyle::with_template("{msg:>12} [{bar:40}] {elapsed}") {
        bar.set_style(style.progress_chars("=> "));
    }
    bar
}

fn show(bar: &ProgressBar, progress: Progress) {
    bar.set_message(progress.stage.name());
    bar.set_position((progress.done.clamp(0.0, 1.0) * STEPS as f64) as u64);
}
