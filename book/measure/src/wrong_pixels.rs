//! Image comparison: how many pixels each method gets wrong.

use std::sync::atomic::{AtomicUsize, Ordering};

use common::rtweekend::*;
use figures::records::WrongPixels;
use figures::table::Table;
use rayon::prelude::*;
use speed_vs_accuracy::{Arithmetic, METHODS, Method, Scene, Sight};

use crate::scene_file::SCENES;

/// Draws the scenes of chapter 6 by all methods, `width` pixels wide. Returns a row for each scene
/// and method, in the order of [`SCENES`] and [`METHODS`], with the number of wrong pixels: more
/// than one level of 255 off in a component.
pub fn table(width: u32) -> Table<WrongPixels> {
    let rows = SCENES.par_iter().flat_map_iter(|scene| rows(scene, width));
    rows.collect::<Vec<_>>().into()
}

fn rows(scene: &Scene, width: u32) -> impl Iterator<Item = WrongPixels> {
    let SceneViews {
        right, by_method, ..
    } = draw(scene, METHODS, width, &|_, _| ());
    let pixels = right.rgb().len() / 3;
    by_method.into_iter().map(move |view| WrongPixels {
        scene: scene.name.clone(),
        precision: view.method.precision(),
        method: view.method.name.to_owned(),
        pixels,
        wrong: view.wrong,
    })
}

/// The right picture of a scene, and the pictures that some methods draw of it.
pub struct SceneViews {
    /// The picture that exact arithmetic draws.
    pub right: Picture,
    /// The number of pixels of the right picture with shadow acne: their surface faces the sun, but
    /// the ray to the sun starts at a rounded point and hits the surface that it leaves.
    pub with_acne: usize,
    /// The pictures of the methods, compared with the right one, in the order in which the methods
    /// were given.
    pub by_method: Vec<MethodView>,
}

/// A method's picture of a scene, compared with the right one.
pub struct MethodView {
    /// The method that drew the picture.
    pub method: Method,
    /// The number of wrong pixels: more than one level of 255 off in red, green or blue.
    pub wrong: usize,
    /// The column and the row of the first wrong pixel in reading order, counted from 0 at the top
    /// left; `None` if no pixel is wrong.
    pub first_wrong: Option<[u32; 2]>,
    /// The greatest difference of a component in any pixel, in levels from 0 to 255.
    pub levels: u8,
    /// The greatest errors of hits, over all pixels that show the right sphere; `None` if no pixel
    /// does.
    pub off: Option<HitErrors>,
    /// The number of pixels that show another sphere than the right one, the sky instead of a
    /// sphere, or a sphere instead of the sky.
    pub misjudged: usize,
}

/// The greatest error of either kind among several hits; NaN counts as infinite.
#[derive(Clone, Copy, Debug)]
pub struct HitErrors {
    /// The greatest distance of a hit point from the right one, in radii of its sphere.
    pub radii: f64,
    /// The greatest error of t, divided by the right t, without sign.
    pub t: f64,
}

impl HitErrors {
    /// Returns the greater of each error; NaN counts as infinite.
    fn or(self, other: Self) -> Self {
        let worse = |one: f64, other: f64| match one.max(other) {
            _ if one.is_nan() || other.is_nan() => f64::INFINITY,
            worse => worse,
        };
        Self {
            radii: worse(self.radii, other.radii),
            t: worse(self.t, other.t),
        }
    }
}

