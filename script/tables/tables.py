# SPDX-License-Identifier: GPL-3.0-or-later
"""The tables: each a function of the results. A table without rows is not made."""
import math

import studies
from cells import Made, amount, name, number, percent, worst
from results import column, distinct, finite, mean, median, quantile, seeds_of

OURS = "dewpoint"
SMOOTHED = "dewpoint-smoothed"
QUICK_FRAMES = 5  # a start counts as quick that takes no more (kQuickFrames of the suite)
COSTLY = ("csrt",)  # of which plan.toml asks fewer runs
ACCURACY, PEOPLE, FIDELITY = "docs/accuracy.md", "docs/measurements-people.md", "docs/fidelity.md"
METHOD = "docs/measurements-dewpoint.md"
BOXES = "docs/method-sugandi.md"


def remarks(rows):
    """What is asked of some scenarios only."""
    words = []
    if rows[0]["scenario"].startswith("S4-") and "jump" not in rows[0]["scenario"]:
        frames = column(rows, "frames_to_converge")
        quick = sum(1 for count in frames if count <= QUICK_FRAMES)
        words.append(f"{quick} of {len(rows)} within {QUICK_FRAMES} frames")
    never = sum(1 for count in column(rows, "frames_to_converge") if math.isinf(count))
    if never:
        words.append(f"{never} of {len(rows)} never found it")
    again = column(rows, "frames_to_reacquire")
    if again:
        words.append(f"found again within {number(quantile(again, 0.9))} frames (90th percentile)")
    blind = column(rows, "blackout_rmse_mm")
    if blind:
        words.append(f"while blind: median {amount(median(blind), 'mm')}, "
                     f"90th percentile {amount(quantile(blind, 0.9), 'mm')}")
    for key, text in (("frames_to_declare_loss", "loss declared within {} frames"),
                      ("largest_step_mm", "largest step {} mm")):
        numbers = column(rows, key)
        if numbers:
            words.append(text.format(number(worst(numbers))))
    switches = column(rows, "identity_switches")
    if rows[0]["scenario"].startswith("S5-") and switches:
        words.append(f"{number(worst(switches))} identity switches at most")
    return "; ".join(words)


# Columns of runs.csv beyond the errors: (name, head, text of the rows' numbers). Those that a program
# does not write are left out.
BELIEF = (
    ("rmse_px", "RMSE in images (px)", lambda numbers: number(median(numbers))),
    ("jitter_mm", "jitter (mm)", lambda numbers: number(median(numbers))),
    ("success", "success", lambda numbers: f"{mean(numbers):.3f}"),
    ("lost_percent", "lost", lambda numbers: percent(mean(numbers))),
    ("false_alarm_percent", "false alarms", lambda numbers: percent(mean(numbers))),
    ("coverage50_percent", "in the 50 % ellipsoid", lambda numbers: percent(mean(numbers))),
    ("coverage95_percent", "in the 95 % ellipsoid", lambda numbers: percent(mean(numbers))),
    ("nees", "NEES", lambda numbers: number(median(numbers))),
    ("sure_and_wrong_percent", "sure and wrong", lambda numbers: percent(mean(numbers))),
    ("existence_ece", "ECE of P(exists)", lambda numbers: number(mean(numbers))),
)


def scenarios(grade):
    """All scenarios of a grade, method dewpoint."""

    def make(results):
        rows = results.runs(grade=grade, method=OURS)
        shown = [one for one in BELIEF if column(rows, one[0])]
        head = ["scenario", "runs", "RMSE, median (mm)", "worst run", *[one[1] for one in shown], "also"]
        table = []
        for scenario in distinct(rows, "scenario"):
            runs = results.runs(grade=grade, scenario=scenario, method=OURS)
            errors = column(runs, "rmse_mm")
            table.append([name(scenario), str(len(runs)), number(median(errors)), number(worst(errors)),
                          *[text(column(runs, key)) for key, _, text in shown], remarks(runs)])
        return Made(head, table, [OURS], seeds_of(rows))

    return make


# Columns of runs.csv that are measured by the target's size: (name, head, text of the rows' numbers).
SIZES = (
    ("near_centroid_percent", "centroid within a quarter of the target", lambda numbers: percent(mean(numbers))),
    ("centroid_error_percent", "error of the centroid, share of the half axis", lambda numbers: percent(median(numbers))),
    ("size_error_percent", "error of the size", lambda numbers: percent(median(numbers))),
)


