# SPDX-License-Identifier: Apache-2.0
"""What a run left, and studies of many runs. Working folder: that of the repository."""
import pathlib
import tempfile
import unittest

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

    def test_a_run_is_opened_with_its_tables_as_arrays(self):
        with tempfile.TemporaryDirectory() as folder:
            out = pathlib.Path(folder, "run")
            riprap.run(riprap.load("hello_block", overrides={"end": 0.02}), str(out))
            run = riprap.open(out)
            self.assertEqual(run.status, "finished")
            self.assertAlmostEqual(run.probes["time"][-1], 0.02)
            self.assertEqual(run.probes.units["block.displacement.x"], "m")
            with self.assertRaises(riprap.FileError):
                riprap.open(folder)


if __name__ == "__main__":
    unittest.main()
