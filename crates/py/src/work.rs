//! Long work: on a thread of its own, while the calling thread watches for Ctrl-C and tells of progress.

mod pool;

use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering::Relaxed};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::thread::Builder;
use std::time::Duration;

use numpy::{PyArray2, PyArrayMethods};
use pyo3::prelude::*;

use crate::arrays::rows;
use crate::fault::Fault;
use pool::{STACK, pool};

/// How often the calling thread looks for Ctrl-C.
const GLANCE: Duration = Duration::from_millis(40);

/// Is told the stage and the share of it that is done.
pub type Observe<'a> = &'a (dyn Fn(&'static str, f64) + Sync);

/// What the worker sends.
enum Message<T> {
    Progress(&'static str, f64),
    End(Result<T, Fault>),
}

/// The payload with which abandoned work unwinds.
struct Abandoned;

/// Does `work` on the rows of `points` without holding the interpreter's lock, and without a copy of them. `progress` is called
/// with stage and share on the thread of the caller. An exception there, or of a signal, is raised at once; the work then ends
/// when it next tells of its progress.
pub fn on_rows<T, W>(points: &Bound<PyArray2<f64>>, progress: Option<Bound<PyAny>>, work: W) -> PyResult<T>
where
    T: Send + 'static,
    W: FnOnce(&[[f64; 3]], Observe) -> Result<T, Fault> + Send + 'static,
{
    let array = points.clone().unbind();
    watched(points.py(), progress, move |observe| {
        let done = Python::try_attach(|py| {
            let array = array.bind(py).try_readonly().map_err(|e| Fault::Internal(e.to_string()))?;
            let points = rows(&array)?;
            py.detach(|| caught(|| pool()?.install(|| work(points, observe))))
        });
        done.unwrap_or_else(|| Err(Fault::Internal("the interpreter has ended".into())))
    })
}

/// As [`on_rows`], of work that has no array of Python's to read.
pub fn alone<T, W>(py: Python, work: W) -> PyResult<T>
where
    T: Send + 'static,
    W: FnOnce() -> Result<T, Fault> + Send + 'static,
{
    watched(py, None, |_| caught(|| pool()?.install(work)))
}

fn watched<T, W>(py: Python, progress: Option<Bound<PyAny>>, work: W) -> PyResult<T>
where
    T: Send + 'static,
    W: FnOnce(Observe) -> Result<T, Fault> + Send + 'static,
{
    let (sender, mut messages) = channel();
    let abandoned = Arc::new(AtomicBool::new(false));
    let flag = abandoned.clone();
    Builder::new()
        .name("lineament".into())
        .stack_size(STACK)
        .spawn(move || {
            let result = work(&|stage, share| tell(&flag, &sender, stage, share));
            // The caller has gone only if it was interrupted.
            let _ = sender.send(Message::End(result));
        })
        .map_err(|e| Fault::Internal(format!("no thread: {e}")))?;
    watch(py, &mut messages, progress).inspect_err(|_| abandoned.store(true, Relaxed))
}

/// Sends progress, or unwinds if nobody waits for the result any more.
fn tell<T>(abandoned: &AtomicBool, sender: &Sender<Message<T>>, stage: &'static str, share: f64) {
    if abandoned.load(Relaxed) {
        resume_unwind(Box::new(Abandoned));
    }
    let _ = sender.send(Message::Progress(stage, share));
}

/// Passes messages on until the last.
fn watch<T: Send>(
    py: Python,
    messages: &mut Receiver<Message<T>>,
    progress: Option<Bound<PyAny>>,
) -> PyResult<T> {
    loop {
        let own = &mut *messages;
        let message = py.detach(move || own.recv_timeout(GLANCE));
        py.check_signals()?;
        match (message, &progress) {
            (Ok(Message::End(result)), _) => return Ok(result?),
            (Ok(Message::Progress(stage, share)), Some(progress)) => {
                progress.call1((stage, share))?;
            }
            (Ok(Message::Progress(..)) | Err(RecvTimeoutError::Timeout), _) => {}
            (Err(RecvTimeoutError::Disconnected), _) => {
                return Err(Fault::Internal("the work ended without a result".into()).into());
            }
        }
    }
}

/// Does work, with a panic as an error.
fn caught<T>(work: impl FnOnce() -> Result<T, Fault>) -> Result<T, Fault> {
    let done = catch_unwind(AssertUnwindSafe(work));
    done.unwrap_or_else(|payload| Err(Fault::Internal(told(payload.as_ref()))))
}

/// The text of a panic.
fn told(payload: &(dyn Any + Send)) -> String {
    let text = payload.downcast_ref::<String>().map(String::as_str);
    text.or_else(|| payload.downcast_ref::<&str>().copied()).unwrap_or("a panic").into()
}
