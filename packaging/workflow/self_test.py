#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests of jobs.py and of the scripts of the profiles, with made-up sbatch and kubectl. Run by tests/cli/workflow_test.sh."""
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

import jobs

HERE = pathlib.Path(__file__).resolve().parent


class TableTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def jobs_of(self, text, name="table.csv", **config):
        table = self.folder / name
        table.write_text(text)
        return jobs.tracking_jobs(jobs.checked({"table": str(table), **config}))

    def test_each_method_seed_and_setting_is_a_job(self):
        made = self.jobs_of("recording,project,methods,settings\na,demo,,\nb,demo,barrera,particles=9 x=1\n",
                            methods=["dewpoint", "barrera"], seeds=[1, 2], settings=["", "kld_error=0"])
        self.assertEqual(len(made), 2 * 2 * 2 + 2)
        self.assertIn("a/dewpoint-kld_error=0/seed-2", made)
        job = made["b/barrera-particles=9-x=1/seed-1"]
        self.assertEqual(job.command_line("cli", 3),
                         "cli track demo --out runs/b/barrera-particles=9-x=1/seed-1 --label b --seed 1 --threads 3 "
                         "--method barrera --set particles=9 --set x=1")

    def test_paths_count_from_the_table(self):
        (self.folder / "day 1").mkdir()
        for name in ("project.toml", "truth.csv"):
            (self.folder / "day 1" / name).write_text("")
        made = self.jobs_of("recording\tproject\ttruth\tframes\nday 1\tday 1/project.toml\tday 1/truth.csv\t0:9\n",
                            "table.tsv")
        job = made["day-1/track-as-in-project/seed-1-frames-0-9"]
        self.assertEqual(job.project, str(self.folder / "day 1" / "project.toml"))
        self.assertEqual(job.evaluation_line("cli"), f"cli evaluate {job.folder} '{self.folder}/day 1/truth.csv' --save")

    def test_paths_of_the_configuration_count_from_its_folder(self):
        config = jobs.checked({"table": "lab.csv", "program": "bin/dewpoint-cli"}, "/lab")
        self.assertEqual((config.table, config.program), ("/lab/lab.csv", "/lab/bin/dewpoint-cli"))
        self.assertEqual(jobs.checked({}, "/lab").program, "dewpoint-cli")

    def test_list_is_written_when_it_changes(self):
        made = self.jobs_of("recording,project\na,demo\n", seeds=[1, 2])
        file = self.folder / "jobs.txt"
        jobs.write_list(file, made)
        self.assertEqual(file.read_text(), "runs/a/track-as-in-project/seed-1\nruns/a/track-as-in-project/seed-2\n")
        before = file.stat().st_ino
        jobs.write_list(file, made)
        self.assertEqual(file.stat().st_ino, before)

    def test_what_is_wrong_is_said(self):
        head = "recording,project"
        for text, word in [("recording\na\n", "column project is missing"), (f"{head},colour\na,b,c\n", "no colour"),
                           (f"{head}\n,demo\n", "line 2"), (f"{head}\na,demo\na,demo\n", "another job"),
                           (f"{head}\na\n", "line 2 has more or fewer cells"), (f"{head}\n", "no recordings"),
                           (f"{head},seeds\na,demo,1 x\n", "x is no seed"),
                           (f"{head},command\na,demo,guess\n", "command is track or people")]:
            with self.assertRaisesRegex(jobs.Failure, word):
                self.jobs_of(text)
        for config, word in [({"colour": 1}, "no colour"), ({"threads": 0}, "threads"), ({"seeds": [1.5]}, "seeds"),
                             ({"suite": {"scenario": "S0"}}, "no scenario")]:
            with self.assertRaisesRegex(jobs.Failure, word):
                jobs.checked(config)

    def test_suite_is_cut_into_blocks_of_seeds(self):
        shards = jobs.suite_shards(jobs.checked({"suite": {
            "scenarios": ["S0-slow", "S0-fast"], "grades": ["ideal"], "first_seed": 11, "seeds": 5, "seeds_per_shard": 2,
            "methods": ["dewpoint", "csrt"]}}))
        self.assertEqual([(one.first_seed, one.seeds) for one in shards.values()][:3], [(11, 2), (13, 2), (15, 1)])
        self.assertEqual(len(shards), 6)
        self.assertEqual(shards["S0-fast-ideal-15"].command_line("cli"),
                         "cli suite --part --scenario S0-fast --grade ideal --first-seed 15 --seeds 1 --out "
                         "suite/parts/S0-fast-ideal-15 --method dewpoint,csrt")
        self.assertEqual(jobs.suite_shards(jobs.checked({})), {})


