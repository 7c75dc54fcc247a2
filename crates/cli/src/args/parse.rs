//! Values of options that need parsing.

use lineament::apply::GraphKind;
use lineament::detect::baselines::Detector;
use lineament::mesh::MOST_SAMPLES;
use lineament::params::ParamValue;
use lineament_io::{Format, Returns, StepProtocol, Unit};

/// `KEY=VALUE`.
pub fn setting(text: &str) -> Result<(String, String), String> {
    let (key, value) = text.split_once('=').ok_or("write KEY=VALUE, such as penalty.gamma=0.4")?;
    Ok((key.trim().into(), value.trim().into()))
}

/// A value of a parameter, whatever its range.
pub fn parameter<T: ParamValue>(text: &str) -> Result<T, String> {
    let any = f64::NEG_INFINITY..=f64::INFINITY;
    T::parse(text).ok_or_else(|| format!("expected {}", T::accepts(&any)))
}

/// The name of a detector.
pub fn detector(text: &str) -> Result<Detector, String> {
    let names = || Detector::ALL.map(Detector::name).join(", ");
    Detector::named(text).ok_or_else(|| format!("the detectors are {}", names()))
}

/// Six numbers, the least corner and the greatest.
pub fn bounds(text: &str) -> Result<[[f64; 3]; 2], String> {
    let numbers: Option<Vec<f64>> = text.split(',').map(|t| t.trim().parse().ok()).collect();
    match numbers.as_deref() {
        Some(&[a, b, c, d, e, f]) if a <= d && b <= e && c <= f => Ok([[a, b, c], [d, e, f]]),
        _ => Err("write the least and the greatest corner as six numbers: X,Y,Z,X,Y,Z".into()),
    }
}

/// A whole number from 1 on.
pub fn count(text: &str) -> Result<usize, String> {
    text.parse().ok().filter(|&n| n > 0).ok_or_else(|| "a whole number from 1 on was expected".into())
}

/// A number of points on a mesh.
pub fn samples(text: &str) -> Result<usize, String> {
    let count = text.parse().ok().filter(|n| (1..=MOST_SAMPLES).contains(n));
    count.ok_or_else(|| format!("a whole number from 1 to {MOST_SAMPLES} was expected"))
}

/// A number above 0.
pub fn length(text: &str) -> Result<f64, String> {
    let length = text.parse().ok().filter(|&x: &f64| x > 0.0 && x.is_finite());
    length.ok_or_else(|| "a number above 0 was expected".into())
}

/// An angle between faces, degrees.
pub fn angle(text: &str) -> Result<f64, String> {
    let angle = text.parse().ok().filter(|x: &f64| *x > 0.0 && *x < 180.0);
    angle.ok_or_else(|| "a number of degrees above 0 and below 180 was expected".into())
}

/// The name of a neighbour graph.
pub fn graph(name: &str) -> Result<GraphKind, String> {
    match name {
        "riemannian" => Ok(GraphKind::Riemannian),
        "delaunay" => Ok(GraphKind::Delaunay),
        _ => Err("riemannian or delaunay was expected".into()),
    }
}

/// A number from 0 to 1.
pub fn share(text: &str) -> Result<f64, String> {
    let share = text.parse().ok().filter(|x| (0.0..=1.0).contains(x));
    share.ok_or_else(|| "a number from 0 to 1 was expected".into())
}

/// The name or an extension of a format of scans.
pub fn format(text: &str) -> Result<Format, String> {
    Format::parse(text).ok_or_else(|| {
        let names: Vec<String> = Format::all().iter().map(Format::to_string).collect();
        format!("the formats that can be read are {}", names.join(", "))
    })
}

/// Three names or numbers of columns.
pub fn columns(text: &str) -> Result<[String; 3], String> {
    let parts: Vec<String> = text.split(',').map(|part| part.trim().into()).collect();
    let three = <[String; 3]>::try_from(parts).ok().filter(|parts| parts.iter().all(|part| !part.is_empty()));
    three.ok_or_else(|| "write the columns of x, y and z: 2,3,4 or their names".into())
}

/// The code of a reference system.
pub fn reference(text: &str) -> Result<u32, String> {
    lineament_io::reference_code(text).ok_or_else(|| {
        "expected the code of a horizontal reference system of the EPSG register, such as EPSG:25832".into()
    })
}

/// The returns of a pulse.
pub fn returns(text: &str) -> Result<Returns, String> {
    match text {
        "first" => Ok(Returns::First),
        "last" => Ok(Returns::Last),
        "only" => Ok(Returns::Only),
        _ => Err("first, last or only was expected".into()),
    }
}

/// The sign of a unit of length.
pub fn unit(text: &str) -> Result<Unit, String> {
    Unit::parse(text).ok_or_else(|| format!("the units are {}", Unit::ALL.map(Unit::sign).join(", ")))
}

/// An application protocol of STEP.
pub fn protocol(text: &str) -> Result<StepProtocol, String> {
    match text.to_ascii_lowercase().as_str() {
        "ap242" => Ok(StepProtocol::Ap242),
        "ap214" => Ok(StepProtocol::Ap214),
        _ => Err("ap242 or ap214 was expected".into()),
    }
}

/// A number of bytes, with K, M, G or T for powers of 1024.
pub fn bytes(text: &str) -> Result<u64, String> {
    let units = [('K', 1u64 << 10), ('M', 1 << 20), ('G', 1 << 30), ('T', 1 << 40)];
    let unit = units.iter().find(|(letter, _)| text.ends_with([*letter, letter.to_ascii_lowercase()]));
    let (digits, factor) = unit.map_or((text, 1), |(_, factor)| (&text[..text.len() - 1], *factor));
    let bytes = digits.parse::<u64>().ok().and_then(|n| n.checked_mul(factor));
    bytes.ok_or_else(|| "write a number of bytes, such as 500M or 4G".into())
}

/// `WIDTHxHEIGHT`.
pub fn size(text: &str) -> Result<(usize, usize), String> {
    let sides = text.split_once(['x', 'X']).and_then(|(w, h)| Some((w.parse().ok()?, h.parse().ok()?)));
    sides.ok_or_else(|| "write WIDTHxHEIGHT in pixels, such as 1600x1200".into())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn settings_split_at_the_first_equals_sign() {
        assert_eq!(setting("a.b = c=d"), Ok(("a.b".into(), "c=d".into())));
        assert!(setting("a.b").is_err());
    }

    #[test]
    fn bounds_are_two_corners_in_order() {
        assert_eq!(bounds("-1,0,2,3.5,0,1e3"), Ok([[-1.0, 0.0, 2.0], [3.5, 0.0, 1e3]]));
        for bad in ["", "1,2,3", "1,0,0,0,1,1", "nan,0,0,1,1,1", "0,0,0,1,1,1,1"] {
            assert!(bounds(bad).is_err(), "{bad}");
        }
    }

    #[test]
    fn bytes_have_units() {
        assert_eq!(bytes("500"), Ok(500));
        assert_eq!(bytes("4G"), Ok(4 << 30));
        assert_eq!(bytes("64m"), Ok(64 << 20));
        for bad in ["", "G", "-1", "1.5G", "99999999999T"] {
            assert!(bytes(bad).is_err(), "{bad}");
        }
    }

    #[test]
    fn sizes_are_width_by_height() {
        assert_eq!(size("800x600"), Ok((800, 600)));
        for bad in ["800", "x", "800x", "8x6x4", "-8x6", "800x6.5"] {
            assert!(size(bad).is_err(), "{bad}");
        }
    }
}
