//! The program inside tmux, behind an SSH server and on a cluster, as its users meet it.
//!
//! Needs tmux, OpenSSH and Slurm, so a plain `cargo test` lists these tests as ignored and says why;
//! `.ci/run` installs what is missing and runs them with
//! `cargo test --test real_programs -- --ignored`. Asked for, they fail where a program is missing.

#![cfg(target_os = "linux")]
#![expect(clippy::unwrap_used, reason = "a test may panic")]

#[path = "../program/chance.rs"]
mod chance;
mod job_links;
#[path = "../common/jobs.rs"]
mod jobs;
#[path = "../common/pty.rs"]
#[expect(dead_code, reason = "other tests use the rest")]
mod pty;
mod slurm;
mod slurm_servers;
#[path = "../common/small.rs"]
mod small;
mod ssh;
mod sshd;
mod tmux;
mod work;