def sizes(results):
    """Targets that are no balls of a known radius, method dewpoint."""
    table, used = [], []
    for grade in distinct(results.runs(method=OURS), "grade"):
        for scenario in distinct(results.runs(grade=grade, method=OURS), "scenario"):
            if not scenario.startswith("S21-"):
                continue
            rows = results.runs(grade=grade, scenario=scenario, method=OURS)
            cells = [(column(rows, key), text) for key, _, text in SIZES]
            if any(numbers for numbers, _ in cells):
                used += rows
                table.append([name(scenario), grade, str(len(rows)),
                              *[text(numbers) if numbers else "-" for numbers, text in cells]])
    return Made(["scenario", "grade", "runs", *[one[1] for one in SIZES]], table, [OURS], seeds_of(used))


def error_words(rows):
    """The median error in millimeters; of clips without a truth in space, in pixels."""
    millimeters, pixels = column(rows, "rmse_mm"), column(rows, "rmse_px")
    return number(median(millimeters)) if millimeters or not pixels else f"{number(median(pixels))} px"


def peers(grade):
    """All methods side by side, on the seeds that all of them have. The costly ones have fewer: then their
    number of runs stands behind the share of lost frames."""

    def make(results):
        all_rows = results.runs(grade=grade)
        methods = [method for method in distinct(all_rows, "method") if method != SMOOTHED]
        table, used = [], []
        for scenario in distinct(all_rows, "scenario"):
            cells = {method: results.runs(grade=grade, scenario=scenario, method=method) for method in methods}
            cells = {method: rows for method, rows in cells.items() if rows}
            if len(cells) < 2:
                continue
            cheap = [set(seeds_of(rows)) for method, rows in cells.items() if method not in COSTLY]
            common = set.intersection(*(cheap or [set(seeds_of(rows)) for rows in cells.values()]))
            line = [name(scenario), str(len(common))]
            for method in methods:
                rows = [row for row in cells.get(method, []) if int(row["seed"]) in common]
                used += rows
                lost = percent(mean(column(rows, "lost_percent"))) if rows else ""
                fewer = f"; {len(rows)}" if len(rows) < len(common) else ""
                line.append(f"{error_words(rows)} ({lost}{fewer})" if rows else "-")
            table.append(line)
        return Made(["scenario", "runs", *map(name, methods)], table, methods, seeds_of(used))

    return make


def bound(one):
    """What is asked: at most, or between."""
    unit = f" {one['unit']}" if one["unit"] else ""
    low, high = one["low"], one["high"]
    if isinstance(low, str) or low is None:  # "-inf"
        return f"at most {high:g}{unit}"
    if isinstance(high, str) or high is None:
        return f"at least {low:g}{unit}"
    return f"{high:g}{unit}" if low == high else f"{low:g} to {high:g}{unit}"


def requirements(results):
    table = []
    for one in results.requirements:
        if not one["runs"]:
            continue
        measured = one["value"]
        if isinstance(measured, str):  # "inf"
            measured = float(measured)
        unit = f" {one['unit']}" if one["unit"] and measured is not None and math.isfinite(measured) else ""
        verdict = {"not reached": "**not reached**"}.get(one["verdict"], one["verdict"])
        if one.get("next_version"):  # this version is measured against it, and may miss it
            verdict += ", for the next version"
        decides = f" ({name(one['scenario'])})" if one.get("scenario") else ""
        grade = [one["grade"]] if "grade" in one else []
        table.append([one["requirement"], *grade, bound(one), number(measured) + unit + decides, str(one["runs"]), verdict])
    graded = ["grade"] if any("grade" in one for one in results.requirements) else []
    rows = results.runs(method=OURS)
    # A requirement compares with triangulation.
    methods = [OURS] + [method for method in ("triangulation",) if results.runs(method=method)]
    return Made(["requirement", *graded, "must be", "measured", "runs", "verdict"], table, methods, seeds_of(rows))


def exact(value):
    """A number of JSON, where what is not finite is a text or nothing."""
    return float(value) if isinstance(value, str) else value


# Figures of belief by their names in report.json.
BELIEF_FIGURES = {
    "coverage50_percent": "in the 50 % ellipsoid, %",
    "coverage95_percent": "in the 95 % ellipsoid, %",
    "nees": "NEES",
    "existence_ece": "ECE of P(exists)",
    "sure_and_wrong_percent": "sure and wrong, % of frames",
    "wrong_percent": "declared, not within 30 mm, % of frames",
    "wrong_when_sure_percent": "the same with P(exists) above 0.95, % of frames",
    "sure_of_tie_percent": "sure of a tie, % of frames",
}


