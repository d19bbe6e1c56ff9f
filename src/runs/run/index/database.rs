//! The database file: its name, its tables, and what is done when it is damaged.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::Duration;

use rusqlite::{Connection, ErrorCode};

use super::IndexError;
use crate::case::TextDigest;
use crate::files::disk;

/// Another number makes every index anew.
const VERSION: i64 = 1;

/// How long one program waits for another that writes.
const PATIENCE: Duration = Duration::from_secs(10);

const TABLES: &str = "
    CREATE TABLE runs (
        id INTEGER PRIMARY KEY AUTOINCREMENT,
        name TEXT NOT NULL UNIQUE,
        stamp TEXT NOT NULL,
        change INTEGER NOT NULL,
        case_file TEXT NOT NULL,
        state TEXT NOT NULL,
        failure TEXT,
        damaged INTEGER NOT NULL,
        started TEXT NOT NULL,
        method TEXT NOT NULL,
        duration_s REAL NOT NULL,
        steps INTEGER NOT NULL,
        cpu_s REAL NOT NULL,
        overrides TEXT NOT NULL,
        text INTEGER NOT NULL,
        notes TEXT NOT NULL
    );
    CREATE INDEX runs_of_case ON runs (case_file, change);
    CREATE TABLE counter (change INTEGER NOT NULL);
    INSERT INTO counter VALUES (0);
    CREATE TABLE names (id INTEGER PRIMARY KEY, name TEXT NOT NULL UNIQUE);
    CREATE TABLE baselines (case_file TEXT PRIMARY KEY, inputs TEXT NOT NULL);
    CREATE TABLE inputs (
        key INTEGER NOT NULL, run INTEGER NOT NULL, value TEXT, PRIMARY KEY (key, run)
    ) WITHOUT ROWID;
    CREATE INDEX inputs_of_run ON inputs (run);
    CREATE TABLE results (
        result INTEGER NOT NULL, run INTEGER NOT NULL, value REAL NOT NULL, unit TEXT NOT NULL,
        error REAL, least REAL, greatest REAL, PRIMARY KEY (result, run)
    ) WITHOUT ROWID;
    CREATE INDEX results_of_run ON results (run);
";

/// The name of the database for a directory of runs on this host.
pub(super) fn file_name(root: &Path) -> String {
    let root = std::path::absolute(root).unwrap_or_else(|_| root.to_owned());
    let root = fs::canonicalize(&root).unwrap_or(root);
    let host = rustix::system::uname();
    let host = host.nodename().to_string_lossy().into_owned();
    let digest = TextDigest::of_text(&format!("{host}:{}", root.display())).0;
    format!("runs-{digest:016x}.sqlite")
}

/// Opens or makes a database; in memory where no file is asked for or none can be written.
pub(super) fn open(file: Option<PathBuf>) -> Result<(Connection, Option<PathBuf>), IndexError> {
    if let Some(file) = file {
        if let Some(folder) = file.parent() {
            // Where that fails, so does what follows.
            let _ = disk::create_dir_all(folder);
        }
        let opened = at(&file).or_else(|error| {
            if is_damaged(&IndexError::Database(error)) {
                remove(Some(&file));
            }
            at(&file)
        });
        if let Ok(database) = opened {
            return Ok((database, Some(file)));
        }
    }
    let mut database = Connection::open_in_memory()?;
    prepare(&mut database)?;
    Ok((database, None))
}

fn at(file: &Path) -> rusqlite::Result<Connection> {
    let mut database = Connection::open(file)?;
    database.busy_timeout(PATIENCE)?;
    prepare(&mut database)?;
    Ok(database)
}

/// Makes the tables where they are of another version, in one step, so that of two programs one does it.
fn prepare(database: &mut Connection) -> rusqlite::Result<()> {
    let version = |database: &Connection| {
        database.pragma_query_value(None, "user_version", |row| row.get::<_, i64>(0))
    };
    if version(database)? == VERSION {
        return Ok(());
    }
    let step = database.transaction_with_behavior(rusqlite::TransactionBehavior::Immediate)?;
    if version(&step)? != VERSION {
        for table in ["runs", "counter", "names", "baselines", "inputs", "results"] {
            step.execute_batch(&format!("DROP TABLE IF EXISTS {table};"))?;
        }
        step.execute_batch(TABLES)?;
        step.pragma_update(None, "user_version", VERSION)?;
    }
    step.commit()
}

/// Whether an error says that the file is no database any more, or one whose tables are not as they should be.
pub(super) fn is_damaged(error: &IndexError) -> bool {
    let IndexError::Database(error) = error else {
        return false;
    };
    match error {
        rusqlite::Error::SqliteFailure(why, words) => {
            let tables = words.as_deref().is_some_and(|w| w.starts_with("no such"));
            tables
                || matches!(
                    why.code,
                    ErrorCode::DatabaseCorrupt | ErrorCode::NotADatabase | ErrorCode::TypeMismatch
                )
        }
        rusqlite::Error::InvalidColumnType(..)
        | rusqlite::Error::FromSqlConversionFailure(..)
        | rusqlite::Error::IntegralValueOutOfRange(..) => true,
        rusqlite::Error::SqlInputError { msg, .. } => msg.starts_with("no such"),
        _ => false,
    }
}

/// Removes a database and what belongs to it.
pub(super) fn remove(file: Option<&Path>) {
    let Some(file) = file else {
        return;
    };
    for end in ["", "-journal", "-wal", "-shm"] {
        let mut name = file.as_os_str().to_owned();
        name.push(end);
        // Best effort: what cannot be removed cannot be opened either, and memory serves.
        let _ = disk::remove_file(Path::new(&name));
    }
}
