//! Prints the picture of this chapter: `cargo run -p speed_vs_accuracy > speed_vs_accuracy.ppm`

fn main() -> std::process::ExitCode {
    common::engine::main(400, speed_vs_accuracy::picture)
}
