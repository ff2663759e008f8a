//! The verdict on a picture: right, wrong, or no picture, with what explains it.

use std::cmp::Reverse;

use common::rtweekend::Picture;
use slips::{Chapter, Edition, Letters, Slip};

use crate::bits::Left;
use crate::comparison::{Comparison, Difference};
use crate::evidence::{Evidence, Known};
use crate::explanations::{But, Conversion, Curve, Degradation, Explanation, Seen};
use crate::judge::{Judgement, is_own, is_same, shortest};
use crate::names_of;
use crate::reading::{self, Cause, Reading};
use crate::scene::Scene;
use crate::sources::is_same_line;
use crate::telling::{self, Telling};
use crate::told::TOLD;
use crate::{causes, seen, surfaces};

/// What there is to say about a picture.
#[derive(Debug)]
pub enum Check {
    /// It is right.
    Right(Right),
    /// It is right but for something that is no mistake.
    Near(Finding),
    /// It is a picture, and not the right one.
    Wrong(Finding),
    /// It is right, but of another scene: a change was forgotten, or is still there, or
    /// it is another chapter's.
    Another {
        /// Which one it is, and how to go on.
        cause: Cause,
        /// The scenes that it shows: several if their right pictures are the same.
        scenes: Vec<Scene>,
    },
    /// It is a picture of another shape than the scene's.
    WrongShape {
        /// The shape that it should have, and what gives this one.
        cause: Cause,
        /// What its pixels tell, unless there are more than [`MOST_MISSHAPEN`].
        finding: Option<Box<Finding>>,
        /// What it shows by itself, if there are.
        shown: Vec<String>,
    },
    /// It is no picture, or not a valid one.
    NotAPicture {
        /// Why.
        cause: Cause,
        /// What its pixels tell, if there are any.
        finding: Option<Box<Finding>>,
    },
}

/// A right picture.
#[derive(Clone, Debug)]
pub struct Right {
    /// The scene, by the latest edition of the book that draws this picture.
    pub scene: Scene,
    /// All editions that do.
    pub editions: Vec<Edition>,
    /// Pixels in a row.
    pub width: u32,
    /// Number of rows.
    pub height: u32,
    /// How many pixels are off at all; 0 means equal to the last bit.
    pub off: usize,
    /// The farthest that a component is off, in levels; no more than was
    /// tolerated.
    pub levels: u8,
    /// Slips that give it its shape, if that is not the chapter's: it may have been a
    /// choice, or one of these.
    pub shape_given_by: Vec<&'static Slip>,
}

/// What explains a picture that is not right to the last bit.
#[derive(Debug)]
pub struct Finding {
    /// The scene that it shows, by the edition that explains most.
    pub scene: Scene,
    /// All editions that explain as much.
    pub editions: Vec<Edition>,
    /// The right picture of that scene in the same size.
    pub right: Picture,
    /// The reader's, as a viewer shows it.
    pub yours: Picture,
    /// What happened to yours between the program and the file; to the right one too then.
    pub degradation: Option<Degradation>,
    /// Where the two differ; `None` if only the shape is wrong, or only numbers
    /// that are no levels.
    pub difference: Option<Difference>,
    /// The farthest that a component is off, in levels.
    pub levels: u8,
    /// What it is if it is right but for something that is no mistake.
    pub near: Option<Near>,
    /// Mistakes that explain it, best first.
    pub sets: Vec<Set>,
    /// What can be seen, where nothing known explains it.
    pub sights: Vec<String>,
    /// What the picture shows by itself, where nothing known draws it.
    pub shown: Vec<String>,
    /// Whether something explains it.
    pub is_known: bool,
    /// Whether nothing explains it, and it has nothing of the scene's picture.
    pub is_strange: bool,
    /// What is seen, where that explains it and no line of a program is known that does it.
    pub sight: Option<Seen>,
    /// Whether nothing explains it, and it is off by little everywhere.
    pub is_blurred: bool,
    /// Whether the few lines that are not as the chapter has them explain it.
    pub is_typed: bool,
    /// Whether it explains all answers of the reader's functions, too.
    pub is_answered: bool,
    /// By how many bits that is shorter than any other explanation: with 10 it is a
    /// thousand times as likely.
    pub lead: f64,
    /// Probes of which it is the right picture, as wide as it has to be, though one
    /// mistake draws it as well.
    pub others: Vec<Scene>,
}

