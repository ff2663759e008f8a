//! The answer to a picture, part by part: what the command and the page lay out.

use slips::{Chapter, Edition, Slip};

use crate::Row;
use crate::blind_spots::{self, Next};
use crate::causes;
use crate::known::Known;
use crate::reading::Cause;
use crate::scene::Scene;
use crate::verdict::{Check, Finding, Right};
use crate::words::names_of;

/// A picture after it has been judged.
pub struct Judged<'a> {
    /// What it should show.
    pub scene: Scene,
    /// Whether that was guessed from the picture.
    pub is_guessed: bool,
    /// What the picture is called.
    pub name: String,
    /// What keeps viewers from it.
    pub encoding: Option<Cause>,
    /// What is known besides the picture.
    pub known: Known<'a>,
    /// What was found.
    pub check: Check,
}

/// The first lines of an answer.
pub struct Headline {
    /// What comes before the verdict: the name of the picture.
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
    /// What explains the picture.
    Title(String),
    /// The name of what explains it.
    Name(String),
    /// What there is to say of it.
    Rows(Vec<Row>),
    /// Where to read how it is right.
    Read(&'static Slip),
    /// The next picture to draw.
    Next(Box<Next>),
}

impl Judged<'_> {
    /// Right, wrong, or why it is no picture; and what it was taken for.
    pub fn headline(&self) -> Headline {
        let mut headline = match self.unrecognized() {
            Some(seen) => Headline {
                before: format!("{} is ", self.name),
                verdict: "not recognized",
                is_right: false,
                after: format!(": {seen}."),
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
            let taken = format!("It was taken for {}{also}.", self.scene_name());
            headline.notes.insert(0, taken);
        }
        headline
    }

    fn verdict(&self) -> Headline {
        let is = |verdict, is_right, after: String, notes| Headline {
            before: format!("{} is ", self.name),
            verdict,
            is_right,
            after,
            notes,
        };
        let notes = |scene: &Scene, shape: &[&Slip]| {
            let given_by = self.known.shape_given_by(scene, shape);
            given_by.into_iter().chain(notes_on(scene)).collect()
        };
        match &self.check {
            Check::Right(right) => {
                let after = format!("{}: {}.", right.by(), self.how_right(right));
                let notes = notes(&right.scene, &right.shape_given_by);
                is("right", true, after, notes)
            }
            Check::Near(finding) => {
                let by = Edition::said(&finding.editions);
                let after = format!("{by}, but {}.", finding.but());
                let (width, height) = (finding.yours.width(), finding.yours.height());
                let shape = causes::slips_giving(&self.scene, width, height);
                is("right", true, after, notes(&finding.scene, &shape))
            }
            Check::Wrong(finding) => {
                let verdict = if finding.levels() <= 1 {
                    "right within one level, but not to the last bit"
                } else {
                    "wrong"
                };
                let after = format!(": {}.", self.counts(finding));
                is(verdict, false, after, notes_on(&finding.scene))
            }
            Check::Another { cause, .. }
            | Check::WrongShape { cause, .. }
            | Check::NotAPicture { cause, .. } => {
                let verdict = match &self.check {
                    Check::NotAPicture { finding: None, .. } => "not a picture",
                    Check::NotAPicture { .. } => "not a valid picture",
                    _ => "wrong",
                };
                let after = format!(": {}.", cause.problem);
                is(verdict, false, after, vec![cause.fix.clone()])
            }
        }
    }

    /// What follows.
    pub fn parts(&self) -> Vec<Part> {
        if let Check::Right(right) = &self.check {
            return self.next_probe(right).into_iter().collect();
        }
        let finding = self.check.finding();
        match finding.filter(|_| self.unrecognized().is_none()) {
            Some(finding) => self.explained(finding),
            None => Vec::new(),
        }
    }

    /// Of a right picture, the one to draw next, in which mistakes would show that this one
    /// hides.
    fn next_probe(&self, right: &Right) -> Option<Part> {
        if right.levels > 0 {
            return None;
        }
        let next = blind_spots::next(&right.scene, right.width, |_| true);
        next.map(|next| Part::Next(Box::new(next)))
    }

    fn explained(&self, finding: &Finding) -> Vec<Part> {
        let pixels = finding.right.rgb().len() / 3;
        let mut parts = Vec::new();
        if finding.repair.is_some() {
            // The lines say it.
        } else if let Some(mistakes) = &finding.mistakes {
            parts.push(Part::Title(mistakes.title(pixels)));
            let single = finding.single();
            if single.iter().any(|slip| !slip.name.is_empty()) {
                parts.push(Part::Name(names_of(single)));
            }
        } else if finding.near.is_none() && finding.difference.is_some() {
            parts.extend(whereabouts(finding));
            if let Some(title) = finding.drawn.title() {
                parts.push(Part::Title(title.to_owned()));
            } else if finding.sights.len() != 1 {
                let unknown = match self.scene.probe {
                    None if self.known.sources.files().is_empty() => {
                        "No mistake in the catalogue draws this picture.".to_owned()
                    }
                    None => "No mistake in the catalogue explains this picture and your files."
                        .to_owned(),
                    Some(_) => format!(
                        "No known mistake draws this picture and the chapter's own right. Is that right? {}",
                        self.scene.without_probe().command()
                    ),
                };
                parts.push(Part::Title(unknown));
            }
        }
        parts.push(Part::Rows(finding.rows(&self.known)));
        let single = finding.single().iter();
        let with_a_page = single.filter(|slip| !slip.page.is_empty());
        parts.extend(with_a_page.map(|slip| Part::Read(slip)));
        let next = finding.next(self.known.letters, |probe| self.scene.probed_command(probe));
        parts.extend(next.map(|next| Part::Rows(vec![("next", next)])));
        parts
    }

    /// What is seen, where the chapter was guessed and the picture says too little of it.
    fn unrecognized(&self) -> Option<String> {
        // Levels that are none are said first.
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
            return Some(format!(
                "it has one color everywhere, {first:?}, and many mistakes draw that"
            ));
        }
        let difference = finding.difference.as_ref()?;
        let is_explained = finding.near.is_some() || finding.mistakes.is_some();
        let is_unlike = !is_explained && 2 * difference.count > difference.total;
        (is_unlike && finding.levels() > 1).then(|| {
            "it is not found among the pictures of these chapters, right or with a mistake"
                .to_owned()
        })
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
            0 if all == 1 => format!("the one pixel of {name}, to the last bit"),
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
        format!(
            "{count} of {total} pixels ({share:.1} %) are not those of {name} at {width} × {height}{}",
            Edition::said(&finding.editions)
        )
    }
}