def belief(results):
    """Whether the method knows how sure it may be, by grade: median over the scenarios, and the worst."""
    table = []
    for one in results.belief:
        if one["method"] == OURS:
            table += [[one["grade"], BELIEF_FIGURES.get(figure, figure), number(exact(found["median"])),
                       number(exact(found["worst"])), name(found["worst_scenario"]) if found["worst_scenario"] else "-"]
                      for figure, found in one.get("figures", {}).items()]
    return Made(["grade", "figure", "median of the scenarios", "worst", "in"], table, [OURS],
                seeds_of(results.runs(method=OURS)))


# Families of scenarios in which a target or its images are not as method dewpoint takes them to be.
BEYOND_MODEL = ("S11", "S12", "S13", "S14", "S15", "S16", "S17", "S18", "S19", "S20", "S21")
PEER = "triangulation-kalman"


def beyond_model(results):
    """How often method dewpoint is wrong, and sure of it, where its model does not hold."""

    def wrong(rows):
        shares = [mean(column(rows, key)) for key in ("wrong_percent", "wrong_when_sure_percent")]
        return f"{percent(shares[0])} ({percent(shares[1])})" if None not in shares else "-"

    table, used = [], []
    for scenario in distinct(results.suite, "scenario"):
        if scenario.split("-")[0] not in BEYOND_MODEL:
            continue
        cells = []
        for grade in ("ideal", "room"):
            ours, theirs = (results.runs(grade=grade, scenario=scenario, method=method) for method in (OURS, PEER))
            cells += [wrong(ours), percent(mean(column(theirs, "wrong_percent"))),
                      percent(mean(column(ours, "coverage95_percent")))]
            used += ours + theirs
        table.append([name(scenario), *cells])
    return Made(["scenario", *[head for grade in ("ideal", "room") for head in (
        f"wrong (and sure), {grade}", "wrong, " + name(PEER), "in the 95 % ellipsoid")]], table, [OURS, PEER], seeds_of(used))


def smoothed(results):
    families = {}
    for row in results.runs(grade="ideal", method=SMOOTHED):
        families.setdefault(row["scenario"].split("-")[0], []).append(row["scenario"])
    table, used = [], []

    def line(title, names, bold):
        smooth = [row for row in results.runs(grade="ideal", method=SMOOTHED) if row["scenario"] in names]
        both = {(row["scenario"], row["seed"]) for row in smooth}
        live = [row for row in results.runs(grade="ideal", method=OURS) if (row["scenario"], row["seed"]) in both]
        before, after = median(column(live, "rmse_mm")), median(column(smooth, "rmse_mm"))
        if not before or after is None or not math.isfinite(before):
            return
        used.extend(live)
        share = percent(100.0 * (1.0 - after / before))
        table.append([title, str(len(smooth)), number(before), number(after), f"**{share}**" if bold else share,
                      *[f"{percent(mean(column(live, key)))} / {percent(mean(column(smooth, key)))}"
                        if column(live, key) and column(smooth, key) else ""
                        for key in ("coverage95_percent", "blackout_coverage95_percent")]])

    for family, names in families.items():
        for scenario in dict.fromkeys(names):
            line(name(scenario), {scenario}, False)
        line(f"**all runs of {family}**", set(names), True)
    return Made(["scenario", "runs", "live (mm)", "smoothed (mm)", "less by", "in the 95 % ellipsoid, live / smoothed",
                 "the same while blind"], table, [OURS, SMOOTHED], seeds_of(used))


def people_cells(results):
    for grade in distinct(results.people, "grade"):
        for scenario in distinct(results.people, "scenario"):
            for clothes in ("different", "similar"):
                rows = [row for row in results.people
                        if (row["grade"], row["scenario"], row["clothes"]) == (grade, scenario, clothes)]
                if rows:
                    yield [name(scenario), grade, clothes], rows


def people_identities(results):
    methods = distinct(results.people, "method")
    table = []
    for what, rows in people_cells(results):
        line = [*what, str(len(seeds_of(rows)))]
        for method in methods:
            kept = [row["kept"] for row in rows if row["method"] == method]
            line.append(f"{sum(kept):.0f}" if kept else "-")
        table.append(line)
    return Made(["scenario", "grade", "clothes", "seeds", *map(name, methods)], table, methods, seeds_of(results.people))


