# SPDX-License-Identifier: Apache-2.0
"""Bodies, water and contacts as arrays. Working folder: that of the repository."""
import gc
import sys
import unittest

import numpy as np

import riprap
from scenes import POOL, falling_block


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

    def test_objects_that_no_constructor_has_made_are_refused(self):
        simulation = riprap.Simulation(riprap.loads(POOL))
        for made in (simulation.bodies, simulation.fluid, simulation, falling_block()):
            raw = type(made).__new__(type(made))
            for name in ("position", "mass", "ledger", "time", "title", "resolved"):
                if hasattr(type(made), name):
                    with self.assertRaises(TypeError):
                        getattr(raw, name)
        with self.assertRaises(TypeError):
            riprap.Simulation(riprap.Case.__new__(riprap.Case))

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


if __name__ == "__main__":
    sys.exit(unittest.main())
