#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests of what script/figures is made of. Usage: self_test.py (tests/cli runs it)."""
import dataclasses
import importlib.machinery
import importlib.util
import os
import pathlib
import shutil
import stat
import subprocess
import sys
import tempfile
import textwrap
import unittest

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
sys.path.insert(0, str(HERE))
sys.dont_write_bytecode = True

import pages  # noqa: E402
import plan as plans  # noqa: E402
import results as read  # noqa: E402
import tables  # noqa: E402

CATALOG = plans.Catalog(["S0-slow", "S1-still-1"], ["dewpoint", "barrera"], ["ideal"], ["people-crossing"], 1005001,
                        1006000)
COSTS = plans.Costs([{"scenario": "*", "grade": "*", "what": "*", "seconds": "1"},
                     {"scenario": "*", "grade": "*", "what": "render", "seconds": "10"},
                     {"scenario": "S1-*", "grade": "*", "what": "barrera", "seconds": "5"}])


class Plan(unittest.TestCase):
    def test_the_last_cost_counts(self):
        self.assertEqual(COSTS.of("S0-slow", "ideal", "barrera"), 1.0)
        self.assertEqual(COSTS.of("S1-still-1", "ideal", "barrera"), 5.0)
        self.assertEqual(COSTS.run("S1-still-1", "ideal", ["dewpoint", "barrera"]), 16.0)

    def test_the_last_rule_counts(self):
        rules = [{"scenarios": ["*"], "grades": ["*"], "methods": ["*"], "seeds": 5, "least": 2},
                 {"scenarios": ["S1-*"], "grades": ["ideal"], "methods": ["dewpoint"], "seeds": 20}]
        found = plans.amounts(rules, CATALOG)
        self.assertEqual([(one.scenario, one.method, one.seeds, one.least) for one in found],
                         [("S0-slow", "dewpoint", 5, 2), ("S0-slow", "barrera", 5, 2),
                          ("S1-still-1", "dewpoint", 20, 20), ("S1-still-1", "barrera", 5, 2)])

    def test_methods_share_frames_as_far_as_they_go(self):
        found = [plans.Amount("S0", "ideal", "dewpoint", 20, 20), plans.Amount("S0", "ideal", "barrera", 5, 2),
                 plans.Amount("S0", "ideal", "camshift", 0, 0)]
        self.assertEqual(list(plans.blocks(found)), [("S0", "ideal", ["dewpoint", "barrera"], 0, 5),
                                                     ("S0", "ideal", ["dewpoint"], 5, 20)])
        # 5 runs of 10 + 1 + 1 seconds, 15 of 10 + 1.
        self.assertEqual(plans.seconds(found, COSTS), 225.0)

    def test_seeds_are_cut_where_they_cost_most(self):
        found = [plans.Amount("S1-a", "ideal", "dewpoint", 4, 4), plans.Amount("S1-a", "ideal", "barrera", 4, 2),
                 plans.Amount("S0-a", "ideal", "dewpoint", 4, 1), plans.Amount("S0-a", "ideal", "barrera", 4, 4)]
        # 4 x (10 + 1 + 5) + 4 x (10 + 1 + 1) = 112; a seed of barrera on S1 saves 5, one of dewpoint on S0
        # saves 1, for barrera needs its frames.
        self.assertEqual(plans.seconds(found, COSTS), 112.0)
        self.assertEqual(plans.cut(found, COSTS, 107.0), 107.0)
        self.assertEqual([one.seeds for one in found], [4, 3, 4, 4])
        self.assertEqual(plans.cut(found, COSTS, 0.0), 112.0 - 10.0 - 3.0)  # as far as it may
        self.assertEqual([one.seeds for one in found], [4, 2, 1, 4])
        self.assertEqual(plans.seconds(found, COSTS), 99.0)

    def test_the_frames_are_saved_with_the_last_method(self):
        found = [plans.Amount("S0", "ideal", "dewpoint", 3, 0), plans.Amount("S0", "ideal", "barrera", 2, 2)]
        self.assertEqual(plans.cut(found, COSTS, 30.0), 24.0)  # 35 less 10 + 1: two seeds of both
        self.assertEqual([one.seeds for one in found], [2, 2])

    def test_shards_are_short_and_hold_every_run_once(self):
        found = [plans.Amount("S0", "ideal", "dewpoint", 7, 7), plans.Amount("S0", "ideal", "barrera", 3, 3)]
        shards = list(plans.suite_shards(found, COSTS, 1005001, 24.0))  # two runs of 12 or of 11 seconds
        self.assertEqual([shard.seeds for shard in shards],
                         [(1005001, 2), (1005003, 1), (1005004, 2), (1005006, 2)])
        self.assertEqual(len({shard.name for shard in shards}), 4)
        self.assertIn("dewpoint,barrera", shards[0].command)
        self.assertIn("dewpoint", shards[2].command)

    def test_methods_need_not_be_named(self):
        rules = [{"scenarios": ["R*"], "grades": ["real"], "methods": ["all"], "seeds": 2, "options": ["--clips", "{root}/a"]}]
        catalog = plans.Catalog(["S0", "R1-hand"], ["dewpoint"], ["real"], [], 1005001, 1006000)
        found = plans.amounts(rules, catalog)
        self.assertEqual([(one.scenario, one.method, one.seeds) for one in found], [("R1-hand", "all", 2)])
        shard, = plans.suite_shards(found, COSTS, 1005001, 100.0)
        self.assertNotIn("--method", shard.command)
        self.assertIn(str(ROOT / "a"), shard.command)

    def test_the_plan_that_is_kept_fits_into_its_hours(self):
        declared = plans.read_plan()
        costs = plans.Costs.read(HERE / "costs.csv")
        scenarios = [f"S{family}-{kind}" for family in range(23) for kind in ("a", "b", "c")]
        catalog = plans.Catalog(scenarios + ["S4-desk-cloud", "S5-eight"],
                                ["dewpoint", "dewpoint-smoothed", "barrera", "triangulation", "csrt"],
                                ["ideal", "room", "wild"], ["people-crossing", "people-apart"], 1005001, 1006000)
        whole = plans.make_plan(declared, costs, catalog)
        self.assertLess(whole.hours(), 4.0)
        self.assertTrue(any("real" in note for note in whole.notes))
        quick = plans.make_plan(declared, costs, catalog, quick=True)
        self.assertLess(quick.hours(), 0.25)
        self.assertTrue(quick.shards)
        self.assertTrue(whole.shards[-1].alone)
        self.assertFalse(any(amount.grade == "real" for amount in whole.amounts), "S* is rendered")
        recorded = dataclasses.replace(catalog, scenarios=["S5-four", "R1-hand"], grades=["ideal", "real"],
                                       skipped=["R1-bands is skipped: gone."])
        with_clips = plans.make_plan(declared, costs, recorded)
        self.assertEqual({amount.scenario for amount in with_clips.amounts if amount.grade == "real"}, {"R1-hand"})
        self.assertIn("R1-bands is skipped: gone.", with_clips.notes)
        with self.assertRaises(plans.Failure):  # the studies take their seeds from the same block
            plans.make_plan(declared, costs, dataclasses.replace(catalog, last_seed=1005900))


