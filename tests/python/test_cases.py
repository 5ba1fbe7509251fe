# SPDX-License-Identifier: Apache-2.0
"""Cases from files, texts and dicts, and what is wrong with them. Working folder: that of the repository."""
import os
import pathlib
import pickle
import subprocess
import sys
import tempfile
import unittest

import numpy as np

import riprap
from scenes import BLOCK, PROGRAM, falling_block


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

    def test_a_lone_surrogate_is_told_with_its_place(self):
        half = "rock\udcff"  # as in the names of files that are not UTF-8
        for wrong, place in (
            (lambda: riprap.loads(f"title = '{half}'\n"), "the text of the case"),
            (lambda: riprap.loads("end = 1\n", name=half), "name"),
            (lambda: riprap.build({"title": half}), "title"),
            (lambda: riprap.build({half: 1}), "a key of the case"),
            (lambda: riprap.loads("end = 1\n", overrides={"title": half}), "title"),
            (lambda: riprap.loads("end = 1\n", overrides=[f"title={half}"]), "an override"),
        ):
            with self.assertRaisesRegex(ValueError, f"^{place} holds half of a surrogate pair"):
                wrong()

    def test_overrides_replace_keys(self):
        case = riprap.load("cases/stack", overrides={"end": 0.5, "body.cube.position": [0, 0, 0.75], "title": "Higher"})
        self.assertEqual((case.end, case.title), (0.5, "Higher"))
        self.assertEqual(riprap.load("cases/stack", ["end=500 ms"]).end, 0.5)

    def test_overrides_that_are_neither_a_dict_nor_texts_say_what_is_wanted(self):
        with self.assertRaisesRegex(TypeError, r'overrides is a str: give a dict, \{"end": 2.0\}'):
            riprap.load("cases/stack", overrides="end=2")
        with self.assertRaisesRegex(TypeError, "holds texts"):
            riprap.load("cases/stack", overrides=[("end", 2)])

    def test_an_override_that_is_wrong_is_told_in_words_of_python(self):
        with self.assertRaises(riprap.CaseError) as caught:
            riprap.load("cases/stack", overrides=["end"])
        self.assertIn("override end", str(caught.exception))
        self.assertNotIn("--", str(caught.exception))

    def test_the_examples_that_come_with_the_package_are_found_from_any_folder(self):
        here = os.getcwd()
        with tempfile.TemporaryDirectory() as folder:
            os.chdir(folder)
            try:
                self.assertIn("hello_block", riprap.list())
                self.assertEqual(riprap.load("hello_block").end, 1.0)
                self.assertEqual(len(riprap.load("armour_unit").warnings), 0)  # reads a file beside it
                with self.assertRaisesRegex(riprap.FileError, r"riprap.list\(\) knows; did you mean 'hello_block'"):
                    riprap.load("hello_blok")
                pathlib.Path("cases/hello_block").mkdir(parents=True)
                pathlib.Path("cases/hello_block/case.toml").write_text(
                    riprap.load("stack").text.replace("title", "title = \"Mine\" #", 1))
                self.assertEqual(riprap.load("hello_block").title, "Mine")
            finally:
                os.chdir(here)

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


if __name__ == "__main__":
    sys.exit(unittest.main())
