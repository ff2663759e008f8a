//! Pattern search (Hooke and Jeeves, 1961) and forward selection: the colors, the viewport and
//! the spheres that a reader chose, with slips beside them, from the picture.
//!
//! One kind of number after the other is taken to be the reader's, each time the one that
//! makes the picture shortest, and those that were found before are fitted again beside it.
//! A search moves each of its numbers a step up or down as long as that brings the program's
//! picture nearer to the reader's; then the steps are halved. It finds what is near the place
//! where it begins, so that has to be good: a grid of viewports, the box around what is not
//! background.

use std::cell::RefCell;
use std::ops::Range;

use common::rtweekend::{Point3, Vec3};

use ::slips::{Ball, Chapter, Program, Room, Slip};

use super::colors::{self, KEPT, colored};
use super::slips::name_of;
use super::{Evidence, Hypothesis, Places, spread};
use crate::bits::{distance, number};
use crate::reading::Reading;
use crate::scene::{Chosen, Scene, USUAL_RATIOS, angle};

/// How many pixels are compared for each step, first and where steps are small; and how many
/// to choose among simple numbers.
const LOOKS: [usize; 2] = [250, 1000];
const CHOICE: u32 = 600;
/// A pixel that is off by more levels counts no more: it may be another color for any
/// reason. Where only the sky is compared, all that lies before it is.
const FAR: u16 = 24;
const NO_SKY: u16 = 3;
/// The same picture may be so many levels off.
const RIGHT: u16 = 2;

/// Where one pixel in so many is another, it is another picture.
const MANY_FAR: usize = 100;

/// How often steps are halved: to half a thousandth of a unit, from a tenth.
const HALVINGS: [i32; 2] = [8, 4];
/// How often a kind of number is taken to be the reader's, or fitted again.
const ROUNDS: usize = 6;
/// How many slips are told together.
const MOST_SLIPS: usize = 2;
/// What leaves a greater part of what is unexplained is chance.
const WORTH: f64 = 0.7;
/// Numbers are simple if they are so many to the unit, the earlier the simpler.
const GRIDS: [f64; 6] = [1.0, 2.0, 4.0, 10.0, 20.0, 100.0];
/// How far away a sphere may be thought to be.
const DISTANCES: [f64; 5] = [1.0, 2.0, 1.5, 3.0, 5.0];

/// What part of the book's length a viewport of another one differs by at least, and a sphere's radius;
/// and by so much its top, in units.
const NEAR: f64 = 0.01;

/// A sphere of no size, which is none.
const NO_SPHERE: Ball = Ball::new(0.0, 0.0, -1.0, 0.0);
/// The book's sphere, and its ground.
const SPHERE: Ball = Ball::new(0.0, 0.0, -1.0, 0.5);
const GROUND: Ball = Ball::new(0.0, -100.5, -1.0, 100.0);
/// Radii of a ground that people type.
const RADII: [f64; 8] = [1.0, 5.0, 10.0, 20.0, 30.0, 50.0, 100.0, 1000.0];

/// How far the middle of a ground may be thought to be.
const DEPTHS: Range<f64> = 0.5..20.0;

/// That the scene is the reader's own, beside its numbers.
const NAME: f64 = 8.0;
/// Bits of a ratio or a radius that people choose.
const USUAL: f64 = 4.0;

/// Programs, each with more and more of the reader's own.
pub(crate) type Path = Vec<Hypothesis>;

/// The program with more and more of the reader's own, by one way and by another; with a slip in the
/// scale of levels, if colors tell of it.
pub(crate) fn chosen_otherwise(evidence: &Evidence, right: &Hypothesis) -> Vec<Path> {
    let (chosen, _) = Kind::chosen_and_slips();
    let rescaled = colors::rescaled(evidence, right);
    let starts = rescaled.iter().chain([right]);
    let Some(fit) = Fit::new(evidence, right) else {
        return Vec::new();
    };
    let paths = starts.flat_map(|start| fit.selected(&chosen, &[start], &chosen));
    paths.collect()
}

