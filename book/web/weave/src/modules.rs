//! WebAssembly in scripts: a page that is opened from a file may load nothing else.

use std::fs;
use std::io::{self, Write};
use std::path::Path;

use base64::prelude::{BASE64_STANDARD, Engine as _};
use flate2::Compression;
use flate2::write::GzEncoder;
use launcher::output;

/// Writes a script for each module of WebAssembly in the folder `modules` into the folder `scripts`,
/// unless the script is there already. `NAME.module.js` sets `NAMEModule` to the module, as base64 of
/// gzip. A folder that is missing has no module.
///
/// # Errors
/// If a file can't be read or written.
pub(crate) fn pack(modules: &Path, scripts: &Path) -> io::Result<()> {
    if !modules.is_dir() {
        return Ok(());
    }
    for entry in fs::read_dir(modules)? {
        let module = entry?.path();
        let Some(name) = module.file_stem().filter(|_| is_wasm(&module)) else {
            continue;
        };
        let name = name.display();
        let mut gzip = GzEncoder::new(Vec::new(), Compression::best());
        gzip.write_all(&fs::read(&module)?)?;
        let text = BASE64_STANDARD.encode(gzip.finish()?);
        let script = format!("globalThis.{name}Module = \"{text}\";\n");
        let path = scripts.join(format!("{name}.module.js"));
        if fs::read_to_string(&path).ok().as_ref() != Some(&script) {
            output::to_file(&path, |file| file.write_all(script.as_bytes()))?;
        }
    }
    Ok(())
}

/// Returns true for the name of a module.
fn is_wasm(path: &Path) -> bool {
    path.extension().is_some_and(|it| it == "wasm")
}
