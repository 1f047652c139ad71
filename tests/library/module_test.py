"""The module `flying` of Python: what it takes, what it answers, what it refuses."""

import json
import os
import pickle
import subprocess
import tempfile
import unittest

import numpy as np

import flying

FALL = {
    "until": 2.0,
    "world": {
        "field": {"kind": "uniform", "gravity": [0.0, -10.0]},
        "restitution": 0.5,
        "box": {"min": [-5, 0], "max": [5, 10]},
    },
    "body": [
        {"name": "ball", "shape": {"kind": "disc", "radius": 0.5}, "position": [0.0, 5.5]},
        {"name": "plate", "shape": {"kind": "polygon", "vertices": [[-1, -1], [1, -1], [1, 1], [-1, 1]],
                                    "holes": [[[-0.5, -0.5], [0.5, -0.5], [0, 0.5]]]},
         "position": [3.0, 2.0], "static": True},
    ],
}


class ModuleTest(unittest.TestCase):
    def test_a_dict_is_a_scene_and_states_are_arrays(self):
        world = flying.World(FALL)
        self.assertEqual((len(world), world.names, world.time, world.until), (2, ["ball", "plate"], 0.0, 2.0))
        self.assertTrue(world.advance(0.5))
        states = world.states()
        self.assertEqual((states.shape, states.dtype), ((2, len(flying.COLUMNS)), np.float64))
        # Free fall from 5.5 m: y = 5.5 - g t^2/2, v = -g t, in rounding
        np.testing.assert_allclose(states[0], [0.0, 4.25, 0.0, 0.0, -5.0, 0.0], rtol=1e-14, atol=1e-15)

    def test_numpy_numbers_and_arrays_may_stand_in_a_dict(self):
        scene = dict(FALL, until=np.float32(2.0))
        scene["body"] = [dict(FALL["body"][0], position=np.array([0.0, 5.5])), FALL["body"][1]]
        scene["world"] = dict(FALL["world"], friction=np.int64(0))
        one, other = flying.World(scene), flying.World(FALL)
        one.advance(2.0)
        other.advance(2.0)
        self.assertEqual(one.report()["hash"], other.report()["hash"])

    def test_a_dict_and_its_text_are_the_same_scene(self):
        one, other = flying.World(FALL), flying.World(flying.to_toml(FALL))
        one.advance(2.0)
        other.advance(2.0)
        self.assertEqual(one.report()["hash"], other.report()["hash"])

    def test_the_report_is_that_of_the_program(self):
        scene = flying.generate("gas", count=20, seed=4, radius=(0.1, 0.2), until=2)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "s.toml")
            report_path = os.path.join(folder, "r.json")
            with open(path, "w") as file:
                file.write(scene)
            subprocess.run([os.environ["FLYING_PROGRAM"], "simulate", path, "--quiet", "--report", report_path], check=True)
            with open(report_path) as file:
                expected = json.load(file)
        world = flying.World(scene)
        world.advance(2.0)
        found = world.report()
        self.assertEqual(list(found), list(expected))
        for key in ("time", "engine", "events", "collisions", "energy", "momentum", "hash", "bodies", "handover_log"):
            self.assertEqual(found[key], expected[key], key)
        self.assertGreater(found["collisions"], 20)

    def test_a_snapshot_and_a_pickled_world_go_on_with_the_same_bits(self):
        scene = flying.generate("pile", count=8, seed=6)
        whole = flying.World(scene)
        whole.advance(1.5)
        half = flying.World(scene)
        half.advance(0.7331)
        for again in (flying.World.resume(scene, half.snapshot()), pickle.loads(pickle.dumps(half))):
            self.assertEqual(again.time, 0.7331)
            again.advance(1.5)
            self.assertEqual(again.report()["hash"], whole.report()["hash"])
            np.testing.assert_array_equal(again.states(), whole.states())

    def test_a_bound_on_events_stops_early(self):
        world = flying.World(flying.generate("gas", count=20, seed=4))
        self.assertFalse(world.advance(5.0, max_events=10))
        self.assertEqual(world.events, 10)
        self.assertLess(world.time, 5.0)
        self.assertTrue(world.advance(5.0))

    def test_outlines_are_radii_and_rings(self):
        world = flying.World(FALL)
        self.assertEqual(world.outline(0), 0.5)
        outline, hole = world.outline(1)
        self.assertEqual((outline.shape, hole.shape), ((4, 2), (3, 2)))
        with self.assertRaisesRegex(IndexError, "no body number 2"):
            world.outline(2)

    def test_all_faults_of_a_scene_come_at_once(self):
        scene = dict(FALL, colour="red")
        scene["body"] = [dict(FALL["body"][0], shape={"kind": "disc", "radius": -1.0})]
        faults = flying.check(scene)
        self.assertEqual(len(faults), 2)
        with self.assertRaisesRegex(flying.SceneError, '"ball", shape.radius: found -1') as caught:
            flying.World(scene)
        self.assertEqual(caught.exception.faults, faults)
        self.assertEqual(flying.check(FALL), [])

    def test_what_no_scene_can_hold_is_refused_by_its_path(self):
        scene = dict(FALL, body=[{"shape": {1, 2}}])
        with self.assertRaisesRegex(TypeError, r"body\[0\]\.shape: found set"):
            flying.World(scene)
        with self.assertRaisesRegex(TypeError, "found int, expected TOML text or a dict"):
            flying.World(7)

    def test_options_that_are_none_are_refused(self):
        with self.assertRaisesRegex(flying.SceneError, '"fast"'):
            flying.World(FALL, engine="fast")
        with self.assertRaisesRegex(flying.SceneError, "far-features"):
            flying.World(FALL, without=["nothing"])
        with self.assertRaisesRegex(flying.SceneError, "positive number of seconds"):
            flying.World(FALL, step=0.0)
        with self.assertRaises(ValueError):
            flying.World(FALL).advance(float("nan"))
        with self.assertRaisesRegex(flying.SceneError, "--count"):
            flying.generate("gas", count=-1)
        with self.assertRaisesRegex(flying.SceneError, "cut short"):
            flying.World.resume(FALL, "{")


if __name__ == "__main__":
    unittest.main()
