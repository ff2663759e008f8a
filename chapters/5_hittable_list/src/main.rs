//! Prints the picture of this chapter: `cargo run -p hittable_list > hittable_list.ppm`

fn main() -> std::process::ExitCode {
    common::chapter::main(|| hittable_list::picture(400))
}
