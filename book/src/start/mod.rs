//! `start`: a crate of the reader's own, ready to be typed into.

mod carry;
mod files;

use std::error::Error;
use std::path::{Path, PathBuf};
use std::{fs, io};

use carry::Written;
use check::names::from_here;
use check::workspace::workspace;
use clap::Args;
use common::engine::output;
use slips::{Chapter, steps};

use crate::chapter::OneOf;
use crate::mine::{Mine, TYPED};
use crate::misuse::misuse;
use crate::terminal;

/// What `cargo rtrace start` is told.
#[derive(Args)]
pub(crate) struct Arguments {
    /// The chapter that you are about to type
    #[arg(value_name = "CHAPTER", value_parser = OneOf(&TYPED))]
    chapter: Chapter,

    /// Where your crates are to be [default: mine]
    #[arg(long, alias = "in", value_name = "FOLDER")]
    into: Option<PathBuf>,

    /// Type the prelude as well: vectors, rays, camera and the text of a picture
    #[arg(long)]
    own_prelude: bool,

    /// Begin the chapter once more; what you have typed is kept beside it
    #[arg(long)]
    again: bool,
}

/// Makes the crate, and says where it is and what comes next.
pub(crate) fn start(arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    let chapter = arguments.chapter;
    let mine = Mine::find(arguments.into.as_deref());
    refuse_ours(&mine)?;
    let folder = mine.of(chapter);
    if folder.exists() && !arguments.again {
        let prelude = match Written::read(&folder).has_own_prelude() {
            true => " --own-prelude",
            false => "",
        };
        return Err(misuse(&format!(
            "{} is there already, and nothing is written over it\n\
             Go on with {}, or begin once more with {}{prelude} --again.",
            from_here(&folder),
            mine.watch(chapter),
            mine.start(chapter),
        )));
    }
    let before = TYPED.into_iter().rev().filter(|&it| it < chapter);
    let before = before.map(|it| mine.of(it)).find(|it| it.is_dir());
    let new = New::compose(arguments, before.as_deref())?;
    let kept = new
        .write(&folder)
        .map_err(|cause| format!("cannot write {}: {cause}", from_here(&folder)))?;
    let kept = kept.map_or(String::new(), |kept| {
        format!("What you had is in {}.\n", from_here(&kept))
    });
    let said = kept + &new.said(&mine);
    Ok(output::to_stdout(|out| out.write_all(said.as_bytes()))?)
}

/// Whatever is in our folders belongs to our workspace, and it would take the crate for
/// one of its own.
fn refuse_ours(mine: &Mine) -> Result<(), Box<dyn Error>> {
    let ours = ["common", "chapters", "book", "tests"];
    let below = workspace().and_then(|it| mine.folder().strip_prefix(it).ok());
    match below.is_some_and(|below| ours.iter().any(|name| below.starts_with(name))) {
        true => Err(misuse(
            "that folder belongs to this workspace: choose one of your own, such as mine",
        )),
        false => Ok(()),
    }
}

/// A crate that is about to be written.
struct New {
    chapter: Chapter,
    /// Files to be copied as they are, each with the name that it gets.
    copies: Vec<(PathBuf, PathBuf)>,
    /// The other files, by their names. One of the chapter takes the place of a copy.
    files: Vec<(&'static str, String)>,
    /// What was carried over from the chapter before, or why nothing was.
    carried: String,
}

impl New {
    fn compose(arguments: &Arguments, before: Option<&Path>) -> Result<Self, Box<dyn Error>> {
        let chapter = arguments.chapter;
        let workspace = workspace().ok_or(
            "your crate would use the prelude and the laws of the workspace that this program \
             was built from, and that is not there any more",
        )?;
        let written = before.map(Written::read);
        let has_own = written.as_ref().is_some_and(Written::has_own_prelude);
        let own = arguments.own_prelude || has_own;
        let mut carried = carry::into(files::skeletons(chapter, own), written.as_ref());
        let (_, lib) = &mut carried.files[0];
        lib.insert_str(0, &files::about(chapter));
        if own && written.is_none() && chapter > Chapter::Gradient {
            *lib += include_str!("skeletons/own/sky.rs");
        }
        let lock = fs::read_to_string(workspace.join("Cargo.lock"));
        let texts = [
            ("src/main.rs", files::main(chapter, own)),
            ("tests/laws.rs", files::test(chapter, own)),
            ("Cargo.toml", files::manifest(chapter, own, workspace)),
            // The same versions as ours: they have been downloaded.
            ("Cargo.lock", lock.unwrap_or_default()),
            (".cargo/config.toml", files::config(workspace)),
        ];
        let prelude = files::OWN_PRELUDE.map(|(name, text)| (name, text.to_owned()));
        let prelude = prelude.into_iter().filter(|_| own && !has_own);
        // In the order in which they are typed.
        carried.files.rotate_left(1);
        let files = prelude.chain(carried.files).chain(texts);
        let copies = written.map_or(Vec::new(), |Written { folder, files, .. }| {
            let copy = |name: PathBuf| (folder.join(&name), name);
            files.into_iter().map(copy).collect()
        });
        Ok(Self {
            chapter,
            copies,
            files: files.filter(|(_, text)| !text.is_empty()).collect(),
            carried: carried.said,
        })
    }

    /// Writes all files, or none: into a folder beside it, which then gets the name. Where
    /// the folder is, if it had the name before.
    fn write(&self, folder: &Path) -> io::Result<Option<PathBuf>> {
        let mine = folder.parent().expect("a crate is in a folder");
        fs::create_dir_all(mine)?;
        let new = mine.join(format!(".start-{}", self.chapter.name()));
        if new.exists() {
            // It was ended before it had the name.
            fs::remove_dir_all(&new)?;
        }
        let place = |name: &Path| {
            let path = new.join(name);
            fs::create_dir_all(path.parent().expect("a file is in a folder"))?;
            io::Result::Ok(path)
        };
        for (file, name) in &self.copies {
            fs::copy(file, place(name)?)?;
        }
        for (name, text) in &self.files {
            fs::write(place(name.as_ref())?, text)?;
        }
        let kept = folder.exists().then(|| put_aside(folder)).transpose()?;
        let named = fs::rename(new, folder);
        if let (Err(_), Some(kept)) = (&named, &kept) {
            fs::rename(kept, folder)?;
        }
        named.map(|()| kept)
    }

    fn said(&self, mine: &Mine) -> String {
        let file = mine.of(self.chapter).join("src/lib.rs");
        let mut said = format!("{} is yours.\n{}", from_here(&file), self.carried);
        let is_to_type = |(_, text): &&(_, String)| text.contains("todo!()");
        let to_type = self.files.iter().filter(is_to_type).map(|&(name, _)| name);
        if let [before @ .., last] = &to_type.collect::<Vec<_>>()[..]
            && !before.is_empty()
        {
            said += &format!("Type {}, and then {last}.\n", before.join(", "));
        }
        for (number, step) in (1..).zip(steps::of(self.chapter)) {
            let line = format!("  step {number}  {}", step.says);
            said += &(terminal::hanging(&line, 10) + "\n");
        }
        said + &format!(
            "Open it in your editor, and in a terminal: {}\n",
            mine.watch(self.chapter)
        )
    }
}

/// Renames the folder to the first name beside it that is free.
fn put_aside(folder: &Path) -> io::Result<PathBuf> {
    let name = |n: u32| folder.with_extension(n.to_string());
    let free = (1..).map(name).find(|path| !path.exists());
    let free = free.expect("there are more numbers than folders");
    fs::rename(folder, &free)?;
    Ok(free)
}
