//! Right programs in other words: the page has no remark on them.

use fixtures::typing::{Change, typings};
use page::typed::Draft;
use slips::Chapter;

#[test]
fn right_programs_in_rust_get_no_remark() {
    for spelling in typings(include_str!("spellings.rs.txt")) {
        let chapter = Chapter::find(&spelling.title).expect("a chapter");
        let mut typed = Draft::complete(chapter);
        for Change { old, new } in &spelling.changes {
            let mut files = typed.files.iter_mut();
            let found = files.find(|it| it.text.contains(old));
            let file = &mut found.unwrap_or_else(|| panic!("{old} is in no file")).text;
            *file = file.replace(old, new);
        }
        let program = typed.read().expect("it is Rust");
        let picture = typed.draw(&program, 64).expect("it draws");
        let answer = typed.answer(&program, &picture);
        assert!(answer.is_right(), "{spelling:?}: {}", answer.headline);
        assert!(answer.rows.is_empty(), "{spelling:?} has a remark");
    }
}
