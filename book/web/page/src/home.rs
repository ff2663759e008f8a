//! The crate that `start` would have made, with what was typed in a page, as an archive: a
//! `tar` in which each file follows a block that tells its name and its length, so that it
//! needs no library here, and no program there.

use interpreter::SourceFile;

use crate::typed::Draft;

/// An archive to be unpacked in the workspace: the reader's crate of the chapter in `mine`,
/// with a number that no other crate has.
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

const BLOCK: usize = 512;

/// A plain file in an archive (POSIX.1-1988, ustar): its block, and its bytes in blocks.
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