class Pages(unittest.TestCase):
    # The same line is read in tests/experiment/report/table_states_test.cpp.
    LINE = ("Commit `abc1234`; seeds 1005001 to 1005020; state `dewpoint` 1a2b3c4d, "
            "`triangulation-kalman` 00000001.")

    def test_the_state_stands_above_the_table(self):
        self.assertEqual(pages.state_line("abc1234", pages.seed_words([1005001, 1005002, 1005020]),
                                          {"dewpoint": "1a2b3c4d", "triangulation-kalman": "00000001"}), self.LINE)
        self.assertEqual(pages.state_line("abc1234", "1", {}), "Commit `abc1234`; seeds 1; state not compared.")

    def test_a_table_is_replaced_and_nothing_else(self):
        page = "before\n<!-- table: a -->\nold\n<!-- /table -->\nmiddle\n<!-- table: b -->\nkept\n<!-- /table -->\nafter\n"
        table = pages.table_text(["x", "y"], [["1", "2 \\| 3"]])
        changed = pages.replaced(page, "a", self.LINE, table)
        self.assertEqual(changed, "before\n<!-- table: a -->\n" + self.LINE
                         + "\n\n| x | y |\n| --- | --- |\n| 1 | 2 \\| 3 |\n<!-- /table -->\nmiddle\n"
                           "<!-- table: b -->\nkept\n<!-- /table -->\nafter\n")
        self.assertEqual(pages.replaced(changed, "a", self.LINE, table), changed)
        self.assertEqual(pages.names_in(changed), ["a", "b"])
        with self.assertRaises(ValueError):
            pages.replaced(page, "c", self.LINE, table)

    def test_every_marked_table_can_be_made(self):
        known = {(page, name) for page, name, _ in tables.TABLES}
        for page in dict.fromkeys(page for page, _ in known):
            for name in pages.names_in((ROOT / page).read_text()):
                self.assertIn((page, name), known)


