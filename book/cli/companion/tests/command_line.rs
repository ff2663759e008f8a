//! Command lines: what is shown, what is refused, and in which words.

use fixtures::desk::Desk;
use insta::assert_snapshot;

#[test]
fn the_companion_explains_itself_when_asked_and_when_misunderstood() {
    assert_snapshot!(Desk::default().transcript(
        "rtrace --help
         rtrace show --help
         rtrace help check
         rtrace needs -h
         rtrace sho
         rtrace help unicorn
         rtrace show
         rtrace show gradient red_sphere
         rtrace show gradient --widht 3
         rtrace show gradient --width
         rtrace show gradient --open=yes
         rtrace show gradient --width 3 --width 4
         rtrace check
         rtrace check gradient a.ppm b.ppm
         rtrace check a.ppm b.ppm
         rtrace check gradient
         rtrace check gradient mine.ppm -- true
         rtrace check gradient mine.ppm --timeout 3
         rtrace check gradient mine.ppm --probe insde
         rtrace check gradient mine.ppm --tolerance 256
         rtrace laws normals
         rtrace show hitable-list
         rtrace show gradient
         rtrace show gradient --open --output -
         rtrace show gradient --output picture.jpg
         rtrace show gradient --output .png
         rtrace show gradient --output - --width 0
         rtrace check gradient --timeout nan -- true
         rtrace check gradient mine.ppm --probe inside
         rtrace watch gradient --in nowhere
         rtrace done \"\""
    ));
}
