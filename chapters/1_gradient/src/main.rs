//! Prints the picture of this chapter: `cargo run -p gradient > gradient.ppm`

fn main() -> std::process::ExitCode {
    common::engine::main(400, gradient::picture)
}
