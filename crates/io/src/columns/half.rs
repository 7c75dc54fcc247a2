//! Numbers of half precision (IEEE 754-2008, binary16), which files store and columns hold as `f32`.

/// The value of 16 bits, which `f32` holds exactly.
pub(crate) fn single(bits: u16) -> f32 {
    let sign = u32::from(bits & 0x8000) << 16;
    let magnitude = u32::from(bits & 0x7fff);
    if magnitude >= 0x7c00 {
        return f32::from_bits(sign | 0x7f80_0000 | magnitude << 13);
    }
    // The exponents of the two types differ by 112; a product makes numbers below the normal ones right too.
    let scaled = f32::from_bits(magnitude << 13) * f32::from_bits((127 + 112) << 23);
    f32::from_bits(sign | scaled.to_bits())
}

#[cfg(test)]
mod tests {
    use super::single;

    #[test]
    fn every_value_is_sign_times_mantissa_times_power() {
        for bits in 0..=u16::MAX {
            let (exponent, mantissa) = (i32::from(bits >> 10 & 31), f64::from(bits & 1023));
            let magnitude = match exponent {
                0 => mantissa * 2f64.powi(-24),
                31 if mantissa == 0.0 => f64::INFINITY,
                31 => f64::NAN,
                _ => (1024.0 + mantissa) * 2f64.powi(exponent - 25),
            };
            let wanted = if bits & 0x8000 == 0 { magnitude } else { -magnitude };
            let found = f64::from(single(bits));
            assert!(found == wanted || found.is_nan() && wanted.is_nan(), "{bits:#x}: {found}, not {wanted}");
            assert_eq!(found.is_sign_negative(), bits & 0x8000 != 0);
        }
    }
}
