//! What there is to say about a set of mistakes, wherever it is said.

use common::engine::companion;

use super::{Conversion, Explains, Scene, Set};
use crate::slips::Slip;

impl Set {
    /// How well the mistakes explain a picture of that many pixels.
    pub fn title(&self, pixels: usize) -> String {
        let several = self.mistakes.len() > 1;
        let both = self.mistakes[0].len() > 1;
        let who = match (several, both) {
            (false, false) => "One mistake draws",
            (true, false) => "Each of these mistakes draws",
            (false, true) => "Two mistakes together draw",
            (true, true) => "Each of these pairs of mistakes draws",
        };
        let wrapped = match self.conversion {
            Conversion::Wrapped => {
                " (if levels beyond 255 begin again at 0, as with a cast to a byte in C)"
            }
            _ => "",
        };
        format!("{who} {}{wrapped}:", self.extent(pixels))
    }

    /// How to find out which mistake it is, if there are several.
    pub fn how_to_tell(&self, scene: &Scene) -> String {
        if self.mistakes.len() < 2 {
            return String::new();
        }
        let Some(telling) = &self.telling else {
            return "\n  This picture can't tell them apart, and no probe can: look for each.\n"
                .to_owned();
        };
        let group = |group: &Vec<usize>| {
            let names: Vec<String> = group.iter().map(|&n| names_of(&self.mistakes[n])).collect();
            names.join(", ")
        };
        let groups: Vec<String> = telling.groups.iter().map(group).collect();
        let (name, probe) = (scene.chapter.name(), telling.probe.name);
        format!(
            "\n  This picture can't tell them apart. The probe {probe} can: {}.\n  Change your program to\n    {}\n  and then: {} check {name} --probe {probe} PICTURE\n",
            groups.join(" | "),
            telling.probe.lines(scene.chapter).replace('\n', "\n    "),
            companion(),
        )
    }

    fn extent(&self, pixels: usize) -> String {
        let (far, off, compared) = (self.fit.far, self.fit.off, self.fit.compared);
        match self.explains {
            Explains::All if compared == pixels => "exactly this picture".to_owned(),
            Explains::All => format!("this picture in all {compared} pixels that were compared"),
            Explains::AllButOneLevel => {
                format!("this picture, but for one level in {off} of {compared} pixels")
            }
            Explains::Most if far > 0 => format!(
                "most of this picture, but not all: {far} of {compared} pixels are still wrong"
            ),
            Explains::Most => format!(
                "most of this picture, but not all: {off} of {compared} pixels are still a level off"
            ),
        }
    }
}

/// The names of slips that were made together.
pub fn names_of(mistake: &[&Slip]) -> String {
    let names: Vec<&str> = mistake.iter().map(|slip| slip.name).collect();
    names.join(" and ")
}
