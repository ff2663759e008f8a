//! Source-to-source: what a reader wrote in one chapter goes on into the next.
//!
//! A skeleton says by marks what becomes of it. `// carry NAME` puts the reader's item
//! in the place of the skeleton's next one, `// carry NAME as OTHER` puts it there by
//! another name, and `// show NAME` puts it there as a comment, to be looked at. What no
//! skeleton knows, such as a function that the reader added, goes to the end.

use std::path::{Path, PathBuf};
use std::{fs, io, thread};

use syn::spanned::Spanned;
use syn::{File, Item};

/// The crate that a reader wrote for a chapter.
pub(super) struct Written {
    chapter: String,
    /// The named items of `src/lib.rs` with their texts; or why it can't be read.
    items: Result<Vec<(String, String)>, String>,
    pub(super) folder: PathBuf,
    /// The other files of `src`, by their names as seen from the crate.
    pub(super) files: Vec<PathBuf>,
}

impl Written {
    pub(super) fn read(folder: &Path) -> Self {
        let text = read_file(&folder.join("src/lib.rs"));
        let items = text.map_err(|cause| format!("src/lib.rs: {cause}"));
        let chapter = folder.file_name().unwrap_or_default();
        Self {
            chapter: chapter.to_string_lossy().into_owned(),
            items: items.and_then(|text| on_a_stack_for(&text)),
            folder: folder.to_owned(),
            files: other_files(folder, Path::new("src")),
        }
    }

    /// Whether vectors and rays are the reader's own.
    pub(super) fn has_own_prelude(&self) -> bool {
        let prelude = Path::new("src/rtweekend.rs");
        self.files.iter().any(|name| name == prelude)
    }
}

