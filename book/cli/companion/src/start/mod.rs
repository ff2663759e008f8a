//! `start`: a crate of the reader's own, ready to be typed into.

mod carry;
mod settings;

use std::error::Error;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use carry::EarlierCrate;
use check::names::name_from_here;
use check::workspace::workspace;
use interpreter::SourceFile;
use slips::{Chapter, steps};

use crate::command_line::Words;
use crate::misuse::misuse;
use crate::output;
use crate::reader_crates::ReaderCrates;
use crate::wrap::wrap_hanging;

/// Makes a crate for the reader to type a chapter in, and returns where it is and what comes next.
pub(crate) fn start(words: &Words) -> Result<String, Box<dyn Error>> {
    let chapter = words.required_chapter()?;
    let crates = ReaderCrates::find(words.path("--into").as_deref());
    let folder = crates.folder_of(chapter);
    let failed = |cause: io::Error| {
        format!(
            "cannot write {}: {cause}\nName a folder that you may write to: {} --into FOLDER",
            name_from_here(&folder),
            ReaderCrates::find(None).start_command(chapter),
        )
    };
    fs::create_dir_all(crates.folder()).map_err(failed)?;
    if folder.exists() {
        return Err(misuse(&format!(
            "{} is there already, and nothing is written over it\n\
             Go on with {}, or rename that folder to begin once more.",
            name_from_here(&folder),
            crates.watch_command(chapter),
        )));
    }
    let before = Chapter::TYPED.into_iter().rev().filter(|&it| it < chapter);
    let before = before.map(|it| crates.folder_of(it)).find(|it| it.is_dir());
    let own_prelude = words.has("--own-prelude");
    let new = NewCrate::compose(chapter, own_prelude, before.as_deref(), &folder)?;
    new.make(&folder).map_err(failed)?;
    Ok(new.as_text(&crates))
}

/// A crate of a reader that is about to be written.
struct NewCrate {
    chapter: Chapter,
    /// Files to be copied from there as they are, each with its path in the new crate.
    copies: Vec<(PathBuf, PathBuf)>,
    /// The other files, in the order in which they are typed. One of the same name replaces a copy.
    files: Vec<SourceFile>,
    /// A sentence about what was carried over from that crate, or why nothing was; empty without
    /// it.
    carried: String,
}

impl NewCrate {
    fn compose(
        chapter: Chapter,
        own_prelude: bool,
        before: Option<&Path>,
        folder: &Path,
    ) -> Result<Self, Box<dyn Error>> {
        let workspace = workspace().ok_or(
            "your crate would use the prelude and the laws of the workspace that this program \
             was built from, and that workspace is not there any more",
        )?;
        let written = before.map(EarlierCrate::read);
        let has_own = written.as_ref().is_some_and(EarlierCrate::has_own_prelude);
        let own = own_prelude || has_own;
        let mut carried = carry::carry_over(chapter, own, written.as_ref());
        let lib = &mut carried.files.last_mut().expect("a chapter has a file").text;
        lib.insert_str(0, &settings::chapter_head(chapter));
        if own && written.is_none() && chapter > Chapter::Gradient {
            *lib += &format!("\n{}", skeletons::OWN_SKY);
        }
        let prelude = (own && !has_own).then(skeletons::own_prelude);
        // In the order in which they are typed.
        let files = prelude
            .into_iter()
            .flatten()
            .chain(carried.files)
            .chain(given(chapter, own, folder, workspace));
        let copies = written.map_or(Vec::new(), |EarlierCrate { folder, files, .. }| {
            let copy = |name: PathBuf| (folder.join(&name), name);
            files.into_iter().map(copy).collect()
        });
        Ok(Self {
            chapter,
            copies,
            files: files.filter(|file| !file.text.is_empty()).collect(),
            carried: carried.said,
        })
    }

    /// Writes the whole crate beside its place, and moves it there: it appears whole or not at all.
    fn make(&self, folder: &Path) -> io::Result<()> {
        output::forget_partials(folder);
        let partial = output::partial(folder)?;
        let made = self
            .write(&partial)
            .and_then(|()| fs::rename(&partial, folder));
        if made.is_err() {
            // The first failure is the one to report, whether or not this works.
            let _ = fs::remove_dir_all(&partial);
        }
        made
    }

    /// Writes all files into the folder.
    fn write(&self, folder: &Path) -> io::Result<()> {
        let place = |name: &Path| {
            let path = folder.join(name);
            fs::create_dir_all(path.parent().expect("a file is in a folder"))?;
            io::Result::Ok(path)
        };
        for (file, name) in &self.copies {
            fs::copy(file, place(name)?)?;
        }
        for SourceFile { name, text } in &self.files {
            fs::write(place(name.as_ref())?, text)?;
        }
        Ok(())
    }

    fn as_text(&self, crates: &ReaderCrates) -> String {
        let file = crates.folder_of(self.chapter).join("src/lib.rs");
        let mut said = format!("{} is yours.\n{}", name_from_here(&file), self.carried);
        let is_to_type = |file: &&SourceFile| file.text.contains("todo!()");
        let to_type = self.files.iter().filter(is_to_type);
        let to_type = to_type.map(|file| &file.name[..]);
        if let [before @ .., last] = &to_type.collect::<Vec<_>>()[..]
            && !before.is_empty()
        {
            said += &format!("Type {}, and then {last}.\n", before.join(", "));
        }
        for (number, step) in (1..).zip(steps::of_chapter(self.chapter)) {
            let line = format!("  step {number}  {}", step.instruction);
            said += &(wrap_hanging(&line, 10) + "\n");
        }
        said + &format!(
            "Open it in your editor, and in a terminal: {}\n",
            crates.watch_command(self.chapter)
        )
    }
}

/// Writes the files that the reader need not touch; an empty text is no file.
fn given(chapter: Chapter, own: bool, folder: &Path, workspace: &Path) -> [SourceFile; 6] {
    let ours = settings::workspace_from_crate(folder, workspace);
    let path = settings::with_slashes(&ours);
    let manifest = skeletons::manifest(chapter, own, &path, output::random());
    let lock = fs::read_to_string(workspace.join("Cargo.lock"));
    [
        ("src/main.rs", skeletons::main(chapter, own)),
        ("tests/laws.rs", skeletons::test(chapter, own)),
        ("Cargo.toml", manifest),
        // The same versions as ours: they have been downloaded.
        ("Cargo.lock", lock.unwrap_or_default()),
        (
            ".cargo/config.toml",
            settings::cargo_config(&ours, workspace),
        ),
        (".vscode/settings.json", skeletons::EDITOR.to_owned()),
    ]
    .map(|(name, text)| SourceFile::new(name, text))
}
