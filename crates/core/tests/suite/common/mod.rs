//! What every test of a result needs: the extraction, checked.

use lineament::shapes::Sampled;
use lineament::{Cloud, Error, Extraction, Params, check, evaluate, extract};

/// The extraction with the defaults, all invariants of its network stated.
#[track_caller]
pub fn found(cloud: &Cloud) -> Extraction {
    checked(cloud, &Params::default()).unwrap()
}

/// The extraction; where there is one, all invariants of its network stated.
#[track_caller]
pub fn checked(cloud: &Cloud, params: &Params) -> Result<Extraction, Error> {
    let extraction = extract(cloud, params)?;
    check::network(&extraction.network).unwrap();
    check::sources(&extraction.network, cloud.len()).unwrap();
    Ok(extraction)
}

/// The score of what is found in a scan.
#[track_caller]
pub fn scored(scan: &Sampled) -> evaluate::Score {
    evaluate::against(&found(&scan.cloud).network, &scan.truth, scan.spacing)
}

/// A cloud of these points.
pub fn cloud(points: &[[f64; 3]]) -> Cloud {
    Cloud::new(points.to_vec())
}

/// The points with their coordinates rounded to multiples of 2^-20, so that sums with few-bit numbers are exact.
pub fn few_bits(points: &[[f64; 3]]) -> Vec<[f64; 3]> {
    let steps = f64::from(1 << 20);
    points.iter().map(|p| p.map(|x| (x * steps).round() / steps)).collect()
}
