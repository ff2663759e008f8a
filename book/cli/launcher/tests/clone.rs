//! Fixture: a clone in which all is built, and a cargo that says so and builds nothing.

use std::fs::{self, Permissions};
use std::os::unix::fs::PermissionsExt;
use std::process::{Command, Output};
use std::sync::LazyLock;

use fixtures::command::{path_of, run};
use fixtures::desk::Desk;
use fixtures::drawn::p3;
use slips::{Chapter, ChapterCode};

/// A folder with the parts of a clone. Scripts stand for the chapters' programs, which print
/// pictures of ours, for the programs of other commands, which print their arguments, and for the
/// weaver.
pub(crate) struct Clone(pub(crate) Desk);

/// The names and the texts of the pictures that the chapters' programs print, drawn once.
static PICTURES: LazyLock<Vec<(String, Vec<u8>)>> = LazyLock::new(|| {
    let widths = |chapter: Chapter| [16, 30, chapter.book_width()].map(|width| (chapter, width));
    let drawn = |(chapter, width): (Chapter, u32)| {
        let name = format!("{}.{width}.ppm", chapter.name());
        (name, p3(&chapter.picture(width)))
    };
    let drawn = Chapter::OF_THE_BOOK.into_iter().flat_map(widths).map(drawn);
    // No reader draws chapter 6: any picture of its size does.
    let sixth = p3(&Chapter::Gradient.picture(400));
    let sixth = ("speed_vs_accuracy.400.ppm".to_owned(), sixth);
    drawn.chain([sixth]).collect()
});

impl Clone {
    /// Makes a clone in which the program of one chapter, if any, does not compile.
    pub(crate) fn without(broken: Option<&str>) -> Self {
        let clone = Self(Desk::default());
        for part in ["common/Cargo.toml", "tests/laws/Cargo.toml", "book/notes/"] {
            clone.0.write(part, "");
        }
        clone.0.write("target/.rustc_info.json", "");
        clone.0.write("target/debug/", "");
        let copy = clone.0.path("target/debug/launcher");
        fs::copy(path_of("launcher"), copy).expect("a copy of the program");
        for chapter in Chapter::ALL {
            clone.write_program(chapter.name(), "cat \"$0.$2.ppm\"");
        }
        for (name, picture) in &*PICTURES {
            clone.0.write(&format!("target/debug/{name}"), picture);
        }
        for program in ["rtrace", "methods"] {
            clone.write_program(program, "printf '<%s>' \"$@\"; exit 3");
        }
        clone.write_program("weave", "mkdir -p \"$2\" && echo woven > \"$2/index.html\"");
        clone.write_cargo(broken);
        clone
    }

    /// Writes a cargo that reports each program that it is asked for as built, but for one.
    fn write_cargo(&self, broken: Option<&str>) {
        let script = "for word
do
    if [ \"$before\" = --bin ] && [ \"$word\" != BROKEN ]
    then echo \"{\\\"executable\\\":\\\"$word\\\",\\\"fresh\\\":true}\"
    fi
    before=$word
done
exit CODE";
        let code = if broken.is_some() { "101" } else { "0" };
        let script = script.replace("BROKEN", broken.unwrap_or("''"));
        self.write_program("cargo", &script.replace("CODE", code));
    }

    fn write_program(&self, name: &str, script: &str) {
        let name = format!("target/debug/{name}");
        self.0.write(&name, format!("#!/bin/sh\n{script}\n"));
        let may_run = Permissions::from_mode(0o755);
        fs::set_permissions(self.0.path(&name), may_run).expect("it may run");
    }

    /// Makes the command `launcher` with the words of the line as its arguments.
    pub(crate) fn command(&self, line: &str) -> Command {
        let mut command = Command::new(self.0.path("target/debug/launcher"));
        command.args(line.split_whitespace());
        command.env("CARGO", self.0.path("target/debug/cargo"));
        command.current_dir(self.0.path(""));
        command
    }

    /// Runs `launcher` with these arguments, and returns its output.
    pub(crate) fn run(&self, line: &str) -> Output {
        run(&mut self.command(line))
    }
}
