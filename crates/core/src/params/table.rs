//! The macro that turns the one table of parameters into structs, defaults, checks and listings.

/// One parameter as a listing shows it.
#[derive(Clone, Debug, PartialEq)]
pub struct Entry {
    /// Section and name, such as `penalty.gamma`.
    pub key: String,
    /// The value as text, in the form that [`Params::set`](super::Params::set) reads.
    pub value: String,
    /// The default as text.
    pub default: String,
    /// The unit, empty for a plain number.
    pub unit: &'static str,
    /// The values accepted, in words.
    pub accepts: String,
    /// The words accepted; none of numbers.
    pub names: Vec<&'static str>,
    /// Its meaning.
    pub doc: &'static str,
}

/// Declares the parameter structs. Each line is `name: type = default, "unit", least..=greatest;` under its documentation.
macro_rules! sections {
    (
        $(#[$meta:meta])*
        pub struct Params;
        $(
            $(#[doc = $section_doc:literal])+
            $section:ident: $type:ident {
                $( $(#[doc = $doc:literal])+ $field:ident: $value:ty = $default:expr, $unit:literal, $range:expr; )+
            }
        )+
    ) => {
        $(#[$meta])*
        #[derive(Clone, Debug, PartialEq)]
        pub struct Params {
            /// The method that finds the lines.
            pub method: Method,
            $( $(#[doc = $section_doc])+ pub $section: $type, )+
        }

        $(
            $(#[doc = $section_doc])+
            #[derive(Clone, Debug, PartialEq)]
            pub struct $type {
                $( $(#[doc = $doc])+ pub $field: $value, )+
            }

            impl Default for $type {
                fn default() -> Self {
                    Self { $( $field: $default, )+ }
                }
            }

            impl $type {
                /// Checks every value against its range.
                ///
                /// # Errors
                /// [`Error::Parameter`] for the first value outside its range.
                pub fn check(&self) -> Result<(), Error> {
                    $(
                        $crate::params::table::check(
                            concat!(stringify!($section), ".", stringify!($field)),
                            &self.$field,
                            &$range,
                        )?;
                    )+
                    Ok(())
                }
            }
        )+

        impl Default for Params {
            fn default() -> Self {
                Self { method: Method::Auto, $( $section: $type::default(), )+ }
            }
        }

        impl Params {
            /// Sets the parameter `key`, such as `penalty.gamma` or `method`, from text.
            ///
            /// # Errors
            /// [`Error::Parameter`] when there is no such key, or the text is not a value in its range.
            pub fn set(&mut self, key: &str, text: &str) -> Result<(), Error> {
                if key == "method" {
                    self.method = $crate::params::table::read(key, text, &(0.0..=0.0))?;
                    return Ok(());
                }
                $( $(
                    if key == concat!(stringify!($section), ".", stringify!($field)) {
                        self.$section.$field = $crate::params::table::read(key, text, &$range)?;
                        return Ok(());
                    }
                )+ )+
                Err(Error::Parameter {
                    key: key.into(),
                    value: text.into(),
                    expected: "there is no parameter of this name".into(),
                })
            }

            /// Every parameter with its value, default, unit, range and meaning, in the order of the pipeline.
            pub fn entries(&self) -> Vec<Entry> {
                let default = Self::default();
                let mut entries = vec![$crate::params::table::entry(
                    "method".into(),
                    &self.method,
                    &default.method,
                    "",
                    &(0.0..=0.0),
                    "The method that finds the lines.",
                )];
                $( $(
                    entries.push($crate::params::table::entry(
                        concat!(stringify!($section), ".", stringify!($field)).into(),
                        &self.$section.$field,
                        &default.$section.$field,
                        $unit,
                        &$range,
                        concat!($($doc),+).trim(),
                    ));
                )+ )+
                entries
            }

            /// Checks every value against its range.
            ///
            /// # Errors
            /// [`Error::Parameter`] for the first value outside its range.
            pub fn check(&self) -> Result<(), Error> {
                $( self.$section.check()?; )+
                Ok(())
            }
        }
    };
}
pub(super) use sections;

use super::ParamValue;
use crate::Error;
use std::ops::RangeInclusive;

/// Reads and checks one value.
pub(super) fn read<T: ParamValue>(key: &str, text: &str, range: &RangeInclusive<f64>) -> Result<T, Error> {
    let expected = || Error::Parameter { key: key.into(), value: text.into(), expected: expect::<T>(range) };
    let value = T::parse(text.trim()).ok_or_else(expected)?;
    check(key, &value, range)?;
    Ok(value)
}

/// Holds one value against its range.
pub(super) fn check<T: ParamValue>(key: &str, value: &T, range: &RangeInclusive<f64>) -> Result<(), Error> {
    if let Some(expected) = value.fault() {
        return Err(Error::Parameter {
            key: key.into(),
            value: value.show(),
            expected: format!("expected {expected}"),
        });
    }
    match value.number() {
        Some(x) if !range.contains(&x) => {
            Err(Error::Parameter { key: key.into(), value: value.show(), expected: expect::<T>(range) })
        }
        _ => Ok(()),
    }
}

/// One row of the listing.
pub(super) fn entry<T: ParamValue>(
    key: String,
    value: &T,
    default: &T,
    unit: &'static str,
    range: &RangeInclusive<f64>,
    doc: &'static str,
) -> Entry {
    let (value, default) = (value.show(), default.show());
    Entry { key, value, default, unit, accepts: T::accepts(range), names: T::names(), doc }
}

fn expect<T: ParamValue>(range: &RangeInclusive<f64>) -> String {
    format!("expected {}", T::accepts(range))
}

#[cfg(test)]
mod tests {
    use crate::Params;

    #[test]
    fn every_entry_sets_back_to_its_own_text() {
        let mut params = Params::default();
        for entry in Params::default().entries() {
            assert_eq!(entry.value, entry.default);
            params.set(&entry.key, &entry.value).unwrap();
        }
        assert_eq!(params, Params::default());
        params.check().unwrap();
    }

    #[test]
    fn a_value_outside_its_range_is_refused_with_key_and_range() {
        let error = Params::default().set("neighbors.k", "3").unwrap_err().to_string();
        assert!(
            error.contains("neighbors.k") && error.contains("`3`") && error.contains("from 4 to 64"),
            "{error}"
        );
        let mut params = Params::default();
        params.neighbors.k = 1000;
        assert!(params.check().is_err());
    }

    #[test]
    fn methods_have_the_names_of_their_authors_too() {
        let mut params = Params::default();
        for (name, canonical) in [("tran", "projection"), ("demarsin", "segments"), ("gumhold", "penalty")] {
            params.set("method", name).unwrap();
            let shown = params.entries().swap_remove(0).value;
            assert_eq!(shown, canonical);
            params.set("method", canonical).unwrap();
            assert_eq!(params.entries().swap_remove(0).value, shown);
        }
        assert!(params.set("method", "Tran").is_err());
    }

    #[test]
    fn unknown_keys_and_text_that_is_no_number_are_refused() {
        let mut params = Params::default();
        assert!(params.set("penalty.nosuch", "1").is_err());
        assert!(params.set("penalty.gamma", "many").is_err());
        assert!(params.set("penalty.gamma", "NaN").is_err());
        assert!(params.set("penalty.hops", "auto").is_ok());
        assert!(params.set("penalty.hops", "3").is_ok());
    }
}
