//! The numbers that chapters 1 to 5 tell in their sentences are those that come out.

use std::fs;
use std::path::Path;

use check::comparison::differing_pixels;
use common::rtweekend::*;
use slips::Chapter;

use suite::drawn::p3;
use suite::slip;

#[test]
fn the_setup_page_tells_how_large_a_picture_is() {
    for &chapter in &Chapter::OF_THE_BOOK[1..] {
        let megabytes = p3(&chapter.picture(400)).len() as f64 / 1e6;
        assert_eq!(format!("{megabytes:.0}"), "1", "{chapter:?}");
    }
    told("setup", "a picture of the book's size is a megabyte");
}

#[test]
fn chapter_1_tells_heights_distances_and_weights() {
    let ideal = |width: u32| f64::from(width) / (16.0 / 9.0);
    told(
        "gradient",
        &format!("400 divided by 16/9 is {}", ideal(400)),
    );
    told("gradient", &format!("401 gives {:.2}", ideal(401)));
    told(
        "gradient",
        &format!("the height is cut to {}", Camera::new(401).image_height),
    );

    let (nearest, farthest) = range(|ray| ray.direction.length());
    told(
        "gradient",
        &format!("in the middle that is {nearest:.2} units away"),
    );
    told("gradient", &format!("in a corner {farthest:.2}"));
    let (least, greatest) = range(|ray| 0.5 * (ray.direction.normalize().y + 1.0));
    told(
        "gradient",
        &format!("$a$ goes from {least:.3} to {greatest:.3}"),
    );

    let right = gradient::picture(400);
    let wrong = slip("grid-not-inset")
        .program(Chapter::Gradient)
        .run(400)
        .picture();
    let count = differing_pixels(&right, &wrong).count();
    let all = right.rgb().len() / 3;
    told(
        "gradient",
        &format!("{count} of {all} pixels would change, each by a single level"),
    );
}

#[test]
fn chapter_2_tells_how_large_the_disc_is() {
    let pixels_high = 0.5 * f64::from(Camera::new(400).image_height);
    told(
        "red_sphere",
        &format!("a radius of {:.0} pixels", (0.5 * pixels_high).floor()),
    );
    let tangent = 30.0_f64.to_radians().tan();
    told(
        "red_sphere",
        &format!(
            "{tangent:.3}, and times {pixels_high} pixels that is {:.2}",
            pixels_high * tangent
        ),
    );
    let picture = red_sphere::picture(400);
    let (pixels, _) = picture.rgb().as_chunks::<3>();
    let red: Vec<usize> = (0..pixels.len())
        .filter(|&at| pixels[at] == [255, 0, 0])
        .collect();
    told("red_sphere", &format!("the disc has {} of them", red.len()));
    let columns = || red.iter().map(|at| at % 400);
    let (first, last) = (columns().min(), columns().max());
    let (first, last) = (first.expect("it is red"), last.expect("it is red"));
    told(
        "red_sphere",
        &format!("fills the columns {first} to {last}"),
    );
}

#[test]
fn chapter_3_tells_two_colors() {
    told("normals", &format!("Half of 255.999 is {}", 255.999 / 2.0));
    let picture = normals::picture(400);
    let (pixels, _) = picture.rgb().as_chunks::<3>();
    let [left, right] = [199, 200].map(|i| pixels[112 * 400 + i]);
    let text = |[r, g, b]: [u8; 3]| format!("`{r} {g} {b}`");
    told("normals", &format!("{} and {}", text(left), text(right)));
}

#[test]
fn chapter_5_tells_where_the_horizon_is() {
    let camera = Camera::new(400);
    let ground = hittable_list::Sphere::new(Point3::new(0.0, -100.5, -1.0), 100.0);
    let row = |i| {
        let is_ground = |&j: &u32| {
            let hit = hittable_list::Hittable::hit(&ground, &camera.ray(i, j), 0.0, f64::INFINITY);
            hit.is_some()
        };
        (0..225)
            .find(is_ground)
            .expect("the ground is in every column")
    };
    let (edge, middle) = (row(0), row(200));
    told(
        "hittable_list",
        &format!("Row {edge} at the edge and row {middle} in the middle"),
    );
}

/// The least and the greatest `number` of all rays of the picture.
fn range(number: impl Fn(&Ray) -> f64) -> (f64, f64) {
    let camera = Camera::new(400);
    let rays = (0..225).flat_map(|j| (0..400).map(move |i| camera.ray(i, j)));
    rays.map(|ray| number(&ray)).fold(
        (f64::INFINITY, f64::NEG_INFINITY),
        |(least, most), number| (number.min(least), number.max(most)),
    )
}

/// Asserts that the page says this, wherever its lines break.
fn told(page: &str, what: &str) {
    let notes = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../book/notes");
    let text = fs::read_to_string(notes.join(page).with_extension("md")).expect("a page");
    let text: Vec<&str> = text.split_whitespace().collect();
    assert!(
        text.join(" ").contains(what),
        "{page}.md does not say: {what}"
    );
}