class Numbers(unittest.TestCase):
    def test_three_digits(self):
        shown = [tables.number(value) for value in (0.0, 0.251, 4.301, 12.34, 630.4, float("inf"), None, 0.004)]
        self.assertEqual(shown, ["0", "0.25", "4.30", "12.3", "630", "never", "-", "0.004"])

    def test_nearly_none_is_not_none(self):
        shown = [tables.percent(value) for value in (0.0, 0.04, 0.5, 46.2, 97.6, 99.97, 100.0, None)]
        self.assertEqual(shown, ["0 %", "0.04 %", "0.5 %", "46 %", "98 %", "100.0 %", "100 %", "-"])

    def test_quantiles(self):
        self.assertEqual(read.quantile([3.0, 1.0, 2.0], 0.5), 2.0)
        self.assertAlmostEqual(read.quantile([0.0, 10.0], 0.9), 9.0)
        self.assertEqual(read.quantile([1.0, float("inf")], 0.5), float("inf"))
        self.assertIsNone(read.median([]))


RUNS = """\
    scenario,grade,method,seed,rmse_mm,lost_percent,false_alarm_percent,coverage95_percent,frames_to_converge,us_per_frame,frames
    S0-slow,ideal,dewpoint,1005001,0.25,0,0,100,0,200,180
    S0-slow,ideal,dewpoint,1005002,0.35,0,0,98,0,200,180
    S0-slow,ideal,barrera,1005001,4.77,0,,,0,20,180
    S4-desk-cloud,ideal,dewpoint,1005001,0.3,0,0,97,2,200,10
    S4-desk-cloud,ideal,dewpoint,1005002,,100,0,0,inf,200,10
    """


def results_of(folder, **files):
    for name, text in files.items():
        file = folder / name.replace("__", "/").replace("_csv", ".csv").replace("_json", ".json")
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(textwrap.dedent(text))
    people = plans.Shard("people-crossing-different-1005001-2", [], "people", seeds=(1005001, 2))
    starts = plans.Shard("starts", [], "starts", seeds=(1005001, 5))
    return read.Results(folder, [people, starts])


