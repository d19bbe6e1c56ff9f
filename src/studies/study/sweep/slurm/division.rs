//! Which task computes which load cases.

use std::collections::BTreeSet;

use crate::study::sweep::SweepPart;

/// Tasks of an array, where the user does not say how many load cases each has: Slurm allows 1001 unless it is told otherwise.
const MOST_TASKS: usize = 1000;

/// The load cases of a sweep shared out to tasks, each of which has as many that follow one another.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Division {
    /// Load cases in all.
    pub load_cases: usize,
    /// Load cases of a task, one at least; the last task may have fewer.
    pub by_task: usize,
}

impl Division {
    /// The smallest tasks of which there are 1000 at most.
    #[must_use]
    pub fn usual(load_cases: usize) -> Self {
        Self {
            load_cases,
            by_task: load_cases.div_ceil(MOST_TASKS).max(1),
        }
    }

    /// Number of tasks; they are numbered from 0.
    #[must_use]
    pub fn tasks(self) -> usize {
        self.load_cases.div_ceil(self.by_task.max(1))
    }

    /// The load cases of a task.
    #[must_use]
    pub fn part(self, task: usize) -> SweepPart {
        SweepPart {
            first: task * self.by_task + 1,
            last: ((task + 1) * self.by_task).min(self.load_cases),
        }
    }

    /// The tasks that have any of these load cases, given by their places in the list, in ascending order.
    #[must_use]
    pub fn tasks_of(self, load_cases: &[usize]) -> Vec<usize> {
        let tasks = load_cases.iter().map(|index| index / self.by_task.max(1));
        tasks.collect::<BTreeSet<usize>>().into_iter().collect()
    }
}

/// Ascending numbers as `sbatch --array` takes them: `0-3,7`.
#[must_use]
pub fn array_list(numbers: &[usize]) -> String {
    let mut ranges: Vec<(usize, usize)> = Vec::new();
    for number in numbers {
        match ranges.last_mut() {
            Some((_, last)) if *last + 1 == *number => *last = *number,
            _ => ranges.push((*number, *number)),
        }
    }
    let words = ranges.iter().map(|(first, last)| match last - first {
        0 => first.to_string(),
        _ => format!("{first}-{last}"),
    });
    words.collect::<Vec<String>>().join(",")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_thousand_tasks_are_enough() {
        for (load_cases, by_task, tasks) in [
            (1, 1, 1),
            (200, 1, 200),
            (1000, 1, 1000),
            (1001, 2, 501),
            (1_000_000, 1000, 1000),
        ] {
            let division = Division::usual(load_cases);
            assert_eq!((division.by_task, division.tasks()), (by_task, tasks));
        }
    }

    #[test]
    fn parts_follow_each_other_to_the_last_load_case() {
        let division = Division {
            load_cases: 11,
            by_task: 4,
        };
        let parts = (0..division.tasks()).map(|task| division.part(task));
        let ends: Vec<_> = parts.map(|part| (part.first, part.last)).collect();
        assert_eq!(ends, [(1, 4), (5, 8), (9, 11)]);
    }

    #[test]
    fn only_tasks_with_missing_load_cases_are_submitted_again() {
        let division = Division {
            load_cases: 40,
            by_task: 4,
        };
        assert_eq!(division.tasks_of(&[0, 1, 7, 8, 12, 39]), [0, 1, 2, 3, 9]);
        assert!(division.tasks_of(&[]).is_empty());
    }

    #[test]
    fn numbers_that_follow_each_other_are_a_range() {
        for (numbers, words) in [
            (&[0, 1, 2, 3, 7][..], "0-3,7"),
            (&[5], "5"),
            (&[1, 3, 4, 9, 10], "1,3-4,9-10"),
            (&[], ""),
        ] {
            assert_eq!(array_list(numbers), words);
        }
    }
}
