//! Trial: edges from cross-sections pooled along the direction in which the surface does not change.

mod apply;
mod chain;
mod field;
mod moments;
mod pieces;
mod section;

pub(crate) use apply::edgelets;

pub(super) struct Knobs {
    pub(super) half: f64,
    pub(super) curve: f64,
    pub(super) growth: f64,
    pub(super) piece: f64,
    pub(super) model: f64,
    pub(super) fold: f64,
    pub(super) short: f64,
    pub(super) centre: f64,
    pub(super) like: f64,
    pub(super) chain: f64,
    pub(super) bend: f64,
    pub(super) verbose: f64,
    pub(super) only: f64,
    pub(super) grade: f64,
    pub(super) thin: f64,
    pub(super) snap: f64,
    pub(super) clear: f64,
    pub(super) run: f64,
    pub(super) reach: f64,
}

pub(super) fn knobs() -> &'static Knobs {
    static KNOBS: std::sync::OnceLock<Knobs> = std::sync::OnceLock::new();
    let env = |name: &str, default: f64| std::env::var(name).ok().and_then(|v| v.parse().ok()).unwrap_or(default);
    KNOBS.get_or_init(|| Knobs {
        half: env("HALF", 20.0),
        curve: env("CURVE", 0.08),
        growth: env("GROWTH", 50.0),
        piece: env("PIECE", 9.0),
        model: env("MODEL", 0.06),
        fold: env("FOLD", 22.0),
        short: env("SHORT", 0.5),
        centre: env("CENTRE", 2.5),
        like: env("LIKE", 3.0),
        chain: env("CHAIN", 5.0),
        bend: env("BEND", 0.03),
        verbose: env("VERBOSE", 0.0),
        only: env("ONLY", 0.0),
        grade: env("GRADE", 0.7),
        thin: env("THIN", 1.0),
        snap: env("SNAP", 1.0),
        clear: env("CLEAR", 0.5),
        run: env("RUN", 4.0),
        reach: env("REACH", 1.0),
    })
}
