//! Which files each input's results go to.

use std::ffi::OsString;
use std::path::{MAIN_SEPARATOR, Path, PathBuf};

use crate::failure::{Code, Failure};
use crate::source::Origin;

/// The place of an input's name in a pattern.
const STEM: &str = "{stem}";

/// For each input the outputs: `asked`, where a folder means files in it that are named after the input with each of
/// `suffixes`, and `{stem}` in a name means the input's name without folders and extension. Without `asked`, files
/// beside the input; standard output for standard input.
///
/// # Errors
/// Usage if two outputs would be one file.
pub fn plan(origins: &[Origin], asked: &[PathBuf], suffixes: &[&str]) -> Result<Vec<Vec<PathBuf>>, Failure> {
    let plan: Vec<Vec<PathBuf>> = origins.iter().map(|origin| of_one(origin, asked, suffixes)).collect();
    match first_repeated(&plan) {
        None => Ok(plan),
        Some((path, [one, other])) => Err(repeated(path, &origins[one], &origins[other], asked)),
    }
}

/// The failure of two outputs that are one file, which belong to two inputs, or to one.
fn repeated(path: &Path, one: &Origin, other: &Origin, asked: &[PathBuf]) -> Failure {
    let path = path.display();
    let twice = Failure::new(Code::Usage, format!("{path}: named as output twice"));
    if std::ptr::eq(one, other) {
        return twice;
    }
    let named_by_input = |path: &PathBuf| is_folder(path) || path.to_string_lossy().contains(STEM);
    if asked.iter().all(named_by_input) {
        let [one, other] = [one, other].map(Origin::shown);
        let message = format!("{path}: would be the output of both {one} and {other}");
        return Failure::new(Code::Usage, message).advise("give each a run, and an output, of its own");
    }
    twice.advise("several inputs are named: give a folder, or a name with {stem} in it, such as lines/{stem}.dxf; each output has an -o of its own")
}

fn of_one(origin: &Origin, asked: &[PathBuf], suffixes: &[&str]) -> Vec<PathBuf> {
    let of_stem = |folder: PathBuf, stem: OsString| {
        suffixes.iter().map(move |suffix| folder.join(with_suffix(stem.clone(), suffix)))
    };
    match origin.folder() {
        _ if !asked.is_empty() => asked
            .iter()
            .flat_map(|path| {
                if is_folder(path) {
                    of_stem(path.clone(), origin.stem()).collect()
                } else {
                    vec![filled(path, origin)]
                }
            })
            .collect(),
        Some(folder) => of_stem(folder, origin.own_stem()).collect(),
        None => vec![PathBuf::from("-")],
    }
}

fn with_suffix(mut name: OsString, suffix: &str) -> OsString {
    name.push(".");
    name.push(suffix);
    name
}

/// The name with `{stem}` replaced.
pub fn filled(path: &Path, origin: &Origin) -> PathBuf {
    match path.to_str() {
        Some(text) if text.contains(STEM) => text.replace(STEM, &origin.stem().to_string_lossy()).into(),
        _ => path.into(),
    }
}

fn is_folder(path: &Path) -> bool {
    path.is_dir() || ends_in_slash(path)
}

fn ends_in_slash(path: &Path) -> bool {
    path.as_os_str().to_string_lossy().ends_with(['/', MAIN_SEPARATOR])
}

/// A file that stands in the plan twice, and the inputs that it belongs to.
fn first_repeated(plan: &[Vec<PathBuf>]) -> Option<(&Path, [usize; 2])> {
    let mut all: Vec<(&PathBuf, usize)> = Vec::new();
    plan.iter().enumerate().for_each(|(i, outputs)| all.extend(outputs.iter().map(|path| (path, i))));
    all.sort();
    all.windows(2).find(|w| w[0].0 == w[1].0).map(|w| (w[0].0.as_path(), [w[0].1, w[1].1]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::source;

    const SUFFIXES: [&str; 2] = ["lines.json", "lines.obj"];

    fn files(names: &[&str]) -> Vec<Origin> {
        source::files_at(&names.iter().map(PathBuf::from).collect::<Vec<_>>())
    }

    fn planned(inputs: &[&str], asked: &[&str]) -> Result<Vec<Vec<PathBuf>>, Failure> {
        let asked: Vec<PathBuf> = asked.iter().map(PathBuf::from).collect();
        plan(&files(inputs), &asked, &SUFFIXES)
    }

    #[test]
    fn default_outputs_stand_beside_the_input() {
        let expected = ["scans/a.b.lines.json", "scans/a.b.lines.obj"].map(PathBuf::from);
        assert_eq!(planned(&["scans/a.b.ply"], &[]).unwrap(), [expected]);
        assert_eq!(plan(&[Origin::Stdin], &[], &SUFFIXES).unwrap(), [[PathBuf::from("-")]]);
        let sample = Origin::Sample { name: "box".into(), seed: 1 };
        assert_eq!(plan(&[sample], &[], &SUFFIXES).unwrap()[0][0], PathBuf::from("box.lines.json"));
    }

    #[test]
    fn patterns_are_filled_for_each_input() {
        let plan = planned(&["x/a.ply", "y/b.xyz"], &["{stem}.dxf", "{stem}/{stem}.obj"]).unwrap();
        assert_eq!(plan, [["a.dxf", "a/a.obj"].map(PathBuf::from), ["b.dxf", "b/b.obj"].map(PathBuf::from)]);
    }

    #[test]
    fn folders_hold_the_default_names_and_are_not_made_yet() {
        let plan = planned(&["a.ply", "b.ply"], &["new/lines/"]).unwrap();
        assert_eq!(plan[1][0], PathBuf::from("new/lines/b.lines.json"));
        assert!(!Path::new("new").exists());
    }

    #[test]
    fn inputs_of_one_name_have_their_folders_name_before_it() {
        let inputs = ["p/a.ply", "q/a.ply", "b.ply", "a.xyz"];
        let first = |asked: &[&str]| -> Vec<String> {
            let plan = planned(&inputs, asked).unwrap();
            plan.iter().map(|outputs| outputs[0].display().to_string()).collect()
        };
        assert_eq!(first(&["{stem}.obj"]), ["p_a.obj", "q_a.obj", "b.obj", "a.obj"]);
        let all = ["o/p_a.lines.json", "o/q_a.lines.json", "o/b.lines.json", "o/a.lines.json"];
        assert_eq!(first(&["o/"]), all);
        let beside = ["p/a.lines.json", "q/a.lines.json", "b.lines.json", "a.lines.json"];
        assert_eq!(first(&[]), beside);
        let failure = planned(&["p/a.ply", "p/a.xyz"], &["o/"]).unwrap_err();
        assert!(failure.message.contains("both p/a.ply and p/a.xyz"), "{}", failure.message);
        assert!(!failure.advice.unwrap().contains("folder"));
    }

    #[test]
    fn outputs_that_would_be_one_file_are_refused() {
        for (inputs, asked) in [
            (vec!["a.ply"], vec!["x.obj", "x.obj"]),
            (vec!["a.ply", "b.ply"], vec!["x.obj"]),
            (vec!["a.ply", "b.ply"], vec!["-"]),
            (vec!["x/p/a.ply", "y/p/a.ply"], vec!["{stem}.obj"]),
            (vec!["a.ply", "a.xyz"], vec![]),
        ] {
            assert_eq!(planned(&inputs, &asked).unwrap_err().code, Code::Usage, "{inputs:?} {asked:?}");
        }
    }
}
