//! The number of threads changes no byte.

use crate::common::Sandbox;

#[test]
fn outputs_are_the_same_for_1_2_4_and_8_threads() {
    for sample in ["random-cube", "bent-sheet"] {
        let sandbox = Sandbox::new();
        let mut first: Option<[Vec<u8>; 3]> = None;
        for threads in ["1", "2", "4", "8"] {
            let with = |args: &[&str]| {
                sandbox.run(&[args, &["--sample", sample, "--threads", threads]].concat()).expect(0);
            };
            with(&["extract", "-o", "a.json"]);
            with(&["classify", "-o", "a.ply"]);
            with(&["render", "-o", "a.png", "--size", "400x300"]);
            let files = ["a.json", "a.ply", "a.png"].map(|name| sandbox.read(name));
            match &first {
                None => first = Some(files),
                Some(first) => assert!(*first == files, "{sample} differs with {threads} threads"),
            }
        }
    }
}
