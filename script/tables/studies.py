# SPDX-License-Identifier: GPL-3.0-or-later
"""The tables of the papers' experiments and of people, each a function of the results."""
import itertools
import re

from cells import Made, name, number, percent
from results import column, distinct, finite, mean, median

METER = 1000.0  # millimeters


def point(row, what):
    return "(" + ", ".join(f"{row[f'{what}_{axis}_m']:g}" for axis in "xyz") + ")"


def start_words(row):
    half = [row[f"half_{axis}_m"] for axis in "xyz"]
    if not any(half):
        return point(row, "start")
    return "evenly spread, " + " x ".join(f"{2.0 * size:g}" for size in half) + " m around " + point(row, "start")


def convergence(results):
    table = []
    for row in results.convergence:
        found = int(row["converged"])
        near = [f"{int(row['within'])}"] if "within" in row else []
        table.append([row["case"], start_words(row), point(row, "ball"), f"{found} of {int(row['runs'])}", *near,
                      number(row["median_iterations"]),
                      "-" if row["rmse_mm"] is None else f"{row['rmse_mm']:.1f} mm",
                      "-" if row["depth_bias_mm"] is None else f"{row['depth_bias_mm']:+.1f} mm"])
    head = ["case", "start", "ball", "converged", "iterations (median)", "RMSE", "bias in depth"]
    if results.convergence and "within" in results.convergence[0]:
        head.insert(4, "of these within 3 cm")
    seeds = [int(row["first_seed"] + add) for row in results.convergence for add in (0, row["runs"] - 1)]
    return Made(head, table, ["barrera"], sorted(set(seeds)))


def starts(results):
    found = [("evenly spread in a cube around the ball, half its edge", row["half_edge_m"], row)
             for row in results.start_boxes]
    found += [("(0.5, y, 0.15), at and beyond the ball, y =", row["y_m"], row) for row in results.start_points]
    shown = [(key, title) for key, title in (("share", "converged"), ("share_within_3_cm", "and within 3 cm"))
             if any(key in row for _, _, row in found)]
    table = [[where, f"{size:g} m", *[percent(100.0 * row[key]) for key, _ in shown]] for where, size, row in found]
    first, count = results.start_seeds or (0, 1)
    return Made(["start", "", *[title for _, title in shown]], table, ["barrera"], sorted({first, first + count - 1}))


def drift(results):
    table = [[f"first {int(row['iterations'])}", str(int(row["runs"])), f"{row['mm_per_iteration']:.1f} mm"]
             for row in results.drift]
    seeds = [int(row["first_seed"] + add) for row in results.drift for add in (0, row["runs"] - 1)]
    return Made(["iterations", "runs", "away from the camera, per iteration"], table, ["barrera"], sorted(set(seeds)))


def span(numbers, text):
    """The median, and the least and the largest where there are several."""
    if not numbers:
        return "-"
    middle = text(median(numbers))
    return middle if len(numbers) == 1 else f"{middle} ({text(min(numbers))} to {text(max(numbers))})"


def millimeters(meters):
    return number(METER * meters) + " mm"


def share_along(row):
    """Of the cloud's variance, along camera 1's axis: of one that is round, a third."""
    along, across = row["spread_along_axis_1_m"] ** 2, row["spread_across_it_m"] ** 2
    return 100.0 * along / (along + 2.0 * across)


def cloud(results):
    """Barrera et al., figures 3 and 4: the cloud on its way."""
    found = results.figures("barrera-fig4", "instants.csv")
    rows = [row for _, rows in found for row in rows]
    table = []
    for iteration in distinct(rows, "iteration"):
        mine = [row for row in rows if row["iteration"] == iteration]
        table.append([number(iteration), span(column(mine, "error_m"), millimeters),
                      span(column(mine, "spread_along_axis_1_m"), millimeters),
                      span(column(mine, "spread_across_it_m"), millimeters),
                      span([share_along(row) for row in mine], percent)])
    return Made(["iteration", "error", "spread along camera 1's axis", "spread across this axis",
                 "fraction of the variance along it"], table, ["barrera"], [seed for seed, _ in found])