/// The same with a slip or two besides; `chosen` is what was found without.
pub(crate) fn chosen_beside_slips(
    evidence: &Evidence,
    right: &Hypothesis,
    chosen: &[Path],
) -> Vec<Hypothesis> {
    let Some(fit) = Fit::new(evidence, right) else {
        return Vec::new();
    };
    let ends = chosen
        .iter()
        .flat_map(|path| path.first().into_iter().chain(path.last()));
    // What a hit's color is made of, a slip may tell in fewer bits.
    let ends = ends.map(|it| without_shade(it.clone()));
    let ends: Vec<Hypothesis> = ends.filter(|it| is_same_scene(it, right)).collect();
    let mut starts: Vec<&Hypothesis> = ends.iter().chain([right]).collect();
    starts.dedup_by(|one, other| are_same(one, other));
    let (_, slips) = Kind::chosen_and_slips();
    let paths = fit.selected(&slips, &starts, &Kind::ALL);
    let mut found: Vec<Hypothesis> = paths.into_iter().flatten().collect();
    // Slips by themselves are looked for elsewhere.
    found.retain(|it| it.scene.chosen != Chosen::default() && !it.slips.is_empty());
    // Where the numbers that were fitted draw the same without them, none were made.
    let without = found.iter().map(|it| fit.named(it.without_slips()));
    let without: Vec<Hypothesis> = without.collect();
    // Nor does a slip count that numbers were fitted to undo.
    found.retain(|it| !fit.draws_the_right_picture(it));
    // A color that is none makes up for a slip, and beside another for that.
    found.retain(|it| !it.scene.chosen.has_no_color());
    found.into_iter().chain(without).collect()
}

/// The same in simple numbers that were fitted through the middles of pixels: before version 4 a
/// single ray goes elsewhere, and the mean of several doesn't.
pub(crate) fn through_the_middle(
    evidence: &Evidence,
    right: &Hypothesis,
    it: &Hypothesis,
) -> Option<Hypothesis> {
    let Chosen {
        viewport_height,
        balls: [sphere, ground],
        ..
    } = it.scene.chosen;
    let kinds = [
        viewport_height.map(|_| Kind::Viewport),
        sphere
            .filter(|it| *it != NO_SPHERE)
            .map(|_| Kind::FirstSphere),
        ground.map(|_| Kind::Ground),
    ];
    if !it.scene.edition.counts_from_below() || !it.scene.chosen.is_placed() {
        return None;
    }
    let fit = Fit::new(evidence, right)?;
    // It draws what a ray through the middle of each pixel does.
    let middle = ::slips::find("deltas-from-last-pixel")?;
    let mut found = it.clone();
    found.slips.push(middle);
    for kind in kinds.into_iter().flatten() {
        let near = fit.fitted(kind, &found).into_iter().next()?;
        (_, found) = fit.shortest(fit.simplified(kind, &near), f64::INFINITY)?;
    }
    Some(fit.named(Hypothesis {
        slips: it.slips.clone(),
        ..found
    }))
}

/// What a reader may have chosen, or done besides.
#[derive(Clone, Copy)]
enum Kind {
    Colors,
    Viewport,
    /// The viewport, with the colors that are seen through it.
    Both,
    FirstSphere,
    NoFirstSphere,
    Ground,
    /// What the color of a hit is made of.
    Shade,
    Slips,
}

impl Kind {
    const ALL: [Self; 8] = [
        Self::Colors,
        Self::Viewport,
        Self::Both,
        Self::FirstSphere,
        Self::NoFirstSphere,
        Self::Ground,
        Self::Shade,
        Self::Slips,
    ];

    fn is_slip(self) -> bool {
        matches!(self, Self::Slips)
    }

    /// Whether it is worth a look beside what was found: colors are seen through the viewport, so
    /// where they are the reader's own, both are fitted.
    fn is_next_of(self, it: &Hypothesis) -> bool {
        let has_colors = colors::books(&it.scene).chosen != it.scene.chosen;
        match self {
            Self::Viewport => !has_colors,
            Self::Both => has_colors,
            _ => true,
        }
    }

    /// What a reader chooses, and what nobody does.
    fn chosen_and_slips() -> (Vec<Self>, Vec<Self>) {
        Self::ALL.into_iter().partition(|kind| !kind.is_slip())
    }
}

/// What is compared.
#[derive(Clone, Copy)]
enum Part {
    All,
    Sky,
}

/// A picture that programs are fitted to.
struct Fit<'a> {
    evidence: &'a Evidence<'a>,
    right: &'a Hypothesis,
    reading: &'a Reading,
    looked: Vec<u32>,
    places: Places,
    /// What is chosen of the sky with some slips, where it was looked for.
    backdrops: RefCell<Vec<(Hypothesis, Option<Chosen>)>>,
}

impl<'a> Fit<'a> {
    fn new(evidence: &'a Evidence, right: &'a Hypothesis) -> Option<Self> {
        let reading = evidence.reading;
        let says_something = !evidence.has_no_levels && !reading.is_plain();
        says_something.then(|| Self {
            evidence,
            right,
            reading,
            looked: spread(LOOKS[1] as u32, reading.pixels.len() as u32).collect(),
            places: Places::new(reading, None, CHOICE),
            backdrops: RefCell::default(),
        })
    }

