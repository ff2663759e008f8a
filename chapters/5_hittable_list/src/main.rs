//! Prints the picture of this chapter: `cargo run -p hittable_list > hittable_list.ppm`

fn main() -> std::process::ExitCode {
    common::engine::main(400, hittable_list::picture)
}
