# SPDX-License-Identifier: GPL-3.0-or-later
"""What all tables are made of."""
import dataclasses
import math


@dataclasses.dataclass
class Made:
    """A table and what it is of."""

    head: list
    rows: list
    methods: list  # whose states it depends on; none: it holds times only
    seeds: list


def number(value):
    """Three digits, as in the report of the suite."""
    if value is None or math.isnan(value):
        return "-"
    if math.isinf(value):
        return "never"
    size = abs(value)
    if value == round(value) and size < 1e6:
        return f"{value:.0f}"
    if size >= 100.0:
        return f"{value:.0f}"
    if size >= 10.0:
        return f"{value:.1f}"
    return f"{value:.2f}" if size >= 0.01 else f"{value:.1g}"


def amount(value, unit):
    """A number with its unit; what never happened has none."""
    text = number(value)
    return text if text == "never" else f"{text} {unit}"


def percent(value):
    """Whole percents, but never 0 % or 100 % of what is not quite that."""
    if value is None:
        return "-"
    if 0.0 < value < 1.0:
        return f"{value:.1g} %" if value < 0.95 else "1 %"
    return f"{value:.1f} %" if 99.0 < value < 100.0 else f"{value:.0f} %"


def name(text):
    return f"`{text}`"


def worst(numbers):
    return max(numbers, default=None)
