//! A folder is replaced whole, and nothing that is a reader's is removed or written over.

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

use tempfile::TempDir;
use weave::folder::replace;

type Done = Result<(), Box<dyn Error>>;

#[test]
fn a_new_and_an_empty_folder_are_filled_and_our_own_is_replaced_whole() {
    let desk = TempDir::new().expect("a folder");
    fs::create_dir(desk.path().join("empty")).expect("a folder");
    for name in ["new/book", "empty", "empty/../empty/."] {
        let folder = desk.path().join(name);
        replace(&folder, book("first", &["index.html", "css/old.css"])).expect("it is filled");
        // What we wrote is ours, also when it was changed, and what an interrupted call has left.
        write(&folder, "index.html", "changed");
        let left = format!(
            ".{}.0123456789abcdef.partial",
            name.rsplit('/').find(|it| *it != ".").unwrap_or(name)
        );
        let left = fs::canonicalize(&folder)
            .expect("it is there")
            .with_file_name(left);
        fs::create_dir(&left).expect("a folder");
        replace(&folder, book("second", &["index.html", "css/new.css"])).expect("it is replaced");
        assert_eq!(
            files(&folder),
            [".rtrace-book", "css/new.css", "index.html"]
        );
        assert_eq!(read(&folder.join("index.html")), "second");
        assert!(!left.exists());
    }
}

/// What a reader does to a folder of ours, and what the message names then.
type Stranger = (fn(&Path), &'static str);

const STRANGERS: [Stranger; 7] = [
    (|folder| write(folder, "thesis.txt", "mine"), "thesis.txt"),
    (
        |folder| write(folder, "drafts/thesis.txt", "mine"),
        "drafts/thesis.txt",
    ),
    (|folder| write(folder, ".hidden", "mine"), ".hidden"),
    (
        |folder| write(folder, "css/more.css", "mine"),
        "css/more.css",
    ),
    (
        |folder| fs::create_dir(folder.join("notes")).expect("a folder"),
        "notes",
    ),
    // Nor is a marker ours that somebody else has written, nor a folder without one.
    (
        |folder| write(folder, ".rtrace-book", "index.html\n"),
        ".rtrace-book",
    ),
    (
        |folder| fs::remove_file(folder.join(".rtrace-book")).expect("it is there"),
        "css/main.css",
    ),
];

#[test]
fn a_folder_with_anything_else_in_it_stays_as_it_is_and_the_message_names_it() {
    for (change, named) in STRANGERS {
        let desk = TempDir::new().expect("a folder");
        let folder = filled(desk.path());
        change(&folder);
        let before = files(&folder);
        refuses(&folder, named);
        assert_eq!(files(&folder), before);
    }
}

#[test]
fn what_comes_while_the_new_one_is_made_is_not_lost_nor_is_the_old_one_if_that_fails() {
    let desk = TempDir::new().expect("a folder");
    let folder = filled(desk.path());
    let failed =
        |make: &dyn Fn(&Path) -> Done| replace(&folder, make).expect_err("it fails").to_string();
    let half = |new: &Path| {
        write(new, "index.html", "half");
        Err("a formula is wrong".into())
    };
    assert_eq!(failed(&half), "a formula is wrong");
    let comes = |new: &Path| {
        write(&folder, "thesis.txt", "mine");
        book("second", &["index.html"])(new)
    };
    assert!(failed(&comes).contains("thesis.txt"));
    assert_eq!(read(&folder.join("thesis.txt")), "mine");
    assert_eq!(read(&folder.join("index.html")), "first");
    assert_eq!(
        desk.path().read_dir().expect("it").count(),
        1,
        "nothing is left beside it"
    );
}

#[test]
fn a_file_is_refused_and_so_is_a_full_folder_by_any_name() {
    let desk = TempDir::new().expect("a folder");
    write(desk.path(), "file", "mine");
    refuses(&desk.path().join("file"), "cannot look into");
    assert_eq!(read(&desk.path().join("file")), "mine");
    fs::create_dir_all(desk.path().join("above/empty")).expect("a folder");
    refuses(&desk.path().join("above/empty/.."), "no name");
    refuses(&desk.path().join("above/."), "holds empty");
}

#[cfg(unix)]
#[test]
fn no_link_is_followed_or_replaced() {
    use std::os::unix::fs::symlink;
    let desk = TempDir::new().expect("a folder");
    let home = desk.path().join("home");
    write(&home, "css/main.css", "mine");
    for (name, target) in [
        ("css", "css"),
        ("index.html", "css/main.css"),
        (".rtrace-book", "css/main.css"),
    ] {
        let folder = filled(&desk.path().join(name));
        let place = folder.join(name);
        let _ = fs::remove_dir_all(&place).or_else(|_| fs::remove_file(&place));
        symlink(home.join(target), &place).expect("a link");
        refuses(&folder, name);
        assert!(place.is_symlink());
    }
    let link = desk.path().join("link");
    symlink(filled(&desk.path().join("real")), &link).expect("a link");
    refuses(&link, "is a link");
    assert_eq!(read(&link.join("index.html")), "first");
    assert_eq!(read(&home.join("css/main.css")), "mine");
}

/// Makes a folder `book` as a first call leaves it, and returns its path.
fn filled(desk: &Path) -> PathBuf {
    let folder = desk.join("book");
    replace(&folder, book("first", &["index.html", "css/main.css"])).expect("it is filled");
    folder
}

/// Writes a book of files with these names, all with the same text.
fn book(text: &str, names: &[&str]) -> impl FnOnce(&Path) -> Done {
    move |folder| {
        names.iter().for_each(|name| write(folder, name, text));
        Ok(())
    }
}

fn refuses(folder: &Path, said: &str) {
    let refused = replace(folder, |_| panic!("it is refused before a book is made"));
    let refused = refused.expect_err("it is refused").to_string();
    assert!(refused.contains(said), "{refused}");
}

fn write(folder: &Path, name: &str, text: &str) {
    let path = folder.join(name);
    fs::create_dir_all(path.parent().expect("a folder")).expect("a folder");
    fs::write(path, text).expect("a file");
}

fn read(path: &Path) -> String {
    fs::read_to_string(path).expect("the file is there")
}

/// Lists the names of all files below the folder, with `/` between folders.
fn files(folder: &Path) -> Vec<String> {
    let mut names = Vec::new();
    for entry in folder.read_dir().expect("a folder").flatten() {
        let name = entry.file_name().to_string_lossy().into_owned();
        match entry.path().is_dir() {
            true => names.extend(files(&entry.path()).iter().map(|it| format!("{name}/{it}"))),
            false => names.push(name),
        }
    }
    names.sort();
    names
}
