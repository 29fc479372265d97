#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests of what script/figures is made of. Usage: self_test.py (tests/cli runs it)."""
import contextlib
import dataclasses
import importlib.machinery
import importlib.util
import io
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

VALIDATION = (1000001, 1006000)
CATALOG = plans.Catalog(["S0-slow", "S1-still-1"], ["dewpoint", "barrera"], ["ideal"], ["people-crossing"], 1006001,
                        1007000)
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
        shards = list(plans.suite_shards(found, COSTS, 1006001, 24.0))  # two runs of 12 or of 11 seconds
        self.assertEqual([shard.seeds for shard in shards],
                         [(1006001, 2), (1006003, 1), (1006004, 2), (1006006, 2)])
        self.assertEqual(len({shard.name for shard in shards}), 4)
        self.assertIn("dewpoint,barrera", shards[0].command)
        self.assertIn("dewpoint", shards[2].command)

    def test_methods_need_not_be_named(self):
        rules = [{"scenarios": ["R*"], "grades": ["real"], "methods": ["all"], "seeds": 2, "options": ["--clips", "{root}/a"]}]
        catalog = plans.Catalog(["S0", "R1-hand"], ["dewpoint"], ["real"], [], 1006001, 1007000)
        found = plans.amounts(rules, catalog)
        self.assertEqual([(one.scenario, one.method, one.seeds) for one in found], [("R1-hand", "all", 2)])
        shard, = plans.suite_shards(found, COSTS, 1006001, 100.0)
        self.assertNotIn("--method", shard.command)
        self.assertIn(str(ROOT / "a"), shard.command)

    def test_the_plan_that_is_kept_fits_into_its_hours(self):
        declared = plans.read_plan()
        costs = plans.Costs.read(HERE / "costs.csv")
        scenarios = [f"S{family}-{kind}" for family in range(23) for kind in ("a", "b", "c")]
        catalog = plans.Catalog(scenarios + ["S4-desk-cloud", "S5-eight"],
                                ["dewpoint", "dewpoint-smoothed", "barrera", "triangulation", "csrt"],
                                ["ideal", "room", "wild"], ["people-crossing", "people-apart"], 1006001, 1007000,
                                VALIDATION, ("barrera-fig4", "mohedano-fig1"))
        whole = plans.make_plan(declared, costs, catalog)
        self.assertLess(whole.hours(), 2.25)
        self.assertEqual({amount.seeds for amount in whole.amounts if amount.grade == "room" and amount.method == "dewpoint"
                          and not amount.scenario.startswith(("S1-", "S4-", "S5-"))}, {10})
        self.assertFalse(any(amount.method == "csrt" for amount in whole.amounts if amount.scenario == "S5-eight"))
        self.assertFalse(any(amount.seeds == 0 for amount in whole.amounts))
        self.assertEqual([shard.seeds[0] for shard in whole.shards if shard.kind == "barrera-fig4"],
                         [1006001, 1006002, 1006003, 1006004, 1006005])
        self.assertIn("figure barrera-fig5: the program does not have it; left out", whole.notes)
        self.assertTrue(any("real" in note for note in whole.notes))
        quick = plans.make_plan(declared, costs, catalog, quick=True)
        self.assertLess(quick.hours(), 0.25)
        self.assertTrue(quick.shards)
        self.assertTrue(whole.shards[-1].alone)
        self.assertEqual({shard.kind for shard in quick.shards if shard.kind.endswith(("fig1", "fig4"))},
                         {"barrera-fig4", "mohedano-fig1"})
        for shard in quick.shards:
            self.assertTrue(not shard.seeds or VALIDATION[0] <= shard.seeds[0] < sum(shard.seeds) <= 1006001, shard)
        self.assertIn("validation seeds, from 1005901 on: the tables stay out of the pages", quick.notes)
        with self.assertRaises(plans.Failure):  # reporting seeds
            plans.make_plan(declared, costs, dataclasses.replace(catalog, validation=(1000001, 1005900)), quick=True)
        self.assertFalse(any(amount.grade == "real" for amount in whole.amounts), "S* is rendered")
        recorded = dataclasses.replace(catalog, scenarios=["S5-four", "R1-hand"], grades=["ideal", "real"],
                                       skipped=["R1-bands is skipped: gone."])
        with_clips = plans.make_plan(declared, costs, recorded)
        self.assertEqual({amount.scenario for amount in with_clips.amounts if amount.grade == "real"}, {"R1-hand"})
        self.assertIn("R1-bands is skipped: gone.", with_clips.notes)
        quick_clips = plans.make_plan(declared, costs, recorded, quick=True)
        self.assertEqual([amount.seeds for amount in quick_clips.amounts if amount.grade == "real"], [1])
        with self.assertRaises(plans.Failure):  # the studies take their seeds from the same block
            plans.make_plan(declared, costs, dataclasses.replace(catalog, last_seed=1006900))


