//! Fewer points, and several inputs as one.

use crate::common::from_bytes;
use lineament_io::{ReadOptions, Returns, Scan, read_all};

fn grid(options: ReadOptions) -> Scan {
    let mut text = String::from("x y z i\n");
    for i in 0..100 {
        text += &format!("{} {} 0.5 {i}\n", f64::from(i % 10) + 0.25, f64::from(i / 10) + 0.5);
    }
    from_bytes(text.as_bytes(), "grid.xyz", &options).unwrap()
}

#[test]
fn every_nth_point_is_kept_with_its_attributes() {
    let scan = grid(ReadOptions { every: Some(7), ..Default::default() });
    assert_eq!(scan.cloud.len(), 15);
    assert_eq!(scan.cloud.positions[1], [7.25, 0.5, 0.5]);
    assert_eq!(scan.cloud.attributes[0].values.len(), 15);
    assert_eq!(scan.ignored, ["85 points that are not every 7th"]);
}

#[test]
fn bounds_include_both_corners() {
    let scan = grid(ReadOptions { bounds: Some([[0.25, 0.5, 0.0], [2.25, 1.5, 1.0]]), ..Default::default() });
    assert_eq!(scan.cloud.len(), 6);
}

#[test]
fn one_point_a_voxel_whatever_their_order() {
    let options = ReadOptions { voxel: Some(2.0), ..Default::default() };
    let scan = grid(options.clone());
    assert_eq!(scan.cloud.len(), 25);
    assert!(scan.cloud.positions.contains(&[1.25, 0.5, 0.5]));
    let mut rows: Vec<String> = (0..100)
        .map(|i| format!("{} {} 0.5 {i}", f64::from(i % 10) + 0.25, f64::from(i / 10) + 0.5))
        .collect();
    rows.reverse();
    let reversed = from_bytes(rows.join("\n").as_bytes(), "grid.xyz", &options).unwrap();
    let sorted = |scan: &Scan| {
        let mut points: Vec<_> = scan.cloud.positions.iter().map(|p| p.map(f64::to_bits)).collect();
        points.sort_unstable();
        points
    };
    assert_eq!(sorted(&scan), sorted(&reversed));
}

#[test]
fn voxels_finer_than_the_coordinates_are_refused() {
    let options = ReadOptions { voxel: Some(1e-12), ..Default::default() };
    let message = from_bytes(b"1e7 0 0\n1e7 1 0\n1e7 0 1\n", "far.xyz", &options).unwrap_err().to_string();
    assert!(message.contains("finer than coordinates of 10000000"), "{message}");
}

#[test]
fn several_inputs_are_one_cloud_with_the_attributes_they_share() {
    let folder = tempfile::tempdir().unwrap();
    let (a, b) = (folder.path().join("a.csv"), folder.path().join("b.csv"));
    std::fs::write(&a, "x,y,z,i,only\n1,2,3,4,5\n").unwrap();
    std::fs::write(&b, "i,x,y,z\n9,5,6,7\n8,6,7,8\n").unwrap();
    let scan = read_all(&[a.clone(), b], &ReadOptions::default()).unwrap();
    assert_eq!(scan.cloud.positions, [[1.0, 2.0, 3.0], [5.0, 6.0, 7.0], [6.0, 7.0, 8.0]]);
    assert_eq!((scan.cloud.attributes.len(), scan.cloud.attributes[0].values.len()), (1, 3));
    assert!(scan.ignored[0].ends_with("alike: only"), "{:?}", scan.ignored);
    assert!(read_all(&[a, folder.path().join("none.csv")], &ReadOptions::default()).is_err());
}

#[test]
fn classes_and_returns_are_chosen_by_the_columns_that_hold_them() {
    let mut text = String::from("x,y,z,classification,return_number,number_of_returns\n");
    for (i, [class, number, of]) in [[2, 1, 1], [6, 1, 2], [6, 2, 2], [2, 3, 3], [7, 1, 3]].iter().enumerate()
    {
        text += &format!("{i},0,0,{class},{number},{of}\n");
    }
    let read = |classes: &[u8], returns| {
        let options = ReadOptions { classes: classes.to_vec(), returns, ..Default::default() };
        from_bytes(text.as_bytes(), "a.csv", &options)
    };
    let kept = |classes: &[u8], returns| -> Vec<f64> {
        read(classes, returns).unwrap().cloud.positions.iter().map(|p| p[0]).collect()
    };
    assert_eq!(kept(&[2, 7], None), [0.0, 3.0, 4.0]);
    assert_eq!(kept(&[], Some(Returns::First)), [0.0, 1.0, 4.0]);
    assert_eq!(kept(&[], Some(Returns::Last)), [0.0, 2.0, 3.0]);
    assert_eq!(kept(&[], Some(Returns::Only)), [0.0]);
    assert_eq!(kept(&[6], Some(Returns::Last)), [2.0]);
    let message = read(&[9], None).unwrap_err().to_string();
    assert!(message.contains("none of 5 points is of these classes"), "{message}");
    assert!(message.contains("there are the classes 2, 6, 7"), "{message}");
    let options = ReadOptions { returns: Some(Returns::Only), ..Default::default() };
    let message = from_bytes(b"0 0 0\n1 0 0\n", "a.xyz", &options).unwrap_err().to_string();
    assert!(message.contains("its points have no `"), "{message}");
}
