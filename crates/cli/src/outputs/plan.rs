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
/// A folder that ends in a slash is made if it is not there, and so is the folder before a name with `{stem}` in it.
///
/// # Errors
/// Usage if two outputs would be one file; output if a folder cannot be made.
pub fn plan(origins: &[Origin], asked: &[PathBuf], suffixes: &[&str]) -> Result<Vec<Vec<PathBuf>>, Failure> {
    asked.iter().filter_map(|path| to_make(path)).try_for_each(make)?;
    let plan: Vec<Vec<PathBuf>> = origins.iter().map(|origin| of_one(origin, asked, suffixes)).collect();
    match first_repeated(&plan) {
        None => Ok(plan),
        Some(path) => {
            let failure = Failure::new(Code::Usage, format!("{}: named as output twice", path.display()));
            let advice = format!(
                "{} inputs are named: give a folder, or a name with {{stem}} in it, such as lines/{{stem}}.dxf; each output has an -o of its own",
                origins.len()
            );
            Err(if origins.len() > 1 { failure.advise(advice) } else { failure })
        }
    }
}

fn of_one(origin: &Origin, asked: &[PathBuf], suffixes: &[&str]) -> Vec<PathBuf> {
    let named = |folder: PathBuf| suffixes.iter().map(move |suffix| folder.join(with_suffix(origin, suffix)));
    match origin.folder() {
        _ if !asked.is_empty() => asked
            .iter()
            .flat_map(|path| {
                if is_folder(path) { named(path.clone()).collect() } else { vec![filled(path, origin)] }
            })
            .collect(),
        Some(folder) => named(folder).collect(),
        None => vec![PathBuf::from("-")],
    }
}

fn with_suffix(origin: &Origin, suffix: &str) -> OsString {
    let mut name = origin.stem();
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

/// The folder that is to be there before results are written; `None` where the user makes it.
fn to_make(path: &Path) -> Option<&Path> {
    if ends_in_slash(path) {
        return Some(path);
    }
    let holds_stem = |part: &Path| part.to_string_lossy().contains(STEM);
    path.parent().filter(|folder| holds_stem(path) && !holds_stem(folder) && !folder.as_os_str().is_empty())
}

/// Makes a folder and those above it.
pub fn make(folder: &Path) -> Result<(), Failure> {
    std::fs::create_dir_all(folder)
        .map_err(|e| Failure::new(Code::Output, format!("{}: cannot make the folder: {e}", folder.display())))
}

fn first_repeated(plan: &[Vec<PathBuf>]) -> Option<&Path> {
    let mut all: Vec<&PathBuf> = plan.iter().flatten().collect();
    all.sort();
    all.windows(2).find(|pair| pair[0] == pair[1]).map(|pair| pair[0].as_path())
}

#[cfg(test)]
mod tests {
    use super::*;

    const SUFFIXES: [&str; 2] = ["lines.json", "lines.obj"];

    fn files(names: &[&str]) -> Vec<Origin> {
        names.iter().map(|name| Origin::File(name.into())).collect()
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
    fn folders_hold_the_default_names_and_are_made() {
        let base = tempfile::tempdir().unwrap();
        let folder = format!("{}/new/lines/", base.path().display());
        let plan = planned(&["a.ply", "b.ply"], &[&folder]).unwrap();
        assert_eq!(plan[1][0], base.path().join("new/lines/b.lines.json"));
        planned(&["a.ply"], &[&format!("{}/cad/{{stem}}.dxf", base.path().display())]).unwrap();
        assert!(base.path().join("cad").is_dir());
        assert!(base.path().join("new/lines").is_dir());
    }

    #[test]
    fn outputs_that_would_be_one_file_are_refused() {
        for (inputs, asked) in [
            (vec!["a.ply"], vec!["x.obj", "x.obj"]),
            (vec!["a.ply", "b.ply"], vec!["x.obj"]),
            (vec!["a.ply", "b.ply"], vec!["-"]),
            (vec!["p/a.ply", "q/a.ply"], vec!["{stem}.obj"]),
            (vec!["a.ply", "a.xyz"], vec![]),
        ] {
            assert_eq!(planned(&inputs, &asked).unwrap_err().code, Code::Usage, "{inputs:?} {asked:?}");
        }
    }
}
