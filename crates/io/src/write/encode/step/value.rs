//! Values of parameters in the exchange structure (ISO 10303-21, 6.4).

use std::fmt::{self, Display, Formatter};

/// Number of an instance.
pub(in crate::write) type Id = usize;

/// A real number in the shortest decimals that give it back; it always has a point, and its exponent a capital letter.
pub(in crate::write) struct Real(pub f64);

impl Display for Real {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let text = format!("{:?}", self.0);
        match text.split_once('e') {
            Some((mantissa, exponent)) => {
                let point = if mantissa.contains('.') { "" } else { "." };
                write!(f, "{mantissa}{point}E{exponent}")
            }
            None => f.write_str(&text),
        }
    }
}

/// A text in quotes: those inside are doubled, and what is not ASCII is given by its code.
pub(in crate::write) struct Text<'a>(pub &'a str);

impl Display for Text<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.write_str("'")?;
        for c in self.0.chars() {
            match c {
                '\'' => f.write_str("''")?,
                '\\' => f.write_str("\\\\")?,
                ' '..='~' => write!(f, "{c}")?,
                _ => write!(f, "\\X4\\{:08X}\\X0\\", c as u32)?,
            }
        }
        f.write_str("'")
    }
}

/// A list of instances.
pub(in crate::write) struct List<'a>(pub &'a [Id]);

impl Display for List<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.write_str("(")?;
        for (k, id) in self.0.iter().enumerate() {
            write!(f, "{}#{id}", if k > 0 { "," } else { "" })?;
        }
        f.write_str(")")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reals_have_a_point_and_a_capital_exponent() {
        let shown = [1.0, -0.5, 1e-7, 2.5e300, 5648349.895035].map(|x| Real(x).to_string());
        assert_eq!(shown, ["1.0", "-0.5", "1.E-7", "2.5E300", "5648349.895035"]);
    }

    #[test]
    fn texts_are_ascii() {
        assert_eq!(Text("it's a\\b \u{e9}").to_string(), "'it''s a\\\\b \\X4\\000000E9\\X0\\'");
    }
}
