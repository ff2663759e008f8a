//! The catalogue: every slip by name.

mod camera;
mod chapters;
mod file;
mod function;
mod list;
mod normals;
mod sky;
mod sphere;

use super::slip::Slip;

/// All slips, in the order in which a reader can first make them.
pub fn all() -> impl Iterator<Item = &'static Slip> {
    [
        file::SLIPS,
        camera::SLIPS,
        sky::SLIPS,
        sphere::SLIPS,
        normals::SLIPS,
        list::SLIPS,
    ]
    .into_iter()
    .flatten()
}

/// Mistakes without a name, which only laws look for.
pub fn unnamed() -> impl Iterator<Item = &'static Slip> {
    function::SLIPS.iter()
}

/// The slip of that name.
pub fn find(name: &str) -> Option<&'static Slip> {
    all().find(|slip| slip.name == name)
}