impl Finding {
    /// What it is instead of the book's picture, after "right, but".
    pub fn but(&self) -> String {
        let pixels = self.right.rgb().len() / 3;
        let near = self.near.as_ref();
        near.map_or(String::new(), |near| near.clause(pixels))
    }
}

impl Right {
    /// After "right": by which editions, and whose its shape is if not theirs.
    pub(crate) fn by(&self) -> String {
        let by = Edition::said(&self.editions);
        let shape = if !self.scene.has_another_shape() {
            ""
        } else if self.scene.is_in_a_later_shape(self.width, self.height) {
            " in the shape of later ones"
        } else {
            " in this shape, which is not the book's"
        };
        format!("{by}{shape}")
    }
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
                "It is compared with {}. That has otherwise than version 4, which this workspace follows: {differs}.",
                scene.edition
            ),
            "To be judged by version 4 alone: --edition 4.".to_owned(),
        ],
    }
}

/// The box of what differs, if that is not the whole picture.
fn whereabouts(finding: &Finding) -> Option<Part> {
    let difference = finding.difference.as_ref()?;
    let (columns, rows) = (difference.columns, difference.rows);
    let last = (finding.right.width() - 1, finding.right.height() - 1);
    if (columns, rows) == ((0, last.0), (0, last.1)) {
        return None;
    }
    let said = format!(
        "columns {} to {}, rows {} to {}",
        columns.0, columns.1, rows.0, rows.1
    );
    Some(Part::Rows(vec![("where", said)]))
}