    /// What comes of the best of the first kinds, and of the second best, which may be what was
    /// done: each with more and more of the others.
    fn selected(&self, first: &[Kind], starts: &[&Hypothesis], others: &[Kind]) -> Vec<Path> {
        let first = starts
            .iter()
            .flat_map(|start| first.iter().map(move |kind| (kind, start)));
        let first = first.filter_map(|(&kind, start)| {
            let length = start.estimated(self.reading, &self.places, f64::INFINITY)?;
            let most = if kind.is_slip() {
                length
            } else {
                f64::INFINITY
            };
            let (length, found) = self.shortest(self.fitted(kind, start), most)?;
            Some((length, kind, found))
        });
        let mut first: Vec<(f64, Kind, Hypothesis)> = first.collect();
        first.sort_by(|(one, ..), (other, ..)| one.total_cmp(other));
        first.dedup_by(|(_, _, one), (_, _, other)| are_same(one, other));
        let mut paths: Vec<Path> = Vec::new();
        // Where what lies before the sky is the reader's too, its sky alone is of no use at first,
        // and what is not where it is thought to be has any color.
        let after = |is_meant: fn(Kind) -> bool| {
            let mut others = first.iter().skip(1);
            let at = others.position(|(_, kind, _)| is_meant(*kind));
            at.map(|at| at + 1)
        };
        let of_sky = after(|kind| matches!(kind, Kind::Both));
        let of_places = after(|kind| !matches!(kind, Kind::Both | Kind::Shade));
        let is_shaded = matches!(first.first(), Some((_, Kind::Shade, _)));
        let further = match is_shaded {
            true => [of_sky, of_places],
            false => [of_sky.or(of_places), None],
        };
        for (at, (_, kind, it)) in first.into_iter().enumerate() {
            if at == 0 || further.contains(&Some(at)) {
                let path = self.select(kind, it, others, &paths);
                paths.push(path);
            }
        }
        paths
    }

    /// The program with what was fitted first, and what comes of it, up to where another path
    /// came.
    fn select(&self, kind: Kind, first: Hypothesis, others: &[Kind], paths: &[Path]) -> Path {
        let mut path = Path::new();
        let mut next = Some((kind, first));
        while path.len() < ROUNDS
            && let Some((kind, it)) = next
        {
            let simple = self.simplified(kind, &it).into_iter().chain([it]);
            let Some((length, it)) = self.shortest(simple, f64::INFINITY) else {
                break;
            };
            let mut known = paths.iter().flatten();
            if known.any(|other| are_same(other, &it)) {
                break;
            }
            let mut most = WORTH * length;
            next = None;
            // Where nothing is left, nothing else was done.
            let is_explained = length <= it.name;
            let others = others.iter().filter(|_| !is_explained);
            let others = others.filter(|kind| kind.is_next_of(&it));
            for &kind in others {
                if let Some((length, it)) = self.shortest(self.fitted(kind, &it), most) {
                    most = length;
                    next = Some((kind, it));
                }
            }
            path.push(it);
        }
        path
    }

    /// Programs with numbers of a kind that are fitted to the picture, from one that may have
    /// some.
    fn fitted(&self, kind: Kind, it: &Hypothesis) -> Vec<Hypothesis> {
        let has_spheres = it.scene.chapter.room() != Room::None && it.scene.probe.is_none();
        let has_ground = has_spheres && it.scene.chapter.room() == Room::Many;
        match kind {
            Kind::Colors => vec![colored(it, self.reading, colors::LOOK)],
            Kind::Viewport => self.viewport(Part::All, it, |it| it),
            Kind::Both => self.backdrop(it).into_iter().collect(),
            Kind::FirstSphere if has_spheres => self.first_sphere(it).into_iter().collect(),
            Kind::NoFirstSphere if has_ground => vec![with_ball(it, 0, NO_SPHERE)],
            Kind::Ground if has_ground => vec![self.ground(it)],
            Kind::Shade => colors::shaded(it, self.reading, colors::LOOK)
                .into_iter()
                .collect(),
            Kind::Slips => self.slips(it),
            Kind::FirstSphere | Kind::NoFirstSphere | Kind::Ground => Vec::new(),
        }
    }

    /// The same with simple numbers that are near.
    fn simplified(&self, kind: Kind, it: &Hypothesis) -> Vec<Hypothesis> {
        match kind {
            Kind::Colors | Kind::Shade => vec![Hypothesis {
                scene: colors::simple(&it.scene),
                ..it.clone()
            }],
            Kind::Viewport => self.simple_viewports(it, |it| it),
            Kind::FirstSphere => {
                let simple = simple_spheres(it).into_iter();
                simple.map(|it| self.with_paint(it)).collect()
            }
            Kind::Ground => simple_grounds(it),
            Kind::Both | Kind::NoFirstSphere | Kind::Slips => Vec::new(),
        }
    }

