//! Width and height: which mistakes give a picture its shape.

use super::scene::Scene;
use slips::{Program, Slip};

/// The slips with which a program draws `width` × `height` pixels where the
/// right one does not, whatever the pixels are.
pub fn giving(scene: &Scene, width: u32, height: u32) -> Vec<&'static Slip> {
    let gives = |program: Program| {
        [width, height]
            .into_iter()
            .any(|asked| program.run(asked).size() == (width, height))
    };
    if gives(scene.program(&[])) {
        return Vec::new();
    }
    scene
        .slips()
        .filter(|slip| gives(scene.program(&[slip])))
        .collect()
}
