//! Prints the picture of this chapter: `cargo run -p speed_vs_accuracy > speed_vs_accuracy.ppm`

fn main() -> std::process::ExitCode {
    common::chapter::main(|| speed_vs_accuracy::picture(400))
}