    /// The shortest of these as an explanation, if it is shorter than `most`, with its length
    /// from some places.
    fn shortest(
        &self,
        all: impl IntoIterator<Item = Hypothesis>,
        mut most: f64,
    ) -> Option<(f64, Hypothesis)> {
        let mut shortest = None;
        for it in all {
            let it = self.named(it);
            if let Some(length) = it.estimated(self.reading, &self.places, most) {
                most = length;
                shortest = Some((length, it));
            }
        }
        shortest
    }

    fn named(&self, it: Hypothesis) -> Hypothesis {
        let it = without_the_books_spheres(self.without_the_books_viewport(it));
        let (scene, chosen) = (it.scene, it.scene.chosen);
        let [sphere, ground] = chosen.balls;
        let places: f64 = [
            sphere.map(sphere_name),
            ground.map(ground_name),
            chosen.viewport_width.map(|width| width_name(&scene, width)),
            chosen
                .viewport_height
                .map(|height| self.height_name(height)),
        ]
        .into_iter()
        .flatten()
        .sum();
        let own = if places > 0.0 { NAME + places } else { 0.0 };
        let slips =
            name_of(&it.slips) + self.evidence.besides(&it) - self.evidence.besides(self.right);
        Hypothesis {
            name: self.right.name + own + slips + colors::name(&scene),
            ..it
        }
    }

    /// Bits of a viewport's height: who types a width, a focal length or an angle, types no height.
    fn height_name(&self, height: f64) -> f64 {
        let typed = [height, height * self.ratio(), 2.0 / height, angle(height)];
        let typed = typed.map(|it| number(to_grid(it, 1e6)));
        typed.into_iter().fold(f64::INFINITY, f64::min)
    }

    /// Nobody chooses a viewport that is nearly the book's: it makes up for something else.
    fn without_the_books_viewport(&self, it: Hypothesis) -> Hypothesis {
        let chosen = it.scene.chosen;
        let Some(height) = chosen.viewport_height else {
            return it;
        };
        let book = it.scene.without_choices().program(&[]);
        let [across, down] = [self.reading.width, self.reading.height].map(f64::from);
        let ratio = (book.viewport_ratio)(across, down, book.aspect_ratio);
        let width = chosen.viewport_width.unwrap_or(height * ratio);
        let is_near = |own: f64, book: f64| (own / book - 1.0).abs() < NEAR;
        let book = book.viewport_height;
        match is_near(height, book) && is_near(width, book * ratio) {
            true => with_chosen(
                &it,
                Chosen {
                    viewport_width: None,
                    viewport_height: None,
                    ..chosen
                },
            ),
            false => it,
        }
    }

    /// How far the picture of a program is from the reader's, in levels, as far as that is
    /// less than `most`.
    fn off(&self, part: Part, it: &Hypothesis, look: usize, most: u32) -> u32 {
        let (output, far) = match part {
            Part::All => (it.output(self.reading), FAR),
            Part::Sky => (Some(without_balls(it, 3).run(self.reading.width)), NO_SKY),
        };
        let Some(output) = output else {
            return u32::MAX;
        };
        let mut sum = 0;
        for &n in self.looked.iter().take(look) {
            let drawn = it.pixel(&output, n);
            sum += u32::from(distance(drawn, self.reading.pixels[n as usize]).min(far));
            if sum >= most {
                break;
            }
        }
        sum
    }

    /// Whether almost all that it draws is within two levels of what the book draws.
    fn draws_the_right_picture(&self, it: &Hypothesis) -> bool {
        let right = Hypothesis {
            scene: it.scene.without_choices(),
            slips: Vec::new(),
            ..it.clone()
        };
        let [Some(own), Some(books)] = [it, &right].map(|it| it.output(self.reading)) else {
            return false;
        };
        let is_far = |&&n: &&u32| distance(it.pixel(&own, n), right.pixel(&books, n)) > RIGHT;
        let far = self.looked.iter().filter(is_far).count();
        MANY_FAR * far <= self.looked.len()
    }