class Tables(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)

    def test_scenarios(self):
        made = tables.scenarios("ideal")(results_of(self.folder, suite__runs_csv=RUNS))
        self.assertEqual(made.head, ["scenario", "runs", "RMSE, median (mm)", "worst run", "lost", "false alarms",
                                     "in the 95 % ellipsoid", "also"])
        self.assertEqual(made.rows[0], ["`S0-slow`", "2", "0.30", "0.35", "0 %", "0 %", "99 %", ""])
        self.assertEqual(made.rows[1], ["`S4-desk-cloud`", "2", "0.30", "0.30", "50 %", "0 %", "48 %",
                                        "1 of 2 within 5 frames; 1 of 2 never found it"])
        self.assertEqual((made.methods, made.seeds), (["dewpoint"], [1005001, 1005002]))
        self.assertEqual(tables.scenarios("room")(results_of(self.folder)).rows, [])

    def test_peers_see_the_same_seeds(self):
        made = tables.peers("ideal")(results_of(self.folder, suite__runs_csv=RUNS))
        self.assertEqual(made.head, ["scenario", "runs", "`dewpoint`", "`barrera`"])
        # Seed 1005002 is dewpoint's alone; S4 has one method.
        self.assertEqual(made.rows, [["`S0-slow`", "1", "0.25 (0 %)", "4.77 (0 %)"]])
        self.assertEqual(made.seeds, [1005001])

    def test_requirements(self):
        made = tables.requirements(results_of(self.folder, suite__runs_csv=RUNS, suite__report_json="""{"bars": [
            {"requirement": "lost", "unit": "%", "low": "-inf", "high": 0.0, "runs": 4, "value": 100.0, "verdict": "not reached"},
            {"requirement": "inside", "unit": "%", "low": 92.0, "high": 98.0, "runs": 4, "value": 97.6, "verdict": "reached"},
            {"requirement": "frames", "unit": "frames", "low": "-inf", "high": 2.0, "runs": 1, "value": "inf", "verdict": "not reached"},
            {"requirement": "elsewhere", "unit": "", "low": "-inf", "high": 1.0, "runs": 0, "value": null, "verdict": "not measured"}
            ]}"""))
        self.assertEqual(made.rows, [["lost", "at most 0 %", "100 %", "4", "**not reached**"],
                                     ["inside", "92 to 98 %", "97.6 %", "4", "reached"],
                                     ["frames", "at most 2 frames", "never", "1", "**not reached**"]])

    def test_requirements_of_grades_and_belief(self):
        made = results_of(self.folder, suite__runs_csv=RUNS, suite__report_json="""{"bars": [
            {"requirement": "inside", "grade": "room", "next_version": true, "scenario": "S4-desk-cloud", "unit": "%",
             "low": 92.0, "high": 98.0, "runs": 72, "value": 14.0, "verdict": "not reached"}],
            "belief": [{"grade": "room", "method": "triangulation", "figures": {"nees": {"median": 3, "worst": 4, "worst_scenario": "S0"}}},
                       {"grade": "room", "method": "dewpoint", "figures": {
                           "nees": {"median": 5.0, "worst": "inf", "worst_scenario": "S4-desk-cloud"},
                           "coverage95_percent": {"median": null, "worst": null, "worst_scenario": ""}}}]}""")
        self.assertEqual(tables.requirements(made).rows,
                         [["inside", "room", "92 to 98 %", "14 % (`S4-desk-cloud`)", "72", "**not reached**, for the next version"]])
        self.assertEqual(tables.belief(made).rows, [["room", "nees", "5", "never", "`S4-desk-cloud`"],
                                                    ["room", "coverage95 percent", "-", "-", "-"]])

    def test_people(self):
        made = results_of(self.folder, **{"shards__people-crossing-different-1005001-2__runs_csv": """\
            scenario,clothes,method,seed,kept,mota,motp_m,hota,identity_switches,longest_ghost_s,longest_missed_s
            crossing,different,people,1005001,1,1,0.02,0.9,0,0,0.8
            crossing,different,people,1005002,0,0.5,nan,0.7,2,0.1,0.4
            """})
        self.assertEqual(tables.people_identities(made).rows, [["`crossing`", "different", "2", "1"]])
        self.assertEqual(tables.people_quality(made).rows,
                         [["`crossing`", "different", "`people`", "2", "0.750", "0.800", "20", "0.10", "0.80"]])

    def test_fidelity(self):
        made = results_of(self.folder, shards__convergence__convergence_csv="""\
            case,ball_x_m,ball_y_m,ball_z_m,start_x_m,start_y_m,start_z_m,half_x_m,half_y_m,half_z_m,first_seed,runs,converged,within,median_iterations,rmse_mm,depth_bias_mm
            "a, b",0.5,0.5,0.15,0.4,0.1,0.2,0,0,0,1005001,20,20,19,16,4.3,1.04
            c,0.5,0.5,0.15,0.5,0.5,1,2,2,1,1005001,20,0,0,,,
            """, shards__starts__boxes_csv="half_edge_m,share,share_within_3_cm\n0.2,1,0.9\n",
            shards__starts__points_csv="y_m,share,share_within_3_cm\n0.8,0.3,0\n", shards__convergence__drift_csv="""\
            first_seed,runs,iterations,mm_per_iteration
            1005001,50,5,5.94
            """)
        found = tables.convergence(made)
        self.assertEqual(found.head[3:6], ["converged", "of these within 3 cm", "iterations (median)"])
        self.assertEqual(found.rows, [["a, b", "(0.4, 0.1, 0.2)", "(0.5, 0.5, 0.15)", "20 of 20", "19", "16", "4.3 mm",
                                       "+1.0 mm"],
                                      ["c", "evenly spread, 4 x 4 x 2 m around (0.5, 0.5, 1)", "(0.5, 0.5, 0.15)",
                                       "0 of 20", "0", "-", "-", "-"]])
        self.assertEqual(pages.seed_words(found.seeds), "1005001 to 1005020")
        self.assertEqual(tables.drift(made).rows, [["first 5", "50", "5.9 mm"]])
        self.assertEqual(tables.starts(made).head, ["start", "", "converged", "and within 3 cm"])
        self.assertEqual([row[1:] for row in tables.starts(made).rows], [["0.2 m", "100 %", "90 %"], ["0.8 m", "30 %", "0 %"]])
        self.assertEqual(tables.starts(made).seeds, [1005001, 1005005])


