//! The time of day in UTC, as text.

use std::time::{Duration, SystemTime, UNIX_EPOCH};

use time::OffsetDateTime;

use crate::files::faults;

/// What the clock shows.
#[must_use]
pub fn now() -> SystemTime {
    faults::clock().unwrap_or_else(SystemTime::now)
}

/// `2026-11-21T06:11:26Z` (RFC 3339, UTC).
#[must_use]
pub fn rfc3339(at: SystemTime) -> String {
    let [year, month, day, hour, minute, second] = civil(at);
    format!("{year:04}-{month:02}-{day:02}T{hour:02}:{minute:02}:{second:02}Z")
}

/// `20261121-061126`, for file names.
#[must_use]
pub fn stamp(at: SystemTime) -> String {
    let [year, month, day, hour, minute, second] = civil(at);
    format!("{year:04}{month:02}{day:02}-{hour:02}{minute:02}{second:02}")
}

/// The last second of the year 9999.
const LAST: Duration = Duration::from_secs(253_402_300_799);

/// Year, month, day, hour, minute, second in UTC; clocks before 1970 read as 1970, and those after 9999 as its end.
fn civil(at: SystemTime) -> [i32; 6] {
    let at = OffsetDateTime::from(at.clamp(UNIX_EPOCH, UNIX_EPOCH + LAST));
    let (year, month, day) = at.to_calendar_date();
    let [day, hour, minute, second] = [day, at.hour(), at.minute(), at.second()].map(i32::from);
    [year, i32::from(u8::from(month)), day, hour, minute, second]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn days_that_calendars_get_wrong() {
        let at = |s| rfc3339(UNIX_EPOCH + Duration::from_secs(s));
        assert_eq!(at(0), "1970-01-01T00:00:00Z");
        assert_eq!(at(1 << 60), "9999-12-31T23:59:59Z");
        assert_eq!(at(951_782_399), "2000-02-28T23:59:59Z");
        assert_eq!(at(951_782_400), "2000-02-29T00:00:00Z");
        assert_eq!(at(1_709_251_199), "2024-02-29T23:59:59Z");
        assert_eq!(at(4_107_542_400), "2100-03-01T00:00:00Z");
        assert_eq!(
            stamp(UNIX_EPOCH + Duration::from_secs(1_798_761_599)),
            "20261231-235959"
        );
    }
}
