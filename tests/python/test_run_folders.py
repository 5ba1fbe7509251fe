# SPDX-License-Identifier: Apache-2.0
"""Runs with a folder, and Ctrl-C. Working folder: that of the repository."""
import json
import os
import pathlib
import signal
import sys
import tempfile
import threading
import unittest

import numpy as np

import riprap
from scenes import POOL, falling_block


class Interrupts(unittest.TestCase):
    def test_ctrl_c_stops_a_long_step_between_two_steps(self):
        simulation = riprap.Simulation(falling_block(end=1000.0))
        timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
        timer.start()
        with self.assertRaises(KeyboardInterrupt):
            simulation.run()
        steps = simulation.steps
        self.assertGreater(steps, 0)
        self.assertEqual(simulation.step(5), 5)

    def test_ctrl_c_ends_a_run_with_a_folder_by_a_checkpoint_that_it_continues_from(self):
        with tempfile.TemporaryDirectory() as folder:
            case = falling_block(end=1000.0, output={"vtk": False, "interval": 1.0, "probe_interval": 1.0})
            timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
            timer.start()
            with self.assertRaises(KeyboardInterrupt):
                riprap.run(case, folder)
            summary = json.loads(pathlib.Path(folder, "summary.json").read_text())
            self.assertEqual(summary["reason"], "stopped by SIGINT")
            further = falling_block(end=summary["time"] + 0.01,
                                    output={"vtk": False, "interval": 1.0, "probe_interval": 1.0})
            self.assertEqual(riprap.run(further, folder, resume=True)["steps"], summary["steps"] + 100)


class RunFolders(unittest.TestCase):
    def test_a_callback_of_a_run_can_stop_it_and_cannot_step_or_keep_it(self):
        kept = []

        def look(s):
            kept.append((s, s.bodies.position, s.bodies.position.copy()))
            self.assertRaises(RuntimeError, s.step)
            return len(kept) < 3

        with tempfile.TemporaryDirectory() as folder:
            summary = riprap.run(falling_block(), folder, callback=look, every=10)
            self.assertEqual((summary["status"], summary["steps"]), ("interrupted", 30))
            with self.assertRaises(riprap.FileError):
                riprap.run(falling_block(), folder)
        for view, position, copy in kept:
            np.testing.assert_array_equal(position, copy)
            self.assertRaises(RuntimeError, lambda: view.time)

    def test_a_refused_folder_is_told_in_words_of_python(self):
        with tempfile.TemporaryDirectory() as folder:
            riprap.run(falling_block(), folder)
            with self.assertRaisesRegex(riprap.FileError, "resume=True continues it, force=True replaces it") as caught:
                riprap.run(falling_block(), folder)
            self.assertNotIn("--", str(caught.exception))
            with self.assertRaisesRegex(ValueError, "one of the two"):
                riprap.run(falling_block(), folder, resume=True, force=True)

    def test_runs_with_a_folder_come_one_at_a_time(self):
        def nested(_):
            riprap.run(falling_block(), pathlib.Path(folder, "inner"))

        with tempfile.TemporaryDirectory() as folder:
            with self.assertRaisesRegex(RuntimeError, "one at a time"):
                riprap.run(falling_block(), pathlib.Path(folder, "outer"), callback=nested)
            riprap.run(falling_block(), pathlib.Path(folder, "next"))

    def test_waves_are_read_from_the_gauges_of_a_run(self):
        gauges = "".join(f'[[output.gauge]]\nname = "g{i}"\nkind = "level"\npoint = [{x}, 0.0, 0.0]\n'
                         for i, x in enumerate((0.3, 0.5)))
        with tempfile.TemporaryDirectory() as folder:
            riprap.run(riprap.loads(POOL + gauges), folder)
            found = riprap.waves(folder)
            self.assertEqual([gauge["name"] for gauge in found["gauges"]], ["g0", "g1"])
            self.assertAlmostEqual(found["gauges"][0]["mean_level"], 0.5, delta=0.02)
            self.assertIsNone(found["reflection"])
            # In deep water a wave is g T^2 / (2 pi) long: far shorter than the 0.2 m between the gauges.
            self.assertRegex(riprap.waves(folder, period=0.01, depth=0.5)["why_no_reflection"],
                             "waves are 0.000156. m long")
            with self.assertRaisesRegex(ValueError, "no level or surface gauge 'g7'"):
                riprap.waves(folder, ["g7"])
            with self.assertRaisesRegex(ValueError, "no period or depth"):
                riprap.waves(folder, period=-1.0)

    def test_a_refused_step_and_a_failing_callback_come_out_of_a_run(self):
        with tempfile.TemporaryDirectory() as folder:
            with self.assertRaisesRegex(riprap.NumericalError, "velocity of block"):
                riprap.run(falling_block(solid={"max_speed": 1.0}), pathlib.Path(folder, "a"))
            with self.assertRaises(ZeroDivisionError):
                riprap.run(falling_block(), pathlib.Path(folder, "b"), callback=lambda s: 1 / 0)


class DamagedFolders(unittest.TestCase):
    """What a kill, a full disk or another program left is told, with its place; nothing else is raised, nothing waits."""

    def test_tables_summaries_and_frames_that_are_damaged_are_named(self):
        with tempfile.TemporaryDirectory() as folder:
            riprap.run(falling_block(end=0.02, output={"interval": 0.01, "probe_interval": 0.005}), folder)
            run = riprap.open(folder)
            table = pathlib.Path(folder, "ledger.csv")
            whole = table.read_text()
            rows = len(run.ledger["time"])
            table.write_text(whole[:-1])  # the last number may be cut
            self.assertEqual(len(run.ledger["time"]), rows - 1)
            lines = whole.splitlines(keepends=True)
            for damaged, word in ((lines[0] + lines[1] + "1,2\n" + lines[2], "line 3 has 2 fields"),
                                  (lines[0] + "x" + lines[1] + lines[2], "line 2, column 1 is 'x"),
                                  (lines[0] + '"' + lines[1] + lines[2], "line 2")):
                table.write_text(damaged)
                with self.assertRaisesRegex(riprap.FileError, word):
                    run.ledger
            table.unlink()
            os.mkfifo(table)
            with self.assertRaisesRegex(riprap.FileError, "not a regular file"):
                run.ledger
            for text in ('{"status": ', "[]"):
                pathlib.Path(folder, "summary.json").write_text(text)
                with self.assertRaisesRegex(riprap.FileError, "summary.json"):
                    run.status
            frame = sorted(pathlib.Path(folder, "frames").glob("bodies_*"))[0]
            whole = frame.read_text()
            for damaged in (whole[:len(whole) // 2], whole.replace("AQAAAAAAAAA", "AQAAAAA!!!"), ""):
                frame.write_text(damaged)
                with self.assertRaisesRegex(riprap.FileError, "is damaged"):
                    riprap.open(folder).frames[0].bodies


if __name__ == "__main__":
    sys.exit(unittest.main())
