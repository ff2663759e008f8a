//! What the workers of an editor call.
//!
//! What is given is the name of a chapter, and then the name and the text of each file, with a
//! zero byte between them.

use std::cell::RefCell;

use common::rtweekend::Picture;
use interpreter::{Program, SourceFile};
use slips::Chapter;

use super::{given::given, keep};
use crate::rgba;
use crate::typed::{Draft, Feedback};
use crate::typing::Caret;
use crate::{home, next, typed};

/// The files of the chapter whose name was given: of each its name, with nothing in its
/// functions, and in full. After them the steps.
#[unsafe(no_mangle)]
extern "C" fn begin() -> usize {
    keep(typed::beginning(draft().chapter).join("\0"))
}

thread_local! {
    static DRAWN: RefCell<Option<(Draft, Program, Picture)>> = const { RefCell::new(None) };
}

/// Draws the text: the height of the picture, whose pixels are the answer; or 0, and the answer
/// is what is said of a text that is no program, or that stops. The reader is typing at the end of
/// this line of this file; at none, if the line is 0.
#[unsafe(no_mangle)]
extern "C" fn draw(width: u32, file: usize, line: usize) -> u32 {
    let draft = Draft {
        caret: (line > 0).then_some(Caret { file, line }),
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

/// How long the answer is.
#[unsafe(no_mangle)]
extern "C" fn length() -> usize {
    super::ANSWER.with_borrow(Vec::len)
}

/// Judges what was drawn last, once.
#[unsafe(no_mangle)]
extern "C" fn judge() -> usize {
    let (draft, program, picture) = DRAWN.take().expect("it was drawn");
    keep(lines(&draft.judged(program, &picture)))
}

/// The next line to type, from that file on: its file, what it goes above, whether it takes that
/// place, and the line itself. Nothing if all is there.
#[unsafe(no_mangle)]
extern "C" fn next_line(first: usize) -> usize {
    let next = next::next(&draft(), first);
    let next = next.map(|it| {
        let replaces = u8::from(it.replaces_todo);
        format!("{}\t{}\t{replaces}\t{}", it.file, it.above, it.text)
    });
    keep(next.unwrap_or_default())
}

/// The archive of the crate, with a number that no other has.
#[unsafe(no_mangle)]
extern "C" fn take_home(number: f64) -> usize {
    keep(home::archive(&draft(), number as u64))
}

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

/// The places on a line, the headline on one, and then the rest.
fn lines(feedback: &Feedback) -> String {
    let place = |place: &[usize; 4]| place.map(|it| it.to_string()).join(" ");
    let places: Vec<String> = feedback.places.iter().map(place).collect();
    format!(
        "{}\n{}\n{}",
        places.join("\t"),
        feedback.headline,
        feedback.rest
    )
}
