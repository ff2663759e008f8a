//! throw-away
use check::scene::Scene;
use check::verdict::{Check, check};
use common::rtweekend::Picture;
use slips::{Chapter, Edition};
use std::io::{BufRead, Write};
fn cpu() -> f64 {
    let s = std::fs::read_to_string("/proc/self/schedstat").unwrap();
    s.split_whitespace().next().unwrap().parse::<f64>().unwrap() / 1e9
}
fn main() {
    let args: Vec<String> = std::env::args().collect();
    if args[1] == "draw" {
        let width: u32 = args[2].parse().unwrap();
        let dir = &args[3];
        std::fs::create_dir_all(dir).unwrap();
        for chapter in Chapter::OF_THE_BOOK {
            for e in Edition::ALL {
                let p = e.program(chapter).run(width).picture();
                std::fs::write(
                    format!("{dir}/{}+right{:?}.png", chapter.name(), e),
                    check::png::encode(&p),
                )
                .unwrap();
            }
            for slip in slips::all().filter(|s| s.chapters.contains(&chapter)) {
                let o = slip.program(chapter).run(width);
                let (w, h) = o.size();
                if w == 0 || h == 0 || w as u64 * h as u64 > 4_000_000 {
                    continue;
                }
                let levels: Vec<[i32; 3]> = o.pixels().collect();
                let outside = levels.iter().flatten().any(|l| !(0..256).contains(l));
                let p: Picture = o.picture();
                let right = Edition::ALL
                    .into_iter()
                    .any(|e| e.program(chapter).run(width).picture() == p);
                let mark = match (right, outside) {
                    (true, _) => "=",
                    (_, true) => "~",
                    _ => "",
                };
                std::fs::write(
                    format!("{dir}/{}+{}{mark}.png", chapter.name(), slip.name),
                    check::png::encode(&p),
                )
                .unwrap();
                if outside {
                    std::fs::write(
                        format!("{dir}/{}+{}{mark}.ppm", chapter.name(), slip.name),
                        o.to_string(),
                    )
                    .unwrap();
                }
            }
        }
        return;
    }
    let out = std::io::stdout();
    for line in std::io::stdin().lock().lines() {
        let line = line.unwrap();
        let (chapter, path) = line.split_once(' ').unwrap();
        let scene = Scene::new(Chapter::find(chapter).unwrap(), None).unwrap();
        let bytes = std::fs::read(path).unwrap();
        let start = cpu();
        let answer = check(&scene, &bytes, 0);
        let took = cpu() - start;
        let kind = match &answer {
            Check::Right(r) => format!(
                "Right {:?} off {} given {:?}",
                r.scene.edition,
                r.off,
                r.shape_given_by.iter().map(|s| s.name).collect::<Vec<_>>()
            ),
            Check::Near(_) => "Near".into(),
            Check::Wrong(_) => "Wrong".into(),
            Check::Another { cause, .. } => format!("Another {}", cause.problem),
            Check::WrongShape { cause, .. } => format!("WrongShape {}", cause.fix),
            Check::NotAPicture { cause, .. } => format!("NotAPicture {}", cause.name),
        };
        let mut said = String::new();
        if let Some(f) = answer.finding() {
            said += &format!(" | {:?} lead {:.0} |", f.scene.edition, f.lead);
            if f.near.is_some() {
                said += &format!(" but {}", f.but());
            }
            for s in &f.sets {
                let names: Vec<String> = s.mistakes.iter().map(|m| check::names_of(m)).collect();
                said += &format!(
                    " [{}: {} off {} far {} bits {:.0}]",
                    names.join(", "),
                    s.title(f.right.rgb().len() / 3),
                    s.left.off,
                    s.left.far,
                    s.bits
                );
            }
            for s in &f.sights {
                said += &format!(" <{s}>");
            }
        }
        let mut out = out.lock();
        writeln!(out, "{took:.2}\t{path}\t{kind}{said}").unwrap();
        out.flush().unwrap();
    }
}
