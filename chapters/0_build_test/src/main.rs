//! Prints the picture of this chapter: `cargo run -p build_test > build_test.ppm`

fn main() -> std::process::ExitCode {
    common::engine::main(256, build_test::picture)
}