# Does as dewpoint-cli, in no time: a run has an error of its seed in micrometers.
PROGRAM = """\
#!/usr/bin/env python3
import os, pathlib, sys
words = sys.argv[1:]
def option(name, usual=None):
    return words[words.index(name) + 1] if name in words else usual
def write(folder, name, lines):
    pathlib.Path(folder).mkdir(parents=True, exist_ok=True)
    (pathlib.Path(folder) / name).write_text("".join(line + "\\n" for line in lines))
HEAD = "scenario,grade,method,seed,rmse_mm,lost_percent,us_per_frame,frames"
out = option("--out")
if words[:2] == ["suite", "--list"]:
    if option("--grade", "ideal") not in ("ideal", "room"):
        sys.exit(2)
    print("S0   S0-slow                         20 seeds  Slow.\\n\\nmethods: dewpoint triangulation")
elif words[0] == "suite" and "--merge" in words:
    rows = [row for folder in words[words.index("--merge") + 1:]
            for row in (pathlib.Path(folder) / "runs.csv").read_text().splitlines()[1:]]
    write(out, "runs.csv", [HEAD, *rows])
    write(out, "report.json", ['{"bars": []}'])
elif words[0] == "suite":
    if os.path.exists(os.environ.get("BREAKS", "")):
        sys.exit(130)
    first, count = int(option("--first-seed")), int(option("--seeds"))
    write(out, "runs.csv", [HEAD, *[f"{option('--scenario')},{option('--grade')},{method},{seed},{seed / 1000},0,100,180"
                                    for method in option("--method").split(",") for seed in range(first, first + count)]])
elif words[1] == "seeds":
    print("block,first,last,what for\\nreporting,1005001,1006000,tables")
elif words[1] == "--help":
    print("Subcommands:\\n  people-crossing   Two people.\\n  seeds  Seeds.")
elif words[1] == "fingerprint":
    print("method,fingerprint\\ndewpoint,1a2b3c4d\\ntriangulation,00000001\\npeople,12345678\\nbarrera,0e000001")
elif words[1] == "people-crossing":
    write(out, "runs.csv", ["scenario,clothes,method,seed,kept", f"crossing,{option('--clothes')},people,{option('--seed')},1"])
elif words[1] == "convergence":
    write(out, "drift.csv", ["first_seed,runs,iterations,mm_per_iteration", "1005001,50,5,5.9"])
elif words[1] == "starts":
    write(out, "boxes.csv", ["half_edge_m,share", "0.2,0.5"])
"""
BENCH = """\
#!/usr/bin/env python3
import sys
name = sys.argv[1].split("=")[1]
open(name, "w").write('{"benchmarks": [{"name": "MOG2", "cpu_time": 6.0}, {"name": "people", "cpu_time": 2.0}]}')
"""


