# SPDX-License-Identifier: Apache-2.0
"""The Python package against the command line and against itself. Working folder: that of the repository."""
import gc
import json
import os
import pathlib
import pickle
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest

import numpy as np

import riprap

PROGRAM = os.environ["RIPRAP_PROGRAM"]

BLOCK = {
    "title": "A block falls onto the ground",
    "gravity": [0.0, 0.0, -9.81],
    "end": 0.3,
    "time_step": 1e-4,
    "material": {"rock": {"density": 2500.0, "normal_stiffness": "10 MPa", "friction_coefficient": 0.5}},
    "body": [
        {"name": "ground", "shape": {"half_space": {"normal": [0, 0, 1]}}, "material": "rock", "fixed": True},
        {"name": "block", "shape": {"cube": 1.0}, "position": [0, 0, 0.6], "material": "rock"},
    ],
    "solid": {"local_damping": 0.3},
}

POOL = """
title = "A box floats in a planar tank"
dimension = 2
gravity = [0.0, -9.81, 0.0]
end = 0.05
[material.wood]
density = 500.0
normal_stiffness = "1 MPa"
[fluid]
spacing = 0.05
domain = { low = [-0.2, -0.2, 0.0], high = [1.2, 1.5, 0.0] }
[[fluid.region]]
box = { low = [0.0, 0.0, 0.0], high = [1.0, 0.5, 0.0] }
[[body]]
name = "floor"
shape = { half_space = { normal = [0.0, 1.0, 0.0] } }
material = "wood"
fixed = true
[[body]]
name = "left"
shape = { half_space = { normal = [1.0, 0.0, 0.0] } }
material = "wood"
fixed = true
[[body]]
name = "right"
shape = { half_space = { normal = [-1.0, 0.0, 0.0], offset = -1.0 } }
material = "wood"
fixed = true
"""


def falling_block(**keys):
    return riprap.build({**BLOCK, **keys})


class Cases(unittest.TestCase):
    def test_every_problem_of_a_case_is_in_the_exception_with_its_place(self):
        text = "end = -1\n\n[material.rock]\ndensity = 2500.0\nnormal_stifness = 1e7\n"
        with self.assertRaises(riprap.CaseError) as caught:
            riprap.loads(text, name="wrong.toml")
        problems = caught.exception.problems
        self.assertGreaterEqual(len(problems), 2)
        end = next(problem for problem in problems if problem.line == 1)
        self.assertEqual((end.file, end.column), ("wrong.toml", 7))
        slip = next(problem for problem in problems if problem.line == 5)
        self.assertIn("normal_stiffness", slip.message + slip.allowed)
        self.assertIn("wrong.toml:5:1: ", str(caught.exception))
        self.assertIsInstance(caught.exception, ValueError)

    def test_a_case_file_says_the_same_as_on_the_command_line(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "case.toml")
            path.write_text("gravity = 3\n")
            said = subprocess.run([PROGRAM, "check", path], capture_output=True, text=True).stderr
            with self.assertRaises(riprap.CaseError) as caught:
                riprap.load(path)
            self.assertTrue(said.startswith(str(caught.exception) + "\n"), said)

    def test_a_dict_is_the_case_of_the_same_keys(self):
        loaded = riprap.load("cases/stack")
        built = riprap.build(loaded.resolved)
        self.assertEqual(built.resolved, loaded.resolved)
        self.assertEqual(built.body_names, ["ground"] + [f"cube[{i}]" for i in range(5)])

    def test_numbers_of_numpy_and_tuples_are_taken(self):
        case = falling_block(gravity=np.array([0, 0, -1.62]), end=np.float64(0.25), seed=np.int64(7))
        self.assertEqual(case.resolved["gravity"], [0, 0, -1.62])
        self.assertEqual(case.end, 0.25)

    def test_what_no_case_can_hold_is_a_type_error_that_names_its_key(self):
        with self.assertRaisesRegex(TypeError, r"body\[1\]\.position\[2\] is a complex"):
            body = {**BLOCK["body"][1], "position": [0, 0, 1j]}
            falling_block(body=[BLOCK["body"][0], body])
        endless = dict(BLOCK)
        endless["solid"] = endless
        with self.assertRaisesRegex(TypeError, "too deep"):
            riprap.build(endless)

    def test_overrides_replace_keys(self):
        case = riprap.load("cases/stack", overrides={"end": 0.5, "body.cube.position": [0, 0, 0.75], "title": "Higher"})
        self.assertEqual((case.end, case.title), (0.5, "Higher"))
        self.assertEqual(riprap.load("cases/stack", ["end=500 ms"]).end, 0.5)

    def test_the_exception_of_a_case_crosses_processes_whole(self):
        with self.assertRaises(riprap.CaseError) as caught:
            riprap.loads("gravity = 3")
        copy = pickle.loads(pickle.dumps(caught.exception))
        self.assertEqual((str(copy), copy.problems), (str(caught.exception), caught.exception.problems))

    def test_a_missing_file_is_an_os_error(self):
        with self.assertRaises(OSError) as caught:
            riprap.load("no/such/case.toml")
        self.assertIsInstance(caught.exception, riprap.FileError)

    def test_check_predicts_a_run_without_making_it(self):
        check = falling_block().check()
        self.assertEqual((check["bodies"], check["free_bodies"], check["mass"]), (2, 1, 2500))
        self.assertEqual(check["steps"], 3000)


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


