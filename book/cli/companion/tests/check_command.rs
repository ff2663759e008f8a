//! Transcripts of `cargo rtrace check`.

use std::fs::File;

use fixtures::command::{run, text};
use fixtures::desk::Desk;
use fixtures::drawn::p3;
use insta::assert_snapshot;
use slips::{Chapter, ChapterCode};

#[test]
fn a_right_picture_is_followed_by_what_it_can_not_show() {
    let desk = Desk::default();
    desk.write_picture("right.ppm", &Chapter::Normals.picture(100));
    let utf_16 = text(&p3(&Chapter::Normals.picture(100)));
    let utf_16: Vec<u8> = utf_16.encode_utf16().flat_map(u16::to_le_bytes).collect();
    desk.write("utf-16.ppm", utf_16);
    desk.write_slip("rounded.png", "rounded", Chapter::HittableList);
    desk.write_slip("square.png", "integer-aspect-ratio", Chapter::Gradient);
    assert_snapshot!(desk.transcript(
        "rtrace check normals right.ppm
         rtrace check normals utf-16.ppm
         rtrace check hittable_list rounded.png
         rtrace check hittable_list rounded.png --tolerance 1
         rtrace check gradient square.png"
    ));
}

#[test]
fn a_wrong_picture_is_shown_with_the_mistake() {
    let desk = Desk::default();
    desk.write_slip("sign.png", "minus-h", Chapter::HalfBSphere);
    desk.write_slip("half.ppm", "normal-only-shifted", Chapter::Normals);
    desk.write_picture("list.ppm", &Chapter::HittableList.picture(100));
    let mut noise = b"P6 64 36 255\n".to_vec();
    noise.extend((0..64 * 36 * 3_u32).map(|n| (n * n % 65_521) as u8));
    desk.write("noise.ppm", noise);
    assert_snapshot!(desk.transcript(
        "rtrace check half_b_sphere sign.png
         rtrace check normals half.ppm
         rtrace check normals list.ppm
         rtrace check noise.ppm"
    ));
}

#[test]
fn a_probe_is_checked_with_its_own_scene() {
    let desk = Desk::default();
    desk.write_picture("list.ppm", &Chapter::HittableList.picture(128));
    desk.write_picture("ball.ppm", &Chapter::Normals.picture(100));
    assert_snapshot!(desk.transcript(
        "rtrace check hittable_list list.ppm --probe reversed
         rtrace check hittable_list list.ppm --probe odd-width
         rtrace check normals ball.ppm --probe off-axis
         rtrace check gradient list.ppm --probe inside"
    ));
}

/// Without it, a picture of chapter 4 is taken for one of chapter 3, which draws the same.
#[test]
fn inside_a_readers_crate_its_chapter_is_meant() {
    let desk = Desk::default();
    let manifest = "[package]\nname = \"my_half_b_sphere\"\n";
    desk.write("mine/half_b_sphere/Cargo.toml", manifest);
    desk.write_picture(
        "mine/half_b_sphere/src/a.ppm",
        &Chapter::Normals.picture(100),
    );
    let inside = |line| {
        run(desk
            .command(line)
            .current_dir(desk.path("mine/half_b_sphere/src")))
    };
    let said = text(&inside("rtrace check a.ppm").stdout);
    assert!(said.contains("100 × 56 pixels of half_b_sphere"), "{said}");
    let said = text(&inside("rtrace watch --once --probe reversed").stderr);
    assert!(said.contains("no place for the spheres"), "{said}");
    let said = text(&desk.run("rtrace watch --once").stderr);
    assert!(said.contains("CHAPTER is missing"), "{said}");
}

#[test]
fn what_is_no_picture_is_refused_with_cause_and_fix() {
    let desk = Desk::default();
    desk.write("chatty.ppm", "P3\n400 225\n255\nScanlines remaining: 224\n");
    // As a stream of text changes them on Windows.
    let swollen = [b"P6\n16 16\n255\n", Chapter::BuildTest.picture(16).rgb()].concat();
    let swollen = swollen.split(|&byte| byte == b'\n').collect::<Vec<_>>();
    desk.write("swollen.ppm", swollen.join(&b"\r\n"[..]));
    assert_snapshot!(desk.transcript(
        "rtrace check gradient chatty.ppm
         rtrace check gradient swollen.ppm
         rtrace check gradient missing.ppm"
    ));
}

#[test]
fn a_picture_may_come_from_standard_input() {
    let desk = Desk::default();
    desk.write_picture("right.ppm", &Chapter::RedSphere.picture(64));
    let mut check = desk.command("rtrace check red_sphere -");
    let output = run(check.stdin(File::open(desk.path("right.ppm")).expect("it")));
    assert!(text(&output.stdout).starts_with("standard input is right"));
}

/// Also programs that would keep a check waiting: a loop, one that hands its output to a
/// process that goes on, one that closes it and goes on.
#[cfg(unix)]
#[test]
fn a_picture_may_come_from_a_program_which_ends_within_its_time() {
    let desk = Desk::default();
    desk.write_picture("right.ppm", &Chapter::Normals.picture(100));
    desk.write("loop.sh", "exec sleep 60");
    desk.write("counts.sh", "printf '\\r1 row left' >&2; cat right.ppm");
    desk.write("starts-another.sh", "cat right.ppm; sleep 9 2>&- &");
    desk.write("closes-it.sh", "exec >&-; exec sleep 60");
    assert_snapshot!(desk.transcript_at_once(
        "rtrace check normals -- cat right.ppm
         rtrace check gradient -- cat right.ppm
         rtrace check normals -- false
         rtrace check normals --timeout 3 -- sh starts-another.sh
         rtrace check normals --timeout 0.2 -- sh loop.sh
         rtrace check normals --timeout 0.2 -- sh closes-it.sh"
    ));
    // The verdict does not stand beside an unfinished line.
    let counted = desk.run("rtrace check normals -- sh counts.sh");
    assert_eq!(text(&counted.stderr), "\r1 row left\n");
}
