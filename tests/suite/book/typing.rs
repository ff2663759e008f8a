//! Help for a reader who types in a page. That the page judges as `watch` does is tested with the
//! companion, and the page itself in `tests/browser`.

use page::next::next;
use page::typed::Text;
use slips::Chapter;

/// As many times as it takes.
#[test]
fn the_next_lines_lead_from_empty_functions_to_the_chapter() {
    for chapter in Chapter::OF_THE_BOOK {
        let mut text = Text::skeleton(chapter);
        while let Some(next) = next(&text, 0) {
            let (name, file) = &mut text.files[next.file];
            let mut lines: Vec<&str> = file.lines().collect();
            if next.is_last {
                lines[next.above] = next.text;
            } else {
                lines.insert(next.above, next.text);
            }
            assert!(lines.len() < 200, "{name} never ends:\n{file}");
            *file = lines.join("\n");
        }
        for ((name, typed), (_, full)) in text.files.iter().zip(Text::full(chapter).files) {
            assert_eq!(code(typed), code(&full), "{name} of {}", chapter.name());
        }
    }
}

fn code(text: &str) -> Vec<&str> {
    let is_code = |line: &&str| {
        !line.is_empty()
            && !["//", "#", "use "]
                .iter()
                .any(|it| line.trim_start().starts_with(it))
    };
    text.lines().filter(is_code).collect()
}
