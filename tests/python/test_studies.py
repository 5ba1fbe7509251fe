# SPDX-License-Identifier: Apache-2.0
"""What a run left, and studies of many runs. Working folder: that of the repository."""
import concurrent.futures
import inspect
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import types
import unittest
import unittest.mock

import riprap


class Studies(unittest.TestCase):
    def test_a_study_runs_every_combination_and_goes_on_where_it_was(self):
        with tempfile.TemporaryDirectory() as folder:
            vary = {"end": [0.01, 0.02]}
            runs = riprap.sweep("hello_block", vary, folder, jobs=2)
            self.assertEqual([one["set"]["end"] for one in runs], [0.01, 0.02])
            self.assertEqual([one["run"].status for one in runs], ["finished", "finished"], [one["error"] for one in runs])
            written = pathlib.Path(folder, "run_001", "run.jsonl").stat().st_mtime_ns
            again = riprap.sweep("hello_block", vary, folder, jobs=2)
            self.assertEqual(again[1]["error"], "")
            self.assertEqual(pathlib.Path(folder, "run_001", "run.jsonl").stat().st_mtime_ns, written)
            page = pathlib.Path(folder, "index.html").read_text()
            self.assertIn('"name":"run_002"', page)
            study = json.loads(pathlib.Path(folder, "sweep.json").read_text())
            self.assertEqual(study["runs"][1]["set"], {"end": "0.02"})
            self.assertAlmostEqual(study["runs"][1]["columns"]["block.displacement.x"]["last"],
                                   runs[1]["run"].probes["block.displacement.x"][-1])

    def test_a_case_object_is_studied_with_what_replaced_its_keys(self):
        with tempfile.TemporaryDirectory() as folder:
            case = riprap.load("hello_block", overrides={"end": 0.02, "material.rock.friction_angle_deg": 10})
            runs = riprap.sweep(case, {"end": [0.01, "never"]}, folder, jobs=1)
            alone = riprap.run(riprap.load("hello_block", overrides={"end": 0.01, "material.rock.friction_angle_deg": 10}),
                               pathlib.Path(folder, "alone"))
            self.assertEqual(runs[0]["run"].summary["state_hash"], alone["state_hash"], runs[0]["error"])
            self.assertIsNone(runs[1]["run"])
            self.assertIn("never", runs[1]["error"])
            study = json.loads(pathlib.Path(folder, "sweep.json").read_text())
            self.assertEqual([one["status"] for one in study["runs"]], ["finished", "failed"])
            self.assertIn("never", study["runs"][1]["reason"])

    def test_runs_of_a_study_are_made_where_a_map_sends_them(self):
        """Python's own map, one of a pool that gives answers, and one that gives futures, as Dask's client does."""
        def futures(function, tasks):
            with concurrent.futures.ThreadPoolExecutor(1) as pool:
                return [pool.submit(function, task) for task in tasks]

        for name, way in (("map", map), ("futures", futures)):
            with self.subTest(name), tempfile.TemporaryDirectory() as folder:
                runs = riprap.sweep("hello_block", {"end": [0.01, "never"]}, folder, map=way)
                self.assertEqual(runs[0]["run"].status, "finished", runs[0]["error"])
                self.assertIn("never", runs[1]["error"])

    def test_an_ensemble_has_the_members_and_bands_of_the_command_line(self):
        text = riprap.load("hello_block", overrides={"end": 0.02}).text + (
            '\n[[spread]]\nkey = "material.rock.friction_angle_deg"\nlow = 10\nhigh = 25\n')
        with tempfile.TemporaryDirectory() as folder:
            place = pathlib.Path(folder)
            (place / "case.toml").write_text(text)
            case = riprap.load(place / "case.toml", overrides={"end": 0.02})
            study = riprap.ensemble(case, 3, place / "here", map=map)
            self.assertEqual([one["error"] for one in study], ["", "", ""])
            self.assertEqual(len({one["set"]["material.rock.friction_angle_deg"] for one in study}), 3)
            subprocess.run([os.environ["RIPRAP_PROGRAM"], "run", str(place / "case.toml"), "--set", "end=0.02", "--ensemble", "3",
                            "--quiet", "--out", str(place / "there")], check=True)
            for table in ("ensemble.csv", "bands.csv"):
                self.assertEqual((place / "here" / table).read_text(), (place / "there" / table).read_text())
            for k, one in enumerate(study, 1):
                self.assertEqual(one["run"].summary["state_hash"], riprap.open(place / "there" / f"member-{k}").summary["state_hash"])
            self.assertIn("member-3", (place / "here" / "index.html").read_text())
        with self.assertRaisesRegex(ValueError, "spread"), tempfile.TemporaryDirectory() as folder:
            riprap.ensemble("hello_block", 2, folder)

    def test_a_study_runs_on_dask_where_it_is_installed(self):
        try:
            import distributed
        except ImportError:
            self.skipTest("distributed is not installed")
        with tempfile.TemporaryDirectory() as folder, \
                distributed.Client(n_workers=2, threads_per_worker=1, dashboard_address=None) as client:
            runs = riprap.sweep("hello_block", {"end": [0.01, "never", 0.02]}, folder, map=client.map)
            self.assertEqual([one["run"].status if one["run"] else "" for one in runs], ["finished", "", "finished"])
            self.assertIn("never", runs[1]["error"])

    def test_a_machine_that_is_lost_is_the_error_of_its_run_alone(self):
        class Lost:
            def result(self):
                raise ConnectionError("no worker is left")

        with tempfile.TemporaryDirectory() as folder:
            runs = riprap.sweep("hello_block", {"end": [0.01, 0.02]}, folder,
                                map=lambda function, tasks: [function(tasks[0]), Lost()])
            self.assertEqual(runs[0]["run"].status, "finished", runs[0]["error"])
            self.assertEqual(runs[1]["error"], "ConnectionError: no worker is left")
            again = riprap.sweep("hello_block", {"end": [0.01, 0.02]}, folder, map=map)
            self.assertEqual([one["error"] for one in again], ["", ""])

    def test_a_study_is_a_table_with_a_row_for_each_run(self):
        """Of pandas, which is optional, DataFrame alone is needed; it takes a list of rows."""
        pandas = types.SimpleNamespace(DataFrame=list)
        with tempfile.TemporaryDirectory() as folder, unittest.mock.patch.dict(sys.modules, pandas=pandas):
            runs = riprap.sweep("hello_block", {"end": [0.01, 0.02]}, folder, map=map)
            rows = runs.table()
            self.assertEqual([row["end"] for row in rows], [0.01, 0.02])
            self.assertEqual([row["status"] for row in rows], ["finished", "finished"])
            self.assertEqual(rows[1]["block.displacement.x"], runs[1]["run"].probes["block.displacement.x"][-1])

    def test_a_run_is_opened_with_its_tables_as_arrays(self):
        with tempfile.TemporaryDirectory() as folder:
            out = pathlib.Path(folder, "run")
            riprap.run(riprap.load("hello_block", overrides={"end": 0.02}), str(out))
            run = riprap.open(out)
            self.assertEqual(run.status, "finished")
            self.assertAlmostEqual(run.probes["time"][-1], 0.02)
            self.assertEqual(run.probes.units["block.displacement.x"], "m")
            self.assertAlmostEqual(run["block.displacement.x"][-1], run.probes.at(1.0)["block.displacement.x"])
            with self.assertRaises(riprap.FileError):
                riprap.open(folder)
            with self.assertRaisesRegex(riprap.FileError, "did you mean '.*run'"):
                riprap.open(pathlib.Path(folder, "runn"))
            with self.assertRaisesRegex(KeyError, "did you mean 'block.displacement.x'"):
                run["block.displacement.xx"]

    def test_frames_hold_a_row_for_every_body_and_every_particle(self):
        with tempfile.TemporaryDirectory() as folder:
            case = riprap.load("floating_box", overrides={"fluid.spacing": 0.05, "end": 0.02, "output.interval": 0.01})
            riprap.run(case, folder, force=True)
            run = riprap.open(folder)
            self.assertEqual(len(run.times), len(run.frames))
            frame = run.frame(0.02)
            self.assertEqual(len(frame.bodies["position"]), len(run.body_names))
            self.assertEqual(frame.bodies["velocity"].shape, frame.bodies["position"].shape)
            box = run.body_names.index("box")
            simulation = riprap.Simulation(case)
            simulation.run()
            self.assertTrue((frame.bodies["position"][box] == simulation.bodies.position[box]).all())
            self.assertEqual(len(frame.water["pressure"]), len(simulation.fluid))
            self.assertEqual(sorted(frame.water["id"]), sorted(simulation.fluid.id))
            with self.assertRaisesRegex(KeyError, "did you mean 'pressure'"):
                frame.water["presure"]
            self.assertIn("water", repr(frame))

    def test_the_page_of_a_run_is_written_and_shown_in_notebooks(self):
        with tempfile.TemporaryDirectory() as folder:
            riprap.run(riprap.load("hello_block", overrides={"end": 0.01}), folder, force=True)
            run = riprap.open(folder)
            try:
                page = run.view()
            except riprap.FileError as error:  # built without Node.js
                self.assertIn("carries no page", str(error))
                return
            self.assertGreater(page.stat().st_size, 100_000)
            self.assertTrue(run._repr_html_().startswith("<iframe srcdoc="))

    def test_everything_that_editors_see_has_types(self):
        seen = [riprap.open, riprap.sweep, riprap.ensemble]
        for kind in (riprap.Frame, riprap.Run, riprap.Table):
            for name, member in vars(kind).items():
                member = member.fget if isinstance(member, property) else member
                if inspect.isfunction(member) and (name == "__init__" or not name.startswith("_")):
                    seen.append(member)
        for one in seen:
            names = set(inspect.signature(one).parameters) - {"self"} | {"return"}
            self.assertEqual(names - set(one.__annotations__), set(), one.__qualname__)


if __name__ == "__main__":
    unittest.main()
