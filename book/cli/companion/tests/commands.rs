//! Every command line that a page or an answer names is understood, and those that stand in
//! a block do their work where a reader types them.

use std::fs;
use std::path::Path;

use fixtures::command::{files, run, text};
use fixtures::desk::Desk;
use fixtures::workspace;
use slips::{Chapter, ChapterCode};

/// Runs the commands of a block in a folder with the files that they name. None may be misused.
#[test]
fn every_command_that_a_page_names_works() {
    for (page, text) in pages() {
        let desk = Desk::default();
        desk.write_picture("mine.ppm", &Chapter::Normals.picture(32));
        desk.write_picture("build_test.ppm", &Chapter::BuildTest.picture(32));
        desk.write_picture("mine.png", &Chapter::Normals.picture(32));
        for line in named(&text) {
            let output = run(&mut desk.command(&with_help(&line)));
            assert!(output.status.success(), "{page}: {line}");
        }
        for line in in_blocks(&text) {
            if is_quick(&line) {
                let code = desk.run(&line).status.code();
                assert!(matches!(code, Some(0 | 1)), "{page}: {line}");
            }
        }
        if text.contains("`rtrace ") || text.contains("\nrtrace ") {
            let says_how = text.contains("#in-any-folder") || text.contains("## In any folder");
            assert!(says_how, "{page} does not say how `rtrace` is installed");
        }
    }
}

/// Also the commands that the companion tells a reader to type next.
#[test]
fn every_command_that_an_answer_names_is_understood() {
    let desk = Desk::default();
    let mut said = String::new();
    for chapter in Chapter::OF_THE_BOOK {
        let name = chapter.name();
        desk.write_picture("right.ppm", &chapter.picture(100));
        for line in [
            format!("rtrace watch {name} --once"),
            format!("rtrace check {name} right.ppm"),
            format!("rtrace check {name} right.ppm --probe inside"),
        ] {
            let output = desk.run(&line);
            said += &(text(&output.stdout) + &text(&output.stderr));
        }
        for twice in ["rtrace start", "rtrace start"] {
            let output = desk.run(&format!("{twice} {name}"));
            said += &(text(&output.stdout) + &text(&output.stderr));
        }
    }
    // A line of an answer goes on below its label.
    let said = said.replace("\n           ", " ");
    let end = |c: char| ",`\n;".contains(c);
    let rest = said.split("rtrace ").skip(1);
    let lines: Vec<String> = rest
        .map(|rest| {
            rest.split(end)
                .next()
                .unwrap_or_default()
                .trim_end_matches('.')
        })
        .map(|words| filled(format!("rtrace {words}")))
        .collect();
    assert!(lines.len() > 20, "{said}");
    for line in lines {
        let output = run(&mut desk.command(&with_help(&line)));
        assert!(output.status.success(), "{line}\n{}", text(&output.stderr));
    }
}

/// Returns the README and the notes, each with its name.
fn pages() -> Vec<(String, String)> {
    let notes = files(&workspace().join("book/notes")).into_iter();
    let is_page = |file: &Path| file.extension().is_some_and(|it| it == "md");
    notes
        .filter(|file| is_page(file))
        .chain([workspace().join("README.md")])
        .map(|file| {
            let name = file.file_name().unwrap_or_default().display().to_string();
            (name, fs::read_to_string(file).expect("a page"))
        })
        .collect()
}

/// Lists our commands on a page, as in a folder where `rtrace` is installed.
fn named(page: &str) -> Vec<String> {
    let [alias, installed] = ["cargo rtrace", "rtrace"].map(|it| commands(page, it));
    let installed = installed.into_iter().filter(|line| !line.contains(" = "));
    let aliased = alias.iter().map(|line| line.replacen("cargo ", "", 1));
    aliased.chain(installed).map(filled).collect()
}

/// Lists the lines of code blocks, and the pieces of code in a sentence, that begin with `begin`.
fn commands(page: &str, begin: &str) -> Vec<String> {
    let in_sentences = page
        .split('`')
        .skip(1)
        .step_by(2)
        .filter(|it| !it.contains('\n'));
    let lines = page.lines().chain(in_sentences).map(without_comment);
    lines
        .filter(|line| line.starts_with(begin))
        .map(str::to_owned)
        .collect()
}

fn in_blocks(page: &str) -> Vec<String> {
    let blocks = page
        .split("```sh\n")
        .skip(1)
        .filter_map(|it| it.split("```").next());
    blocks.flat_map(named).collect()
}

fn without_comment(line: &str) -> &str {
    line.split(" #").next().unwrap_or_default().trim()
}

/// Puts something in place of what a reader chooses.
fn filled(line: String) -> String {
    let choices = [
        ("--probe NAME", "--probe inside"),
        ("NAME", "normals"),
        ("CHAPTER", "normals"),
        ("SCENE", "telescope"),
    ];
    let filled = choices.into_iter();
    filled.fold(line, |line, (choice, chosen)| line.replace(choice, chosen))
}

/// Makes a command that asks for help: all words before that are understood then.
fn with_help(line: &str) -> String {
    match line.split_once(" -- ") {
        Some((ours, _)) => format!("{ours} --help"),
        None => format!("{line} --help"),
    }
}

/// Returns true if the command is not tested elsewhere, opens no window, and does not take minutes.
fn is_quick(line: &str) -> bool {
    let slow = [
        "rtrace book",
        "rtrace needs",
        "rtrace watch",
        "rtrace show",
        "--open",
    ];
    line != "rtrace" && !slow.iter().any(|it| line.contains(it)) && !line.contains(" -- ")
}