    /// A slip, and perhaps a second one, in the reader's colors, in simpler ones and in the book's.
    fn slips(&self, it: &Hypothesis) -> Vec<Hypothesis> {
        let is_shaded = usize::from(it.scene.chosen.shade.is_some());
        if it.slips.len() + is_shaded >= MOST_SLIPS {
            return Vec::new();
        }
        let mut scenes = vec![
            it.scene,
            colors::simple(&it.scene),
            colors::books(&it.scene),
        ];
        scenes.dedup_by_key(|scene| scene.chosen);
        let is_new =
            |slip: &&'static Slip| !it.slips.iter().any(|other| std::ptr::eq(*other, *slip));
        let slips = self.evidence.slips(&it.scene).filter(is_new);
        let with = |slip| {
            let slips: Vec<_> = it.slips.iter().copied().chain([slip]).collect();
            let of = move |&scene: &Scene| Hypothesis {
                scene,
                slips: slips.clone(),
                ..it.clone()
            };
            let plain = of(&it.scene);
            let all: Vec<Hypothesis> = scenes.iter().map(of).collect();
            // Beside a slip other colors are seen.
            let shaded = colors::shaded(&plain, self.reading, colors::GLANCE);
            let seen = shaded.into_iter().chain([self.with_colors(plain)]);
            let seen = seen.filter(|_| it.slips.is_empty());
            all.into_iter().chain(seen).collect::<Vec<_>>()
        };
        slips.flat_map(with).collect()
    }

    /// A sphere that has only one color, in what is seen where it lies.
    fn with_paint(&self, it: Hypothesis) -> Hypothesis {
        match it.scene.chapter {
            Chapter::RedSphere => {
                let paint = self.with_colors(it.clone()).scene.chosen.paint;
                let chosen = it.scene.chosen;
                with_chosen(&it, Chosen { paint, ..chosen })
            }
            _ => it,
        }
    }

    fn with_colors(&self, it: Hypothesis) -> Hypothesis {
        colored(&it, self.reading, colors::GLANCE)
    }

    /// The first sphere elsewhere or of another size.
    fn first_sphere(&self, it: &Hypothesis) -> Option<Hypothesis> {
        let with = |[x, y, radius]: [f64; 3]| {
            self.with_paint(with_ball(it, 0, Ball::new(x, y, -1.0, radius.abs())))
        };
        let near = |ball: Ball| {
            let [x, y, z] = ball.center.to_array();
            [x, y, ball.radius].map(|number| -number / z)
        };
        let own = it.scene.chosen.balls[0];
        let start = near(own.or_else(|| self.seen_ball(it))?);
        Some(with(self.searched(Part::All, start, [0.1; 3], with)))
    }

    /// The second sphere of the list higher or lower, nearer or farther, or of another size.
    fn ground(&self, it: &Hypothesis) -> Hypothesis {
        let with =
            |[top, z, radius]: [f64; 3]| with_ball(it, 1, Ball::new(0.0, top - radius, z, radius));
        let Ball { center, radius } = it.scene.chosen.balls[1].unwrap_or(GROUND);
        let start = [center.y + radius, center.z, radius];
        with(self.searched(Part::All, start, [0.4, 0.5, 0.6 * radius], with))
    }

    /// The viewport and the colors of the sky by the sky alone: what lies before it may be
    /// anything, and is the same whatever was found of it.
    fn backdrop(&self, it: &Hypothesis) -> Option<Hypothesis> {
        let plain = Hypothesis {
            scene: it.scene.without_choices(),
            ..it.clone()
        };
        let mut known = self.backdrops.borrow_mut();
        let found = match known.iter().find(|(of, _)| of.is_same_program(&plain)) {
            Some((_, found)) => *found,
            None => {
                let found = self.seen_backdrop(&plain).map(|it| it.scene.chosen);
                known.push((plain, found));
                found
            }
        }?;
        let seen = with_viewport(it, found.viewport_width, found.viewport_height?);
        let chosen = Chosen {
            viewport_width: found.viewport_width,
            viewport_height: found.viewport_height,
            sky: found.sky,
            ..seen.scene.chosen
        };
        Some(self.with_paint(with_chosen(it, chosen)))
    }

    /// The same of a program in which nothing is the reader's. Of simple numbers those with which
    /// it is nearest.
    fn seen_backdrop(&self, it: &Hypothesis) -> Option<Hypothesis> {
        let fitted = self.viewport(Part::Sky, it, |it| self.with_colors(it));
        let simple = |it: &Hypothesis| self.simple_viewports(it, |it| self.with_colors(it));
        let simple = fitted.iter().flat_map(simple).chain(fitted.clone());
        let in_simple_colors = |it: Hypothesis| {
            let scene = colors::simple(&it.scene);
            [
                Hypothesis {
                    scene,
                    ..it.clone()
                },
                it,
            ]
        };
        let nearest = |(least, best), it| match self.off(Part::Sky, &it, LOOKS[1], least) {
            off if off < least => (off, Some(it)),
            _ => (least, best),
        };
        let all = simple.flat_map(in_simple_colors);
        all.fold((u32::MAX, None), nearest).1
    }

