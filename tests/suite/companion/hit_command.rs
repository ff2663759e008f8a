//! What `cargo rtrace hit` says.

use std::io::{BufRead, BufReader, Write};
use std::process::Stdio;

use insta::assert_snapshot;
use suite::desk::Desk;

#[test]
fn one_ray_shows_which_methods_lose_digits_or_overflow_and_why() {
    assert_snapshot!(Desk::default().transcript(
        "rtrace hit --origin -1,0,0 --direction 1,0,-1e-9 --center 3e7,0.5,0 --radius 1
         rtrace hit --origin 0,0,0 --direction 0,0,-1e200 --center 0,0,-1 --radius 0.5
         rtrace hit --origin 0,0,0 --direction 0,0,1e-50 --center 0,0,1 --radius 0.5
         rtrace hit --origin 0,0,0 --direction 0,0,-1e-300 --center 0,0,-1e300 --radius 1"
    ));
}

/// Also where negative numbers stand after a blank.
#[test]
fn one_ray_may_have_a_range_and_be_seen_by_one_method() {
    assert_snapshot!(Desk::default().transcript(
        "rtrace hit --origin=0,0,0 --direction=0,0,-1 --center=0,0,-1 --radius=0.5 --t-min=0.5 --t-max=1.5 --method=half_b
         rtrace hit --origin -1,-2,-3 --direction -1,0,0 --center -5,-2,-3 --radius -1 --t-min -1 --method exact"
    ));
}

#[test]
fn what_is_no_ray_is_refused() {
    assert_snapshot!(Desk::default().transcript(
        "rtrace hit --origin=1,2
         rtrace hit --origin=1,2,x
         rtrace hit --origin=1,2,1e999
         rtrace hit --origin=1,2,inf
         rtrace hit --origin=0,0,0
         rtrace hit --csv no-such-file"
    ));
}

const HEAD: &str = "ox,oy,oz,dx,dy,dz,cx,cy,cz,r";
const GOOD: &str = "0,0,0,0,0,-1,0,0,-1,0.5";

/// From any program: whatever the columns are called besides, in any order, from Windows, from
/// a spreadsheet, with empty lines, or with more digits than a number has.
#[test]
fn a_file_is_answered_until_a_bad_row_which_is_refused_by_line_and_reason() {
    let miss = "0,0,0,1,0,0,0,0,-1,0.5";
    let far = "0,0,0,0,0,-1,0,0,-1.00000000000000011102230246251565404236316680908203126,0";
    let five = GOOD.replace("0.5", "five");
    let files = [
        format!("{HEAD}\n{GOOD}\n{miss}\n"),
        "note,r,cz,cy,cx,dz,dy,dx,oz,oy,ox\n\"a, b\",0.5,-1,0,0,-2,0,0,0,0,0\n".to_owned(),
        format!("\u{feff}{HEAD}\r\n\r\n0, 0, 0, 0, 0, -1, 0, 0, -1, 5e-1\r\n"),
        format!("{HEAD}\n{far}"),
        format!("{HEAD}\r\n\r\n{GOOD}\r\n\r\n{five}"),
        format!("{HEAD}\n{GOOD}\n0,0,0,0,0,-1,0,0,-1\n"),
        format!("{HEAD}\nnan,0,0,0,0,-1,0,0,-1,1\n"),
        HEAD.replace(",r", ""),
        String::new(),
    ];
    let desk = Desk::default();
    let answers = files.map(|file| {
        desk.write("rays.csv", &file);
        format!(
            "{file}\n{}",
            desk.transcript("rtrace hit --method exact --csv rays.csv")
        )
    });
    assert_snapshot!(answers.concat());
}

#[test]
fn a_file_is_answered_while_it_is_written() {
    let mut hit = Desk::default().command("rtrace hit --method half_b --csv -");
    let piped = hit
        .current_dir(".")
        .stdin(Stdio::piped())
        .stdout(Stdio::piped());
    let mut child = piped.spawn().expect("the program starts");
    let mut stdin = child.stdin.take().expect("it is piped");
    let mut answers = BufReader::new(child.stdout.take().expect("it is piped")).lines();
    let mut next = || answers.next().expect("it goes on").expect("text");
    writeln!(stdin, "{HEAD}\n{GOOD}").expect("it reads");
    assert_eq!([next(), next()], ["row,method,t", "1,half_b,0.5"]);
    writeln!(stdin, "{GOOD}").expect("it reads");
    assert_eq!(next(), "2,half_b,0.5");
    drop(stdin);
    assert!(child.wait().expect("the program ends").success());
}
