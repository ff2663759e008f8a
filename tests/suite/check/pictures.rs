//! Pictures of chapter 6, and how pictures are compared.

use check::comparison::Comparison;
use check::png;
use common::rtweekend::*;
use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use image::{ExtendedColorType, ImageEncoder};
use measure::scene_file::find_scene;
use speed_vs_accuracy::Method;

use suite::drawn::p3_with_threads;
use suite::drawn::{assert_picture, compare_files};

mod is_right {
    use super::*;

    #[test]
    fn speed_vs_accuracy() {
        assert_picture("speed_vs_accuracy", &::speed_vs_accuracy::picture(400));
    }
}

/// Scenes of chapter 6 in which a method fails, and what they should look like.
mod the_snapshot_is_drawn_by_a_method {
    use super::*;

    const WIDTH: u32 = 200;

    #[test]
    fn telescope() {
        assert_failure("telescope", Method::HALF_B);
    }

    #[test]
    fn grazing() {
        assert_failure("grazing", Method::HALF_B);
    }

    #[test]
    fn shadows() {
        assert_failure("shadows", Method::HALF_B_F32);
    }

    #[test]
    fn neighbors() {
        assert_failure("neighbors", Method::HALF_B);
        let scene = find_scene("neighbors").expect("it is one of the seven");
        let best = scene.picture(Method::EXACT, WIDTH);
        assert_picture("neighbors_exact", &best);
    }

    fn assert_failure(scene: &str, method: Method) {
        let scene = find_scene(scene).expect("it is one of the seven");
        let wrong = scene.picture(method, WIDTH);
        let right = scene.right_picture(WIDTH);
        assert_ne!(wrong, right);
        assert_picture(&format!("{}_{}", scene.name, method.name), &wrong);
        assert_picture(&format!("{}_right", scene.name), &right);
    }
}

#[test]
fn the_number_of_threads_changes_no_byte() {
    // Large enough for three strips, and no multiple of anything.
    let picture = hittable_list::picture(263);
    let text = |threads| p3_with_threads(&picture, threads);
    for threads in [2, 3, 7, 100] {
        assert!(text(1) == text(threads), "the text of {threads} threads");
        assert!(
            picture.rgb_with_threads(1) == picture.rgb_with_threads(threads),
            "the bytes of {threads} threads"
        );
    }
}

#[test]
fn chapters_3_and_4_draw_the_same_picture_at_any_width() {
    for width in [1, 2, 3, 50, 333] {
        assert_equal(
            &normals::picture(width),
            &half_b_sphere::picture(width),
            &format!("chapters 3 and 4 at {width} wide"),
        );
    }
}

#[test]
fn a_snapshot_may_be_compressed_in_another_way_but_not_show_another_picture() {
    let picture = gradient::picture(40);
    let stored = png::encode(&picture);

    let mut other_file = Vec::new();
    PngEncoder::new_with_quality(&mut other_file, CompressionType::Best, FilterType::NoFilter)
        .write_image(picture.rgb(), 40, 22, ExtendedColorType::Rgb8)
        .expect("memory takes it");
    assert_ne!(stored, other_file);
    assert_eq!(compare_files(&stored, &other_file), Comparison::Equal);

    let mut rgb = picture.rgb().to_vec();
    rgb[3 * (40 * 7 + 5) + 1] ^= 1;
    let other_picture = Picture::from_rgb(40, 22, rgb).expect("the size is the same");
    let comparison = compare_files(&stored, &png::encode(&other_picture));
    assert!(
        comparison.to_string().starts_with(
            "1 of 880 pixels differ, in columns 5 to 5 and rows 7 to 7; \
             the first is column 5, row 7:"
        ),
        "{comparison}"
    );
}

#[test]
fn pictures_are_equal_if_size_and_bytes_are() {
    let picture = |width, height, level| {
        Picture::from_rgb(width, height, vec![level; 12]).expect("12 bytes are 4 pixels")
    };
    assert_eq!(picture(2, 2, 7), picture(2, 2, 7));
    assert_ne!(picture(2, 2, 7), picture(2, 2, 8));
    assert_ne!(picture(4, 1, 7), picture(1, 4, 7));
    assert_ne!(picture(4, 1, 7), picture(2, 2, 7));
    let wider = Picture::from_rgb(5, 2, vec![0; 30]).expect("30 bytes are 10 pixels");
    let narrower = Picture::from_rgb(4, 2, vec![0; 24]).expect("24 bytes are 8 pixels");
    assert_ne!(wider, narrower);
    assert_eq!(format!("{wider:?}"), "Picture of 5 × 2 pixels");
}

#[test]
fn bytes_that_are_not_three_a_pixel_are_no_picture() {
    assert_eq!(Picture::from_rgb(2, 2, vec![0; 11]), None);
    assert!(Picture::from_rgb(2, 2, vec![0; 12]).is_some());
}

fn assert_equal(expected: &Picture, actual: &Picture, what: &str) {
    let comparison = Comparison::of(expected, actual);
    assert!(comparison == Comparison::Equal, "{what}: {comparison}");
}