/// The files of a chapter to be typed, and what to say about their origin.
pub(super) struct Carried {
    pub(super) files: Vec<(&'static str, String)>,
    pub(super) said: String,
}

/// The skeletons, `src/lib.rs` first, with what was written before.
pub(super) fn into(skeletons: Vec<(&'static str, String)>, written: Option<&Written>) -> Carried {
    let (items, said) = match written.map(|written| (&written.chapter, &written.items)) {
        None => (&[][..], String::new()),
        Some((chapter, Ok(items))) => (
            &items[..],
            format!("It begins with what you wrote in {chapter}.\n"),
        ),
        Some((chapter, Err(why))) => (
            &[][..],
            format!("Nothing is carried over from {chapter}, which can't be read: {why}\n"),
        ),
    };
    let mut used = Vec::new();
    let mut files = skeletons;
    for (_, text) in &mut files {
        if text.contains("mod rtweekend;") {
            // Who types the prelude has no use for ours any more.
            used.push("common::rtweekend::*".to_owned());
        }
        *text = filled(text, items, &mut used);
    }
    let (_, lib) = &mut files[0];
    for (name, text) in items {
        if !used.contains(name) {
            *lib += &format!("\n{text}\n");
        }
    }
    Carried { files, said }
}

/// The skeleton with items in the places of its marks. `used` gets the names of all that
/// now has a place.
fn filled(skeleton: &str, items: &[(String, String)], used: &mut Vec<String>) -> String {
    let find = |name: &str| {
        let named = items.iter().find(|(own, _)| own == name);
        named.map(|(_, text)| text)
    };
    used.extend(defined(skeleton));
    let mut source = String::new();
    let mut lines = skeleton.lines();
    while let Some(line) = lines.next() {
        let words: Vec<&str> = line.split(' ').collect();
        match words[..] {
            ["//", "carry", name, "as", other] => {
                used.extend([name, other].map(str::to_owned));
                match find(name) {
                    Some(text) => source += &format!("{}\n", renamed(text, name, other)),
                    // The mark goes, and the empty line below it.
                    None => drop(lines.next()),
                }
            }
            ["//", "carry", name] => {
                if let Some(text) = find(name) {
                    source += &format!("{text}\n");
                    lines.find(|&line| line == "}");
                }
            }
            ["//", "show", name] => {
                used.push(name.to_owned());
                // What was never written tells nobody anything.
                let text = find(name).filter(|text| !text.contains("todo!()"));
                source += &text.map_or(String::new(), |text| shown(text));
            }
            _ => source += &format!("{line}\n"),
        }
    }
    source
}

/// The item as a comment, for the eyes.
fn shown(text: &str) -> String {
    let is_doc = |line: &&str| line.trim_start().starts_with("///");
    let lines = text.lines().filter(|line| !is_doc(line));
    let comment: String = lines.map(|line| format!("// {line}\n")).collect();
    format!("// What you wrote before:\n//\n{comment}\n")
}

/// The text of a function by another name.
fn renamed(text: &str, name: &str, other: &str) -> String {
    text.replacen(&format!("fn {name}("), &format!("fn {other}("), 1)
}

/// The names that the skeleton defines.
fn defined(skeleton: &str) -> Vec<String> {
    let items = items_of(skeleton).expect("a skeleton is Rust");
    items.into_iter().map(|(name, _)| name).collect()
}

/// The text of a plain file: whoever opens a pipe waits for its other end, and a link may
/// lead to a file that does not end.
fn read_file(path: &Path) -> io::Result<String> {
    if !path.symlink_metadata()?.is_file() {
        return Err(io::Error::other("it is no file"));
    }
    Ok(fs::read_to_string(path)?.replace("\r\n", "\n"))
}

/// The items of a source that may be nested as deep as it has letters, and is parsed by
/// recursion.
fn on_a_stack_for(source: &str) -> Result<Vec<(String, String)>, String> {
    // What a letter may take: 50,000 references of a type, without optimization, took half.
    const FRAMES: usize = 1 << 16;
    let stack = thread::Builder::new().stack_size((1 << 21) + FRAMES * source.len());
    thread::scope(|scope| {
        let parsed = stack.spawn_scoped(scope, || items_of(source));
        let parsed = parsed.map_err(|cause| format!("it is too long: {cause}"))?;
        parsed.join().expect("it fits on the stack")
    })
}

/// Each item of the source that has a name, with all that is written behind it.
fn items_of(source: &str) -> Result<Vec<(String, String)>, String> {
    let file: File = syn::parse_str(source)
        .map_err(|cause| format!("line {}: {cause}", cause.span().start().line))?;
    let text = |item: &Item| {
        let item = item.span().byte_range();
        let rest = source[item.end..].lines().next().unwrap_or_default();
        let is_comment = rest.trim_start().starts_with("//");
        source[item].to_owned() + if is_comment { rest } else { "" }
    };
    let named = |item: &Item| Some((name(item, source)?, text(item)));
    Ok(file.items.iter().filter_map(named).collect())
}

/// What an item goes by: an impl block by its header, so that it stays with its type.
fn name(item: &Item, source: &str) -> Option<String> {
    let written = |part: &dyn Spanned| source[part.span().byte_range()].to_owned();
    Some(match item {
        Item::Const(item) => item.ident.to_string(),
        Item::Enum(item) => item.ident.to_string(),
        Item::Fn(item) => item.sig.ident.to_string(),
        Item::Macro(item) => item.ident.as_ref()?.to_string(),
        Item::Mod(item) => item.ident.to_string(),
        Item::Static(item) => item.ident.to_string(),
        Item::Struct(item) => item.ident.to_string(),
        Item::Trait(item) => item.ident.to_string(),
        Item::Type(item) => item.ident.to_string(),
        Item::Use(item) => written(&item.tree),
        Item::Impl(block) => written(&block.self_ty),
        _ => return None,
    })
}

/// The files below a folder of the crate, however deep, but for the chapter itself and
/// what an editor or a system hides there. A link is left where it is.
fn other_files(folder: &Path, below: &Path) -> Vec<PathBuf> {
    let here = folder.join(below);
    let entries = fs::read_dir(&here)
        .into_iter()
        .filter(|_| !here.is_symlink());
    let entries = entries.flatten();
    let shown = entries
        .flatten()
        .filter(|entry| !entry.file_name().to_string_lossy().starts_with('.'));
    let named = shown.filter_map(|entry| {
        let name = below.join(entry.file_name());
        Some((name, entry.file_type().ok()?))
    });
    let inside = named.flat_map(|(name, kind)| {
        if kind.is_dir() {
            other_files(folder, &name)
        } else if kind.is_file() {
            vec![name]
        } else {
            Vec::new()
        }
    });
    let chapter = ["src/lib.rs", "src/main.rs"].map(PathBuf::from);
    inside.filter(|name| !chapter.contains(name)).collect()
}