    /// The same scene through a higher or lower, wider or narrower viewport; `seen` is what else
    /// has to be fitted then.
    fn viewport(
        &self,
        part: Part,
        it: &Hypothesis,
        seen: impl Fn(Hypothesis) -> Hypothesis,
    ) -> Vec<Hypothesis> {
        if it.scene.chapter == Chapter::BuildTest {
            return Vec::new();
        }
        // Most have the picture's ratio: both lengths go down a valley together.
        let with = |numbers: [f64; 2]| {
            let [height, ratio] = numbers.map(f64::abs);
            seen(with_viewport(it, Some(height * ratio), height))
        };
        let ratio = self.ratio();
        let start = || {
            let heights = (-8..=8).map(|n| 2.0 * (f64::from(n) / 4.0).exp());
            let ratios = [1.0, 0.5, 0.75, 1.5, 2.0].map(|times| times * ratio);
            let starts = heights.flat_map(|height| ratios.map(|ratio| [height, ratio]));
            let nearest = |(least, best), start| match self.off(part, &with(start), LOOKS[0], least)
            {
                off if off < least => (off, start),
                _ => (least, best),
            };
            starts.fold((u32::MAX, [2.0, ratio]), nearest).1
        };
        let chosen = it.scene.chosen;
        let own = chosen.viewport_height.map(|height| {
            let width = chosen.viewport_width.unwrap_or(height * ratio);
            [height, width / height]
        });
        let from = own.unwrap_or_else(start);
        let steps = from.map(|number| number / 8.0);
        vec![with(self.searched(part, from, steps, with))]
    }

    /// Width over height of the picture.
    fn ratio(&self) -> f64 {
        f64::from(self.reading.width) / f64::from(self.reading.height)
    }

    /// Viewports of simple numbers. Who types a width, a focal length or an angle has a height with
    /// many digits.
    fn simple_viewports(
        &self,
        it: &Hypothesis,
        seen: impl Fn(Hypothesis) -> Hypothesis,
    ) -> Vec<Hypothesis> {
        let chosen = it.scene.chosen;
        let (Some(width), Some(height)) = (chosen.viewport_width, chosen.viewport_height) else {
            return Vec::new();
        };
        let ratio = self.ratio();
        let heights = GRIDS.into_iter().flat_map(|grid| {
            let focal_length = to_grid(2.0 / height, grid);
            let by_width = to_grid(width, grid) / ratio;
            [to_grid(height, grid), 2.0 / focal_length, by_width]
        });
        let heights = heights.chain([of_angle(angle(height).round())]);
        let heights = heights.filter(|height| *height > 0.0 && height.is_finite());
        let widths = |height: f64| {
            let on_grids = GRIDS.map(|grid| to_grid(width, grid));
            let by_ratios = USUAL_RATIOS.map(|ratio| ratio * height);
            let all = on_grids.into_iter().chain(by_ratios).map(Some);
            [None].into_iter().chain(all.filter(|it| *it > Some(0.0)))
        };
        let all = heights.flat_map(|height| widths(height).map(move |width| (width, height)));
        let mut all: Vec<(Option<f64>, f64)> = all.collect();
        all.sort_by(|one, other| one.partial_cmp(other).expect("lengths are numbers"));
        all.dedup();
        let all = all.into_iter();
        all.map(|(width, height)| seen(with_viewport(it, width, height)))
            .collect()
    }

    /// The numbers nearby that bring the picture nearest: by few pixels, then by more.
    fn searched<const N: usize>(
        &self,
        part: Part,
        start: [f64; N],
        steps: [f64; N],
        with: impl Fn([f64; N]) -> Hypothesis + Copy,
    ) -> [f64; N] {
        // A valley may be long: the search begins again.
        let near = self.walked(part, start, steps, 0, with);
        let near = self.walked(part, near, steps, 0, with);
        let small = steps.map(|step| step / f64::from(HALVINGS[0] - HALVINGS[1]).exp2());
        self.walked(part, near, small, 1, with)
    }

    /// Moves numbers by smaller and smaller steps while that brings the picture nearer.
    fn walked<const N: usize>(
        &self,
        part: Part,
        start: [f64; N],
        mut steps: [f64; N],
        stage: usize,
        with: impl Fn([f64; N]) -> Hypothesis,
    ) -> [f64; N] {
        let off = |numbers, most| self.off(part, &with(numbers), LOOKS[stage], most);
        let (mut numbers, mut least) = (start, off(start, u32::MAX));
        let mut halved = 0;
        while halved < HALVINGS[stage] {
            let mut is_nearer = false;
            for (n, way) in (0..N).flat_map(|n| [(n, 1.0), (n, -1.0)]) {
                let mut moved = numbers;
                moved[n] += way * steps[n];
                let moved_off = off(moved, least);
                if moved_off < least {
                    (numbers, least, is_nearer) = (moved, moved_off, true);
                }
            }
            if !is_nearer {
                steps = steps.map(|step| step / 2.0);
                halved += 1;
            }
        }
        numbers
    }

