//! Our own folder is replaced whole, and nothing that is a reader's is removed or written over.

use std::error::Error;
use std::fs;
use std::path::Path;

use fixtures::desk::Desk;
use weave::folder;

type Done = Result<(), Box<dyn Error>>;

#[test]
fn a_new_and_an_empty_folder_are_filled_and_our_own_is_replaced_whole() {
    let desk = Desk::default();
    desk.write("ours/old.css", "first");
    desk.write("ours/notes/changed.html", "changed");
    // What an interrupted call has left.
    desk.write(".ours.0123456789abcdef.partial/index.html", "half");
    desk.write("empty/", "");
    for name in ["new/book", "empty", "ours"] {
        replace(&desk, name, |new| write(new, "index.html", "second")).expect("it is filled");
        assert_eq!(desk.read(&format!("{name}/index.html")), "second");
    }
    assert_eq!(names(&desk), ["empty", "new", "ours"]);
    assert!(!desk.path("ours/old.css").exists());
    assert!(!desk.path("ours/notes").exists());
    replace(&desk, "empty/../ours/.", |new| {
        write(new, "index.html", "third")
    })
    .expect("it is ours by any name");
    assert_eq!(desk.read("ours/index.html"), "third");
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
    let desk = Desk::default();
    desk.write("full/.thesis.txt", "mine");
    desk.write("file", "mine");
    desk.write("above/empty/", "");
    desk.write("ours/", "");
    let links = cfg!(unix);
    #[cfg(unix)]
    std::os::unix::fs::symlink(desk.path("ours"), desk.path("link")).expect("a link");
    for (name, said) in REFUSED.iter().filter(|(name, _)| links || *name != "link") {
        let refused = replace(&desk, name, |_| {
            panic!("{name} is refused before a book is made")
        });
        let refused = refused.expect_err("it is refused").to_string();
        assert!(refused.contains(said), "{refused}");
    }
    assert_eq!(desk.read("full/.thesis.txt"), "mine");
    assert_eq!(desk.read("file"), "mine");
    assert!(desk.path("above/empty").exists());
}

#[test]
fn what_comes_while_the_new_one_is_made_is_not_lost_nor_is_the_old_one_if_that_fails() {
    let desk = Desk::default();
    desk.write("ours/index.html", "first");
    let failed = replace(&desk, "ours", |new| {
        write(new, "index.html", "half")?;
        Err("a formula is wrong".into())
    });
    assert_eq!(
        failed.expect_err("it fails").to_string(),
        "a formula is wrong"
    );
    assert_eq!(desk.read("ours/index.html"), "first");
    let came = replace(&desk, "new", |_| {
        write(&desk.path("new"), "thesis.txt", "mine")
    });
    assert!(
        came.expect_err("it came")
            .to_string()
            .contains("is not empty")
    );
    assert_eq!(desk.read("new/thesis.txt"), "mine");
    assert_eq!(names(&desk), ["new", "ours"], "nothing is left beside them");
}

/// Puts what `make` makes into the folder of that name, if this is new, empty or `ours`.
fn replace(desk: &Desk, name: &str, make: impl FnOnce(&Path) -> Done) -> Done {
    folder::replace(&desk.path(name), &desk.path("ours"), make)
}

/// Lists what is on the desk.
fn names(desk: &Desk) -> Vec<String> {
    let entries = desk.path("").read_dir().expect("a folder").flatten();
    let names = entries.map(|entry| entry.file_name().to_string_lossy().into_owned());
    let mut names: Vec<String> = names.collect();
    names.sort();
    names
}

fn write(folder: &Path, name: &str, text: &str) -> Done {
    let path = folder.join(name);
    fs::create_dir_all(path.parent().expect("a folder"))?;
    Ok(fs::write(path, text)?)
}
