//! The commands that compare methods: what does each say of good input and bad?

mod hit_command;
mod needs_command;
