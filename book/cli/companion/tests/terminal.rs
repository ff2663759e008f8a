//! At a terminal: an answer is colored, unless colors are not wanted.

use std::process::Command;

use fixtures::desk::Desk;
use fixtures::terminal::run_in_terminal;
use slips::{Chapter, ChapterCode};

#[test]
fn nothing_is_colored_where_colors_are_not_wanted() {
    let desk = Desk::default();
    desk.write_picture("right.ppm", &Chapter::Normals.picture(16));
    let judged = || desk.command("rtrace check normals right.ppm");
    assert!(run_in_terminal(&mut judged()).1.contains('\x1b'));
    let unwanted: [fn(&mut Command) -> &mut Command; 3] = [
        |command| command.env("TERM", "dumb"),
        |command| command.env("NO_COLOR", "1"),
        |command| command.env_remove("TERM"),
    ];
    for without in unwanted {
        let (_, screen) = run_in_terminal(without(&mut judged()));
        assert!(!screen.contains('\x1b'), "{screen:?}");
    }
}