@unittest.skipUnless(shutil.which("snakemake") and (ROOT / ".git").exists(), "needs Snakemake and a checkout")
class WholeCommand(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)
        for name, text in (("dewpoint-cli", PROGRAM), ("people_bench", BENCH)):
            file = self.folder / "bin" / name
            file.parent.mkdir(exist_ok=True)
            file.write_text(text)
            file.chmod(file.stat().st_mode | stat.S_IXUSR)

    def run_figures(self, *options):
        command = [str(ROOT / "script" / "figures"), "--quick", "--dirty", "--bin", str(self.folder / "bin"),
                   "--out", str(self.folder / "out"), *options]
        environment = dict(os.environ, BREAKS=str(self.folder / "breaks"))
        return subprocess.run(command, capture_output=True, text=True, env=environment)

    def test_goes_on_and_makes_the_tables(self):
        before = (ROOT / "docs" / "accuracy.md").read_text()
        (self.folder / "breaks").touch()
        stopped = self.run_figures()
        self.assertEqual(stopped.returncode, 1, stopped.stderr)
        self.assertIn("the same command goes on", stopped.stderr)
        self.assertTrue((self.folder / "out" / "shards" / "convergence.done").is_file(), "the others were not run")
        (self.folder / "breaks").unlink()
        done = self.run_figures("--jobs", "1")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("grade wild: the program does not have it", done.stdout)
        made = {file.stem: file.read_text() for file in (self.folder / "out" / "tables").iterdir()}
        self.assertEqual(set(made), {"ideal", "room", "peers-ideal", "peers-room", "people-identities", "people-speed",
                                     "starts", "drift"})
        self.assertIn("; seeds 1005001; state `dewpoint` 1a2b3c4d.\n", made["ideal"])
        self.assertIn("| `S0-slow` | 1 | 1005 | 1005 | 0 % |  |", made["ideal"])
        self.assertIn("state `barrera` 0e000001.", made["drift"])
        self.assertIn("3.0x faster", made["people-speed"])
        self.assertEqual((ROOT / "docs" / "accuracy.md").read_text(), before, "--quick has changed a page")


class SavedCosts(unittest.TestCase):
    def test_measured_rows_stand_behind_the_estimates(self):
        folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, folder)
        file = folder / "costs.csv"
        shutil.copy(HERE / "costs.csv", file)
        loader = importlib.machinery.SourceFileLoader("figures", str(ROOT / "script" / "figures"))
        figures = importlib.util.module_from_spec(importlib.util.spec_from_loader("figures", loader))
        sys.modules["figures"] = figures  # its data classes look themselves up
        loader.exec_module(figures)
        rows = [("S0-slow", "room", "render", 2.0), ("S2-still", "room", "render", 4.0), ("people", "*", "run", 7.0)]
        for _ in range(2):  # a second time replaces the first
            figures.save_costs(rows, file)
        costs = plans.Costs.read(file)
        self.assertEqual([costs.of(scenario, "room", "render") for scenario in ("S0-slow", "S7-rates", "S4-desk-cloud")],
                         [2.0, 3.0, 0.4])
        self.assertEqual(costs.of("people", "-", "run"), 7.0)
        self.assertEqual(file.read_text().count("S0-slow"), 1)


if __name__ == "__main__":
    unittest.main()
