# SPDX-License-Identifier: Apache-2.0
"""Steps, against the command line and against themselves. Working folder: that of the repository."""
import json
import pathlib
import subprocess
import sys
import tempfile
import time
import unittest

import numpy as np

import riprap
from scenes import POOL, PROGRAM, falling_block


class SameBits(unittest.TestCase):
    def command_line(self, *arguments):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([PROGRAM, "run", *arguments, "--out", folder, "--threads", "1", "--quiet"],
                           check=True, capture_output=True)
            return json.loads(pathlib.Path(folder, "summary.json").read_text())

    def assert_same(self, simulation, summary):
        self.assertEqual(simulation.state_hash, summary["state_hash"])
        self.assertEqual((simulation.steps, simulation.time), (summary["steps"], summary["time"]))
        ours = simulation.summary()
        for key in ("state_hash", "steps", "time_step", "retries", "ledger", "expects"):
            self.assertEqual(ours[key], summary[key], key)

    def test_blocks_stepped_one_by_one_have_the_bits_of_the_command_line(self):
        summary = self.command_line("cases/hello_block")
        simulation = riprap.Simulation(riprap.load("cases/hello_block"))
        while simulation.step():
            pass
        self.assert_same(simulation, summary)

    def test_water_stepped_in_portions_with_other_threads_has_the_bits_of_the_command_line(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "pool.toml")
            path.write_text(POOL)
            summary = self.command_line(path)
        simulation = riprap.Simulation(riprap.loads(POOL))
        threads = riprap.threads()
        riprap.set_threads(3)
        try:
            simulation.run(until=0.02)
            simulation.step(7, energy=True)
            simulation.run(callback=lambda s: s.fluid.position.sum(), every=5)
        finally:
            riprap.set_threads(threads)
        self.assertTrue(simulation.is_finished)
        self.assert_same(simulation, summary)

    def test_a_run_folder_from_python_is_that_of_the_command_line(self):
        summary = self.command_line("cases/hello_block")
        with tempfile.TemporaryDirectory() as folder:
            seen = []
            ours = riprap.run(riprap.load("cases/hello_block"), pathlib.Path(folder, "run"),
                              callback=lambda s: seen.append(s.state_hash), every=100)
            self.assertTrue(pathlib.Path(folder, "run", "out.pvd").exists())
        self.assertEqual(ours["state_hash"], summary["state_hash"])
        self.assertEqual(ours["expects"], summary["expects"])
        self.assertEqual(seen[-1], summary["state_hash"])
        self.assertEqual(len(seen), -(-summary["steps"] // 100))


class Stepping(unittest.TestCase):
    def test_quantities_and_the_ledger_are_those_of_the_tables(self):
        simulation = riprap.Simulation(falling_block())
        simulation.step(100, energy=True)
        fall = 0.5 * 9.81 * simulation.time**2
        self.assertAlmostEqual(simulation.value("block.displacement.z"), -0.7 * fall, delta=0.02 * fall)
        np.testing.assert_array_equal(simulation.value("block.position"), simulation.bodies.position[1])
        ledger = simulation.ledger
        self.assertEqual(ledger["solid.kinetic"], simulation.value("solid.kinetic"))
        self.assertTrue(np.isfinite(ledger["solid.elastic"]))
        with self.assertRaises(KeyError):
            simulation.value("block.colour")
        with self.assertRaises(KeyError):
            simulation.bodies.index("pebble")

    def test_energy_is_whole_at_the_last_step_before_a_time(self):
        simulation = riprap.Simulation(falling_block())
        simulation.run(until=0.0101, energy=True)
        self.assertTrue(np.isfinite(simulation.ledger["solid.elastic"]))

    def test_a_callback_comes_after_every_so_many_steps_and_may_stop(self):
        simulation = riprap.Simulation(falling_block())
        seen = []
        simulation.run(until=0.01, callback=lambda s: seen.append(s.steps), every=30)
        self.assertEqual(seen, [30, 60, 90, 100])
        self.assertEqual(simulation.run(callback=lambda s: False, every=8), 8)
        self.assertEqual(simulation.run(callback=lambda s: s.bodies.position[1, 2] > 1, every=8), 8)  # NumPy's False
        self.assertEqual(simulation.run(until=0.0132, callback=lambda s: 0), 16)

    def test_what_a_callback_raises_comes_out_and_the_run_goes_on_from_there(self):
        simulation = riprap.Simulation(falling_block())

        def stumble(s):
            raise LookupError("halfway")

        with self.assertRaisesRegex(LookupError, "halfway"):
            simulation.run(callback=stumble, every=50)
        self.assertEqual(simulation.steps, 50)
        simulation.run()
        self.assertTrue(simulation.is_finished)
        self.assertEqual(simulation.step(), 0)
        simulation.end = 0.31
        self.assertEqual(simulation.run(), 100)

    def test_numbers_that_blow_up_are_an_arithmetic_error_and_leave_the_last_good_state(self):
        simulation = riprap.Simulation(falling_block(solid={"max_speed": 1.0}))
        with self.assertRaisesRegex(riprap.NumericalError, "velocity of block"):
            simulation.run()
        steps = simulation.steps
        self.assertLess(abs(simulation.bodies.velocity).max(), 1.0)
        self.assertTrue(np.isnan(simulation.value("block.contact_force.z")))
        with self.assertRaises(ArithmeticError):
            simulation.step()
        self.assertEqual(simulation.steps, steps)

    def test_the_time_of_a_run_is_that_of_its_steps_not_of_what_lies_between(self):
        simulation = riprap.Simulation(falling_block())
        self.assertEqual(simulation.summary()["wall_seconds"], 0)
        simulation.step(100)
        seconds = simulation.summary()["wall_seconds"]
        self.assertGreater(seconds, 0)
        time.sleep(0.02)
        self.assertEqual(simulation.summary()["wall_seconds"], seconds)
        simulation.step()
        self.assertGreater(simulation.summary()["wall_seconds"], seconds)

    def test_what_exists_only_of_a_step_is_no_number_before_the_first(self):
        simulation = riprap.Simulation(falling_block())
        for name in ("momentum", "block.contact_force.z", "max_speed"):
            with self.assertRaisesRegex(RuntimeError, r"step\(\) first"):
                simulation.value(name)
        self.assertEqual(simulation.value("block.position.z"), 0.6)
        simulation.step()
        self.assertFalse(np.isnan(simulation.value("momentum")).any())

    def test_so_is_the_pressure_on_a_face(self):
        gauge = '[[output.gauge]]\nname = "p"\nkind = "wall_pressure"\npoint = [1.0, 0.2]\n'
        simulation = riprap.Simulation(riprap.loads(POOL + gauge))
        with self.assertRaisesRegex(RuntimeError, r"step\(\) first"):
            simulation.value("p")
        simulation.step(3)
        self.assertAlmostEqual(simulation.value("p"), 9810 * 0.3, delta=0.02 * 9810 * 0.3)

    def test_a_time_beyond_the_end_is_no_time_to_run_to(self):
        simulation = riprap.Simulation(falling_block())
        with self.assertRaisesRegex(ValueError, "until = 2.0 s lies beyond the end of the case, 0.3 s"):
            simulation.run(until=2.0)
        self.assertGreater(simulation.run(until=3 * 0.1), 0)  # which is more than 0.3 by round-off

    def test_a_simulation_shows_where_it_is(self):
        simulation = riprap.Simulation(falling_block())
        simulation.step(10)
        self.assertRegex(repr(simulation), r"'A block falls onto the ground': t = 0.00\d+ of 0.3 s, step 10, 2 bodies>")

    def test_wrong_numbers_are_value_errors(self):
        simulation = riprap.Simulation(falling_block())
        for wrong in (lambda: simulation.step(-1), lambda: simulation.run(callback=print, every=0),
                      lambda: riprap.set_threads(0), lambda: setattr(simulation, "end", float("nan"))):
            self.assertRaises(ValueError, wrong)


if __name__ == "__main__":
    sys.exit(unittest.main())
