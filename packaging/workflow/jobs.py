# SPDX-License-Identifier: GPL-3.0-or-later
"""The jobs of a table of recordings, and the shards of the accuracy suite, for the Snakefile beside this."""
import csv
import dataclasses
import itertools
import os
import pathlib
import re
import shlex

COLUMNS = ("recording", "project", "command", "truth", "methods", "seeds", "settings", "frames")
KEYS = ("table", "program", "methods", "seeds", "settings", "threads", "memory", "minutes", "suite")
SUITE_KEYS = ("scenarios", "grades", "methods", "first_seed", "seeds", "seeds_per_shard")
COMMANDS = ("track", "people")
# The truth of a simulated recording, which its run writes.
SIMULATED = "simulated"


class Failure(Exception):
    """What is wrong with the table or the configuration, in a sentence."""


@dataclasses.dataclass(frozen=True)
class Config:
    table: str
    program: str
    methods: tuple
    seeds: tuple
    settings: tuple
    threads: int
    memory: int
    minutes: int
    suite: dict


def strings(value, key):
    values = value if isinstance(value, (list, tuple)) else [value]
    if not all(isinstance(one, (str, int)) for one in values):
        raise Failure(f"configuration: {key} is a list of words")
    return tuple(str(one) for one in values)


def known(given, keys, where):
    for key in given:
        if key not in keys:
            raise Failure(f"{where}: there is no {key}; known are {', '.join(keys)}")


def whole(value, key, least):
    if isinstance(value, bool) or not isinstance(value, int) or value < least:
        raise Failure(f"configuration: {key} is a whole number from {least} on, not {value}")
    return value


def checked(config, folder="."):
    """The configuration, whose paths count from a folder."""
    known(config, KEYS, "configuration")
    suite = config.get("suite", {})
    known(suite, SUITE_KEYS, "configuration: suite")
    program = str(config.get("program", "dewpoint-cli"))
    return Config(
        table=str(pathlib.Path(folder, config["table"])) if config.get("table") else "",
        # A name without a folder is looked for in PATH.
        program=str(pathlib.Path(folder, program)) if "/" in program else program,
        methods=strings(config.get("methods", [""]), "methods"),
        seeds=strings(config.get("seeds", [1]), "seeds"),
        settings=strings(config.get("settings", [""]), "settings"),
        threads=whole(config.get("threads", 1), "threads", 1),
        memory=whole(config.get("memory", 2000), "memory", 1),
        minutes=whole(config.get("minutes", 60), "minutes", 1),
        suite=suite,
    )


@dataclasses.dataclass(frozen=True)
class TrackingJob:
    recording: str
    project: str
    command: str
    truth: str
    method: str  # empty: the project's
    seed: int
    settings: str  # key=value, several separated by spaces
    frames: str  # A:B; empty: all

    @property
    def name(self):
        """Of its folder: recording, method with settings, seed with frames."""
        how = " ".join(filter(None, [self.method or f"{self.command} as in project", self.settings]))
        which = " ".join(filter(None, [f"seed {self.seed}", f"frames {self.frames}" * bool(self.frames)]))
        return "/".join(map(file_name, (self.recording, how, which)))

    @property
    def folder(self):
        return f"runs/{self.name}"

    def command_line(self, program, threads):
        words = [program, self.command, self.project, "--out", self.folder, "--label", self.recording, "--seed",
                 str(self.seed), "--threads", str(threads)]
        if self.method:
            words += ["--method", self.method]
        if self.frames:
            words += ["--frames", self.frames]
        for setting in self.settings.split():
            words += ["--set", setting]
        return shlex.join(words)

    def evaluation_line(self, program):
        truth = f"{self.folder}/truth.csv" if self.truth == SIMULATED else self.truth
        return shlex.join([program, "evaluate", self.folder, truth, "--save"])


def file_name(text):
    """Letters that no shell and no file system minds."""
    return re.sub(r"[^A-Za-z0-9_.,=+-]+", "-", text).strip("-.") or "-"