    /// The sphere one unit away that fills the box around all that is not background.
    fn seen_ball(&self, it: &Hypothesis) -> Option<Ball> {
        let (width, height) = (self.reading.width, self.reading.height);
        let output = without_balls(it, 1).run(width);
        let (mut columns, mut rows): (Option<Range<u32>>, Option<Range<u32>>) = (None, None);
        for n in spread(BOX, self.reading.pixels.len() as u32) {
            if distance(it.pixel(&output, n), self.reading.pixels[n as usize]) > 4 {
                let (i, j) = (n % width, n / width);
                let columns = columns.get_or_insert(i..i + 1);
                *columns = columns.start.min(i)..columns.end.max(i + 1);
                let rows = rows.get_or_insert(j..j + 1);
                *rows = rows.start.min(j)..rows.end.max(j + 1);
            }
        }
        let program = it.scene.program(&it.slips);
        let camera = program.camera(width);
        let corner = |i: u32, j: u32| {
            (program.ray)(&program, &camera, i.min(width - 1), j.min(height - 1)).direction
        };
        let (columns, rows) = (columns?, rows?);
        let (from, to) = (
            corner(columns.start, rows.start),
            corner(columns.end, rows.end),
        );
        let middle: Point3 = 0.5 * (from + to);
        // The disc's radius is the tangent of an angle whose sine is the sphere's.
        let on_viewport = 0.25 * ((to.x - from.x).abs() + (to.y - from.y).abs());
        let radius = on_viewport / on_viewport.hypot(1.0);
        Some(Ball::new(middle.x, middle.y, -1.0, radius))
    }
}

/// The program without the first spheres of its scene.
fn without_balls(it: &Hypothesis, count: usize) -> Program {
    let program = it.scene.program(&it.slips);
    Program {
        world: program.world.without(count),
        ..program
    }
}

/// In how many pixels the box is looked for.
const BOX: u32 = 5000;

/// The height of a viewport one unit away that is seen under so many degrees.
fn of_angle(angle: f64) -> f64 {
    2.0 * (0.5 * angle).to_radians().tan()
}

fn to_grid(number: f64, grid: f64) -> f64 {
    // A zero has no sign here.
    (number * grid).round() / grid + 0.0
}

/// A first sphere of simple numbers. Farther away and as much larger it is the same picture, so
/// any distance will do that makes all of them simple.
fn simple_spheres(it: &Hypothesis) -> Vec<Hypothesis> {
    let Some(Ball { center, radius }) = it.scene.chosen.balls[0] else {
        return Vec::new();
    };
    let simple = |distance: f64, grid: f64| {
        let simple = |number: f64| to_grid(-number / center.z * distance, grid);
        let [x, y, radius] = [center.x, center.y, radius].map(simple);
        (radius > 0.0).then(|| with_ball(it, 0, Ball::new(x, y, -distance, radius)))
    };
    // Somewhere a fine grid has a point near any number, so it is for one distance only.
    let (coarse, fine) = GRIDS.split_at(5);
    let all = DISTANCES
        .into_iter()
        .flat_map(|distance| coarse.iter().map(move |grid| (distance, *grid)))
        .chain(fine.iter().map(|grid| (1.0, *grid)));
    all.filter_map(|(distance, grid)| simple(distance, grid))
        .collect()
}

/// A ground of simple numbers. Farther away and as much larger it is the same, but for what
/// hides what.
fn simple_grounds(it: &Hypothesis) -> Vec<Hypothesis> {
    let Some(Ball { center, radius }) = it.scene.chosen.balls[1] else {
        return Vec::new();
    };
    let simple = |scale: f64, fine: f64, coarse: f64| {
        let top = to_grid((center.y + radius) * scale, fine);
        let radius = to_grid(radius * scale, coarse);
        let with = |z: f64| with_ball(it, 1, Ball::new(0.0, top - radius, z, radius));
        let depths = [-1.0, to_grid(center.z * scale, fine)];
        (radius > 0.0)
            .then(|| depths.map(with))
            .into_iter()
            .flatten()
    };
    // So near that it hides everything it tells nothing of the rest.
    let is_usual = |scale: &f64| DEPTHS.contains(&(scale * center.z.abs()));
    let scales = RADII.map(|simple| simple / radius).into_iter();
    let scales = [1.0].into_iter().chain(scales.filter(is_usual));
    let all = scales.flat_map(|scale| GRIDS.map(|fine| (scale, fine)));
    let all = all.flat_map(|(scale, fine)| {
        let coarse = [0.1].into_iter().chain(GRIDS);
        coarse.flat_map(move |coarse| simple(scale, fine, coarse))
    });
    // Its top is seen well, and its radius is not.
    let top = center.y + radius;
    let tenths = (-15..=15).map(|tenths| to_grid(radius + f64::from(tenths) / 10.0, 10.0));
    let near = tenths.filter(|radius| *radius > 0.0).flat_map(|radius| {
        let tops = GRIDS.map(|fine| to_grid(top, fine));
        tops.map(|top| with_ball(it, 1, Ball::new(0.0, top - radius, -1.0, radius)))
    });
    all.chain(near).collect()
}

