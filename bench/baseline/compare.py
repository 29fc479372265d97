#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares runs of the suite with those of the baseline, or of another file.

Usage: compare.py RUNS [BEFORE] [--methods]

Of runs.csv RUNS, and of BEFORE (runs.csv beside this program unless given), the runs that both have: the same
scenario, grade, method and seed. A line per scenario, grade and method; figures are before -> now.

  --methods   a line per grade and method in place of each scenario: means over the scenarios
"""
import argparse
import csv
import math
import pathlib
import statistics
import sys

# (column of runs.csv, head, how the runs of a scenario are put together)
FIGURES = (("rmse_mm", "RMSE mm", statistics.median), ("lost_percent", "lost %", statistics.fmean),
           ("false_alarm_percent", "false %", statistics.fmean), ("coverage95_percent", "in 95 %", statistics.fmean),
           ("sure_and_wrong_percent", "sure, wrong %", statistics.fmean), ("wrong_percent", "wrong %", statistics.fmean),
           ("us_per_frame", "us/frame", statistics.median))


def read(file):
    try:
        with open(file, newline="") as stream:
            return {(row["grade"], row["scenario"], row["method"], row["seed"]): row for row in csv.DictReader(stream)}
    except (OSError, KeyError) as failure:
        sys.exit(f"compare.py: {file}: {'it has no column ' if isinstance(failure, KeyError) else ''}{failure}")


def figure(rows, column, together):
    numbers = [float(row[column]) for row in rows if row.get(column)]
    return together(numbers) if numbers else math.nan


def cells(groups):
    """Of pairs of runs in groups (a scenario each): a text per figure, means over the groups."""
    for column, _, together in FIGURES:
        before, now = ([figure([pair[side] for pair in pairs], column, together) for pairs in groups] for side in (0, 1))
        both = [(b, n) for b, n in zip(before, now) if not (math.isnan(b) or math.isnan(n))]
        yield " -> ".join(f"{statistics.fmean(side):.4g}" for side in zip(*both)) if both else "-"


def main():
    parser = argparse.ArgumentParser(usage=__doc__.split("\n")[2].removeprefix("Usage: "))
    parser.add_argument("runs")
    parser.add_argument("before", nargs="?", default=pathlib.Path(__file__).resolve().parent / "runs.csv")
    parser.add_argument("--methods", action="store_true")
    wanted = parser.parse_args()
    now, before = read(wanted.runs), read(wanted.before)
    scenarios = {}
    for key in now:
        if key in before:
            scenarios.setdefault(key[:3], []).append((before[key], now[key]))
    if not scenarios:
        sys.exit(f"compare.py: {wanted.runs} and {wanted.before} have no run in common (scenario, grade, method, seed)")
    lines = {}
    for (grade, scenario, method), pairs in scenarios.items():
        lines.setdefault((grade, method) if wanted.methods else (grade, scenario, method), []).append(pairs)
    table = [["", "runs", *[head for _, head, _ in FIGURES]]]
    table += [[" ".join(key), str(sum(map(len, groups))), *cells(groups)] for key, groups in lines.items()]
    widths = [max(map(len, column)) for column in zip(*table)]
    for line in table:
        print("  ".join(text.ljust(width) for text, width in zip(line, widths)).rstrip())


if __name__ == "__main__":
    main()