/// A picture that is right, but for something that is no mistake.
#[derive(Clone, Debug)]
pub struct Near {
    /// The scene, with what the reader chose.
    pub scene: Scene,
    /// What else is not the book's.
    pub but: Vec<But>,
    /// The pixels that are not explained.
    pub left: Left,
}

/// Mistakes that draw the same picture.
#[derive(Clone, Debug)]
pub struct Set {
    /// The scene that they were made in.
    pub scene: Scene,
    /// One slip each, or two that were made together; those that more people
    /// reported come first.
    pub mistakes: Vec<Vec<&'static Slip>>,
    /// What becomes of numbers that are no levels.
    pub conversion: Conversion,
    /// What the picture has besides, and what is no mistake.
    pub but: Vec<But>,
    /// The pixels that they leave unexplained.
    pub left: Left,
    /// Their length in bits.
    pub bits: f64,
    /// A small change of scene that tells them apart, if there is one.
    pub telling: Option<Telling>,
}

/// Explanations that are no more than three bits longer are told together: they are one
/// in eight as likely.
pub(crate) const TOGETHER: f64 = 3.0;

/// Compares the picture in `bytes` with the scene's, by each edition of the book that
/// will do, and accepts components that are at most `tolerance` levels off.
pub fn check(scene: &Scene, bytes: &[u8], tolerance: u8) -> Check {
    check_knowing(scene, bytes, tolerance, &Known::default())
}

/// The same where more is known than the picture.
pub fn check_knowing(scene: &Scene, bytes: &[u8], tolerance: u8, known: &Known) -> Check {
    match reading::read(bytes) {
        Ok(reading) => judge(scene, &reading, tolerance, known),
        Err(cause) => Check::NotAPicture {
            cause,
            finding: None,
        },
    }
}

/// The most pixels of a picture of a wrong shape that are looked at. Its shape tells
/// more than its pixels do, and to draw the right one in a shape that nobody wants may
/// take long.
pub const MOST_MISSHAPEN: u64 = 1 << 20;

/// The same of a picture that was read.
pub fn judge(scene: &Scene, reading: &Reading, tolerance: u8, known: &Known) -> Check {
    let (width, height) = (reading.width, reading.height);
    let another_width = causes::not_as_wide(scene, reading);
    let may_be_right = another_width.is_none();
    let shape = another_width.or_else(|| causes::wrong_shape(scene, width, height));
    if let Some(cause) = causes::no_levels(reading) {
        let finding = match Finding::of(scene, reading, known) {
            Answer::Of(finding) => finding,
            Answer::Another(_) => {
                return Check::NotAPicture {
                    cause,
                    finding: None,
                };
            }
        };
        return Check::NotAPicture {
            cause,
            finding: Some(finding),
        };
    }
    if may_be_right
        && let Some(right) = Right::of(scene, reading, tolerance)
        && (shape.is_none() || causes::is_a_shape_to_choose(width, height))
    {
        let is_answered = known.is_answered_by(&right.scene.program(&[]));
        if !is_answered
            && let Answer::Of(finding) = Finding::of(scene, reading, known)
            && !finding.sets.is_empty()
        {
            return Check::Wrong(*finding);
        }
        let shape_given_by = match shape {
            Some(_) => causes::slips_giving(scene, width, height),
            None => Vec::new(),
        };
        return Check::Right(Right {
            shape_given_by,
            ..right
        });
    }
    let size = u64::from(width) * u64::from(height);
    let has_own_shape = scene.without_probe().height(width) == height;
    match shape {
        Some(cause) if size > MOST_MISSHAPEN && !has_own_shape => Check::WrongShape {
            cause,
            finding: None,
            shown: surfaces::said(reading),
        },
        shape => match (Finding::of(scene, reading, known), shape) {
            (Answer::Another(scenes), _) => Check::Another {
                cause: causes::another(scene, &scenes),
                scenes,
            },
            (Answer::Of(finding), _) if finding.near.is_some() => Check::Near(*finding),
            (Answer::Of(finding), Some(cause)) if !finding.tells_of_the_shape() => {
                Check::WrongShape {
                    cause,
                    finding: Some(finding),
                    shown: Vec::new(),
                }
            }
            (Answer::Of(finding), _) => Check::Wrong(*finding),
        },
    }
}

