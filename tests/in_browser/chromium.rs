//! Chromium without a window.

use std::fs;
use std::process::Command;

/// What is asked of every start: nothing of its own on the network, nothing remembered.
const QUIET: [&str; 10] = [
    "--headless",
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--disable-dev-shm-usage",
    "--no-pdf-header-footer",
];

/// The setting of a profile in which no page may run scripts. With `--blink-settings=scriptEnabled=false` the browser cannot print or dump
/// a page either, which it does by scripts of its own.
const NO_SCRIPTS: &str = r#"{"profile":{"default_content_setting_values":{"javascript":2}}}"#;

/// Width of a printed page between its margins [px].
const PRINTED: f64 = 180.0 / 25.4 * 96.0;

/// Measures the page in its printed width: the right edge of what reaches furthest, and the colours of words.
const SCRIPT: &str = "<script>\
document.body.style.cssText = 'max-width:none;margin:0;padding:0;width:180mm';\
let reach = 0; const colours = new Set();\
for (const e of document.body.querySelectorAll('*')) {\
  reach = Math.max(reach, e.getBoundingClientRect().right);\
  for (const n of e.childNodes) if (n.nodeType == 3 && n.data.trim()) {\
    const s = getComputedStyle(e);\
    colours.add(e instanceof SVGElement ? s.fill : s.color);\
  }\
}\
document.body.innerHTML = '<p id=measured>' + reach + '|' + [...colours].join('|') + '</p>';\
</script>";

/// What a browser says of a page.
pub(crate) struct Measured {
    /// How far to the right anything reaches [px].
    pub(crate) reach: f64,
    /// How wide a printed page is [px].
    pub(crate) width: f64,
    /// The colours of words.
    pub(crate) colours: Vec<[u8; 3]>,
}

/// A browser with a directory for its pages.
pub(crate) struct Browser {
    program: String,
    dir: tempfile::TempDir,
}

impl Browser {
    pub(crate) fn new() -> Self {
        let program = std::env::var("SEACABLE_CHROMIUM");
        Self {
            program: program.unwrap_or_else(|_| "chromium".to_owned()),
            dir: tempfile::tempdir().unwrap(),
        }
    }

    /// Opens a page, with scripts on or off; what is printed on standard output.
    fn open(&self, html: &str, scripts: bool, options: &[&str]) -> Vec<u8> {
        let profile = tempfile::tempdir().unwrap();
        if !scripts {
            fs::create_dir(profile.path().join("Default")).unwrap();
            fs::write(profile.path().join("Default/Preferences"), NO_SCRIPTS).unwrap();
        }
        let file = self.dir.path().join("page.html");
        fs::write(&file, html).unwrap();
        let output = Command::new(&self.program)
            .args(QUIET)
            .arg(format!("--user-data-dir={}", profile.path().display()))
            .args(options)
            .arg(format!("file://{}", file.display()))
            .output();
        let output = output.unwrap_or_else(|error| {
            panic!(
                "{} does not start: {error}; `.ci/run` installs it",
                self.program
            )
        });
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{said}");
        output.stdout
    }

    /// The page as the browser has it, with scripts off.
    pub(crate) fn dom(&self, html: &str) -> String {
        String::from_utf8(self.open(html, false, &["--dump-dom"])).unwrap()
    }

    /// The page printed as PDF, with scripts off.
    pub(crate) fn pdf(&self, html: &str) -> Vec<u8> {
        let file = self.dir.path().join("page.pdf");
        let print = format!("--print-to-pdf={}", file.display());
        self.open(html, false, &[&print]);
        fs::read(file).unwrap()
    }

    /// The page measured by a script of the test's own, which the policy of the page would not let run.
    pub(crate) fn measured(&self, html: &str) -> Measured {
        let policy = html
            .lines()
            .find(|line| line.contains("Content-Security-Policy"));
        let open = html.replace(policy.unwrap(), "");
        let page = open.replace("</body>", &format!("{SCRIPT}</body>"));
        let dom = String::from_utf8(self.open(&page, true, &["--dump-dom"])).unwrap();
        let said = dom.split("id=\"measured\">").nth(1).unwrap();
        let mut parts = said.split("</p>").next().unwrap().split('|');
        Measured {
            reach: parts.next().unwrap().parse().unwrap(),
            width: PRINTED,
            colours: parts.map(colour).collect(),
        }
    }
}

/// Red, green and blue of `rgb(1, 2, 3)`.
fn colour(words: &str) -> [u8; 3] {
    let numbers = words.trim_start_matches("rgb(").trim_end_matches(')');
    let parts: Vec<u8> = numbers
        .split(", ")
        .map(|part| part.parse().unwrap())
        .collect();
    parts.try_into().unwrap()
}
