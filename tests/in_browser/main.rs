//! HTML reports in a real browser.
//!
//! Needs Chromium (`chromium` of Debian, or what `SEACABLE_CHROMIUM` names), so a plain `cargo test` lists these tests as ignored;
//! `.ci/run` installs it and runs them with `cargo test --test in_browser -- --ignored --nocapture`. Without it they fail.
//!
//! A page is opened with scripts off, as whoever receives a report may have them, and printed as PDF.

#![expect(clippy::unwrap_used, reason = "a test may panic")]

mod chromium;
mod pages;
mod pdf;

use chromium::{Browser, Measured};
use pages::pages;
use pdf::Pdf;

/// Width and height of an A4 page \[pt\].
const A4: (f64, f64) = (595.276, 841.89);

/// What names or loads something outside a page, or runs.
const ACTIVE: [&str; 12] = [
    "<script",
    "<iframe",
    "<object",
    "<embed",
    "<link",
    "<img",
    "<image",
    "javascript:",
    "src=",
    "href=",
    "url(",
    "@import",
];

/// Scripts are off where the tests say so.
#[test]
#[ignore = "needs Chromium"]
fn a_browser_without_scripts_runs_none() {
    let script = "<body><p id=\"a\">before</p><script>document.getElementById('a').textContent = 'after'</script></body>";
    assert!(Browser::new().dom(script).contains(">before<"));
}

#[test]
#[ignore = "needs Chromium"]
fn pages_need_no_script_and_load_nothing() {
    let browser = Browser::new();
    for page in pages() {
        for word in ACTIVE {
            assert!(!page.html.contains(word), "{}: {word}", page.name);
        }
        let handlers = page.html.split('<').filter_map(|tag| tag.split('>').next());
        for tag in handlers.filter(|tag| tag.contains(" on")) {
            let attributes = tag.split('"').step_by(2);
            assert!(
                attributes.clone().all(|word| !word.contains(" on")),
                "{}: {tag}",
                page.name
            );
        }
        let dom = browser.dom(&page.html);
        for part in [
            "<h1", "<h2", "<table", "<tr", "<td", "<svg", "<path", "<text",
        ] {
            let (given, there) = (page.html.matches(part).count(), dom.matches(part).count());
            assert!(
                given > 0 && given == there,
                "{}: {part}: {given} {there}",
                page.name
            );
        }
    }
}

#[test]
#[ignore = "needs Chromium"]
fn pages_print_on_a4_and_nothing_is_cut() {
    let browser = Browser::new();
    for page in pages() {
        let Measured { reach, width, .. } = browser.measured(&page.html);
        assert!(
            reach <= width + 0.5,
            "{}: reaches {reach} of {width} px",
            page.name
        );
        let pdf = Pdf::new(&browser.pdf(&page.html));
        assert!(!pdf.pages.is_empty(), "{}", page.name);
        for (width, height) in &pdf.pages {
            let off = (width - A4.0).abs().max((height - A4.1).abs());
            assert!(off < 1.0, "{}: {width} {height}", page.name);
        }
        let sizes = (page.html.len() / 1024, pdf.bytes / 1024, pdf.pages.len());
        println!(
            "{}: {} KB of HTML, {} KB of PDF, {} pages, reaches {reach} of {width} px",
            page.name, sizes.0, sizes.1, sizes.2
        );
    }
}

#[test]
#[ignore = "needs Chromium"]
fn charts_are_printed_as_lines_and_words() {
    let browser = Browser::new();
    for page in pages() {
        let pdf = Pdf::new(&browser.pdf(&page.html));
        assert_eq!(pdf.images, 0, "{}", page.name);
        assert!(pdf.fonts > 0, "{}", page.name);
    }
}

/// Words are dark enough on white to be read in greys, as the browser shows them (WCAG 2.1, level AA).
#[test]
#[ignore = "needs Chromium"]
fn words_are_readable_without_colour() {
    let browser = Browser::new();
    for page in pages() {
        let colours = browser.measured(&page.html).colours;
        assert!(!colours.is_empty(), "{}", page.name);
        for colour in colours {
            let contrast = 1.05 / (luminance(colour) + 0.05);
            assert!(contrast >= 4.5, "{}: {colour:?} {contrast}", page.name);
        }
    }
}

/// The luminance of red, green and blue (WCAG 2.1), from 0 for black to 1 for white.
fn luminance(colour: [u8; 3]) -> f64 {
    let [red, green, blue] = colour.map(|part| {
        let value = f64::from(part) / 255.0;
        match value <= 0.04045 {
            true => value / 12.92,
            false => ((value + 0.055) / 1.055).powf(2.4),
        }
    });
    0.2126 * red + 0.7152 * green + 0.0722 * blue
}
