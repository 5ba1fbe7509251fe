# SPDX-License-Identifier: Apache-2.0
"""Steps beside other threads, and in processes made by fork(). Working folder: that of the repository."""
import multiprocessing
import sys
import threading
import time
import unittest

import riprap
from scenes import POOL, falling_block


class Threads(unittest.TestCase):
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

    def test_their_number_may_change_while_another_thread_steps(self):
        before = riprap.threads()
        plain, disturbed = finer_pool(), finer_pool()
        worker = threading.Thread(target=lambda: disturbed.step(40))
        try:
            worker.start()
            while worker.is_alive():
                for count in (1, 3, 2):
                    riprap.set_threads(count)
            worker.join()
        finally:
            riprap.set_threads(before)
        plain.step(40)
        self.assertEqual(disturbed.state_hash, plain.state_hash)


def finer_pool():
    """3200 particles, which threads share."""
    return riprap.Simulation(riprap.loads(POOL, overrides={"fluid.spacing": 0.0125}))


def go_on(connection, simulation):
    simulation.step(20)
    connection.send((riprap.threads(), simulation.state_hash))


@unittest.skipUnless("fork" in multiprocessing.get_all_start_methods(), "there is no fork() here")
class Forks(unittest.TestCase):
    def test_a_child_goes_on_with_one_thread_from_where_its_parent_was(self):
        before = riprap.threads()
        riprap.set_threads(3)
        try:
            simulation = finer_pool()
            simulation.step(20)  # by now threads wait for work, which fork() does not copy
            processes = multiprocessing.get_context("fork")
            ours, theirs = processes.Pipe()
            child = processes.Process(target=go_on, args=(theirs, simulation), daemon=True)
            child.start()
            self.assertTrue(ours.poll(60), "the child hangs")
            threads, state_hash = ours.recv()
            child.join()
            self.assertEqual((threads, riprap.threads()), (1, 3))
            simulation.step(20)
            self.assertEqual(state_hash, simulation.state_hash)
        finally:
            riprap.set_threads(before)


if __name__ == "__main__":
    sys.exit(unittest.main())
