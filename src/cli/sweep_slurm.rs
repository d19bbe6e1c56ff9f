//! `seacable sweep --slurm`: submits the load cases as a job array, watches it, submits again what is missing, and gathers the results.

use std::path::PathBuf;
use std::process::ExitCode;
use std::time::{Duration, Instant};

use super::{
    CommandError, output,
    progress::ProgressLine,
    signals::StopFlag,
    slurm_refusals::{self, failed, usage},
    slurm_words,
    sweep_args::SweepArgs,
    sweep_compute::words,
};
use seacable_base::files::{read, unsaved::Unsaved};
use seacable_base::limits;
use seacable_studies::study::sweep::slurm::{
    CommandFailed, Division, Queue, Script, SlurmFile, SlurmRecord, Submission, array_list,
    check_of_file, submit,
};
use seacable_studies::study::sweep::{
    Sweep, SweepError, SweepFolder, SweepOutcomes, SweepProgress, SweepResults,
};

/// Arrays that one command submits, or finds in the queue, at most.
const MOST_SUBMISSIONS: usize = 3;
/// Between two looks at the queue: at first, and at most.
const PAUSES: [Duration; 2] = [Duration::from_secs(2), Duration::from_secs(30)];
/// A look takes no more than this share of the time.
const SHARE_OF_LOOKS: u32 = 10;
/// How long `squeue` may fail while an array is watched, as it does while its server is started again.
const PATIENCE: Duration = Duration::from_secs(300);
/// How soon a signal is seen.
const NAP: Duration = Duration::from_millis(50);

/// How the watching ended.
pub(super) enum WatchEnd {
    /// All load cases have ended.
    Gathered(SweepOutcomes),
    /// A signal ended the watching; the array goes on.
    Left(ExitCode),
}

/// A sweep on the cluster, and what is known of it.
struct Watch<'a> {
    sweep: &'a Sweep,
    folder: &'a SweepFolder,
    stop: &'a StopFlag,
    /// The folder, absolute.
    dir: PathBuf,
    file: SlurmFile,
    record: SlurmRecord,
    queue: Queue,
}

/// Has all load cases computed.
pub(super) fn compute(
    args: &SweepArgs,
    sweep: &Sweep,
    folder: &SweepFolder,
    stop: &StopFlag,
) -> Result<WatchEnd, CommandError> {
    if matches!(sweep.results, SweepResults::AtRest(_)) {
        return Err(slurm_refusals::at_rest());
    }
    let mut watch = Watch::begin(args, sweep, folder, stop)?;
    let mut submitted = usize::from(watch.queue.is_active());
    loop {
        if submitted > 0
            && let Some(status) = watch.wait()?
        {
            return Ok(WatchEnd::Left(status));
        }
        let first = watch.record.submissions.is_empty();
        let missing = sweep.missing(folder, first).map_err(usage)?;
        if missing.is_empty() {
            return watch.gather().map(WatchEnd::Gathered);
        }
        if submitted == MOST_SUBMISSIONS {
            let Watch {
                dir, record, queue, ..
            } = &watch;
            let words = slurm_words::given_up(dir, record, queue, &missing, MOST_SUBMISSIONS);
            return Err(CommandError::Usage(words));
        }
        watch.submit(&missing)?;
        submitted += 1;
    }
}

impl<'a> Watch<'a> {
    /// Looks what is there: the record, and an array in the queue.
    fn begin(
        args: &SweepArgs,
        sweep: &'a Sweep,
        folder: &'a SweepFolder,
        stop: &'a StopFlag,
    ) -> Result<Self, CommandError> {
        let dir = std::path::absolute(folder.dir()).map_err(|source| {
            let file = folder.dir().to_owned();
            usage(SweepError::Io { file, source })
        })?;
        let of = sweep.variation.points.len();
        let (file, known) = SlurmFile::of_folder(&dir, of).map_err(usage)?;
        if let Some(record) = known
            .as_ref()
            .filter(|_| args.slurm.slurm_option.is_empty())
        {
            let checked = check_of_file(&record.options);
            checked.map_err(|error| CommandError::Usage(error.to_string()))?;
        }
        let queue = match &known {
            Some(record) => Queue::look(record).map_err(|error| failed(&error))?,
            None => Queue::default(),
        };
        let usual = || SlurmRecord::new(&dir, Division::usual(of), 1, Vec::new());
        let mut watch = Self {
            sweep,
            folder,
            stop,
            record: known.unwrap_or_else(usual),
            dir,
            file,
            queue,
        };
        match watch.queue.is_active() {
            true => watch.found(args)?,
            false => watch.take(args)?,
        }
        Ok(watch)
    }

    /// Takes over what was asked for, and makes room for what is computed anew.
    fn take(&mut self, args: &SweepArgs) -> Result<(), CommandError> {
        let record = &mut self.record;
        if let Some(cases) = args.slurm.cases_per_task {
            record.cases_per_task = cases.min(record.load_cases);
        }
        record.cores_per_task = args.jobs.unwrap_or(record.cores_per_task);
        if !args.slurm.slurm_option.is_empty() {
            record.options.clone_from(&args.slurm.slurm_option);
        }
        self.folder.remove_parts(false).map_err(usage)?;
        self.sweep.clear_stopped(self.folder).map_err(usage)
    }

