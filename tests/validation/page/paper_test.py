"""Verdicts on claims from made-up responses: python3 -m unittest paper_test."""

import unittest

import numpy as np

from paper_judge import (AGREES, DISAGREES, OPEN, UNCLEAR, Difference, judge, judge_claim, mean_interval,
                         paired_difference)
from paper_page import CLAIMS, STUDIES, allowed_change

START = np.array([0.3, -0.2, 0.1, -0.1, 0.0])  # what the runs of all levels share


class Judged(unittest.TestCase):
    def test_mean_has_students_interval(self):
        mean, half = mean_interval([1, 2, 3, np.nan])
        self.assertAlmostEqual(mean, 2)
        self.assertAlmostEqual(half, 4.302653 / np.sqrt(3), 6)
        self.assertTrue(np.isnan(mean_interval([1])[1]))

    def test_starts_that_levels_share_drop_out(self):
        found = paired_difference(10 + START, 12 + START + [0.01, -0.01, 0, 0, 0])
        self.assertAlmostEqual(found.value, 2)
        self.assertLess(found.half, 0.02)
        self.assertAlmostEqual(found.first, 10.02)

    def test_runs_without_a_value_go_with_their_partners(self):
        found = paired_difference([1, 2, np.nan, 4], [2, 3, 9, np.nan])
        self.assertEqual((found.value, found.half, found.first), (1, 0, 1.5))

    def test_direction(self):
        for value, half, change, rises, falls in (
                (2, 1, 0, AGREES, DISAGREES), (2, 3, 0, OPEN, OPEN), (-2, 1, 0, DISAGREES, AGREES),
                (2, 0.5, 1, AGREES, DISAGREES), (2, 0.5, 3, DISAGREES, DISAGREES), (0, 0, 0, DISAGREES, DISAGREES),
                (np.nan, np.nan, 0, OPEN, OPEN)):
            found = Difference(value, half, 10)
            self.assertEqual(judge("rises", change, found), rises, found)
            self.assertEqual(judge("falls", change, found), falls, found)

    def test_level(self):
        for value, half, verdict in ((0, 0, AGREES), (0.2, 0.2, AGREES), (0.4, 0.2, OPEN), (1, 0.2, DISAGREES),
                                     (-1, 0.2, DISAGREES), (0, np.nan, OPEN)):
            self.assertEqual(judge("level", 0.5, Difference(value, half, 10)), verdict, value)

    def test_contradiction_is_not_judged(self):
        self.assertEqual(judge("unclear", 0, Difference(1, 0.1, 1)), UNCLEAR)

    def test_claim_counts_once(self):
        self.assertEqual(judge_claim([AGREES, AGREES]), AGREES)
        self.assertEqual(judge_claim([AGREES, DISAGREES, OPEN]), "agrees in part (1 of 3 readings)")
        self.assertEqual(judge_claim([OPEN, DISAGREES]), DISAGREES)
        self.assertEqual(judge_claim([OPEN, OPEN]), OPEN)
        self.assertEqual(judge_claim([UNCLEAR]), UNCLEAR)


class Claims(unittest.TestCase):
    def test_are_complete(self):
        for claim in CLAIMS:
            self.assertIn(claim["expected"], ("rises", "falls", "level", "unclear"), claim["text"])
            self.assertLessEqual(set(claim["studies"]), set(STUDIES), claim["text"])
            self.assertTrue(claim["readings"], claim["text"])
            if claim["expected"] == "level":
                self.assertGreater(allowed_change(claim, 10), 0, claim["text"])

    def test_change_is_a_share_of_the_first_mean_or_a_value(self):
        self.assertEqual(allowed_change({"at_least": 0.5}, -10), 5)
        self.assertEqual(allowed_change({"within_value": 0.1}, 10), 0.1)
        self.assertEqual(allowed_change({}, 10), 0)

    def test_readings_are_between_levels_of_their_studies(self):
        for claim in CLAIMS:
            for name in claim["studies"]:
                for _, start, end in claim["readings"]:
                    self.assertLessEqual({start, end}, set(STUDIES[name]["levels"]), claim["text"])


if __name__ == "__main__":
    unittest.main()
