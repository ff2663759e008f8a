//! Our own folder is replaced whole, and nothing that is a reader's is removed or written over.

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

use tempfile::TempDir;
use weave::folder;

type Done = Result<(), Box<dyn Error>>;

#[test]
fn a_new_and_an_empty_folder_are_filled_and_our_own_is_replaced_whole() {
    let desk = Desk::new();
    desk.write("ours/old.css", "first");
    desk.write("ours/notes/changed.html", "changed");
    // What an interrupted call has left.
    desk.write(".ours.0123456789abcdef.partial/index.html", "half");
    fs::create_dir(desk.path("empty")).expect("a folder");
    for name in ["new/book", "empty", "ours"] {
        desk.replace(name, |new| write(new, "index.html", "second"))
            .expect("it is filled");
        assert_eq!(read(&desk.path(name).join("index.html")), "second");
    }
    assert_eq!(desk.names(), ["empty", "new", "ours"]);
    assert!(!desk.path("ours/old.css").exists());
    assert!(!desk.path("ours/notes").exists());
    desk.replace("empty/../ours/.", |new| write(new, "index.html", "third"))
        .expect("it is ours by any name");
    assert_eq!(read(&desk.path("ours/index.html")), "third");
}

/// What is refused, and what the message says.
const REFUSED: [(&str, &str); 6] = [
    ("full", "is not empty"),
    ("above", "is not empty"),
    ("above/.", "is not empty"),
    ("above/empty/..", "no name"),
    ("file", "cannot look into"),
    ("link", "is a link"),
];

#[test]
fn a_folder_with_something_in_it_a_file_and_a_link_stay_as_they_are() {
    let desk = Desk::new();
    desk.write("full/.thesis.txt", "mine");
    desk.write("file", "mine");
    fs::create_dir_all(desk.path("above/empty")).expect("a folder");
    fs::create_dir(desk.path("ours")).expect("a folder");
    let links = cfg!(unix);
    #[cfg(unix)]
    std::os::unix::fs::symlink(desk.path("ours"), desk.path("link")).expect("a link");
    for (name, said) in REFUSED.iter().filter(|(name, _)| links || *name != "link") {
        let refused = desk.replace(name, |_| panic!("{name} is refused before a book is made"));
        let refused = refused.expect_err("it is refused").to_string();
        assert!(refused.contains(said), "{refused}");
    }
    assert_eq!(read(&desk.path("full/.thesis.txt")), "mine");
    assert_eq!(read(&desk.path("file")), "mine");
    assert!(desk.path("above/empty").exists());
}

#[test]
fn what_comes_while_the_new_one_is_made_is_not_lost_nor_is_the_old_one_if_that_fails() {
    let desk = Desk::new();
    desk.write("ours/index.html", "first");
    let failed = desk.replace("ours", |new| {
        write(new, "index.html", "half")?;
        Err("a formula is wrong".into())
    });
    assert_eq!(
        failed.expect_err("it fails").to_string(),
        "a formula is wrong"
    );
    assert_eq!(read(&desk.path("ours/index.html")), "first");
    let came = desk.replace("new", |_| write(&desk.path("new"), "thesis.txt", "mine"));
    assert!(
        came.expect_err("it came")
            .to_string()
            .contains("is not empty")
    );
    assert_eq!(read(&desk.path("new/thesis.txt")), "mine");
    assert_eq!(desk.names(), ["new", "ours"], "nothing is left beside them");
}

/// A folder in which `ours` is the folder that may be replaced.
struct Desk(TempDir);

impl Desk {
    fn new() -> Self {
        Self(TempDir::new().expect("a folder"))
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn write(&self, name: &str, text: &str) {
        write(self.0.path(), name, text).expect("a file");
    }

    fn replace(&self, name: &str, make: impl FnOnce(&Path) -> Done) -> Done {
        folder::replace(&self.path(name), &self.path("ours"), make)
    }

    /// Lists what is on the desk.
    fn names(&self) -> Vec<String> {
        let entries = self.0.path().read_dir().expect("a folder").flatten();
        let names = entries.map(|entry| entry.file_name().to_string_lossy().into_owned());
        let mut names: Vec<String> = names.collect();
        names.sort();
        names
    }
}

fn write(folder: &Path, name: &str, text: &str) -> Done {
    let path = folder.join(name);
    fs::create_dir_all(path.parent().expect("a folder"))?;
    Ok(fs::write(path, text)?)
}

fn read(path: &Path) -> String {
    fs::read_to_string(path).expect("the file is there")
}
