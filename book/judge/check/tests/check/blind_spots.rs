//! Tests of blind spots: the mistakes that a right picture hides, and the next picture that shows
//! them; and of pictures of other scenes.

use check::blind_spots;
use check::context::Context;
use check::judge_file;
use check::task::Task;
use check::verdict::RefusalKind;
use difference::png;
use slips::Chapter;
use slips::{self, ChapterCode, Languages, PROBES, Probe, Slip, Unseen};

/// The width of a probe at which the height is rounded.
const WIDTH: u32 = 227;

#[test]
fn those_slips_are_hidden_that_draw_the_right_picture() {
    for chapter in Chapter::OF_THE_BOOK {
        let own = task(chapter, None);
        let right = chapter.picture(WIDTH);
        let hidden = own.slips().filter(|slip| {
            let equivalent = matches!(slip.why_unseen_in(chapter), Some(Unseen::Equivalent(_)));
            let wrong = slip.program(chapter).run(WIDTH);
            let is_as_large = wrong.size() == (right.width(), right.height());
            !equivalent && is_as_large && wrong.rgb().flatten().eq(right.rgb().iter().copied())
        });
        let expected: Vec<&str> = hidden.map(|slip| slip.name).collect();
        let hidden = blind_spots::hidden_slips(&own, WIDTH).into_iter();
        let hidden: Vec<&str> = hidden.map(|slip| slip.name).collect();
        assert_eq!(hidden, expected, "{chapter:?}");
    }
}

/// The next picture is drawn until only laws show the mistakes that are left, and none comes twice.
#[test]
fn the_next_picture_shows_what_it_is_said_to_show() {
    for chapter in [Chapter::Gradient, Chapter::Normals] {
        let own = task(chapter, None);
        let mut hidden = blind_spots::hidden_slips(&own, 400);
        let mut next = blind_spots::next_picture(&own, 400, |_| true);
        let mut drawn = 0;
        while let Some(it) = next {
            let draw = |slips: &[&Slip]| it.task.program(slips).run(it.width).picture();
            for slip in &it.slips {
                assert!(draw(&[slip]) != draw(&[]), "{chapter:?}: {}", slip.name);
            }
            hidden.retain(|slip| it.slips.iter().all(|shown| shown.name != slip.name));
            drawn += 1;
            assert!(drawn <= PROBES.len(), "{chapter:?} goes round in a circle");
            next = blind_spots::next_picture(&it.task, it.width, |_| true);
        }
        let is_unseen = |slip: &&Slip| slip.why_unseen_in(chapter).is_some();
        assert!(hidden.iter().all(is_unseen), "{chapter:?}: {hidden:?}");
    }
}

#[test]
fn a_picture_that_is_too_small_is_to_be_drawn_as_large_as_in_the_book() {
    let own = task(Chapter::Gradient, None);
    let next = blind_spots::next_picture(&own, 60, |_| true).expect("a picture");
    assert_eq!((next.task.probe, next.width), (None, 400));
}

/// The other changes show mistakes of chapters before, or take more to type.
#[test]
fn chapter_5_begins_with_the_probe_that_shows_the_first_hit_returned() {
    let own = task(Chapter::HittableList, None);
    let next = blind_spots::next_picture(&own, 400, |_| true).expect("a picture");
    assert_eq!(next.task.probe, slips::find_probe("reversed"));
    assert!(next.slips.iter().any(|slip| slip.name == "first-hit-wins"));
}

#[test]
fn a_forgotten_change_is_recognized() {
    const WIDTH: u32 = 57;
    for (chapter, probe) in probes() {
        let wanted = task(chapter, Some(probe));
        let own = chapter.picture(WIDTH);
        if probe.spheres.is_some() && own == wanted.right_picture(WIDTH, own.height()) {
            continue;
        }
        let verdict = judge_file(&wanted, &png::encode(&own), 0, &Context::default());
        assert_eq!(verdict.exit_code(), 1);
        let another = verdict.refusal.filter(|it| it.kind == RefusalKind::Another);
        let cause = another.expect("it is named").cause;
        let lines = probe
            .instructions(chapter, Languages::Both)
            .replace('\n', "; ");
        assert!(cause.fix.contains(&lines), "{cause}");
    }
}

/// Each probe in each chapter that has room for it.
fn probes() -> impl Iterator<Item = (Chapter, Probe)> {
    let all = Chapter::OF_THE_BOOK.into_iter();
    all.flat_map(|chapter| PROBES.map(|probe| (chapter, probe)))
        .filter(|&(chapter, probe)| Task::new(chapter, Some(probe)).is_some())
}

fn task(chapter: Chapter, probe: Option<Probe>) -> Task {
    Task::new(chapter, probe).expect("the chapter has room for it")
}
