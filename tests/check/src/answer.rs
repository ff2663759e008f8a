//! The answer to a picture, part by part, in the words that terminal and page share.

use slips::{Chapter, Edition, Letters, Slip};

use crate::blind_spots::BlindSpots;
use crate::evidence::Known;
use crate::explanations::Seen;
use crate::frame::FRAMED;
use crate::map::map;
use crate::names_of;
use crate::reading::Cause;
use crate::scene::Scene;
use crate::told::{self, Row};
use crate::verdict::{Check, Finding, Near, Right};

/// One pixel in so many is a part.
const PART: usize = 8;
/// How many of many mistakes are told.
const AMONG: usize = 3;

/// A picture after it has been judged.
pub struct Judged<'a> {
    /// What it should show.
    pub scene: Scene,
    /// Whether nobody has said so.
    pub is_guessed: bool,
    /// What the picture is called.
    pub name: String,
    /// What keeps viewers from it.
    pub encoding: Option<Cause>,
    /// What is known besides the picture.
    pub known: Known<'a>,
    /// What was found.
    pub check: Check,
    /// What is still hidden, if the picture is right to the last bit.
    pub blind_spots: Option<BlindSpots>,
}

/// The first lines of an answer.
pub struct Headline {
    /// What comes before the verdict: the name of the picture, and what happened to it.
    pub before: String,
    /// The verdict.
    pub verdict: &'static str,
    /// Whether it says right.
    pub is_right: bool,
    /// What comes after it.
    pub after: String,
    /// Further lines.
    pub notes: Vec<String>,
}

/// What follows the headline, in the order in which it is read.
pub enum Part {
    /// What a right picture can't show.
    Hidden(Box<Hidden>),
    /// Where pixels differ.
    Where(Where),
    /// A sentence of its own.
    Sentence(String),
    /// What explains the picture.
    Title(String),
    /// The name of what explains it.
    Name(String),
    /// What there is to say of it.
    Rows(Vec<Row>),
    /// Where to read how it is right.
    Read(Vec<&'static Slip>),
}

/// The mistakes that a right picture can't show.
pub struct Hidden {
    /// What this is.
    pub intro: String,
    /// What shows them, and their names.
    pub groups: Vec<(String, String)>,
    /// What to change, and the command that judges the picture then.
    pub next: Option<Next>,
}

/// The next picture to draw.
pub struct Next {
    /// The scene that it shows.
    pub scene: Scene,
    /// What to change in a program.
    pub change: String,
}

/// Where two pictures differ.
pub struct Where {
    /// The columns and rows, and by how much.
    pub whereabouts: String,
    /// A line for each strip of the picture: the darker a letter, the more pixels differ.
    pub map: Vec<String>,
    /// The first pixel that differs.
    pub first: String,
}

impl<'a> Judged<'a> {
    /// Says of a right picture what it can't show. That of a probe follows the chapter's
    /// own, so it has to show only what is left.
    pub fn new(scene: Scene, name: String, known: Known<'a>, check: Check) -> Self {
        let blind_spots = match &check {
            Check::Right(Right {
                scene,
                width,
                levels: 0,
                ..
            }) => Some(BlindSpots::after(scene, *width)),
            _ => None,
        };
        Self {
            scene,
            is_guessed: false,
            name,
            encoding: None,
            known,
            check,
            blind_spots,
        }
    }

    /// Right, wrong, or why it is no picture; and what it was taken for.
    pub fn headline(&self) -> Headline {
        let mut headline = match self.unrecognized() {
            Some(seen) => Headline {
                before: format!("{} is ", self.subject()),
                verdict: "not recognized",
                is_right: false,
                after: format!(": {seen}. Later chapters are not known here."),
                notes: vec!["To compare it with one, name the chapter.".to_owned()],
            },
            None => self.recognized(),
        };
        headline.notes.extend(self.encoding.iter().flat_map(|it| {
            let besides = format!("Besides, {}.", it.problem);
            [besides, it.fix.clone()]
        }));
        headline
    }

    /// What was judged.
    fn subject(&self) -> String {
        let is_framed = self.encoding.as_ref().is_some_and(|it| it.name == FRAMED);
        let place = if is_framed { ", inside its frame," } else { "" };
        self.name.clone() + place
    }

    /// The verdict, and what the picture was taken for.
    fn recognized(&self) -> Headline {
        let mut headline = self.verdict();
        let is_no_picture = matches!(self.check, Check::NotAPicture { finding: None, .. });
        if self.is_guessed && !is_no_picture {
            let also = self.scene.with_the_other_formula();
            let also = also.map_or("", |other| match other.chapter {
                Chapter::Normals => " or normals",
                _ => " or half_b_sphere",
            });
            let taken = format!(
                "It was taken for {}{also}, because nobody named the chapter.",
                self.scene_name()
            );
            headline.notes.insert(0, taken);
        }
        headline
    }

