//! The types that a parameter can have, and how they read and print.

/// A parameter that follows from the data unless it is given.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Auto<T> {
    /// Derived from the data.
    Auto,
    /// As given.
    Given(T),
}

impl<T: Copy> Auto<T> {
    /// The given value, or that of `derive`.
    pub fn or(self, derive: impl FnOnce() -> T) -> T {
        match self {
            Auto::Auto => derive(),
            Auto::Given(value) => value,
        }
    }

    /// The given value as another.
    pub fn map(self, other: impl FnOnce(T) -> T) -> Self {
        match self {
            Auto::Auto => Auto::Auto,
            Auto::Given(value) => Auto::Given(other(value)),
        }
    }

    /// The given value, if there is one.
    pub fn given(self) -> Option<T> {
        match self {
            Auto::Auto => None,
            Auto::Given(value) => Some(value),
        }
    }
}

/// How a parameter of this type reads from text, prints and is compared with its range.
pub trait ParamValue: Sized {
    /// Reads the text of a command line or parameter file; `None` when it is not of this type.
    fn parse(text: &str) -> Option<Self>;
    /// The text that `parse` reads back.
    fn show(&self) -> String;
    /// The number to hold against the range; `None` when there is none to hold.
    fn number(&self) -> Option<f64>;
    /// The values accepted, in words, given the numeric range.
    fn accepts(range: &std::ops::RangeInclusive<f64>) -> String;
    /// The words accepted; none of numbers.
    fn names() -> Vec<&'static str> {
        Vec::new()
    }
    /// For a value that is refused whatever the range: the values expected instead.
    fn fault(&self) -> Option<&'static str> {
        None
    }
}

/// The range of lengths that may be anything above 0.
pub(crate) const ABOVE_0: std::ops::RangeInclusive<f64> = f64::MIN_POSITIVE..=f64::MAX;

impl ParamValue for usize {
    fn parse(text: &str) -> Option<Self> {
        text.parse().ok()
    }
    fn show(&self) -> String {
        self.to_string()
    }
    fn number(&self) -> Option<f64> {
        Some(*self as f64)
    }
    fn accepts(range: &std::ops::RangeInclusive<f64>) -> String {
        format!("a whole number from {} to {}", range.start(), range.end())
    }
}

impl ParamValue for f64 {
    fn parse(text: &str) -> Option<Self> {
        text.parse().ok().filter(|x: &f64| x.is_finite())
    }
    fn show(&self) -> String {
        format!("{self:?}")
    }
    fn number(&self) -> Option<f64> {
        Some(*self)
    }
    fn accepts(range: &std::ops::RangeInclusive<f64>) -> String {
        if *range == ABOVE_0 {
            return "a number above 0".into();
        }
        format!("a number from {} to {}", range.start(), range.end())
    }
}

impl ParamValue for bool {
    fn parse(text: &str) -> Option<Self> {
        text.parse().ok()
    }
    fn show(&self) -> String {
        self.to_string()
    }
    fn number(&self) -> Option<f64> {
        None
    }
    fn accepts(_: &std::ops::RangeInclusive<f64>) -> String {
        "true or false".into()
    }
    fn names() -> Vec<&'static str> {
        vec!["true", "false"]
    }
}

impl<T: ParamValue> ParamValue for Auto<T> {
    fn parse(text: &str) -> Option<Self> {
        if text == "auto" { Some(Auto::Auto) } else { T::parse(text).map(Auto::Given) }
    }
    fn show(&self) -> String {
        match self {
            Auto::Auto => "auto".into(),
            Auto::Given(value) => value.show(),
        }
    }
    fn number(&self) -> Option<f64> {
        match self {
            Auto::Auto => None,
            Auto::Given(value) => value.number(),
        }
    }
    fn accepts(range: &std::ops::RangeInclusive<f64>) -> String {
        format!("auto or {}", T::accepts(range))
    }
    fn names() -> Vec<&'static str> {
        [vec!["auto"], T::names()].concat()
    }
}

/// Implements [`ParamValue`] for an enum of named choices; names after a bar are read as well.
macro_rules! choices {
    ($type:ident { $($variant:ident = $name:literal $(| $alias:literal)*),+ }) => {
        impl $crate::params::ParamValue for $type {
            fn parse(text: &str) -> Option<Self> {
                match text {
                    $($name $(| $alias)* => Some($type::$variant),)+
                    _ => None,
                }
            }
            fn show(&self) -> String {
                match self {
                    $($type::$variant => $name.into(),)+
                }
            }
            fn number(&self) -> Option<f64> {
                None
            }
            fn accepts(_: &std::ops::RangeInclusive<f64>) -> String {
                concat!("one of", $(" ", $name, $(" (", $alias, ")",)*)+).into()
            }
            fn names() -> Vec<&'static str> {
                vec![$($name, $($alias,)*)+]
            }
        }
    };
}
pub(crate) use choices;
