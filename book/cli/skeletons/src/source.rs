//! Source-to-source: a Rust source by its items.

use std::ops::Range;

use syn::Item;
use syn::spanned::Spanned;

/// A top-level item of a Rust source that has a name, such as a function, a type, an `impl` or an
/// import.
pub struct NamedItem {
    /// The name; of an `impl`, the name of its type; of an import, its path.
    pub name: String,
    /// The range of bytes that the item takes in the source, documentation and attributes included.
    pub place: Range<usize>,
    /// The source at that place.
    pub text: String,
}

/// Lists the named top-level items of a Rust source, from the top. Imports are named after their
/// paths; other items without a name are left out. Empty for an empty source.
///
/// # Errors
/// Returns one line: the number, from 1, of the line at which the source is not Rust, and the
/// reason.
pub fn items(source: &str) -> Result<Vec<NamedItem>, String> {
    let file = syn::parse_file(source).map_err(|cause| describe_error(&cause))?;
    let named = |item: &Item| {
        let place = item.span().byte_range();
        Some(NamedItem {
            name: name(item, source)?,
            text: source[place.clone()].to_owned(),
            place,
        })
    };
    Ok(file.items.iter().filter_map(named).collect())
}

/// Describes in one line why a source is not Rust: its line, counted from 1, and the reason.
pub fn describe_error(cause: &syn::Error) -> String {
    format!("line {}: {cause}", cause.span().start().line)
}

/// Returns the name of an item; that of an `impl` is its type, and that of an import its path.
/// Returns `None` for an item without a name.
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
