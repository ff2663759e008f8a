//! Exports for the workers of an editor in which a reader types a chapter.
//!
//! The bytes that a worker gives are the name of a chapter, and then the name and the text of each
//! file, with a zero byte between them.

use std::cell::RefCell;

use check::answer::Grade;
use common::rtweekend::Picture;
use interpreter::{Program, SourceFile, Span};
use slips::Chapter;

use super::{given::given, keep};
use crate::next::{self, Lack};
use crate::rgba;
use crate::typed::{Draft, Feedback};
use crate::typing::Caret;
use crate::{home, typed};

/// Returns the files with which an editor begins, of the chapter whose name was given: see
/// [`typed::beginning`]. Zero bytes stand between the texts.
#[unsafe(no_mangle)]
extern "C" fn begin() -> usize {
    keep(typed::beginning(draft().chapter).join("\0"))
}

thread_local! {
    static DRAWN: RefCell<Option<(Draft, Program, Picture)>> = const { RefCell::new(None) };
}

/// Draws the draft that was given, `width` pixels wide. Returns the height of the picture, whose
/// pixels are the answer, four bytes each; or 0 if the draft is no program or stops, and then the
/// answer is the feedback on it.
///
/// The reader is typing at the end of `line`, counted from 1, of the file with the index `file`, or
/// rests there; nowhere, if `line` is 0.
#[unsafe(no_mangle)]
extern "C" fn draw(width: u32, file: usize, line: usize, rests: bool) -> u32 {
    let draft = Draft {
        caret: (line > 0).then_some(Caret { file, line, rests }),
        ..draft()
    };
    let drawn = draft.read().and_then(|program| {
        let picture = draft.draw(&program, width)?;
        Ok((program, picture))
    });
    match drawn {
        Ok((program, picture)) => {
            keep(rgba(&picture));
            let height = picture.height();
            DRAWN.set(Some((draft, program, picture)));
            height
        }
        Err(feedback) => {
            keep(lines(&feedback));
            0
        }
    }
}

/// Returns the length of the last answer in bytes, for a call that returned something else.
#[unsafe(no_mangle)]
extern "C" fn length() -> usize {
    super::ANSWER.with_borrow(Vec::len)
}

/// Judges the picture that was drawn last; it is then forgotten.
#[unsafe(no_mangle)]
extern "C" fn judge() -> usize {
    let (draft, program, picture) = DRAWN.take().expect("it was drawn");
    keep(lines(&draft.judged(program, &picture)))
}

/// Returns the next line to type, searched from the function on that has this line, counted from 1,
/// of the file with this index: the index of its file, the line it goes above (from 0), 1 if it
/// replaces that line, and its text, with tabs between them. Returns nothing if no line is missing,
/// and `?` if the draft goes another way than the chapter.
#[unsafe(no_mangle)]
extern "C" fn next_line(file: usize, line: usize) -> usize {
    keep(match next::next(&draft(), (file, line)) {
        Lack::Line(it) => {
            let replaces = u8::from(it.replaces);
            format!("{}\t{}\t{replaces}\t{}", it.file, it.above, it.text)
        }
        Lack::Nothing => String::new(),
        Lack::Unknown => "?".to_owned(),
    })
}

/// Returns an archive of the draft as a crate of its own; `number` tells that crate from all
/// others.
#[unsafe(no_mangle)]
extern "C" fn take_home(number: f64) -> usize {
    keep(home::archive(&draft(), number as u64))
}

/// Reads the draft from the bytes that were given.
pub(super) fn draft() -> Draft {
    let given = given();
    let given = String::from_utf8_lossy(&given);
    let fields: Vec<String> = given.split('\0').map(str::to_owned).collect();
    let (files, _) = fields[1..].as_chunks();
    let file = |[name, text]: &[String; 2]| SourceFile::new(name, text);
    Draft {
        chapter: Chapter::find(&fields[0]).expect("a page names its chapter"),
        files: files.iter().map(file).collect(),
        caret: None,
    }
}

/// Writes feedback for the script: on the first line the grade (`right`, `calm` or `wrong`), `waits`
/// if the caret's line is yet to be judged, and the places, with tabs between; on the second the
/// headline; and then the rest.
fn lines(feedback: &Feedback) -> String {
    let grade = match feedback.grade {
        Grade::Right => "right",
        Grade::OnTheWay => "calm",
        Grade::Wrong | Grade::NoPicture => "wrong",
    };
    let waits = if feedback.is_waiting { "waits" } else { "" };
    let place = |it: &Span| format!("{} {} {} {}", it.file, it.line, it.start, it.end);
    let places = feedback.places.iter().map(place);
    let facts: Vec<String> = [grade, waits]
        .map(str::to_owned)
        .into_iter()
        .chain(places)
        .collect();
    let (headline, rest) = (&feedback.headline, &feedback.rest);
    format!("{}\n{headline}\n{rest}", facts.join("\t"))
}