# Columns of a people study's runs.csv: (name, head, text of the rows' numbers).
PEOPLE_COLUMNS = (
    ("identity_switches", "switches", lambda numbers: f"{sum(numbers):.0f}"),
    ("mota", "MOTA", lambda numbers: f"{mean(numbers):.3f}"),
    ("hota", "HOTA", lambda numbers: f"{mean(numbers):.3f}"),
    ("motp_m", "position (mm)", lambda numbers: number(1000.0 * mean(numbers))),
    ("longest_ghost_s", "longest ghost (s)", lambda numbers: f"{max(numbers):.2f}"),
    ("longest_missed_s", "longest missed (s)", lambda numbers: f"{max(numbers):.2f}"),
    ("found", "found", lambda numbers: percent(100.0 * mean(numbers))),
    ("silhouette_recall", "silhouette recall", lambda numbers: f"{mean(numbers):.2f}"),
    ("silhouette_precision", "silhouette precision", lambda numbers: f"{mean(numbers):.2f}"),
)


def people_quality(results):
    shown = [one for one in PEOPLE_COLUMNS if finite(column(results.people, one[0]))]
    table = []
    for what, rows in people_cells(results) if shown else ():
        for method in distinct(rows, "method"):
            mine = [row for row in rows if row["method"] == method]
            cells = [finite(column(mine, key)) for key, _, _ in shown]
            table.append([*what, name(method),
                          *[text(numbers) if numbers else "-" for numbers, (_, _, text) in zip(cells, shown)]])
    return Made(["scenario", "grade", "clothes", "method", *[one[1] for one in shown]], table,
                distinct(results.people, "method"), seeds_of(results.people))


SPEED = (
    ("people", "`people`, whole frame", "2x"),
    ("people/MOG2", "`people` with `background=1` (MOG2 on the reduced images)", ""),
    ("people+hulls", "`people` and the 95 % volumes of both people", "2x"),
    ("mohedano-msc", "`mohedano-msc` with `background=0`", ""),
    ("mohedano-msc/MOG2", "`mohedano-msc` as it comes (MOG2, full images)", ""),
)


def people_speed(results):
    times = {}
    for one in results.bench:
        if one.get("run_type", "iteration") == "iteration" and not one.get("error_occurred"):
            times.setdefault(one.get("run_name", one["name"]), []).append(one["cpu_time"])
    table = []
    for key, words, bar in SPEED:
        if key in times and "MOG2" in times:
            ratio = min(times["MOG2"]) / min(times[key])
            table.append([words, f"{ratio:.1f}x faster" if ratio > 1.0 else f"{ratio:.1f}x", bar])
    return Made([results.processor, "against MOG2 alone on the same four images", "bar"], table, [], [1])


# (page, name, how it is made)
TABLES = (
    (ACCURACY, "requirements", requirements),
    (ACCURACY, "belief", belief),
    (ACCURACY, "room", scenarios("room")),
    (ACCURACY, "peers-room", peers("room")),
    (ACCURACY, "wild", scenarios("wild")),
    (ACCURACY, "peers-wild", peers("wild")),
    (ACCURACY, "real", scenarios("real")),
    (ACCURACY, "peers-real", peers("real")),
    (ACCURACY, "ideal", scenarios("ideal")),
    (ACCURACY, "peers-ideal", peers("ideal")),
    (ACCURACY, "sizes", sizes),
    (ACCURACY, "smoothed", smoothed),
    (METHOD, "beyond-model", beyond_model),
    (PEOPLE, "people-identities", people_identities),
    (PEOPLE, "people-quality", people_quality),
    (PEOPLE, "people-heights", studies.people_heights),
    (PEOPLE, "masks", studies.masks),
    (PEOPLE, "people-speed", people_speed),
    (FIDELITY, "convergence", studies.convergence),
    (FIDELITY, "cloud", studies.cloud),
    (FIDELITY, "in-images", studies.in_images),
    (FIDELITY, "starts", studies.starts),
    (FIDELITY, "drift", studies.drift),
    (FIDELITY, "cone", studies.cone),
    (FIDELITY, "lazy-color", studies.lazy_color),
    (BOXES, "boxes", studies.boxes),
)

# Tables that need recordings: where some are not there, those of the pages stay as they are.
RECORDED = ("real", "peers-real", "boxes")


def all_made(results):
    """(page, name, Made) of the tables that there are rows for."""
    for page, title, make in TABLES:
        made = make(results)
        if made.rows:
            if title in ("requirements", "belief") and not results.recordings:
                made.rows.append(["grade `real`: not measured, recordings are missing",
                                  *["-" for _ in made.head[1:]]])
            yield page, title, made
