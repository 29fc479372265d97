# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables in the pages of the documentation, between `<!-- table: NAME -->` and `<!-- /table -->`, each
below a line with the commit, the seeds and the state of each method that it is of. The line's form is
read by tests/experiment/report/table_states.h, too; so is NOT_MADE, the sentence of a page some of whose
tables have not been made by script/figures yet."""
import re

NOT_MADE = "Tables marked *state older* were made with earlier methods; `script/figures` updates them."
END = "<!-- /table -->"


def begin(name):
    return f"<!-- table: {name} -->"


def names_in(page):
    return re.findall(r"^<!-- table: ([a-z0-9-]+) -->$", page, re.M)


def state_line(commit, seeds, states):
    """`states` by method; none for a table of times, which no checksum says anything about."""
    words = ", ".join(f"`{method}` {state}" for method, state in states.items()) or "not compared"
    return f"Commit `{commit}`; seeds {seeds}; state {words}."


def seed_words(seeds):
    if not seeds:
        return "none"
    return str(seeds[0]) if len(seeds) == 1 else f"{seeds[0]} to {seeds[-1]}"


def table_text(head, rows):
    lines = ["| " + " | ".join(head) + " |", "| " + " | ".join("---" for _ in head) + " |"]
    lines += ["| " + " | ".join(row) + " |" for row in rows]
    return "\n".join(lines)


def replaced(page, name, line, table):
    """The page with this table instead of that of its name; ValueError where it has no place for it."""
    pattern = re.compile(re.escape(begin(name)) + r"\n.*?^" + re.escape(END) + r"$", re.S | re.M)
    block = f"{begin(name)}\n{line}\n\n{table}\n{END}"
    changed, count = pattern.subn(lambda _: block, page)
    if count != 1:
        raise ValueError(f"{count} places for the table '{name}'")
    return changed


def without_promise(page):
    """The page without the paragraph NOT_MADE once none of its tables is of an older state."""
    older = re.search(r"^Commit `.*; state older\.$", page, re.M)
    return page if older else page.replace(f"\n{NOT_MADE}\n", "", 1)