def rows_of(table):
    path = pathlib.Path(table)
    if not path.is_file():
        raise Failure(f"{table}: there is no such table")
    with path.open(newline="", encoding="utf-8-sig") as stream:
        reader = csv.DictReader(stream, delimiter="\t" if path.suffix == ".tsv" else ",")
        known(reader.fieldnames or [], COLUMNS, table)
        for needed in ("recording", "project"):
            if needed not in (reader.fieldnames or []):
                raise Failure(f"{table}: the column {needed} is missing")
        for row in reader:
            if None in row or None in row.values():
                raise Failure(f"{table}: line {reader.line_num} has more or fewer cells than columns")
            yield reader.line_num, {key: value.strip() for key, value in row.items()}


def beside(path, table):
    """A path of the table counts from its folder. A built-in scene has no file."""
    there = pathlib.Path(table).parent / path
    return str(there) if there.exists() else path


def tracking_jobs(config):
    """By name. Methods and seeds of a cell are separated by spaces; an empty cell: those of the
    configuration."""
    jobs = {}
    for line, row in rows_of(config.table):
        where = f"{config.table}: line {line}"
        if not row["recording"] or not row["project"]:
            raise Failure(f"{where}: recording and project may not be empty")
        command = row.get("command") or "track"
        if command not in COMMANDS:
            raise Failure(f"{where}: command is {' or '.join(COMMANDS)}, not {command}")
        methods = row.get("methods", "").split() or config.methods
        seeds = row.get("seeds", "").split() or config.seeds
        settings = [row["settings"]] if row.get("settings") else config.settings
        truth = row.get("truth", "")
        for method, seed, setting in itertools.product(methods, seeds, settings):
            if not seed.isdigit():
                raise Failure(f"{where}: {seed} is no seed")
            job = TrackingJob(row["recording"], beside(row["project"], config.table), command,
                              truth if truth in ("", SIMULATED) else beside(truth, config.table), method, int(seed),
                              setting, row.get("frames", ""))
            if job.name in jobs:
                raise Failure(f"{where}: there is another job {job.name}")
            jobs[job.name] = job
    if not jobs:
        raise Failure(f"{config.table}: it has no recordings")
    return jobs


def write_list(file, jobs):
    """Names the folders of all jobs. Each process of the workflow comes by here, on many machines: they find it as it
    has to be."""
    text = "".join(f"{job.folder}\n" for job in jobs.values())
    if not pathlib.Path(file).is_file() or pathlib.Path(file).read_text() != text:
        beside = pathlib.Path(f"{file}.{os.getpid()}")
        beside.write_text(text)
        beside.replace(file)


def gather_line(program):
    return shlex.join([program, "gather", "--list", "jobs.txt", "--out", "gathered"])


@dataclasses.dataclass(frozen=True)
class SuiteShard:
    scenario: str
    grade: str
    first_seed: int
    seeds: int
    methods: tuple

    @property
    def name(self):
        return file_name(f"{self.scenario}-{self.grade}-{self.first_seed}")

    def command_line(self, program):
        words = [program, "suite", "--part", "--scenario", self.scenario, "--grade", self.grade, "--first-seed",
                 str(self.first_seed), "--seeds", str(self.seeds), "--out", f"suite/parts/{self.name}"]
        if self.methods:
            words += ["--method", ",".join(self.methods)]
        return shlex.join(words)


def suite_shards(config):
    """By name: each scenario and grade in blocks of seeds."""
    suite = config.suite
    if not suite:
        return {}
    for needed in ("scenarios", "first_seed", "seeds"):
        if needed not in suite:
            raise Failure(f"configuration: suite needs {needed}")
    first, seeds = whole(suite["first_seed"], "first_seed", 0), whole(suite["seeds"], "seeds", 1)
    block = whole(suite.get("seeds_per_shard", seeds), "seeds_per_shard", 1)
    shards = {}
    for scenario, grade in itertools.product(strings(suite["scenarios"], "scenarios"),
                                             strings(suite.get("grades", ["ideal"]), "grades")):
        for begin in range(0, seeds, block):
            shard = SuiteShard(scenario, grade, first + begin, min(block, seeds - begin),
                               strings(suite.get("methods", []), "methods"))
            shards[shard.name] = shard
    return shards


def merge_line(program, shards):
    return shlex.join([program, "suite", "--out", "suite", "--merge", *(f"suite/parts/{name}" for name in shards)])