    /// Says which array goes on, which nothing can be asked of any more.
    fn found(&self, args: &SweepArgs) -> Result<(), CommandError> {
        let jobs = self.queue.job_words();
        let record = &self.record;
        let differs = args
            .slurm
            .cases_per_task
            .is_some_and(|cases| cases != record.cases_per_task)
            || args
                .jobs
                .is_some_and(|cores| cores != record.cores_per_task)
            || !args.slurm.slurm_option.is_empty() && args.slurm.slurm_option != record.options;
        if differs {
            return Err(CommandError::Usage(format!(
                "Slurm's {jobs} of this sweep goes on as it was submitted: leave out --cases-per-task, --jobs and --slurm-option, or end it with scancel first."
            )));
        }
        output::message(&format!(
            "Found Slurm's {jobs} of this sweep: {}.",
            self.queue.words()
        ));
        Ok(())
    }

    /// Submits the tasks that have these load cases.
    fn submit(&mut self, missing: &[usize]) -> Result<(), CommandError> {
        // An array that is not recorded is not found again.
        let _unrecorded = Unsaved::begin();
        let division = self.record.division();
        let tasks = division.tasks_of(missing);
        self.record.gathered = false;
        self.file.write(&self.record).map_err(usage)?;
        self.write_script()?;
        let list = array_list(&tasks);
        let job = submit(&self.dir, &self.record, &list).map_err(|error| failed(&error))?;
        let words =
            slurm_words::submitted(&self.record, &self.queue, (missing.len(), tasks.len()), job);
        self.record.submissions.push(Submission::now(job, list));
        self.file.write(&self.record).map_err(usage)?;
        output::message(&words);
        Ok(())
    }

    fn write_script(&self) -> Result<(), CommandError> {
        let program = std::env::current_exe();
        let program = program.map_err(|error| {
            CommandError::Usage(format!("The place of this program is not known: {error}."))
        })?;
        let size = read::given_limit().map(|bytes| format!("--limit-file-size={bytes}"));
        let options: Vec<String> = limits::lifted().into_iter().chain(size).collect();
        let script = Script {
            program: &program,
            dir: &self.dir,
            job_name: &self.record.job_name,
            division: self.record.division(),
            cores: self.record.cores_per_task,
            options: &options,
            slurm_options: &self.record.options,
        };
        self.file.write_script(&script).map_err(usage)?;
        self.folder.make_room_for_parts().map_err(usage)?;
        Ok(())
    }

    /// Waits until no task is left in the queue; the exit status where a signal ends it before.
    fn wait(&mut self) -> Result<Option<ExitCode>, CommandError> {
        let left = slurm_words::left(&self.queue, self.folder.dir());
        self.stop.say_at_the_end(&left);
        let (mut line, begun) = (ProgressLine::new(), Instant::now());
        let (mut stored, mut answered, [mut pause, longest]) = (None, begun, PAUSES);
        loop {
            let looked = Instant::now();
            match Queue::look(&self.record) {
                Err(error @ CommandFailed::NotRun { .. }) => return Err(failed(&error)),
                Err(error) if answered.elapsed() > PATIENCE => return Err(failed(&error)),
                Err(_) => {}
                Ok(queue) => {
                    self.queue = queue;
                    answered = Instant::now();
                    if !self.queue.is_active() {
                        return Ok(None);
                    }
                    let done = self.stored()?;
                    let stored = *stored.get_or_insert(done);
                    let of = self.record.load_cases;
                    let words = words(
                        SweepProgress { done, stored, of },
                        begun.elapsed().as_secs_f64(),
                    );
                    line.show(&format!("{words}; {}", self.queue.words()));
                }
            }
            if let Some(status) = self.rest(pause.max(looked.elapsed() * SHARE_OF_LOOKS)) {
                drop(line);
                output::message(&slurm_words::left(&self.queue, self.folder.dir()));
                return Ok(Some(status));
            }
            pause = (pause * 3 / 2).min(longest);
        }
    }

    /// Rests; the exit status of a signal that came.
    fn rest(&self, pause: Duration) -> Option<ExitCode> {
        let begun = Instant::now();
        while begun.elapsed() < pause && self.stop.status().is_none() {
            std::thread::sleep(NAP);
        }
        self.stop.status()
    }

    /// Number of runs that are stored.
    fn stored(&self) -> Result<usize, CommandError> {
        let taken = self
            .folder
            .places_taken(self.record.load_cases)
            .map_err(usage)?;
        Ok(taken.into_iter().filter(|taken| *taken).count())
    }

    /// Reads all runs, and puts away what is of no use any more.
    fn gather(&mut self) -> Result<SweepOutcomes, CommandError> {
        let outcomes = self.sweep.gather(self.folder).map_err(usage)?;
        self.folder.remove_parts(true).map_err(usage)?;
        if !self.record.submissions.is_empty() && !self.record.gathered {
            self.record.gathered = true;
            self.file.write(&self.record).map_err(usage)?;
        }
        Ok(outcomes)
    }
}