class ProfileTest(unittest.TestCase):
    """The scripts, with a program in PATH that answers as Slurm or Kubernetes does."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def program(self, name, text):
        file = self.folder / name
        file.write_text("#!/bin/sh\n" + text)
        file.chmod(0o755)

    def run_script(self, script, *arguments, **variables):
        done = subprocess.run([HERE / "profiles" / script, *arguments], text=True, capture_output=True,
                              env={**os.environ, "PATH": f"{self.folder}:/usr/bin:/bin", **variables})
        return done.stdout.strip() or done.stderr.strip()

    def test_states_of_slurm(self):
        for state, answer in [("COMPLETED", "success"), ("RUNNING", "running"), ("PENDING", "running"),
                              ("REQUEUED", "running"), ("REQUEUE_HOLD", "running"), ("FAILED", "failed"),
                              ("NODE_FAIL", "failed"), ("CANCELLED", "failed"), ("TIMEOUT", "failed"),
                              ("OUT_OF_MEMORY", "failed")]:
            self.program("scontrol", f"echo 'JobId=7 JobName=x JobState={state} Reason=None'\n")
            self.assertEqual(self.run_script("slurm/slurm-status", "7"), answer)
        # Forgotten, with and without accounting.
        self.program("scontrol", "echo 'slurm_load_jobs error: Invalid job id specified' >&2; exit 1\n")
        self.program("sacct", "echo COMPLETED\n")
        self.assertEqual(self.run_script("slurm/slurm-status", "7"), "success")
        self.program("sacct", "exit 1\n")
        self.assertEqual(self.run_script("slurm/slurm-status", "7"), "failed")

    def test_states_of_kubernetes(self):
        for said, answer in [("Complete=True ", "success"), ("Failed=True ", "failed"), ("", "running")]:
            self.program("kubectl", f"echo '{said}'\n")
            self.assertEqual(self.run_script("kubernetes/kubernetes-status", "j"), answer)
        self.program("kubectl", "echo 'Error from server (NotFound): jobs j not found' >&2; exit 1\n")
        self.assertEqual(self.run_script("kubernetes/kubernetes-status", "j"), "failed")
        self.program("kubectl", "echo 'connection refused' >&2; exit 1\n")
        self.assertEqual(self.run_script("kubernetes/kubernetes-status", "j"), "running")

    def test_job_of_kubernetes(self):
        script = self.folder / "snakejob.sh"
        script.write_text('#!/bin/sh\n# properties = {"threads": 2, "resources": {"mem_mb": 500, "runtime": 3}}\ntrue\n')
        self.program("kubectl", f"cat >{self.folder}/job.json; echo job.batch/dewpoint-x1\n")
        variables = {"DEWPOINT_IMAGE": "lab/dewpoint", "DEWPOINT_CLAIM": "results", "DEWPOINT_VOLUME": "/data"}
        self.assertEqual(self.run_script("kubernetes/kubernetes-submit", str(script), **variables), "dewpoint-x1")
        spec = json.loads((self.folder / "job.json").read_text())["spec"]
        self.assertEqual(spec["activeDeadlineSeconds"], 180)
        container = spec["template"]["spec"]["containers"][0]
        self.assertEqual(container["command"], ["/bin/sh", str(script)])
        self.assertEqual(container["resources"]["requests"], {"cpu": "2", "memory": "500M"})
        self.assertIn("DEWPOINT_IMAGE", self.run_script("kubernetes/kubernetes-submit", str(script)))


if __name__ == "__main__":
    unittest.main()
