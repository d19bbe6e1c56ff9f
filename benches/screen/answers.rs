//! From the key that steps an input to the coarse answer beside it, and to the full one.

use std::time::{Duration, Instant};

use super::pty::Pty;
use super::times::Times;

const RIGHT: &str = "\x1b[C";
const COARSE: &str = "coarse: the full solve goes on";

/// Steps the duration of the case ten times, and waits for both answers to each step.
pub(super) fn print(screen: &mut Pty) {
    screen.send("/duration\r");
    solved(screen);
    let (mut coarse, mut full, mut none) = (Times::default(), Times::default(), 0);
    for _ in 0..10 {
        let before = screen.text();
        let began = Instant::now();
        screen.send(RIGHT);
        let seen = std::cell::Cell::new(false);
        screen.wait("an answer", |screen| {
            let text = screen.contents();
            seen.set(text.contains(COARSE));
            seen.get() || (text != before && !unsolved(&text))
        });
        // A short case answers in full at once.
        if seen.get() {
            coarse.add(began.elapsed());
        } else {
            none += 1;
        }
        full.add(solved(screen).saturating_duration_since(began));
        std::thread::sleep(Duration::from_millis(50));
    }
    match none {
        10 => println!("{:44}none, the case is short", "key to coarse answer"),
        _ => println!("{:44}{}", "key to coarse answer", coarse.words()),
    }
    println!("{:44}{}", "key to full answer", full.words());
}

fn unsolved(text: &str) -> bool {
    ["coarse", "older than the inputs", "solving"]
        .iter()
        .any(|word| text.contains(word))
}

/// When the full answer is there: still there a little later, and not half of a frame.
fn solved(screen: &Pty) -> Instant {
    let whole = |text: &str| text.contains("results") && !unsolved(text);
    loop {
        screen.wait("the full answer", |screen| whole(&screen.contents()));
        let at = Instant::now();
        std::thread::sleep(Duration::from_millis(30));
        if whole(&screen.text()) {
            return at;
        }
    }
}
