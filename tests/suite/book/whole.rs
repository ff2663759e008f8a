//! The book is whole: nothing is missing, broken, typed where it should be woven, or fetched
//! from afar.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::{LazyLock, Mutex, MutexGuard, PoisonError};

use mdbook_driver::MDBook;
use scraper::{ElementRef, Html, Node, Selector};
use slips::Chapter;

use fixtures::command::{files, names_in};

/// The workspace, and in it the sources of the book.
pub(crate) const WORKSPACE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");
pub(crate) const NOTES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../book/notes");

#[test]
fn every_page_in_the_folder_is_in_the_summary() {
    let written = names_in(Path::new(NOTES)).into_iter();
    let written: Vec<String> = written
        .filter(|name| name.ends_with(".md") && name != "SUMMARY.md")
        .map(|name| name.replace(".md", ".html"))
        .collect();
    let pages = pages();
    let woven: Vec<&String> = chapters(&pages).map(|page| &page.name).collect();
    assert_eq!(written.iter().collect::<Vec<_>>(), woven);
}

/// mdBook's own program loads the book and asks the weaver that book.toml names, as this test does.
/// Only its index of the search is that of its own version.
#[test]
#[ignore = "builds the weaver"]
fn mdbooks_own_program_makes_the_same_book() {
    let folder = Path::new(concat!(env!("CARGO_TARGET_TMPDIR"), "/mdbook"));
    let mut book = MDBook::load(Path::new(NOTES).join("..")).expect("a book");
    book.config.build.build_dir = folder.to_owned();
    book.build().expect("the weaver answers");
    let [ours, theirs] = [woven(), folder].map(|folder| {
        let read = |path: &PathBuf| fs::read(path).expect("a file");
        let name = |path: &PathBuf| path.strip_prefix(folder).expect("in it").to_owned();
        let all = files(folder).into_iter();
        all.map(|path| (name(&path), read(&path)))
            .collect::<Vec<_>>()
    });
    assert_eq!(ours.len(), theirs.len());
    for (ours, theirs) in ours.iter().zip(&theirs) {
        assert!(
            ours == theirs,
            "{} and {} differ",
            ours.0.display(),
            theirs.0.display()
        );
    }
}

/// The index has all pages, and whoever searches for the first time loads it as a whole.
#[test]
fn the_index_of_the_search_has_at_most_1200_kilobytes() {
    let names = names_in(woven()).into_iter();
    let mut index = names.filter(|name| name.starts_with("searchindex"));
    let index = woven().join(index.next().expect("an index"));
    let bytes = fs::metadata(index).expect("a file").len();
    assert!(bytes <= 1_200_000, "{bytes}");
}

#[test]
fn each_figure_is_shown() {
    let pages = pages();
    for figure in figures::figures() {
        let shown = format!("figure#{}", figure.name());
        let is_shown = chapters(&pages).any(|page| !page.all(&shown).is_empty());
        assert!(is_shown, "{} is on no page", figure.name());
    }
}

#[test]
fn every_slip_is_found_by_its_name() {
    let pages = pages();
    let page = pages.iter().find(|page| page.name == "slips.html");
    let page = page.expect("the page");
    for slip in slips::all() {
        assert!(page.has(slip.name), "{} is missing", slip.name);
    }
}

/// Code that is typed into a page is never compiled: `rust,ignore` says that it need not be. The
/// C++ is that of the program that draws the same bytes.
#[test]
fn every_listing_comes_from_a_source() {
    let plain = |text: &str| -> String { text.split_whitespace().collect() };
    let rival = Path::new(WORKSPACE).join("book/measure/rival/book.cc");
    let rival = plain(&fs::read_to_string(rival).expect("the book's program"));
    for page in chapters(&pages()) {
        let all = |selector| page.all(selector).into_iter().map(text_of);
        let listed: Vec<String> = all(".listing code").collect();
        for code in all("code.language-rust:not(.ignore)") {
            assert!(listed.contains(&code), "typed into {}:\n{code}", page.name);
        }
        for code in all("code.language-cpp").filter(|_| page.name == "cpp_to_rust.html") {
            assert!(
                rival.contains(&plain(&code)),
                "not in rival/book.cc:\n{code}"
            );
        }
    }
}

#[test]
fn every_link_and_every_resource_is_in_the_book() {
    let pages = pages();
    for page in pages.iter() {
        for (element, attribute) in [
            ("a", "href"),
            ("link", "href"),
            ("use", "href"),
            ("script", "src"),
            ("img", "src"),
        ] {
            for link in page.attributes(&format!("{element}[{attribute}]"), attribute) {
                if element == "a" && is_elsewhere(link) || link.starts_with("data:") {
                    continue;
                }
                assert!(!is_elsewhere(link), "{} loads {link}", page.name);
                let (path, fragment) = link.split_once('#').unwrap_or((link, ""));
                let path = path.split('?').next().unwrap_or_default();
                let path = if path.is_empty() { &page.name } else { path };
                assert!(woven().join(path).is_file(), "{link} in {}", page.name);
                let target = pages.iter().find(|page| page.name == path);
                assert!(
                    fragment.is_empty() || target.is_none_or(|target| target.has(fragment)),
                    "{link} in {}: nothing there is called #{fragment}",
                    page.name
                );
            }
        }
    }
}