/// The same where the scene was guessed: as another one, if it is a picture of that. Returns
/// also which it is.
pub fn judge_guessed(
    scene: &Scene,
    reading: &Reading,
    tolerance: u8,
    known: &Known,
) -> (Scene, Check) {
    let guessed = scene.guessed();
    let check = judge(&guessed, reading, tolerance, known);
    let other = check
        .others()
        .first()
        .filter(|_| matches!(check, Check::Another { .. }));
    let other = other.map(|it| {
        let chapter = guessed.of_chapter(it.chapter);
        let probed = it.probe.and_then(|probe| chapter.with_probe(probe));
        probed.unwrap_or(chapter)
    });
    match other {
        Some(other) => (other, judge(&other, reading, tolerance, known)),
        None => (guessed, check),
    }
}

/// What the shortest explanation says.
enum Answer {
    /// It is a picture of these scenes.
    Another(Vec<Scene>),
    /// It is a picture of the scene, or of nothing that is known.
    Of(Box<Finding>),
}

impl Finding {
    /// What the shortest explanation of the picture says.
    fn of(scene: &Scene, reading: &Reading, known: &Known) -> Answer {
        let evidence = Evidence::new(scene, reading, known);
        let judgement = shortest(&evidence);
        let best = &judgement.found[0];
        let is_right = best.slips.is_empty() && best.seen.is_none();
        let is_typed = evidence.typed().is_some_and(|typed| match is_right {
            true => typed < best.bits(),
            false => typed + TOGETHER < best.bits(),
        });
        // Where levels were lost, one level names no mistake.
        let is_lossy = best.degradation().is_some_and(Degradation::is_lossy);
        let nearest = judgement.nearest(&evidence, is_typed);
        let is_near = nearest.left.far == 0 && nearest.but.is_empty();
        let is_a_rounding = is_lossy && !is_right && is_near;
        // A table of differences may be short, but who is far off in every pixel has drawn none.
        let is_somewhere = best.left.far < reading.pixels.len();
        let is_rounded = is_right && best.left.is_rounding(reading.pixels.len());
        let is_shorter = best.bits() < judgement.unknown || is_rounded;
        let is_known = is_shorter && !is_typed && !is_a_rounding && is_somewhere;
        if is_known && is_right && !is_same(&best.scene, scene) {
            return Answer::Another(judgement.scenes_like(best));
        }
        let explaining = match is_known {
            true => best,
            false => nearest,
        };
        // A slip, or what is seen, is told beside what the reader chose, which is no mistake.
        let compared = match explaining.slips.is_empty() && explaining.seen.is_none() {
            true => explaining.scene.without_choices(),
            false => explaining.scene,
        };
        let degradation = explaining.degradation();
        let right = match degradation {
            Some(degradation) => degradation.of_picture(&compared, reading),
            None => compared.right(reading.width, reading.height),
        };
        let yours = reading.picture();
        let difference = match Comparison::of(&right, &yours) {
            Comparison::Pixels(difference) => Some(difference),
            _ => None,
        };
        // Noise at edges tells no slip from what is right.
        let is_noisy = is_right && (is_lossy || !best.left.is_one_by_one);
        let sets = match is_known && !is_noisy {
            true => sets(&judgement),
            false => Vec::new(),
        };
        let told: usize = sets.iter().map(|set| set.mistakes.len()).sum();
        let says_little = is_known && judgement.says_little();
        let is_vague = best.slips.len() > 1 || told > TOLD || says_little;
        let curve = best.but.iter().find_map(|it| match it {
            But::Curve(curve) => Some(curve),
            _ => None,
        });
        let sights = match (is_known, &best.seen) {
            (true, Some(seen @ Seen::Little)) => {
                let mut sights = seen::sights(&compared, reading).into_iter();
                let (first, last) = (sights.next(), sights.next_back());
                first.into_iter().chain([seen.said()]).chain(last).collect()
            }
            (true, Some(seen)) => {
                let curve = curve.map(Curve::said);
                [seen.said()].into_iter().chain(curve).collect()
            }
            (true, None) if !is_vague => Vec::new(),
            (false, _) if is_typed => Vec::new(),
            (_, _) => seen::sights(&compared, reading),
        };
        // Whoever is off by more than a level in most pixels is not right, unless that is noise or a
        // loss; levels of a palette are seldom far from its nearest color.
        let is_of_few = |but: &But| matches!(but, But::Degraded(Degradation::Palette { .. }));
        let is_excused = best.left.is_noise(reading.pixels.len()) || is_lossy;
        let most = match is_excused {
            _ if best.but.iter().any(is_of_few) => reading.pixels.len() / 5,
            // Away from edges a mean is exact.
            _ if best.but.iter().any(But::is_mean) => reading.pixels.len() / 10,
            true => reading.pixels.len(),
            false => reading.pixels.len() / 2,
        };
        let is_far = best.left.far > most;
        let is_near = is_known && is_right && !is_far;
        // What is seen through a viewport of the reader's own, or on a curve, is told beside that.
        let is_through_another =
            compared.chosen.viewport_height.is_some() || is_known && curve.is_some();
        let is_told = !sets.is_empty() || is_through_another;
        let sights = sights
            .into_iter()
            .chain(judgement.chosen_instead())
            .collect();
        // A part that is not explained may be a thing of its own.
        let has_a_part = best.left.part.is_some_and(|part| part.off >= MANY);
        let shown = match reading.is_plain() || !is_told && (!is_near || has_a_part) {
            true => surfaces::said(reading),
            false => Vec::new(),
        };
        let others = judgement.scenes_like(best).into_iter();
        let is_a_probe = |it: &Scene| {
            let is_as_wide = it.probe.is_some_and(|probe| probe.width == reading.width);
            is_as_wide && !is_same(it, scene)
        };
        Answer::Of(Box::new(Self {
            scene: compared,
            editions: judgement.editions_like(explaining),
            right,
            yours,
            degradation,
            levels: difference
                .as_ref()
                .map_or(0, |difference| difference.levels),
            difference,
            near: is_near.then(|| Near {
                scene: best.scene,
                but: best.but.clone(),
                left: best.left,
            }),
            sets,
            sights,
            shown,
            is_blurred: !is_known && !is_typed && seen::is_blurred(&compared, reading),
            sight: best.seen.clone().filter(|_| is_known),
            is_known,
            is_strange: !is_known && !is_typed && judgement.is_strange,
            is_typed,
            is_answered: known.is_answered_by(&best.scene.unchanged().program(&best.slips)),
            lead: judgement.lead(),
            others: others.filter(is_a_probe).collect(),
        }))
    }
}