def in_images(results):
    """Barrera et al., figure 3: how many particles are in which image."""
    found = results.figures("barrera-fig3", "instants.csv")
    table = [[number(row["iteration"]), number(row["particles_in_image_1"]), number(row["particles_in_image_2"])]
             for _, rows in found for row in rows if "particles_in_image_1" in row]
    return Made(["iteration", "of 200 particles, in camera 1's image", "in camera 2's image"], table, ["barrera"],
                [seed for seed, _ in found])


CONE_STEP = 0.03  # meters: one standard deviation of the motion


def cone(results):
    """Barrera et al., figure 5: steps toward the camera and away from it. No method has a part in it."""
    for _, rows in results.figures("barrera-fig5", "cone.csv"):
        at = {round(row["step_m"], 6): row for row in rows}
        toward, away = at.get(-CONE_STEP), at.get(CONE_STEP)
        if toward and away:
            table = [[f"{key.split('_')[-2]} m", percent(100.0 * toward[key]), percent(100.0 * away[key])]
                     for key in toward if key.startswith("stay_at_")]
            return Made(["from the camera", "stay in the cone after 3 cm toward it", "after 3 cm away from it"], table, [],
                        [1])
    return Made([], [], [], [])


def lazy_color(results):
    """From how many particles on the whole image is cheaper than the windows."""
    table = []
    for block in results.lazy_color.strip().split("\n\n"):
        crossing = re.search(r"^windows alone stop paying (.*?) particles", block, re.M)
        ratio = re.search(r"^ *3072 +\S+ +\S+ +(\S+)$", block, re.M)
        if crossing and ratio:
            table.append([block.splitlines()[0], crossing[1], ratio[1]])
    return Made([results.processor, "particles from which on the windows are not faster",
                 "time of the windows / of the image, 3072 particles"], table, [], [1])


def masks(results):
    """Mohedano et al., figure 3: how fragmented the motion masks are, means over all frames."""
    found = results.figures("mohedano-fig1", "masks.csv")
    table = [[str(seed), *[f"{mean(column(rows, key)):.1f}" for key in ("regions", "people")],
              *[f"{mean(column(rows, key)):.2f}" for key in ("recall", "precision")]] for seed, rows in found if rows]
    return Made(["seed", "regions of the mask", "people in view", "recall", "precision"], table, ["mohedano-ms"],
                [seed for seed, _ in found])


HEIGHTS = (("below 1.3 m", 0.0, 1.3), ("1.3 to 1.6 m", 1.3, 1.6), ("1.6 m and more", 1.6, 3.0))  # as in the report


def people_heights(results):
    """Who is found, in the scene with people of all heights."""
    mine = [row for row in results.persons if row["scenario"] == "heights"]
    table = []
    for grade, clothes, method in itertools.product(*[distinct(mine, key) for key in ("grade", "clothes", "method")]):
        for title, low, high in HEIGHTS:
            rows = [row for row in mine if (row["grade"], row["clothes"], row["method"]) == (grade, clothes, method)
                    and low <= row["height_m"] < high]
            if rows:
                found, recall, error = (finite(column(rows, key))
                                        for key in ("found", "silhouette_recall", "height_error_m"))
                table.append([grade, clothes, name(method), title, str(len(rows)),
                              percent(100.0 * mean(found)) if found else "-",
                              f"{mean(recall):.2f}" if recall else "-",
                              f"{METER * mean(error):.0f}" if error else "-"])
    return Made(["grade", "clothes", "method", "height", "people", "found", "silhouette recall", "height error (mm)"], table,
                distinct(mine, "method"), sorted({int(row["seed"]) for row in mine}))


def boxes(results):
    """Sugandi et al.: boxes in one camera, on recordings and one rendered clip."""
    found = results.figures("sugandi-rmse", "sugandi-rmse.csv")
    rows = [row for _, rows in found for row in rows]
    methods = distinct(rows, "method")
    table = []
    for clip in distinct(rows, "clip"):
        cells = {row["method"]: row for row in rows if row["clip"] == clip}
        table.append([clip, *[f"{number(cells[method]['rmse_px'])} ({cells[method]['success']:.2f}, "
                              f"{percent(100.0 * cells[method]['precision'])})" if method in cells else "-"
                              for method in methods]])
    seeds = [seed + add for seed, _ in found for add in range(int(max(column(rows, "seeds"))))] if rows else []
    return Made(["clip", *methods], table, ["sugandi", "histogram"], seeds)