#[test]
fn every_id_is_given_once_on_its_page() {
    for page in pages().iter() {
        let mut ids = BTreeSet::new();
        for id in page.attributes("[id]", "id") {
            assert!(ids.insert(id), "{id} is twice in {}", page.name);
        }
    }
}

/// Each letter has one meaning, and a reader can look it up there.
#[test]
fn each_letter_of_the_lesson_is_on_the_page_of_symbols() {
    let page = |name: &str| fs::read_to_string(Path::new(NOTES).join(name)).expect("a page");
    let explained = page("symbols.md");
    let explained: BTreeSet<&str> = formulas(&explained).collect();
    for chapter in Chapter::OF_THE_BOOK {
        let name = page_of(chapter).replace(".html", ".md");
        for formula in formulas(&page(&name)) {
            let letter = formula.trim_start_matches("\\mathbf");
            let mut letters = letter.trim_matches(['{', '}']).chars();
            let is_letter = letters.next().is_some_and(char::is_alphabetic);
            assert!(
                !is_letter || letters.next().is_some() || explained.contains(formula),
                "{name} does not say what {formula} is"
            );
        }
    }
}

/// Lists the formulas in the lines of a page.
fn formulas(text: &str) -> impl Iterator<Item = &str> {
    let lines = text.split("$$").step_by(2);
    lines.flat_map(|text| text.split('$').skip(1).step_by(2))
}

#[test]
fn no_page_names_a_folder_of_this_machine() {
    let here = fs::canonicalize(WORKSPACE).expect("the workspace");
    for name in page_names() {
        let text = fs::read_to_string(woven().join(&name)).expect("a page");
        assert!(!text.contains(&*here.to_string_lossy()), "{name}");
    }
}

/// Returns the folder of the book, which is woven once for all tests.
pub(crate) fn woven() -> &'static Path {
    static WOVEN: LazyLock<&Path> = LazyLock::new(|| {
        let folder = Path::new(concat!(env!("CARGO_TARGET_TMPDIR"), "/book"));
        let _ = fs::remove_dir_all(folder);
        fs::create_dir_all(folder).expect("a folder for the book");
        let source = Path::new(NOTES).join("..");
        weave::weave(&source, folder).unwrap_or_else(|cause| panic!("{cause}"));
        folder
    });
    &WOVEN
}

/// Returns the file name of a chapter's woven page, such as `normals.html`.
pub(crate) fn page_of(chapter: Chapter) -> String {
    match chapter {
        Chapter::BuildTest => "setup.html".to_owned(),
        _ => format!("{}.html", chapter.name()),
    }
}

/// Returns the folder of a chapter, as seen from the workspace.
pub(crate) fn folder_of(chapter: Chapter) -> PathBuf {
    PathBuf::from(format!("chapters/{}_{}", chapter as usize, chapter.name()))
}

/// Returns the names of all pages, those of mdBook's own included.
pub(crate) fn page_names() -> Vec<String> {
    let names = names_in(woven()).into_iter();
    names.filter(|name| name.ends_with(".html")).collect()
}

/// A page of the book as it was woven.
pub(crate) struct Page {
    /// The name of its file.
    pub(crate) name: String,
    html: Html,
}

/// Returns all pages, read once for all tests; one test at a time may look at them.
pub(crate) fn pages() -> MutexGuard<'static, Vec<Page>> {
    static PAGES: LazyLock<Mutex<Vec<Page>>> =
        LazyLock::new(|| Mutex::new(page_names().into_iter().map(Page::read).collect()));
    // A test that failed has changed nothing.
    PAGES.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Lists the pages that were written, without those that mdBook makes of them.
fn chapters(pages: &[Page]) -> impl Iterator<Item = &Page> {
    let made = ["index.html", "print.html", "toc.html", "404.html"];
    pages
        .iter()
        .filter(move |page| !made.contains(&page.name.as_str()))
}

impl Page {
    fn read(name: String) -> Self {
        let text = fs::read_to_string(woven().join(&name)).expect("a page");
        let html = Html::parse_document(&text);
        Self { name, html }
    }

    pub(crate) fn all(&self, selector: &str) -> Vec<ElementRef<'_>> {
        self.html.select(&select(selector)).collect()
    }

    fn attributes(&self, selector: &str, name: &str) -> Vec<&str> {
        let elements = self.all(selector).into_iter();
        elements.filter_map(|element| element.attr(name)).collect()
    }

    /// Returns true if an element has this id.
    fn has(&self, id: &str) -> bool {
        let mut elements = self.html.tree.values().filter_map(Node::as_element);
        elements.any(|element| element.id() == Some(id))
    }
}

pub(crate) fn select(selector: &str) -> Selector {
    Selector::parse(selector).expect("a selector")
}

pub(crate) fn text_of(element: ElementRef) -> String {
    element.text().collect()
}

/// Returns true if the link names a protocol, or a computer.
fn is_elsewhere(link: &str) -> bool {
    link.contains("://") || link.starts_with("//") || link.starts_with("mailto:")
}