impl Finding {
    /// What it is instead of the book's picture, after "right, but".
    pub fn but(&self) -> String {
        let pixels = self.right.rgb().len() / 3;
        let near = self.near.as_ref();
        near.map_or(String::new(), |near| near.clause(pixels))
    }

    /// What can be seen beside the scene, and in the picture by itself.
    pub fn seen(&self) -> impl Iterator<Item = &String> {
        self.sights.iter().chain(&self.shown)
    }

    /// Whether it says what gave the picture another shape than the book's, or who chose it.
    fn tells_of_the_shape(&self) -> bool {
        let is_chosen = self.scene.has_another_shape() && !self.sets.is_empty();
        self.degradation.is_some() || is_chosen
    }

    /// Whether one mistake alone draws the picture, to the last bit.
    pub fn is_certain(&self) -> bool {
        let draws_it = |set: &Set| set.is_exact() && set.mistakes[0].len() == 1;
        self.sets.first().is_some_and(draws_it)
    }
}

impl Judgement {
    /// The scene itself, by the edition or step that leaves least; or as a whole. What
    /// happened to a file is not known where nothing explains its picture, nor is the
    /// edition where the picture has nothing of any.
    fn nearest(&self, evidence: &Evidence, is_whole: bool) -> &Explanation {
        let scene = &evidence.scene;
        let is_plain = |it: &&Explanation| {
            let is_itself = it.slips.is_empty() && it.seen.is_none();
            let is_known = it.scene.edition == scene.edition || it.is_like(evidence.reading);
            is_itself && is_known && it.degradation().is_none() && is_same(&it.scene, scene)
        };
        let mut plain = self.found.iter().filter(is_plain).peekable();
        let first = plain.peek().copied();
        let whole = plain.find(|it| is_whole && it.scene.step().is_none());
        whole.or(first).expect("the scene itself was measured")
    }