    fn verdict(&self) -> Headline {
        let subject = self.subject();
        let is = |way: &str, verdict, is_right, after: String, notes| Headline {
            before: format!("{subject} is {way}"),
            verdict,
            is_right,
            after,
            notes,
        };
        match &self.check {
            Check::Right(right) => {
                let after = format!("{}: {}.", right.by(), self.how_right(right));
                let given_by = given_by(&right.shape_given_by).into_iter();
                let notes = given_by.chain(notes_on(&right.scene)).collect();
                is("", "right", true, after, notes)
            }
            Check::Near(finding) => {
                let by = Edition::said(&finding.editions);
                let after = format!("{by}, but {}.", finding.but());
                is("", "right", true, after, notes_on(&finding.scene))
            }
            Check::Wrong(finding) => {
                // What happened to the file comes first: what is wrong is so beyond it.
                let way = finding.degradation;
                let way = way.map(|way| format!("{}, and beyond that ", way.clause()));
                let verdict = match finding.levels {
                    0 | 1 => "right within one level, but not to the last bit",
                    _ if finding.is_blurred => "nearly right",
                    _ if finding.has_more() => "right but for something more",
                    _ => "wrong",
                };
                let after = format!(": {}.", self.counts(finding));
                let blurred = "Almost no pixel is off by more than a few levels, though many are by less: as in a file that was compressed or scaled, or where numbers were rounded on the way. Is it the one that the program wrote?";
                let blurred = finding.is_blurred.then(|| blurred.to_owned());
                let notes = blurred
                    .into_iter()
                    .chain(notes_on(&finding.scene))
                    .collect();
                is(&way.unwrap_or_default(), verdict, false, after, notes)
            }
            Check::Another { cause, .. } | Check::WrongShape { cause, .. } => {
                let after = format!(": {}.", cause.problem);
                is("", "wrong", false, after, vec![cause.fix.clone()])
            }
            Check::NotAPicture { cause, finding } => {
                let verdict = match finding {
                    None => "not a picture",
                    Some(_) => "not a valid picture",
                };
                let after = format!(": {}.", cause.problem);
                is("", verdict, false, after, vec![cause.fix.clone()])
            }
        }
    }

    /// What follows.
    pub fn parts(&self) -> Vec<Part> {
        let mut parts = Vec::new();
        if let Check::Right(right) = &self.check {
            parts.push(Part::Rows(told::suspected(&right.scene, &self.known)));
        }
        let hidden = self.blind_spots.as_ref();
        parts.extend(hidden.map(|it| Part::Hidden(Box::new(it.advice(&self.scene)))));
        if let Some(finding) = self
            .check
            .finding()
            .filter(|_| self.unrecognized().is_none())
        {
            let is_near = |finding: &Finding| {
                matches!(self.check, Check::Near(_))
                    && !finding.near.as_ref().is_some_and(Near::is_for_pixels)
            };
            if !is_near(finding) {
                parts.push(whereabouts(finding));
            }
            self.explain(finding, &mut parts);
        }
        let shown = self.check.shown().iter();
        parts.push(Part::Rows(shown.map(|it| ("seen", it.clone())).collect()));
        parts
    }

    /// What is seen, where nobody has said what it is and too little in it tells.
    fn unrecognized(&self) -> Option<String> {
        // Levels that are none are told first.
        if !self.is_guessed || matches!(self.check, Check::NotAPicture { .. }) {
            return None;
        }
        if let Check::WrongShape { finding: None, .. } = self.check {
            return Some("it has the shape of none of these chapters' pictures".to_owned());
        }
        let finding = self.check.finding()?;
        let mut colors = finding.yours.rgb().chunks_exact(3);
        let first = colors.next()?;
        if colors.all(|color| color == first) {
            let sets = finding.sets.iter().flat_map(|set| &set.mistakes);
            let names: Vec<String> = sets.take(AMONG).map(|it| names_of(it)).collect();
            // One by itself would be taken for the one.
            let among = match names.len() {
                0 | 1 => String::new(),
                _ => format!(", among them {}", names.join(", ")),
            };
            let is_unscaled = first != [0; 3] && first.iter().all(|level| *level < 2);
            let scale = match is_unscaled {
                true => ", or levels that were not multiplied by 255.999",
                false => "",
            };
            return Some(format!(
                "it has one color everywhere, {first:?}, and many mistakes draw that{among}{scale}"
            ));
        }
        let finding = Some(finding).filter(|it| it.sets.is_empty())?;
        let scene = self.scene_name();
        if let Some(shaded @ Seen::Shaded { .. }) = &finding.sight {
            let gamma = shaded.gamma();
            return Some(format!(
                "it has the sky{gamma} and the outlines of {scene}, but other colors of all that is hit, by a material or a mistake that is not known"
            ));
        }
        // What is off by a level is no other picture.
        if finding.levels <= 1 && matches!(self.check, Check::Wrong(_)) {
            return None;
        }
        let difference = finding.difference.as_ref()?;
        let (wrong, total) = (difference.count, difference.total);
        let right = total - wrong;
        match finding.is_known {
            _ if finding.is_blurred && matches!(self.check, Check::Wrong(_)) => None,
            false if finding.is_strange || PART * right < total => Some(
                "it is not found among the pictures of these chapters, right or with mistakes"
                    .to_owned(),
            ),
            false if right < wrong => Some(format!(
                "{right} of {total} pixels are those of {scene}, but no mistake that is known draws the others"
            )),
            _ => None,
        }
    }

