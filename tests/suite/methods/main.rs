//! Chapter 6: is each method as right, as exact and as it is said to be?

mod campaign;
mod leaving;
mod measured;
mod methods;
mod oracle;
mod pictures;
mod proofs;
mod several_spheres;
mod shadow_oracle;
mod speed_vs_accuracy;
mod stability;
mod witnesses;