    /// What a right program draws the same with, in a sentence, where a mistake does; or one with
    /// a mistake where two do.
    fn chosen_instead(&self) -> Option<String> {
        let best = &self.found[0];
        let is_less = |it: &&Explanation| {
            let is_another = it.mark == best.mark && it.slips.len() < best.slips.len();
            is_another && it.seen.is_none() && is_own(it)
        };
        let less = self.found.iter().filter(is_less);
        let less = less.min_by_key(|it| it.slips.len())?;
        let clause = less.scene.clause()?;
        let by = match &less.slips[..] {
            [] => "A right program".to_owned(),
            slips => format!("A program with {} alone", names_of(slips)),
        };
        Some(format!("{by} draws the same {clause}."))
    }

    /// Whether it is a picture that many mistakes draw, as far as anybody can tell.
    fn says_little(&self) -> bool {
        let shortest = self.found[0].bits();
        let alike = self.found.iter();
        let mut alike = alike.take_while(|it| it.bits() <= shortest + TOGETHER);
        alike.any(|it| it.seen == Some(Seen::Little))
    }

    /// Scenes of the same chapter whose right picture it is as well.
    fn scenes_like(&self, best: &Explanation) -> Vec<Scene> {
        let mut scenes: Vec<Scene> = Vec::new();
        for it in &self.found {
            let is_like = it.mark == best.mark
                && it.slips.is_empty()
                && it.scene.chapter == best.scene.chapter;
            if is_like && !scenes.iter().any(|scene| is_same(scene, &it.scene)) {
                scenes.push(it.scene);
            }
        }
        scenes
    }

    /// The editions in which the same explanation draws the same picture.
    fn editions_like(&self, explaining: &Explanation) -> Vec<Edition> {
        let is_like = |it: &&Explanation| {
            it.mark == explaining.mark
                && is_same(&it.scene, &explaining.scene)
                && are_alike(&it.slips, &explaining.slips, it.scene.chapter)
        };
        let like = self.found.iter().filter(is_like);
        let mut editions: Vec<Edition> = like.map(|it| it.scene.edition).collect();
        // The mean of several rays doesn't show in which precision they were.
        if explaining.but.iter().any(But::is_mean) && editions.contains(&Edition::V1InDouble) {
            editions.push(Edition::V1);
        }
        editions
    }

    /// How many bits the shortest is shorter than any that tells another picture. None if
    /// the first is only the simplest of some that are alike.
    fn lead(&self) -> f64 {
        let best = &self.found[0];
        let mut others = self.found.iter().filter(|it| it.mark != best.mark);
        let other = others.next().map_or(f64::INFINITY, Explanation::bits);
        match best.bits() < self.unknown {
            true => (other.min(self.unknown) - best.bits()).max(0.0),
            false => best.bits() - self.unknown,
        }
    }
}

/// Pixels that are more than odd ones.
const MANY: usize = 50;

/// The sets of slips that are told.
fn sets(judgement: &Judgement) -> Vec<Set> {
    let shortest = judgement.found[0].bits();
    let told = judgement.found.iter();
    let told = told.take_while(|it| it.bits() <= shortest + TOGETHER);
    let mut sets: Vec<(u64, Set)> = Vec::new();
    for it in told.filter(|it| !it.slips.is_empty()) {
        match sets.iter_mut().find(|(mark, _)| *mark == it.mark) {
            // A slip is another line in another edition.
            Some((_, set)) if set.scene.edition != it.scene.edition => {}
            Some((_, set)) => {
                let chapter = set.scene.chapter;
                let mut known = set.mistakes.iter_mut();
                match known.find(|other| are_alike(other, &it.slips, chapter)) {
                    // Of two that are the same, one has a name and a reason.
                    Some(known) if it.slips.iter().all(|slip| !slip.name.is_empty()) => {
                        known.clone_from(&it.slips);
                    }
                    Some(_) => {}
                    None => set.mistakes.push(it.slips.clone()),
                }
            }
            None => sets.push((
                it.mark,
                Set {
                    scene: it.scene,
                    mistakes: vec![it.slips.clone()],
                    conversion: it.conversion,
                    but: it.but.clone(),
                    left: it.left,
                    bits: it.bits(),
                    telling: None,
                },
            )),
        }
    }
    let mut sets: Vec<Set> = sets.into_iter().map(|(_, set)| set).collect();
    for set in &mut sets {
        let reports = |mistake: &Vec<&Slip>| mistake.iter().map(|slip| slip.reports()).sum();
        set.mistakes
            .sort_by_key(|mistake| Reverse::<usize>(reports(mistake)));
        set.telling = telling::apart(&set.scene, &set.mistakes);
    }
    sets
}