    fn scene_name(&self) -> String {
        let chapter = self.scene.chapter.name();
        match self.scene.probe {
            None => chapter.to_owned(),
            Some(probe) => format!("{chapter} with the probe {}", probe.name),
        }
    }

    fn how_right(&self, right: &Right) -> String {
        let name = self.scene_name();
        let all = u64::from(right.width) * u64::from(right.height);
        let (width, height, off) = (right.width, right.height, right.off);
        match right.levels {
            0 => format!("all {all} pixels of {name} at {width} × {height}, to the last bit"),
            levels => format!(
                "{off} of {all} pixels of {name} are off, by no more than {levels}, which is tolerated"
            ),
        }
    }

    fn counts(&self, finding: &Finding) -> String {
        let name = self.scene_name();
        let (width, height) = (finding.right.width(), finding.right.height());
        let Some(difference) = &finding.difference else {
            return format!("no pixel differs from {name} at {width} × {height}");
        };
        let (count, total) = (difference.count, difference.total);
        let share = 100.0 * count as f64 / total as f64;
        let chosen = finding.scene.clause();
        let chosen = chosen.map_or(String::new(), |chosen| format!(", {chosen}"));
        format!(
            "{count} of {total} pixels ({share:.1} %) are not those of {name} at {width} × {height}{}{chosen}",
            Edition::said(&finding.editions)
        )
    }

    fn explain(&self, finding: &Finding, parts: &mut Vec<Part>) {
        let pixels = finding.right.rgb().len() / 3;
        let is_unknown = finding.near.is_none() && finding.sets.is_empty() && !finding.has_more();
        if let Some(set) = finding.sets.first() {
            parts.push(Part::Title(set.title(pixels)));
            if let [mistake] = &set.mistakes[..] {
                parts.push(Part::Name(names_of(mistake)));
            }
        } else if finding.difference.is_some() && is_unknown {
            let unknown = "No mistake in the catalogue draws this picture.";
            parts.push(Part::Title(unknown.to_owned()));
        }
        parts.push(Part::Rows(finding.rows(&self.known)));
        let single = finding.single().iter();
        let has_a_page = |slip: &&&'static Slip| !slip.page.is_empty();
        parts.push(Part::Read(single.filter(has_a_page).copied().collect()));
        let command = |probe| self.scene.probed_command(probe);
        let next = finding.how_to_tell(command).map(|next| ("next", next));
        let others = finding.others.iter().map(|other| {
            let told = format!("it is the picture of a probe: {}", other.command());
            ("also", told)
        });
        parts.push(Part::Rows(next.into_iter().chain(others).collect()));
    }
}

impl Finding {
    /// Whether all of the scene is there, and something more.
    fn has_more(&self) -> bool {
        matches!(self.sight, Some(Seen::More(_)))
    }

    /// The slips that draw it together, if nothing else does.
    pub(crate) fn single(&self) -> &[&'static Slip] {
        match &self.sets[..] {
            [set] if set.mistakes.len() == 1 => &set.mistakes[0],
            _ => &[],
        }
    }
}

/// What may have given a picture its shape, if nobody chose it.
fn given_by(slips: &[&Slip]) -> Option<String> {
    let said = |slip: &&Slip| {
        let words = slip.words(Letters::Book(Edition::V4), slip.chapters[0]);
        format!("{} ({})", slip.name, words.wrong)
    };
    let said: Vec<String> = slips.iter().map(said).collect();
    let said = said.join(", or ");
    (!slips.is_empty()).then(|| format!("If you did not choose this shape, look for {said}."))
}

/// What the edition of a scene has otherwise than the one that this workspace follows.
fn notes_on(scene: &Scene) -> Vec<String> {
    let [with_rays, build_test] = scene.edition.differs_by();
    let differs = match scene.chapter {
        Chapter::BuildTest => build_test,
        _ => with_rays,
    };
    match scene.edition {
        Edition::V4 => Vec::new(),
        _ => vec![
            format!(
                "What it has otherwise than version 4, which this workspace follows: {differs}."
            ),
            "To be judged by version 4 alone: --edition 4.".to_owned(),
        ],
    }
}

fn whereabouts(finding: &Finding) -> Part {
    let Some(difference) = &finding.difference else {
        let said = "But for that, it is the right picture in this size.";
        return Part::Sentence(said.to_owned());
    };
    let (columns, rows, first) = (difference.columns, difference.rows, difference.first);
    Part::Where(Where {
        whereabouts: format!(
            "columns {} to {}, rows {} to {}; no component is off by more than {}",
            columns.0, columns.1, rows.0, rows.1, finding.levels
        ),
        map: map(&finding.right, &finding.yours),
        first: format!(
            "column {}, row {}: expected {:?}, got {:?}",
            first.0, first.1, difference.expected, difference.actual
        ),
    })
}