class Arrays(unittest.TestCase):
    def test_fields_are_shown_without_a_copy_and_cannot_be_written(self):
        simulation = riprap.Simulation(falling_block())
        x = simulation.bodies.position
        self.assertEqual((x.shape, x.dtype), ((2, 3), np.float64))
        self.assertEqual(x.__array_interface__["data"], simulation.bodies.position.__array_interface__["data"])
        self.assertFalse(x.flags.owndata)
        with self.assertRaises(ValueError):
            x[1, 2] = 0
        with self.assertRaises(ValueError):
            x.flags.writeable = True
        np.testing.assert_array_equal(x[1], [0, 0, 0.6])
        np.testing.assert_array_equal(simulation.bodies.orientation[1], [1, 0, 0, 0])

    def test_memory_of_fields_that_nobody_holds_stays_where_it_is(self):
        simulation = riprap.Simulation(falling_block())
        before = simulation.bodies.velocity.__array_interface__["data"][0]
        simulation.step(10)
        self.assertEqual(simulation.bodies.velocity.__array_interface__["data"][0], before)

    def test_an_array_keeps_showing_its_moment_through_steps_and_the_end_of_its_simulation(self):
        simulation = riprap.Simulation(riprap.loads(POOL))
        moments = []
        for _ in range(5):
            x = simulation.fluid.position
            moments.append((x, x.copy()))
            simulation.step(3)
        last = simulation.fluid.velocity
        copy = last.copy()
        bodies = simulation.bodies
        del simulation, bodies
        gc.collect()
        moments.append((last, copy))
        for x, copy in moments:
            np.testing.assert_array_equal(x, copy)
        self.assertFalse(np.array_equal(moments[0][0], moments[4][0]))

    def test_holding_arrays_changes_no_bit(self):
        held, plain = (riprap.Simulation(riprap.loads(POOL)) for _ in range(2))
        kept = []
        held.run(callback=lambda s: kept.append((s.bodies.position, s.fluid.density)))
        plain.run()
        self.assertEqual(held.state_hash, plain.state_hash)

    def test_water_has_its_hydrostatic_pressure_and_every_particle_its_number(self):
        simulation = riprap.Simulation(riprap.loads(POOL))
        simulation.step()
        fluid = simulation.fluid
        self.assertEqual(len(fluid), 200)
        self.assertEqual(sorted(fluid.id), list(range(200)))
        self.assertEqual(fluid.id.dtype, np.int32)
        depth = 0.5 - fluid.position[:, 1]
        np.testing.assert_allclose(fluid.pressure, 1000 * 9.81 * depth, atol=0.1 * 1000 * 9.81 * 0.5)
        self.assertAlmostEqual(len(fluid) * fluid.particle_mass, 500, delta=1)
        self.assertIsNone(riprap.Simulation(falling_block()).fluid)

    def test_a_block_at_rest_is_carried_by_its_contacts(self):
        simulation = riprap.Simulation(falling_block(end=4.0, solid={"local_damping": 0.6}))
        self.assertIsNone(simulation.contacts)
        self.assertIsNone(simulation.bodies.contact_force)
        simulation.run()
        weight = 2500 * 9.81
        block = simulation.bodies.index("block")
        np.testing.assert_allclose(simulation.bodies.contact_force[block], [0, 0, weight], atol=1e-3 * weight)
        contacts = simulation.contacts
        self.assertEqual(set(contacts["body_a"]) | set(contacts["body_b"]), {0, 1})
        self.assertAlmostEqual(contacts["normal_force"].sum() / weight, 1, places=3)
        self.assertTrue((contacts["overlap"] > 0).all())
        self.assertLess(abs(simulation.bodies.velocity[block]).max(), 1e-3)


