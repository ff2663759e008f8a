//! Prints the picture of this chapter: `cargo run -p build_test > build_test.ppm`

fn main() -> std::process::ExitCode {
    common::chapter::main(|| build_test::picture(256))
}
