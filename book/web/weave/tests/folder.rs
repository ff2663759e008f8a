//! A folder is replaced whole, and nothing that is a reader's is removed or written over.

use std::error::Error;
use std::fs;
use std::path::Path;

use tempfile::TempDir;
use weave::folder::replace;

#[test]
fn a_new_and_an_empty_folder_are_filled_and_our_own_is_replaced_whole() {
    let desk = TempDir::new().expect("a folder");
    for name in ["new/book", "empty"] {
        let folder = desk.path().join(name);
        if name == "empty" {
            fs::create_dir(&folder).expect("a folder");
        }
        replace(&folder, book("first", &["index.html", "css/old.css"])).expect("it is filled");
        // What we wrote is ours, also when it was changed, and what an interrupted call has left.
        fs::write(folder.join("index.html"), "changed").expect("a file");
        let left =
            folder.with_file_name(format!(".{}.0123456789abcdef.partial", file_name(&folder)));
        fs::create_dir(&left).expect("a folder");
        replace(&folder, book("second", &["index.html", "css/new.css"])).expect("it is replaced");
        assert_eq!(
            files(&folder),
            [".rtrace-book", "css/new.css", "index.html"]
        );
        assert_eq!(read(&folder.join("index.html")), "second");
        let beside = folder.parent().expect("a folder");
        assert!(
            beside
                .read_dir()
                .expect("it")
                .flatten()
                .all(|it| !is_hidden(&it.path()))
        );
    }
}

#[test]
fn a_folder_with_anything_else_in_it_stays_as_it_is_and_the_message_names_it() {
    let strangers = ["thesis.txt", "drafts/thesis.txt", ".hidden", "css/more.css"];
    for stranger in strangers {
        let desk = TempDir::new().expect("a folder");
        let folder = filled(desk.path());
        write(&folder, stranger, "mine");
        refuses(&folder, stranger);
        assert_eq!(read(&folder.join(stranger)), "mine");
    }
    let desk = TempDir::new().expect("a folder");
    let folder = filled(desk.path());
    fs::create_dir(folder.join("notes")).expect("a folder");
    refuses(&folder, "notes");
    // Nor is a marker ours that somebody else has written, nor a folder without one.
    write(&folder, ".rtrace-book", "index.html\n");
    refuses(&folder, ".rtrace-book");
    fs::remove_file(folder.join(".rtrace-book")).expect("it is there");
    refuses(&folder, "css/main.css");
}

#[test]
fn what_comes_while_the_new_one_is_made_is_not_lost() {
    let desk = TempDir::new().expect("a folder");
    let folder = filled(desk.path());
    let replaced = replace(&folder, |new| {
        write(&folder, "thesis.txt", "mine");
        book("second", &["index.html"])(new)
    });
    assert!(
        replaced
            .expect_err("it came")
            .to_string()
            .contains("thesis.txt")
    );
    assert_eq!(read(&folder.join("thesis.txt")), "mine");
    assert_eq!(read(&folder.join("index.html")), "first");
}

#[test]
fn a_book_that_can_not_be_made_leaves_the_old_one() {
    let desk = TempDir::new().expect("a folder");
    let folder = filled(desk.path());
    let failed = replace(&folder, |new| {
        write(new, "index.html", "half");
        Err("a formula is wrong".into())
    });
    assert_eq!(
        failed.expect_err("it fails").to_string(),
        "a formula is wrong"
    );
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
    fs::create_dir(desk.path().join("none")).expect("a folder");
    let none = desk.path().join("none/../none/.");
    replace(&none, book("first", &["index.html"])).expect("it has a name");
}

#[cfg(unix)]
#[test]
fn no_link_is_followed_or_replaced() {
    use std::os::unix::fs::symlink;
    let desk = TempDir::new().expect("a folder");
    let home = desk.path().join("home");
    write(&home, "css/main.css", "mine");
    for name in ["css", "index.html", ".rtrace-book"] {
        let folder = filled(&desk.path().join(name));
        let place = folder.join(name);
        let _ = fs::remove_dir_all(&place).or_else(|_| fs::remove_file(&place));
        let target = if name == "css" { "css" } else { "css/main.css" };
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
fn filled(desk: &Path) -> std::path::PathBuf {
    let folder = desk.join("book");
    replace(&folder, book("first", &["index.html", "css/main.css"])).expect("it is filled");
    folder
}

/// Writes a book of files with these names, all with the same text.
fn book(text: &str, names: &[&str]) -> impl FnOnce(&Path) -> Result<(), Box<dyn Error>> {
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
        let name = file_name(&entry.path());
        match entry.path().is_dir() {
            true => names.extend(files(&entry.path()).iter().map(|it| format!("{name}/{it}"))),
            false => names.push(name),
        }
    }
    names.sort();
    names
}

fn is_hidden(path: &Path) -> bool {
    file_name(path).starts_with('.')
}

fn file_name(path: &Path) -> String {
    path.file_name()
        .expect("a name")
        .to_string_lossy()
        .into_owned()
}
