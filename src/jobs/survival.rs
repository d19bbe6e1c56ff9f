//! Whether jobs outlive the login: systemd's logind may end all processes of a user at the last logout (`KillUserProcesses`).

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use crate::files::read;

/// Where settings of logind are, the first overriding those after it.
const PLACES: [&str; 4] = [
    "etc/systemd",
    "run/systemd",
    "usr/local/lib/systemd",
    "usr/lib/systemd",
];

/// The setting.
const KEY: &str = "KillUserProcesses";

/// Why jobs of this user end with the login, and what to do about it; nothing where they go on, as far as is known.
#[must_use]
pub fn ended_by_logout() -> Option<String> {
    let user = std::env::var("USER").or_else(|_| std::env::var("LOGNAME"));
    let cgroup = read::text(Path::new("/proc/self/cgroup")).unwrap_or_default();
    ended_by_logout_at(Path::new("/"), &user.unwrap_or_default(), &cgroup)
}

/// The same with the files below another directory.
fn ended_by_logout_at(root: &Path, user: &str, cgroup: &str) -> Option<String> {
    let lingers = !user.is_empty() && root.join("var/lib/systemd/linger").join(user).exists();
    let unit = |suffix: &str, prefix: &str| {
        let mut parts = cgroup.lines().flat_map(|line| line.split('/'));
        parts.any(|part| part.ends_with(suffix) && part.starts_with(prefix))
    };
    if unit(".scope", "session-") && kills(root) {
        return Some(
            "logind ends all processes of a session at its logout (KillUserProcesses=yes), jobs of seacable too. \
             `loginctl enable-linger`, and start it by `systemd-run --user --scope seacable`: then they go on."
                .to_owned(),
        );
    }
    let is_service = unit(".service", "user@");
    (is_service && !lingers).then(|| {
        "systemd ends the processes of this unit at the last logout, jobs of seacable too; \
         `loginctl enable-linger` lets them go on."
            .to_owned()
    })
}

/// Whether logind ends processes: the last setting among the main file and those beside it, in the order of their names. The superuser
/// is left out by default, but may be named.
fn kills(root: &Path) -> bool {
    let main = PLACES
        .iter()
        .map(|place| root.join(place).join("logind.conf"));
    let main = main.map(|path| read::text(&path)).find_map(Result::ok);
    let main = main.unwrap_or_default();
    let texts = std::iter::once(main).chain(further(root));
    let values: Vec<bool> = texts.filter_map(|text| value(&text)).collect();
    let is_root = rustix::process::geteuid().is_root();
    values.last().copied().unwrap_or(false) && !is_root
}

/// The files in the folders `logind.conf.d`, each name once.
fn further(root: &Path) -> Vec<String> {
    let mut files: BTreeMap<std::ffi::OsString, PathBuf> = BTreeMap::new();
    for place in PLACES {
        let dir = root.join(place).join("logind.conf.d");
        let inside = fs::read_dir(dir).into_iter().flatten().flatten();
        for item in inside.filter(|item| item.path().extension().is_some_and(|e| e == "conf")) {
            files.entry(item.file_name()).or_insert_with(|| item.path());
        }
    }
    let texts = files.values().map(|path| read::text(path));
    texts.filter_map(Result::ok).collect()
}

/// The last value of the setting in a file. A comment of the file that comes with systemd states what is built in, and counts for nothing
/// here: distributions that end processes say so themselves.
fn value(text: &str) -> Option<bool> {
    let settings = text.lines().filter_map(|line| line.split_once('='));
    let mut ours = settings.filter(|(key, _)| key.trim() == KEY);
    let (_, value) = ours.next_back()?;
    let value = value.trim().to_lowercase();
    Some(["yes", "true", "on", "1", "y", "t"].contains(&value.as_str()))
}

#[cfg(test)]
mod tests {
    use super::*;

    const SESSION: &str = "0::/user.slice/user-1000.slice/session-3.scope\n";
    const SERVICE: &str =
        "0::/user.slice/user-1000.slice/user@1000.service/app.slice/run-7.scope\n";

    fn write(root: &Path, name: &str, text: &str) {
        let path = root.join(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    }

    #[test]
    fn the_last_setting_counts() {
        let dir = tempfile::tempdir().unwrap();
        let root = dir.path();
        let value_of = || further(root).iter().rev().find_map(|text| value(text));
        assert_eq!(value_of(), None);
        write(
            root,
            "usr/lib/systemd/logind.conf.d/50.conf",
            "[Login]\nKillUserProcesses=yes\n",
        );
        assert_eq!(value_of(), Some(true));
        write(
            root,
            "etc/systemd/logind.conf.d/50.conf",
            "[Login]\n KillUserProcesses = no\n",
        );
        assert_eq!(value_of(), Some(false));
        write(
            root,
            "run/systemd/logind.conf.d/60.conf",
            "[Login]\nKillUserProcesses=1\n",
        );
        assert_eq!(value_of(), Some(true));
        assert_eq!(value("#KillUserProcesses=yes\n"), None);
    }

    #[test]
    fn processes_of_a_session_end_where_logind_is_told_so() {
        let dir = tempfile::tempdir().unwrap();
        let root = dir.path();
        let ended = |cgroup| ended_by_logout_at(root, "anna", cgroup);
        assert_eq!(ended(SESSION), None);
        assert_eq!(ended("0::/\n"), None);
        write(
            root,
            "etc/systemd/logind.conf",
            "[Login]\nKillUserProcesses=yes\n",
        );
        let is_root = rustix::process::geteuid().is_root();
        assert_eq!(ended(SESSION).is_none(), is_root);
        assert!(ended(SERVICE).unwrap().contains("enable-linger"));
        write(root, "var/lib/systemd/linger/anna", "");
        assert_eq!(ended(SERVICE), None);
    }
}