/// Draws `scene`, `width` pixels wide, by exact arithmetic and by each of `methods`, on all
/// threads. After each row of pixels, calls `progress`, from any thread, with the number of rows
/// that are done and the number of all.
///
/// # Panics
/// If `progress` panics.
pub fn draw(
    scene: &Scene,
    methods: &[Method],
    width: u32,
    progress: &(dyn Fn(usize, usize) + Sync),
) -> SceneViews {
    let (camera, done) = (Camera::new(width), AtomicUsize::new(0));
    let rows = (0..camera.image_height).into_par_iter().map(|j| {
        let sights = |arithmetic| -> Vec<Sight> {
            let columns = 0..camera.image_width;
            columns
                .map(|i| scene.look(arithmetic, &camera.ray(i, j)))
                .collect()
        };
        let right = sights(Arithmetic::Exact);
        let of_method = |method: &Method| {
            let seen = sights(Arithmetic::Method(*method));
            let off = farthest(scene, &right, &seen);
            let pairs = right.iter().zip(&seen);
            let misjudged = pairs.filter(|(right, seen)| sphere(right) != sphere(seen));
            (bytes(&seen), off, misjudged.count())
        };
        let seen: Vec<_> = methods.iter().map(of_method).collect();
        let with_acne = right.iter().filter(|sight| has_acne(scene, sight)).count();
        let done = 1 + done.fetch_add(1, Ordering::Relaxed);
        progress(done, camera.image_height as usize);
        ((bytes(&right), with_acne), seen)
    });
    let (right, seen): (Vec<(Vec<u8>, usize)>, Vec<Vec<_>>) = rows.unzip();
    let (right, with_acne): (Vec<Vec<u8>>, Vec<usize>) = right.into_iter().unzip();
    let picture = |rgb: Vec<u8>| {
        Picture::from_rgb(camera.image_width, camera.image_height, rgb).expect("all rows are there")
    };
    let right = picture(right.concat());
    let views = methods.iter().enumerate().map(|(n, method)| {
        let rows = || seen.iter().map(|row| &row[n]);
        let rgb: Vec<&[u8]> = rows().map(|(rgb, ..)| &rgb[..]).collect();
        let off = rows().filter_map(|(_, off, _)| *off).reduce(HitErrors::or);
        let misjudged = rows().map(|(.., misjudged)| misjudged).sum();
        MethodView::new(*method, &right, &picture(rgb.concat()), off, misjudged)
    });
    SceneViews {
        by_method: views.collect(),
        with_acne: with_acne.iter().sum(),
        right,
    }
}

fn bytes(sights: &[Sight]) -> Vec<u8> {
    let mut rgb = vec![0; 3 * sights.len()];
    for (pixel, sight) in rgb.as_chunks_mut().0.iter_mut().zip(sights) {
        write_color(pixel, sight.color);
    }
    rgb
}

fn has_acne(scene: &Scene, sight: &Sight) -> bool {
    sight.hit.zip(scene.sun).is_some_and(|(hit, sun)| {
        let (center, _) = scene.spheres[hit.sphere];
        hit.shaded_by == Some(hit.sphere) && sun.dot(hit.point - center) > 0.0
    })
}

/// Returns the greatest errors of hits, over the pixels that show the right sphere.
fn farthest(scene: &Scene, right: &[Sight], seen: &[Sight]) -> Option<HitErrors> {
    let off = |(right, seen): (&Sight, &Sight)| {
        let (right, seen) = right.hit.zip(seen.hit)?;
        let (_, radius) = scene.spheres[right.sphere];
        let off = HitErrors {
            radii: (seen.point - right.point).length() / radius.abs(),
            t: ((seen.t - right.t) / right.t).abs(),
        };
        (right.sphere == seen.sphere).then_some(off.or(off))
    };
    right.iter().zip(seen).filter_map(off).reduce(HitErrors::or)
}

/// Returns the index of the sphere that a pixel shows; `None` for the sky.
fn sphere(sight: &Sight) -> Option<usize> {
    sight.hit.map(|hit| hit.sphere)
}

impl MethodView {
    fn new(
        method: Method,
        right: &Picture,
        picture: &Picture,
        off: Option<HitErrors>,
        misjudged: usize,
    ) -> Self {
        let levels = levels_off(right, picture);
        let first = levels.iter().position(|&levels| levels > 1);
        let width = right.width();
        Self {
            method,
            wrong: levels.iter().filter(|&&levels| levels > 1).count(),
            first_wrong: first.map(|n| [n as u32 % width, n as u32 / width]),
            levels: levels.into_iter().max().unwrap_or(0),
            off,
            misjudged,
        }
    }
}

/// Returns for each pixel the greatest difference of a component between two pictures of one size,
/// in levels from 0 to 255, row by row: pixel `j * width + i` is in column `i` and row `j` from the
/// top left.
pub fn levels_off(right: &Picture, drawn: &Picture) -> Vec<u8> {
    let pixels = right.rgb().as_chunks().0.iter();
    let levels = |(right, drawn): (&[u8; 3], &[u8; 3])| {
        let both = right.iter().zip(drawn);
        both.map(|(one, other)| one.abs_diff(*other))
            .max()
            .unwrap_or(0)
    };
    pixels.zip(drawn.rgb().as_chunks().0).map(levels).collect()
}