class Stepping(unittest.TestCase):
    def test_quantities_and_the_ledger_are_those_of_the_tables(self):
        simulation = riprap.Simulation(falling_block())
        simulation.step(100, energy=True)
        fall = 0.5 * 9.81 * simulation.time**2
        self.assertAlmostEqual(simulation.value("block.displacement.z"), -0.7 * fall, delta=0.02 * fall)
        np.testing.assert_array_equal(simulation.value("block.position"), simulation.bodies.position[1])
        ledger = simulation.ledger
        self.assertEqual(ledger["kinetic_energy"], simulation.value("kinetic_energy"))
        self.assertTrue(np.isfinite(ledger["elastic_energy"]))
        with self.assertRaises(KeyError):
            simulation.value("block.colour")
        with self.assertRaises(KeyError):
            simulation.bodies.index("pebble")

    def test_energy_is_whole_at_the_last_step_before_a_time(self):
        simulation = riprap.Simulation(falling_block())
        simulation.run(until=0.0101, energy=True)
        self.assertTrue(np.isfinite(simulation.ledger["elastic_energy"]))

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

    def test_other_threads_run_meanwhile_and_cannot_disturb(self):
        simulation = riprap.Simulation(falling_block(end=30.0))
        refused, ticks = [], 0
        done = threading.Event()

        def step():
            simulation.step(20000)
            done.set()

        worker = threading.Thread(target=step)
        worker.start()
        while not done.is_set():
            ticks += 1
            try:
                simulation.bodies.position.sum()
            except RuntimeError as error:
                refused.append(str(error))
            time.sleep(0.001)
        worker.join()
        self.assertGreater(ticks, 1)
        self.assertTrue(refused and all("another thread" in text for text in refused))
        self.assertEqual(simulation.steps, 20000)

    def test_wrong_numbers_are_value_errors(self):
        simulation = riprap.Simulation(falling_block())
        for wrong in (lambda: simulation.step(-1), lambda: simulation.run(callback=print, every=0),
                      lambda: riprap.set_threads(0), lambda: setattr(simulation, "end", float("nan"))):
            self.assertRaises(ValueError, wrong)


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

    def test_runs_with_a_folder_come_one_at_a_time(self):
        def nested(_):
            riprap.run(falling_block(), pathlib.Path(folder, "inner"))

        with tempfile.TemporaryDirectory() as folder:
            with self.assertRaisesRegex(RuntimeError, "one at a time"):
                riprap.run(falling_block(), pathlib.Path(folder, "outer"), callback=nested)
            riprap.run(falling_block(), pathlib.Path(folder, "next"))

    def test_a_refused_step_and_a_failing_callback_come_out_of_a_run(self):
        with tempfile.TemporaryDirectory() as folder:
            with self.assertRaisesRegex(riprap.NumericalError, "velocity of block"):
                riprap.run(falling_block(solid={"max_speed": 1.0}), pathlib.Path(folder, "a"))
            with self.assertRaises(ZeroDivisionError):
                riprap.run(falling_block(), pathlib.Path(folder, "b"), callback=lambda s: 1 / 0)


if __name__ == "__main__":
    sys.exit(unittest.main())
