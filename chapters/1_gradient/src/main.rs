//! Prints the picture of this chapter: `cargo run -p gradient > gradient.ppm`

fn main() -> std::process::ExitCode {
    common::chapter::main(|| gradient::picture(400))
}
