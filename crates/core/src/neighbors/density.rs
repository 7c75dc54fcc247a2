//! The sampling density as a length (Gumhold 2001, section 2.2).

use crate::math::vec3::distance;

/// Mean distance `mu`, the paper's average distance, of point `i` from its neighbours `near`; zero if there are none.
pub fn mean_distance(points: &[[f64; 3]], i: usize, near: &[u32]) -> f64 {
    let sum: f64 = near.iter().map(|&j| distance(points[i], points[j as usize])).sum();
    sum / near.len().max(1) as f64 // equation 1
}
