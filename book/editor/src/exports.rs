//! What the workers of the page call.
//!
//! The script puts a chapter's name, and then the name and the text of each file, where [`take`]
//! says, with a zero byte between them; calls what reads, draws or judges; and reads the answer
//! where [`place`] says. It stays there until the next call.

use std::cell::RefCell;

use common::rtweekend::Picture;
use slips::{Chapter, steps};

use crate::{Said, Text, home, next};

#[derive(Default)]
struct State {
    given: Vec<u8>,
    text: Option<Text>,
    program: Option<interpreter::Program>,
    picture: Option<Picture>,
    said: Vec<u8>,
}

thread_local! {
    static STATE: RefCell<State> = RefCell::default();
}

/// Makes room for a text of so many bytes.
#[unsafe(no_mangle)]
extern "C" fn take(length: usize) -> *mut u8 {
    STATE.with_borrow_mut(|state| {
        *state = State {
            given: vec![0; length],
            ..State::default()
        };
        state.given.as_mut_ptr()
    })
}

/// The files of the chapter whose name was given: of each its name, with nothing in its
/// functions, and in full. After them the steps.
#[unsafe(no_mangle)]
extern "C" fn begin() -> usize {
    let given = given();
    let chapter = Chapter::find(&given[0]).expect("a page names its chapter");
    let (skeleton, full) = (Text::skeleton(chapter), Text::full(chapter));
    let files = skeleton.files.into_iter().zip(full.files);
    let files = files.flat_map(|((name, empty), (_, full))| [name, empty, full]);
    let steps = steps::of(chapter).iter().map(|step| step.says);
    let steps = steps.collect::<Vec<_>>().join("\n");
    let fields: Vec<String> = files.chain([steps]).collect();
    say(fields.join("\0").into_bytes())
}

/// Reads the text: 1 if it is a program.
#[unsafe(no_mangle)]
extern "C" fn read() -> usize {
    let text = text();
    let program = text.read();
    STATE.with_borrow_mut(|state| state.text = Some(text));
    match program {
        Ok(program) => {
            STATE.with_borrow_mut(|state| state.program = Some(program));
            1
        }
        Err(said) => tell(&said),
    }
}

/// Draws what was read: the height of the picture, or 0 if the program was stopped.
#[unsafe(no_mangle)]
extern "C" fn draw(width: u32) -> u32 {
    let drawn = STATE.with_borrow(|state| {
        let text = state.text.as_ref().expect("it was read");
        let program = state.program.as_ref().expect("it is a program");
        text.draw(program, width)
    });
    match drawn {
        Ok(picture) => {
            let height = picture.height();
            STATE.with_borrow_mut(|state| state.picture = Some(picture));
            height
        }
        Err(said) => {
            tell(&said);
            0
        }
    }
}

/// The picture, four bytes a pixel.
#[unsafe(no_mangle)]
extern "C" fn picture() -> usize {
    let opaque = |&[red, green, blue]: &[u8; 3]| [red, green, blue, u8::MAX];
    let rgba = STATE.with_borrow(|state| {
        let picture = state.picture.as_ref().expect("it was drawn");
        picture
            .rgb()
            .as_chunks()
            .0
            .iter()
            .flat_map(opaque)
            .collect()
    });
    say(rgba)
}

/// Judges what was drawn.
#[unsafe(no_mangle)]
extern "C" fn judge() -> usize {
    let (text, program, picture) = STATE.with_borrow_mut(|state| {
        (
            state.text.take(),
            state.program.take(),
            state.picture.take(),
        )
    });
    let (text, picture) = text.zip(picture).expect("it was drawn");
    // What judges keeps programs for good: the page begins with a new worker now and then.
    let program = Box::leak(Box::new(program.expect("it is a program")));
    tell(&Said::of(&text.verdict(program, &picture)));
    length()
}

/// What was said: places, a line to be announced, and the rest.
#[unsafe(no_mangle)]
extern "C" fn length() -> usize {
    STATE.with_borrow(|state| state.said.len())
}

/// The next line to type: its file, what it goes above, whether it takes that place, and the
/// line itself. Nothing if all is there.
#[unsafe(no_mangle)]
extern "C" fn next_line() -> usize {
    let next = next::next(&text());
    let next = next.map(|it| {
        let is_last = u8::from(it.is_last);
        format!("{}\t{}\t{is_last}\t{}", it.file, it.above, it.text)
    });
    say(next.unwrap_or_default().into_bytes())
}

/// The archive of the crate, with a number that no other has.
#[unsafe(no_mangle)]
extern "C" fn take_home(number: f64) -> usize {
    say(home::archive(&text(), number as u64))
}

/// Where the last answer is.
#[unsafe(no_mangle)]
extern "C" fn place() -> *const u8 {
    STATE.with_borrow(|state| state.said.as_ptr())
}

fn given() -> Vec<String> {
    let given = STATE.with_borrow_mut(|state| std::mem::take(&mut state.given));
    let fields = String::from_utf8_lossy(&given);
    fields.split('\0').map(str::to_owned).collect()
}

fn text() -> Text {
    let given = given();
    let (files, _) = given[1..].as_chunks();
    Text {
        chapter: Chapter::find(&given[0]).expect("a page names its chapter"),
        files: files
            .iter()
            .map(|[name, text]| (name.clone(), text.clone()))
            .collect(),
    }
}

fn tell(said: &Said) -> usize {
    let places = said
        .places
        .iter()
        .map(|place| place.map(|it| it.to_string()).join(" "));
    let places = places.collect::<Vec<_>>().join("\t");
    say(format!("{places}\n{}\n{}", said.headline, said.rest).into_bytes());
    0
}

fn say(said: Vec<u8>) -> usize {
    STATE.with_borrow_mut(|state| {
        state.said = said;
        state.said.len()
    })
}