/// Whether it is the same scene by the same edition, with whatever choices.
fn is_same_scene(one: &Hypothesis, other: &Hypothesis) -> bool {
    let place = |it: &Hypothesis| (it.scene.chapter, it.scene.probe, it.scene.edition);
    place(one) == place(other)
}

/// Whether they are the same programs with the same numbers.
fn are_same(one: &Hypothesis, other: &Hypothesis) -> bool {
    one.is_same_program(other) && one.scene.chosen == other.scene.chosen
}

/// The same scene through another viewport: what was fitted to the picture stays where it is seen.
fn with_viewport(it: &Hypothesis, width: Option<f64>, height: f64) -> Hypothesis {
    let times = height / it.scene.program(&[]).viewport_height;
    let [sphere, ground] = it.scene.chosen.balls;
    let sphere = sphere.map(|ball| times_on_viewport(ball, times));
    let chosen = Chosen {
        viewport_width: width,
        viewport_height: Some(height),
        balls: [sphere, ground],
        ..it.scene.chosen
    };
    with_chosen(it, chosen)
}

/// A sphere that is so much larger on the viewport, and so much farther from its middle.
fn times_on_viewport(Ball { center, radius }: Ball, times: f64) -> Ball {
    let [x, y, z] = center.to_array();
    Ball::new(times * x, times * y, z, times * radius)
}

/// Nobody chooses a sphere that is nearly the book's either.
fn without_the_books_spheres(it: Hypothesis) -> Hypothesis {
    let mut chosen = it.scene.chosen;
    for (own, book) in chosen.balls.iter_mut().zip([SPHERE, GROUND]) {
        let top = |Ball { center, radius }: Ball| center + Vec3::new(0.0, radius, 0.0);
        let is_near = |own: Ball| {
            let is_as_large = (own.radius - book.radius).abs() < NEAR * book.radius;
            is_as_large && (top(own) - top(book)).length() < NEAR
        };
        *own = own.filter(|it| !is_near(*it));
    }
    with_chosen(&it, chosen)
}

fn without_shade(it: Hypothesis) -> Hypothesis {
    let chosen = Chosen {
        shade: None,
        ..it.scene.chosen
    };
    with_chosen(&it, chosen)
}

fn with_ball(it: &Hypothesis, n: usize, ball: Ball) -> Hypothesis {
    let mut chosen = it.scene.chosen;
    chosen.balls[n] = Some(ball);
    with_chosen(it, chosen)
}

fn with_chosen(it: &Hypothesis, chosen: Chosen) -> Hypothesis {
    Hypothesis {
        scene: it.scene.with(chosen),
        ..it.clone()
    }
}

/// Bits of a number beside the book's.
fn beside(book: f64, own: f64) -> f64 {
    if own == book { KEPT } else { number(own) }
}

fn sphere_name(Ball { center, radius }: Ball) -> f64 {
    let [x, y, z] = center.to_array();
    beside(0.0, x) + beside(0.0, y) + beside(-1.0, z) + beside(0.5, radius)
}

/// A ground is thought of by its top.
fn ground_name(Ball { center, radius }: Ball) -> f64 {
    let radius_name = match RADII.contains(&radius) {
        true => USUAL,
        false => number(radius),
    };
    let top = to_grid(center.y + radius, 1000.0);
    beside(-0.5, top) + beside(-1.0, center.z) + radius_name
}

/// Bits of the viewport's width: a number, or a ratio to the height.
fn width_name(scene: &Scene, width: f64) -> f64 {
    let ratio = width / scene.program(&[]).viewport_height;
    let is_usual = USUAL_RATIOS.iter().any(|it| (it - ratio).abs() < 1e-9);
    number(width).min(if is_usual { USUAL } else { f64::INFINITY })
}
