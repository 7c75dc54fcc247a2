//! Marks of points against their labels.

/// Shares of points marked rightly, and Matthews' correlation coefficient.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MarkScore {
    /// The labels that are to be marked, and those that count neither way.
    pub wanted: &'static [u8],
    /// Labels that count neither way.
    pub left_out: &'static [u8],
    /// Share of the marked points that are to be marked.
    pub precision: f64,
    /// Share of these that are marked.
    pub recall: f64,
    /// Harmonic mean of both.
    pub f1: f64,
    /// Share of all points that are as they should be.
    pub accuracy: f64,
    /// Matthews' correlation coefficient, -1 to 1; 0 where all or none are marked, or to be marked.
    pub mcc: f64,
}

/// The readings of labels: points on an edge are 1, points near it 2, points that count neither way 3. The last is that of labels
/// that know no 3, such as those published with PCEDNet.
const READINGS: [(&[u8], &[u8]); 4] = [(&[1], &[3]), (&[1, 2], &[3]), (&[1], &[2, 3]), (&[1], &[])];

/// Scores `(N)` marks against `(N)` labels in each of the usual readings of the labels.
pub fn marks(marks: &[bool], labels: &[u8]) -> Vec<MarkScore> {
    READINGS.iter().map(|(wanted, left_out)| of(marks, labels, wanted, left_out)).collect()
}

fn of(marks: &[bool], labels: &[u8], wanted: &'static [u8], left_out: &'static [u8]) -> MarkScore {
    // Marked or not, to be marked or not.
    let mut counts = [[0.0f64; 2]; 2];
    for (&mark, label) in marks.iter().zip(labels).filter(|(_, label)| !left_out.contains(label)) {
        counts[usize::from(mark)][usize::from(wanted.contains(label))] += 1.0;
    }
    let [[tn, fn_], [fp, tp]] = counts;
    let (precision, recall) = (tp / (tp + fp).max(1.0), tp / (tp + fn_).max(1.0));
    let sum = precision + recall;
    let all = tn + fn_ + fp + tp;
    let root = ((tp + fp) * (tp + fn_) * (tn + fp) * (tn + fn_)).sqrt();
    MarkScore {
        wanted,
        left_out,
        precision,
        recall,
        f1: if sum > 0.0 { 2.0 * precision * recall / sum } else { 0.0 },
        accuracy: (tp + tn) / all.max(1.0),
        mcc: if root > 0.0 { (tp * tn - fp * fn_) / root } else { 0.0 },
    }
}
