# SPDX-License-Identifier: GPL-3.0-or-later
"""What the shards have written: the rows of their CSV and JSON files, as numbers."""
import csv
import json
import math
import pathlib
import re


GRADES = ("ideal", "room", "wild", "real")  # from easy to hard, as everywhere in the documentation


def value(text):
    """A number, or the text itself; None for nothing."""
    if text is None or text == "":
        return None
    try:
        return float(text)
    except ValueError:
        return text


def read_rows(file):
    """The rows of a CSV file by the names of its columns; none where there is no file."""
    if not file.is_file():
        return []
    with file.open(newline="") as stream:
        return [{name: value(text) for name, text in row.items()} for row in csv.DictReader(stream)]


def finite(numbers):
    return [number for number in numbers if isinstance(number, float) and math.isfinite(number)]


def column(rows, name):
    """The numbers of a column, infinite ones too, of the rows that have one."""
    numbers = [row[name] for row in rows if isinstance(row.get(name), float)]
    return [number for number in numbers if not math.isnan(number)]


def quantile(numbers, share):
    """Of sorted numbers, linear between them; None of none. Next to an infinite one it is infinite."""
    if not numbers:
        return None
    ordered = sorted(numbers)
    at = share * (len(ordered) - 1)
    low, high = ordered[math.floor(at)], ordered[math.ceil(at)]
    if low == high or math.isinf(high):
        return high if at > math.floor(at) else low
    return low + (at - math.floor(at)) * (high - low)


def median(numbers):
    return quantile(numbers, 0.5)


def mean(numbers):
    return sum(numbers) / len(numbers) if numbers else None


def processor(file=pathlib.Path("/proc/cpuinfo")):
    """What this machine computes with; nothing where that is not known."""
    names = re.findall(r"^model name\s*: (.*)$", file.read_text(), re.M) if file.is_file() else []
    return f"{len(names)} x {names[0].strip()}" if names else ""


class Results:
    """All that a folder of results holds."""

    def __init__(self, folder, shards, recordings=True):
        """`shards`: those of the plan; others that lie in the folder are not read. `recordings`: all that
        grade real has are there."""
        self.folder = folder
        self.recordings = recordings
        self.suite = read_rows(folder / "suite" / "runs.csv")
        report = folder / "suite" / "report.json"
        found = json.loads(report.read_text()) if report.is_file() else {}
        self.requirements = found.get("bars", [])
        self.belief = found.get("belief", [])
        self.people, self.persons = [], []
        self.shards = sorted(shards, key=lambda shard: (shard.seeds, shard.name))
        for shard in self.shards:
            if shard.kind == "people":
                self.people += read_rows(folder / "shards" / shard.name / "runs.csv")
                self.persons += read_rows(folder / "shards" / shard.name / "people.csv")
        for rows in (self.people, self.persons):
            rows.sort(key=lambda row: GRADES.index(row["grade"]))
        self.convergence = self.study("convergence", "convergence.csv")
        self.drift = self.study("convergence", "drift.csv")
        self.start_boxes = self.study("starts", "boxes.csv")
        self.start_points = self.study("starts", "points.csv")
        self.start_seeds = next((shard.seeds for shard in shards if shard.kind == "starts"), ())
        self.states = {row["method"]: row["fingerprint"] for row in self.fingerprints()}
        bench = folder / "shards" / "bench.json"
        self.bench = json.loads(bench.read_text())["benchmarks"] if bench.is_file() else []
        lazy = folder / "shards" / "lazy-color.txt"
        self.lazy_color = lazy.read_text() if lazy.is_file() else ""
        self.processor = processor()

    def figures(self, kind, file):
        """(seed, rows) of a file that each shard of a kind has written."""
        found = [(shard.seeds[0], read_rows(self.folder / "shards" / shard.name / file))
                 for shard in self.shards if shard.kind == kind]
        return [(seed, rows) for seed, rows in found if rows]

    def study(self, kind, file):
        return [row for _, rows in self.figures(kind, file) for row in rows]

    def fingerprints(self):
        """Eight digits may look like a number: they stay text."""
        file = self.folder / "shards" / "fingerprint.csv"
        if not file.is_file():
            return []
        with file.open(newline="") as stream:
            return list(csv.DictReader(stream))

    def runs(self, grade=None, scenario=None, method=None):
        return [row for row in self.suite if grade in (None, row["grade"]) and scenario in (None, row["scenario"])
                and method in (None, row["method"])]


def distinct(rows, name):
    """The values of a column in the order in which they come first."""
    return list(dict.fromkeys(row[name] for row in rows))


def seeds_of(rows):
    return sorted({int(row["seed"]) for row in rows})
