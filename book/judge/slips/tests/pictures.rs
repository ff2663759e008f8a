//! Golden pictures: what each mistake, probe, edition and step draws, as hashes.

use std::fmt::Write;

use slips::{Chapter, Edition, PROBES, Program, steps};

/// Neither the width nor the height that it gives is a multiple of the other's parts.
const WIDTH: u32 = 97;

/// The numbers that a program prints, in one (FNV-1a).
fn hash(program: &Program, width: u32) -> u64 {
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
            for slip in slips::all().filter(|slip| slip.chapters.contains(&chapter)) {
                row(chapter, slip.name, hash(&slip.program(chapter), WIDTH));
            }
        }
    });
    insta::assert_snapshot!("mistakes", drawn);
}

#[test]
fn every_probe_edition_and_step_draws_its_picture() {
    let drawn = table(|row| {
        for chapter in Chapter::OF_THE_BOOK {
            let right = Program::right(chapter);
            row(chapter, "right", hash(&right, WIDTH));
            for probe in PROBES {
                if let Some(probed) = probe.put_to(right) {
                    row(chapter, probe.name, hash(&probed, probe.width));
                }
            }
            for edition in Edition::ALL {
                let name = format!("version {} {edition:?}", edition.name());
                row(chapter, &name, hash(&edition.program(chapter), WIDTH));
            }
            for (n, step) in (1..).zip(steps::of(chapter)) {
                let name = format!("step {n}");
                row(chapter, &name, hash(&step.put_to(right), WIDTH));
            }
        }
    });
    insta::assert_snapshot!("scenes", drawn);
}

/// Which mistakes the chapter's own picture hides, and which probes show them.
#[test]
fn every_hidden_mistake_is_shown_by_the_same_probes() {
    let mut shown = String::new();
    for chapter in Chapter::OF_THE_BOOK {
        let right = hash(&Program::right(chapter), chapter.book_width());
        for slip in slips::all().filter(|slip| slip.chapters.contains(&chapter)) {
            if hash(&slip.program(chapter), chapter.book_width()) != right {
                continue;
            }
            let probes = PROBES.iter().filter(|probe| probe.tells(slip, chapter));
            let probes: Vec<&str> = probes.map(|probe| probe.name).collect();
            writeln!(
                shown,
                "{} {} {}",
                chapter.name(),
                slip.name,
                probes.join(" ")
            )
            .expect("memory takes it");
        }
    }
    insta::assert_snapshot!("shown_by", shown);
}
