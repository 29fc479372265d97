# SPDX-License-Identifier: GPL-3.0-or-later
"""What the shards have written: the rows of their CSV and JSON files, as numbers."""
import csv
import json
import math


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


class Results:
    """All that a folder of results holds."""

    def __init__(self, folder, shards):
        """`shards`: those of the plan; others that lie in the folder are not read."""
        self.folder = folder
        self.suite = read_rows(folder / "suite" / "runs.csv")
        report = folder / "suite" / "report.json"
        found = json.loads(report.read_text()) if report.is_file() else {}
        self.requirements = found.get("bars", [])
        self.belief = found.get("belief", [])
        self.people = []
        for shard in sorted(shards, key=lambda shard: (shard.seeds, shard.name)):
            if shard.kind == "people":
                self.people += read_rows(folder / "shards" / shard.name / "runs.csv")
        self.convergence = read_rows(folder / "shards" / "convergence" / "convergence.csv")
        self.drift = read_rows(folder / "shards" / "convergence" / "drift.csv")
        self.start_boxes = read_rows(folder / "shards" / "starts" / "boxes.csv")
        self.start_points = read_rows(folder / "shards" / "starts" / "points.csv")
        self.start_seeds = next((shard.seeds for shard in shards if shard.kind == "starts"), ())
        self.states = {row["method"]: row["fingerprint"] for row in self.fingerprints()}
        bench = folder / "shards" / "bench.json"
        self.bench = json.loads(bench.read_text())["benchmarks"] if bench.is_file() else []

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