/// Whether they are the same mistakes, or changes of the same line of the chapter.
fn are_alike(one: &[&'static Slip], other: &[&'static Slip], chapter: Chapter) -> bool {
    let line = |slip: &Slip| slip.words(Letters::Rust, chapter).right;
    let are_alike = |(one, other): (&&Slip, &&Slip)| {
        let are_named = !one.name.is_empty() && !other.name.is_empty();
        std::ptr::eq(*one, *other) || !are_named && is_same_line(&line(one), &line(other))
    };
    one.len() == other.len() && one.iter().zip(other).all(are_alike)
}

impl Set {
    /// Whether every pixel is explained to the last bit.
    pub fn is_exact(&self) -> bool {
        self.left.is_nothing() && self.but.is_empty()
    }
}

impl Right {
    /// After "right": by which editions, and whose its shape is if not theirs.
    pub(crate) fn by(&self) -> String {
        let by = Edition::said(&self.editions);
        let shape = match self.scene.has_another_shape() {
            true if self.scene.is_in_a_later_shape(self.width, self.height) => {
                " in the shape of later ones"
            }
            true => " in this shape, which is not the book's",
            false => "",
        };
        format!("{by}{shape}")
    }

    /// The first edition that draws the picture to the last bit, or else the first that
    /// draws it within the tolerance.
    fn of(scene: &Scene, reading: &Reading, tolerance: u8) -> Option<Self> {
        let (width, height) = (reading.width, reading.height);
        let within = |tolerance| {
            let scenes = scene.by_editions(width, height);
            let off = |scene: Scene| {
                let is_near = scene.may_be_shown_by(reading, tolerance);
                let right = is_near.then(|| scene.right(width, height))?;
                let (off, levels) = match Comparison::of(&right, &reading.picture()) {
                    Comparison::Pixels(difference) => (difference.count, difference.levels),
                    _ => (0, 0),
                };
                (levels <= tolerance).then_some((scene, off, levels))
            };
            let near: Vec<_> = scenes.filter_map(off).collect();
            let &(scene, off, levels) = near.first()?;
            Some(Self {
                scene,
                editions: near.iter().map(|(scene, ..)| scene.edition).collect(),
                width,
                height,
                off,
                levels,
                shape_given_by: Vec::new(),
            })
        };
        within(0).or_else(|| within(tolerance))
    }
}

impl Check {
    /// The exit code: 0 for right, 1 for wrong, 2 for not a picture. Right is what an
    /// edition of the book draws, to the last bit or within the tolerance, in a shape that
    /// no slip gives.
    pub fn exit_code(&self) -> u8 {
        match self {
            Self::Right(right) if right.shape_given_by.is_empty() => 0,
            Self::Right(_)
            | Self::Near(_)
            | Self::Wrong(_)
            | Self::WrongShape { .. }
            | Self::Another { .. } => 1,
            Self::NotAPicture { .. } => 2,
        }
    }

    /// Why it is not the picture that was asked for, where that is no matter of pixels.
    pub fn cause(&self) -> Option<&Cause> {
        match self {
            Self::Another { cause, .. }
            | Self::WrongShape { cause, .. }
            | Self::NotAPicture { cause, .. } => Some(cause),
            Self::Right(_) | Self::Near(_) | Self::Wrong(_) => None,
        }
    }

    /// Other scenes of which it is the right picture.
    pub fn others(&self) -> &[Scene] {
        match self {
            Self::Another { scenes, .. } => scenes,
            other => other.finding().map_or(&[], |finding| &finding.others),
        }
    }

    /// What the picture shows by itself, where nothing known draws it.
    pub fn shown(&self) -> &[String] {
        match self {
            Self::WrongShape {
                finding: None,
                shown,
                ..
            } => shown,
            other => other.finding().map_or(&[], |finding| &finding.shown),
        }
    }

    /// What is to be seen, if there are pixels to judge and they are not right.
    pub fn finding(&self) -> Option<&Finding> {
        match self {
            Self::Right(_) | Self::Another { .. } => None,
            Self::Near(finding) | Self::Wrong(finding) => Some(finding),
            Self::WrongShape { finding, .. } | Self::NotAPicture { finding, .. } => {
                finding.as_deref()
            }
        }
    }
}
