//! Transcripts of `cargo rtrace hit`.

use fixtures::desk::Desk;
use insta::assert_snapshot;

#[test]
fn one_ray_shows_which_methods_lose_digits_or_overflow() {
    assert_snapshot!(Desk::default().transcript(
        "methods hit --origin -1,0,0 --direction 1,0,-1e-9 --center 3e7,0.5,0 --radius 1
         methods hit --origin 0,0,0 --direction 0,0,-1e200 --center 0,0,-1 --radius 0.5
         methods hit --origin 0,0,0 --direction 0,0,1e-50 --center 0,0,1 --radius 0.5
         methods hit --origin 0,0,0 --direction 0,0,-1e-300 --center 0,0,-1e300 --radius 1
         methods hit --origin=0,0,0 --direction=0,0,-1 --center=0,0,-1 --radius=0.5 --t-min=0.5"
    ));
}

#[test]
fn what_is_no_ray_is_refused() {
    assert_snapshot!(Desk::default().transcript(
        "methods hit --origin=1,2
         methods hit --origin=1,2,x
         methods hit --origin=1,2,1e999
         methods hit --origin=1,2,inf
         methods hit --origin=0,0,0 --direction=0,0,1 --center=0,0,0 --radius=-1
         methods hit --origin=0,0,0"
    ));
}