class Pages(unittest.TestCase):
    # The same line is read in tests/experiment/report/table_states_test.cpp.
    LINE = ("Commit `abc1234`; seeds 1006001 to 1006020; state `dewpoint` 1a2b3c4d, "
            "`triangulation-kalman` 00000001.")

    def test_the_state_stands_above_the_table(self):
        self.assertEqual(pages.state_line("abc1234", pages.seed_words([1006001, 1006002, 1006020]),
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

    def test_every_marked_table_can_be_made_and_every_other_one_has_a_place(self):
        known = [(page, name) for page, name, _ in tables.TABLES]
        marked = [(page, name) for page in dict.fromkeys(page for page, _ in known)
                  for name in pages.names_in((ROOT / page).read_text())]
        self.assertEqual(sorted(marked), sorted(known))

    def test_a_page_promises_tables_until_all_are_made(self):
        page = f"# A\n\n{pages.NOT_MADE}\n\nCommit `abc1234`; seeds 1; state older.\n"
        self.assertEqual(pages.without_promise(page), page)
        self.assertEqual(pages.without_promise(page.replace("; state older", "; state `dewpoint` 00000001")),
                         "# A\n\nCommit `abc1234`; seeds 1; state `dewpoint` 00000001.\n")

    def test_the_test_in_c_reads_the_same_promise(self):
        self.assertIn(pages.NOT_MADE, (ROOT / "tests" / "experiment" / "report" / "table_states.h").read_text())


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
    S0-slow,ideal,dewpoint,1006001,0.25,0,0,100,0,200,180
    S0-slow,ideal,dewpoint,1006002,0.35,0,0,98,0,200,180
    S0-slow,ideal,barrera,1006001,4.77,0,,,0,20,180
    S4-desk-cloud,ideal,dewpoint,1006001,0.3,0,0,97,2,200,10
    S4-desk-cloud,ideal,dewpoint,1006002,,100,0,0,inf,200,10
    """


def results_of(folder, **files):
    for name, text in files.items():
        file = folder / name.replace("__", "/").replace("_csv", ".csv").replace("_json", ".json")
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(textwrap.dedent(text))
    people = plans.Shard("people-crossing-ideal-different-1006001-2", [], "people", seeds=(1006001, 2))
    starts = plans.Shard("starts", [], "starts", seeds=(1006001, 5))
    studies = [plans.Shard("convergence", [], "convergence", seeds=(1006001, 20))]
    for name, seeds in (("barrera-fig3", 1), ("barrera-fig4", 2), ("barrera-fig5", 1), ("mohedano-fig1", 1),
                        ("sugandi-rmse", 1)):
        studies += [plans.Shard(f"{name}-{1006001 + k}", [], name, seeds=(1006001 + k, 1)) for k in range(seeds)]
    return read.Results(folder, [people, starts, *studies])


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
        self.assertEqual((made.methods, made.seeds), (["dewpoint"], [1006001, 1006002]))
        self.assertEqual(tables.scenarios("room")(results_of(self.folder)).rows, [])

    def test_peers_see_the_same_seeds(self):
        made = tables.peers("ideal")(results_of(self.folder, suite__runs_csv=RUNS))
        self.assertEqual(made.head, ["scenario", "runs", "`dewpoint`", "`barrera`"])
        # Seed 1006002 is dewpoint's alone; S4 has one method.
        self.assertEqual(made.rows, [["`S0-slow`", "1", "0.25 (0 %)", "4.77 (0 %)"]])
        self.assertEqual(made.seeds, [1006001])

    def test_of_a_costly_peer_fewer_runs_are_enough(self):
        head, *lines = textwrap.dedent(RUNS).splitlines()
        of_peer = [line for line in lines if line.startswith("S0-slow,ideal,barrera,")]
        again = [line.replace(",1006001,", ",1006002,") for line in of_peer]
        costly = [line.replace(",barrera,", ",csrt,") for line in of_peer]
        rows = "\n".join([head, *lines, *again, *costly]) + "\n"
        made = tables.peers("ideal")(results_of(self.folder, suite__runs_csv=rows))
        self.assertEqual(made.head, ["scenario", "runs", "`dewpoint`", "`barrera`", "`csrt`"])
        self.assertEqual(made.rows[0], ["`S0-slow`", "2", "0.30 (0 %)", "4.77 (0 %)", "4.77 (0 %; 1)"])

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
        self.assertEqual(tables.belief(made).rows, [["room", "NEES", "5", "never", "`S4-desk-cloud`"],
                                                    ["room", "in the 95 % ellipsoid, %", "-", "-", "-"]])

    def test_beyond_the_model(self):
        made = results_of(self.folder, suite__runs_csv="""\
            scenario,grade,method,seed,wrong_percent,wrong_when_sure_percent,coverage95_percent
            S0-slow,ideal,dewpoint,1006001,90,80,10
            S11-held,ideal,dewpoint,1006001,40,20,50
            S11-held,ideal,dewpoint,1006002,20,0,
            S11-held,ideal,triangulation-kalman,1006001,5,5,90
            S11-held,room,dewpoint,1006001,60,60,30
            """)
        self.assertEqual(tables.beyond_model(made).rows,
                         [["`S11-held`", "30 % (10 %)", "5 %", "50 %", "60 % (60 %)", "-", "30 %"]])

    def test_people(self):
        made = results_of(self.folder, **{"shards__people-crossing-ideal-different-1006001-2__runs_csv": """\
            scenario,grade,clothes,method,seed,kept,mota,motp_m,hota,identity_switches,longest_ghost_s,longest_missed_s
            crossing,room,different,people,1006001,1,1,0.02,0.9,0,0,0.8
            crossing,room,different,people,1006002,0,0.5,nan,0.7,2,0.1,0.4
            """})
        self.assertEqual(tables.people_identities(made).rows, [["`crossing`", "room", "different", "2", "1"]])
        self.assertEqual(tables.studies.people_heights(made).rows, [])  # none of that scene
        self.assertEqual(tables.people_quality(made).rows,
                         [["`crossing`", "room", "different", "`people`", "2", "0.750", "0.800", "20", "0.10", "0.80"]])

    def test_people_by_grades_in_their_order(self):
        made = results_of(self.folder, **{"shards__people-crossing-ideal-different-1006001-2__runs_csv": """\
            scenario,grade,clothes,method,seed,kept
            crossing,wild,different,people,1006001,1
            crossing,ideal,different,people,1006001,1
            """})
        self.assertEqual([row[1] for row in tables.people_identities(made).rows], ["ideal", "wild"])

    def test_fidelity(self):
        made = results_of(self.folder, shards__convergence__convergence_csv="""\
            case,ball_x_m,ball_y_m,ball_z_m,start_x_m,start_y_m,start_z_m,half_x_m,half_y_m,half_z_m,first_seed,runs,converged,within,median_iterations,rmse_mm,depth_bias_mm
            "a, b",0.5,0.5,0.15,0.4,0.1,0.2,0,0,0,1006001,20,20,19,16,4.3,1.04
            c,0.5,0.5,0.15,0.5,0.5,1,2,2,1,1006001,20,0,0,,,
            """, shards__starts__boxes_csv="half_edge_m,share,share_within_3_cm\n0.2,1,0.9\n",
            shards__starts__points_csv="y_m,share,share_within_3_cm\n0.8,0.3,0\n", shards__convergence__drift_csv="""\
            first_seed,runs,iterations,mm_per_iteration
            1006001,50,5,5.94
            """)
        found = tables.studies.convergence(made)
        self.assertEqual(found.head[3:6], ["converged", "of these within 3 cm", "iterations (median)"])
        self.assertEqual(found.rows, [["a, b", "(0.4, 0.1, 0.2)", "(0.5, 0.5, 0.15)", "20 of 20", "19", "16", "4.3 mm",
                                       "+1.0 mm"],
                                      ["c", "evenly spread, 4 x 4 x 2 m around (0.5, 0.5, 1)", "(0.5, 0.5, 0.15)",
                                       "0 of 20", "0", "-", "-", "-"]])
        self.assertEqual(pages.seed_words(found.seeds), "1006001 to 1006020")
        self.assertEqual(tables.studies.drift(made).rows, [["first 5", "50", "5.9 mm"]])
        self.assertEqual(tables.studies.starts(made).head, ["start", "", "converged", "and within 3 cm"])
        self.assertEqual([row[1:] for row in tables.studies.starts(made).rows], [["0.2 m", "100 %", "90 %"], ["0.8 m", "30 %", "0 %"]])
        self.assertEqual(tables.studies.starts(made).seeds, [1006001, 1006005])


    def test_heights(self):
        made = results_of(self.folder, **{"shards__people-crossing-ideal-different-1006001-2__people_csv": """\
            scenario,grade,clothes,method,seed,person,height_m,found,silhouette_recall,silhouette_precision,silhouette_iou,height_error_m
            heights,room,different,people,1006001,1,1.1,0,nan,nan,nan,nan
            heights,room,different,people,1006001,2,1.95,1,0.8,0.8,0.7,-0.02
            heights,room,different,people,1006002,2,1.9,0.5,0.7,0.8,0.7,0.03
            """})
        self.assertEqual(tables.studies.people_heights(made).rows,
                         [["room", "different", "`people`", "below 1.3 m", "1", "0 %", "-", "-"],
                          ["room", "different", "`people`", "1.6 m and more", "2", "75 %", "0.75", "5"]])

    def test_figures_of_the_papers(self):
        instants = "iteration,error_m,spread_along_axis_1_m,spread_across_it_m"
        made = results_of(self.folder, **{
            "shards__barrera-fig3-1006001__instants_csv": f"""\
            {instants},particles_in_image_1,particles_in_image_2
            2,0.9,0.04,0.04,97,0
            60,0.01,0.03,0.02,200,200
            """,
            "shards__barrera-fig4-1006001__instants_csv": f"{instants}\n20,0.5,0.06,0.02\n",
            "shards__barrera-fig4-1006002__instants_csv": f"{instants}\n20,0.7,0.04,0.04\n",
            "shards__barrera-fig5-1006001__cone_csv": """\
            step_m,stay_at_0.25_m,stay_at_1_m
            -0.03,0.2,0.5
            0,0.4,0.6
            0.030000000000000006,0.5,0.61
            """,
            "shards__mohedano-fig1-1006001__masks_csv": "time_s,regions,people,recall,precision\n1,3,2,0.7,0.9\n2,6,2,0.9,0.8\n",
            "shards__sugandi-rmse-1006001__sugandi-rmse_csv": """\
            clip,method,seeds,rmse_px,success,precision,worst_precision,ms_per_frame
            "simulated, fast ball",sugandi 100,3,12.16,0.66,0.947,0.9,0.65
            "simulated, fast ball",KCF,1,64.13,0.059,0.087,0.087,9
            """})
        (self.folder / "shards" / "lazy-color.txt").write_text(textwrap.dedent("""\
            the paper's arithmetic
                   N  windows, us    image, us        ratio
                 100         10.0         99.0         0.10
                3072        110.0        100.0         1.10
            windows alone stop paying at about 2900 particles (counted in pixels, as the paper does: 3072)

            the product
                   N  windows, us    image, us        ratio
                3072         10.0        100.0         0.10
            windows alone stop paying above 12000 particles (counted in pixels, as the paper does: 3072)

            """))
        studies, made = tables.studies, read.Results(self.folder, made.shards)
        self.assertEqual(studies.in_images(made).rows, [["2", "97", "0"], ["60", "200", "200"]])
        self.assertEqual(studies.cloud(made).rows,
                         [["20", "600 mm (500 mm to 700 mm)", "50 mm (40 mm to 60 mm)", "30 mm (20 mm to 40 mm)",
                           "58 % (33 % to 82 %)"]])
        self.assertEqual(studies.cloud(made).seeds, [1006001, 1006002])
        self.assertEqual(studies.cone(made).rows, [["0.25 m", "20 %", "50 %"], ["1 m", "50 %", "61 %"]])
        self.assertEqual(studies.masks(made).rows, [["1006001", "4.5", "2.0", "0.80", "0.85"]])
        self.assertEqual(studies.boxes(made).rows, [["simulated, fast ball", "12.2 (0.66, 95 %)", "64.1 (0.06, 9 %)"]])
        self.assertEqual(studies.boxes(made).seeds, [1006001, 1006002, 1006003])
        self.assertEqual(studies.lazy_color(made).rows, [["the paper's arithmetic", "at about 2900", "1.10"],
                                                         ["the product", "above 12000", "0.10"]])

    def test_what_is_not_there_makes_no_table(self):
        self.assertEqual(list(tables.all_made(results_of(self.folder))), [])

    def test_a_table_of_all_grades_says_that_recordings_are_missing(self):
        results = results_of(self.folder, suite__runs_csv=RUNS, suite__report_json="""{"bars": [
            {"requirement": "lost", "grade": "ideal", "unit": "%", "low": "-inf", "high": 0.0, "runs": 4, "value": 0.0, "verdict": "reached"}]}""")
        self.assertEqual(len(dict((name, one) for _, name, one in tables.all_made(results))["requirements"].rows), 1)
        results.recordings = False
        made = dict((name, one) for _, name, one in tables.all_made(results))["requirements"]
        self.assertEqual(made.rows[-1], ["grade `real`: not measured, recordings are missing", "-", "-", "-", "-", "-"])


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
    print("block,first,last,what for\\nvalidation,1000001,1006000,checks\\nreporting,1006001,1007000,tables")
elif words[1] == "--help":
    print("Subcommands:\\n  people-crossing   Two people.\\n  barrera-fig4   A cloud.\\n  seeds  Seeds.")
elif words[1] == "barrera-fig4":
    if os.path.exists(os.environ.get("NO_FIGURES", "")):
        sys.exit("cannot be written")
    write(out, "instants.csv", ["iteration,error_m,spread_along_axis_1_m,spread_across_it_m", "20,0.5,0.06,0.02"])
elif words[1] == "fingerprint":
    print("method,fingerprint\\ndewpoint,1a2b3c4d\\ntriangulation,00000001\\npeople,12345678\\nbarrera,0e000001")
elif words[1] == "people-crossing":
    write(out, "runs.csv", ["scenario,grade,clothes,method,seed,kept", f"crossing,{option('--grade')},{option('--clothes')},people,{option('--seed')},1"])
elif words[1] == "convergence":
    write(out, "drift.csv", ["first_seed,runs,iterations,mm_per_iteration", option("--seed") + ",50,5,5.9"])
elif words[1] == "starts":
    write(out, "boxes.csv", ["half_edge_m,share", "0.2,0.5"])
"""
BENCH = """\
#!/usr/bin/env python3
import sys
name = sys.argv[1].split("=")[1]
open(name, "w").write('{"benchmarks": [{"name": "MOG2", "cpu_time": 6.0}, {"name": "people", "cpu_time": 2.0}]}')
"""
LAZY = """\
#!/usr/bin/env python3
print("the product\\n       N  windows, us    image, us        ratio\\n    3072         10.0        100.0         0.10\\n"
      "windows alone stop paying above 12000 particles (counted in pixels, as the paper does: 3072)\\n")
"""


@unittest.skipUnless(shutil.which("snakemake") and (ROOT / ".git").exists(), "needs Snakemake and a checkout")
class WholeCommand(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)
        for name, text in (("dewpoint-cli", PROGRAM), ("people_bench", BENCH), ("lazy_color_bench", LAZY)):
            file = self.folder / "bin" / name
            file.parent.mkdir(exist_ok=True)
            file.write_text(text)
            file.chmod(file.stat().st_mode | stat.S_IXUSR)

    def run_figures(self, *options, **environment):
        command = [str(ROOT / "script" / "figures"), "--quick", "--dirty", "--bin", str(self.folder / "bin"),
                   "--out", str(self.folder / "out"), *options]
        environment = dict(os.environ, BREAKS=str(self.folder / "breaks"), NO_FIGURES=str(self.folder / "no-figures"),
                           **environment)
        return subprocess.run(command, capture_output=True, text=True, env=environment)

    def made(self):
        return {file.stem: file.read_text() for file in (self.folder / "out" / "tables").iterdir()}

    def test_goes_on_and_makes_the_tables(self):
        before = {page: (ROOT / page).read_text() for page in dict.fromkeys(page for page, _, _ in tables.TABLES)}
        for name in ("breaks", "no-figures"):
            (self.folder / name).touch()
        stopped = self.run_figures()
        self.assertEqual(stopped.returncode, 1, stopped.stderr)
        self.assertIn("the same command goes on", stopped.stderr)
        self.assertIn("no tables are made", stopped.stderr)
        self.assertTrue((self.folder / "out" / "shards" / "convergence.done").is_file(), "the others were not run")
        (self.folder / "breaks").unlink()
        # A study that fails takes no other table with it.
        done = self.run_figures("--jobs", "1")
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertIn("barrera-fig4-1005901: cannot be written", done.stderr)
        tables_but_one = {"ideal", "room", "peers-ideal", "peers-room", "people-identities", "people-speed", "starts",
                          "drift", "lazy-color"}
        self.assertEqual(set(self.made()), tables_but_one)
        (self.folder / "no-figures").unlink()
        done = self.run_figures("--jobs", "1")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("grade wild: the program does not have it", done.stdout)
        made = self.made()
        self.assertEqual(set(made), tables_but_one | {"cloud"})
        # Validation seeds, and so it says.
        self.assertTrue(all(text.startswith("Validation seeds, ") for text in made.values()))
        self.assertIn("; seeds 1005901; state `dewpoint` 1a2b3c4d.\n", made["ideal"])
        self.assertIn("| `S0-slow` | 1 | 1006 | 1006 | 0 % |  |", made["ideal"])
        self.assertIn("state `barrera` 0e000001.", made["drift"])
        self.assertIn("3.0x faster", made["people-speed"])
        for page, text in before.items():
            self.assertEqual((ROOT / page).read_text(), text, "--quick has changed a page")

    def test_says_in_one_sentence_that_recordings_are_not_there(self):
        done = self.run_figures("--plan", DEWPOINT_DATA=str(self.folder / "nowhere"))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stdout.count("nowhere"), 1)
        self.assertIn("Grade real is left out, and its tables stay as they are: there is no folder", done.stdout)
        self.assertNotIn("all 0", done.stdout)


def figures_module():
    loader = importlib.machinery.SourceFileLoader("figures", str(ROOT / "script" / "figures"))
    figures = importlib.util.module_from_spec(importlib.util.spec_from_loader("figures", loader))
    sys.modules["figures"] = figures  # its data classes look themselves up
    loader.exec_module(figures)
    return figures


class WrittenPages(unittest.TestCase):
    """What is written into pages, on copies of them."""

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)
        self.figures = figures_module()
        self.addCleanup(setattr, self.figures, "ROOT", self.figures.ROOT)
        self.figures.ROOT = self.folder
        for page in dict.fromkeys(page for page, _, _ in tables.TABLES):
            (self.folder / page).parent.mkdir(parents=True, exist_ok=True)
            blocks = "".join(f"{pages.begin(name)}\nCommit `abc1234`; seeds 1; state older.\n\nold\n{pages.END}\n"
                             for where, name, _ in tables.TABLES if where == page)
            (self.folder / page).write_text(f"# A\n\n{pages.NOT_MADE}\n\n{blocks}")

    def write(self, names, recordings):
        made = [(page, name, "Commit `abc1234`; seeds 1006001; state `a` 00000001.", "new " + name)
                for page, name, _ in tables.TABLES if name in names]
        return self.figures.write_pages(made, recordings)

    def text(self, page):
        return (self.folder / page).read_text()

    def test_what_is_not_made_stays_and_is_named(self):
        notes = self.write(["room", "drift"], True)
        self.assertIn("new room", self.text("docs/accuracy.md"))
        self.assertEqual(self.text("docs/accuracy.md").count("\nold\n"), len(pages.names_in(self.text("docs/accuracy.md"))) - 1)
        self.assertIn("docs/accuracy.md: the table 'ideal' was not made and stays as it is", notes)
        self.assertIn(pages.NOT_MADE, self.text("docs/fidelity.md"))

    def test_without_recordings_their_tables_stay(self):
        every = [name for _, name, _ in tables.TABLES]
        notes = self.write(every, False)
        for page in ("docs/accuracy.md", "docs/method-sugandi.md"):
            self.assertIn(pages.NOT_MADE, self.text(page))
        self.assertNotIn("new real", self.text("docs/accuracy.md"))
        self.assertNotIn("new peers-real", self.text("docs/accuracy.md"))
        self.assertIn("docs/accuracy.md: the table 'real' stays as it is, for recordings are missing", notes)
        self.assertFalse(any("real' was not made" in note for note in notes), notes)
        self.assertNotIn(pages.NOT_MADE, self.text("docs/fidelity.md"), "all its tables are made")
        self.assertEqual(self.write(every, True), [])
        self.assertNotIn(pages.NOT_MADE, self.text("docs/accuracy.md"))

    def test_a_table_of_an_unknown_state_is_for_no_page(self):
        results = results_of(self.folder, suite__runs_csv=RUNS, shards__fingerprint_csv="method,fingerprint\ndewpoint,00000001\n")
        with contextlib.redirect_stdout(io.StringIO()) as said:
            made = self.figures.make_tables(self.folder, results, self.figures.CodeState("abc1234", "abc1234"), False)
        self.assertEqual([name for _, name, _, _ in made], ["ideal"])  # the peers' has barrera's numbers, too
        self.assertIn("the table 'peers-ideal' is for no page: of barrera there is no state", said.getvalue())

    def test_processor_time_is_that_of_what_a_shell_waited_for(self):
        file = self.folder / "a.times"
        file.write_text("0m0.002s 0m0.001s\n1m2.500s 0m0.250s\n")
        self.assertEqual(self.figures.processor_seconds(file), 62.75)
        self.assertIsNone(self.figures.processor_seconds(self.folder / "b.times"))


class SavedCosts(unittest.TestCase):
    def test_measured_rows_stand_behind_the_estimates(self):
        folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, folder)
        file = folder / "costs.csv"
        shutil.copy(HERE / "costs.csv", file)
        figures = figures_module()
        rows = [("S0-slow", "room", "render", 2.0), ("S2-still", "room", "render", 4.0), ("people", "*", "run", 7.0)]
        for _ in range(2):  # a second time replaces the first
            figures.save_costs(rows, file)
        costs = plans.Costs.read(file)
        self.assertEqual([costs.of(scenario, "room", "render") for scenario in ("S0-slow", "S8-ramp", "S4-desk-cloud")],
                         [2.0, 3.0, 0.4])
        self.assertEqual(costs.of("people", "wild", "run"), 7.0)
        self.assertEqual(file.read_text().count("S0-slow"), 1)


if __name__ == "__main__":
    unittest.main()
