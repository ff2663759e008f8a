//! A tar archive (POSIX.1-1988, ustar) of the crate that `start` would have made, with the files
//! that a reader typed in a page. Each file follows a block with its name and its length, so
//! writing it needs no library.

use interpreter::SourceFile;

use crate::typed::Draft;

/// Returns the bytes of a tar archive to be unpacked in the folder of this project: the reader's
/// crate of the draft's chapter, in `mine/CHAPTER`. `number` becomes part of its version, and has
/// to be another for each crate.
pub fn archive(draft: &Draft, number: u64) -> Vec<u8> {
    let chapter = draft.chapter;
    let manifest = skeletons::manifest(chapter, false, "../..", number);
    let config = "[build]\ntarget-dir = \"../../target/mine\"\n".to_owned();
    let given = [
        ("src/main.rs", skeletons::main(chapter, false)),
        ("tests/laws.rs", skeletons::test(chapter, false)),
        ("Cargo.toml", manifest),
        (".cargo/config.toml", config),
        (".vscode/settings.json", skeletons::EDITOR.to_owned()),
    ];
    let typed = draft.files.iter().cloned();
    let files = typed.chain(given.map(|(name, text)| SourceFile::new(name, text)));
    let path = |file: &SourceFile| format!("mine/{}/{}", chapter.name(), file.name);
    let mut archive: Vec<u8> = files
        .filter(|it| !it.text.is_empty())
        .flat_map(|it| entry(&path(&it), it.text.as_bytes()))
        .collect();
    // Two empty blocks are its end.
    archive.resize(archive.len() + 2 * BLOCK, 0);
    archive
}

/// The size of a block of an archive, in bytes.
const BLOCK: usize = 512;

/// Returns a plain file as it stands in an archive: its header block, and its bytes, filled up to
/// whole blocks.
fn entry(name: &str, bytes: &[u8]) -> Vec<u8> {
    let mut block = vec![0; BLOCK];
    let mut put =
        |at: usize, text: &str| block[at..at + text.len()].copy_from_slice(text.as_bytes());
    put(0, name);
    // May be read by all and written by an owner without a name.
    put(100, "0000644\x000000000\x000000000\0");
    put(124, &format!("{:011o}\0{:011o}\0", bytes.len(), 0));
    // The sum is made with blanks in its own place.
    put(148, "        0");
    put(257, "ustar\x0000");
    let sum: u32 = block.iter().map(|&byte| u32::from(byte)).sum();
    block[148..155].copy_from_slice(format!("{sum:06o}\0").as_bytes());
    block.extend(bytes);
    block.resize(block.len().next_multiple_of(BLOCK), 0);
    block
}
