//! Golden pictures: the hash of what each mistake, probe and step draws, and version 3 of the book,
//! and the look of each wrong picture.

mod looks;
mod pages;

use std::fmt::Write;

use common::rtweekend::Picture;
use rayon::prelude::*;
use slips::{Chapter, ChapterProgram, PROBES, Slip, steps};

use looks::{Drawn, Look};

/// The width of the pictures in pixels: a prime number, so that no row length fits another by chance.
const WIDTH: u32 = 47;

/// Hashes all numbers that a program prints (FNV-1a).
fn hash(program: &ChapterProgram, width: u32) -> u64 {
    let output = program.run(width);
    let (columns, rows) = output.size();
    let numbers = [columns, rows].map(|it| it as i32);
    let all = numbers.into_iter().chain(output.pixels().flatten());
    all.fold(0xcbf2_9ce4_8422_2325, |hash, number| {
        (hash ^ u64::from(number as u32)).wrapping_mul(0x0000_0100_0000_01b3)
    })
}

fn table(rows: impl FnOnce(&mut dyn FnMut(Chapter, &str, u64))) -> String {
    let mut table = String::new();
    rows(&mut |chapter, name, hash| {
        let chapter = chapter.name();
        writeln!(table, "{chapter:<14} {name:<28} {hash:016x}").expect("memory takes it");
    });
    table
}

#[test]
fn every_mistake_draws_its_picture() {
    let drawn = table(|row| {
        for chapter in Chapter::OF_THE_BOOK {
            for slip in slips::all().filter(|slip| slip.is_possible_in(chapter)) {
                row(chapter, slip.name, hash(&slip.program(chapter), WIDTH));
            }
        }
    });
    insta::assert_snapshot!("mistakes", drawn);
}

#[test]
fn every_probe_version_and_step_draws_its_picture() {
    let drawn = table(|row| {
        for chapter in Chapter::OF_THE_BOOK {
            let right = ChapterProgram::right(chapter);
            row(chapter, "right", hash(&right, WIDTH));
            for probe in PROBES {
                if let Some(probed) = probe.applied_to(&right) {
                    row(chapter, probe.name, hash(&probed, probe.width));
                }
            }
            let older = slips::version_3();
            row(chapter, older.name, hash(&older.applied_to(&right), WIDTH));
            for (n, step) in (1..).zip(steps::of_chapter(chapter)) {
                let name = format!("step {n}");
                row(chapter, &name, hash(&step.applied_to(&right), WIDTH));
            }
        }
    });
    insta::assert_snapshot!("scenes", drawn);
}

/// A look, a chapter, and the mistakes that draw one picture of this look there.
type Seen = (Look, Chapter, Vec<&'static str>);

#[test]
#[ignore = "it draws some hundred pictures"]
fn every_mistake_is_shown_on_its_page_as_it_looks() {
    let right =
        Chapter::OF_THE_BOOK.map(|chapter| Drawn::by(&ChapterProgram::right(chapter), None));
    let slips: Vec<&Slip> = slips::all().collect();
    let looks = slips.into_par_iter().map(|slip| {
        let drawn = slip.chapters().map(|chapter| {
            let right = &right[chapter as usize];
            let wrong = Drawn::by(&slip.program(chapter), Some(right));
            (Look::of(right, &wrong), chapter, wrong.picture)
        });
        (slip.name, drawn.collect::<Vec<_>>())
    });
    let mut seen: Vec<(Seen, Picture)> = Vec::new();
    for (name, drawn) in looks.collect::<Vec<_>>() {
        let mut known = vec![Look::Right];
        for (look, chapter, picture) in drawn {
            if known.contains(&look) {
                continue;
            }
            known.push(look);
            let is_it = |((of, at, _), drawn): &&mut (Seen, _)| {
                (*of, *at) == (look, chapter) && *drawn == picture
            };
            match seen.iter_mut().find(is_it) {
                Some(((.., names), _)) => names.push(name),
                None => seen.push(((look, chapter, vec![name]), picture)),
            }
        }
    }
    pages::assert_shown(&seen);
}

#[test]
#[ignore = "it draws some hundred pictures"]
fn every_hidden_mistake_is_shown_by_the_same_probes() {
    let hidden = Chapter::OF_THE_BOOK.into_par_iter().map(hidden_in);
    insta::assert_snapshot!("hidden", hidden.collect::<String>());
}

fn hidden_in(chapter: Chapter) -> String {
    let right = ChapterProgram::right(chapter);
    let mut hidden = String::new();
    for slip in slips::all().filter(|slip| slip.is_possible_in(chapter)) {
        if !are_alike(&right, &slip.program(chapter), chapter.book_width()) {
            continue;
        }
        hidden += &format!("{} {}", chapter.name(), slip.name);
        for probe in PROBES {
            if let Some(right) = probe.applied_to(&right)
                && !are_alike(&right, &slip.applied_to(&right), probe.width)
            {
                hidden += &format!(" {}", probe.name);
            }
        }
        hidden += "\n";
    }
    hidden
}

fn are_alike(right: &ChapterProgram, wrong: &ChapterProgram, width: u32) -> bool {
    let [right, wrong] = [right, wrong].map(|it| it.run(width));
    right.size() == wrong.size() && right.rgb().eq(wrong.rgb())
}
