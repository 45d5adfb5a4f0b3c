"""accuracy_page.py --check sees what is wrong with a page, and results survive being stored; rows from ladders and budgets."""

import tempfile
import unittest
from pathlib import Path
from unittest import mock

import accuracy_page
import budget_results
import results
import rung_results


class Check(unittest.TestCase):
    def faults_of(self, stored, text=None):
        with tempfile.TemporaryDirectory() as folder:
            page = Path(folder) / "ACCURACY.md"
            page.write_text(stored, encoding="utf-8")
            return accuracy_page.faults(text or accuracy_page.written(), page)

    def test_a_page_edited_by_hand_is_refused(self):
        text = accuracy_page.written()
        self.assertEqual(self.faults_of(text), [])
        self.assertIn("is not what accuracy_page.py writes", self.faults_of(text.replace("0.001", "0.002", 1))[0])

    def test_words_count_beside_tables_only(self):
        text = "| cell |\n" + "| word word |\n" * 2000 + "word\n" * 1500
        self.assertEqual(self.faults_of(text, text), [])
        self.assertIn("1501 words", self.faults_of(text + "word\n", text + "word\n")[0])

    def test_long_lines_are_found(self):
        self.assertIn("121 columns", self.faults_of("a" * 121, "a" * 121)[0])

    def test_a_case_without_its_test_is_found(self):
        cases = 'verification = [["", "", "", "", "unit.src, NoSuchSuite"], ["", "", "", "", "no.such.test"]]'
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "cases.toml").write_text(cases, encoding="utf-8")
            with mock.patch.object(accuracy_page, "HERE", Path(folder)):
                self.assertEqual(accuracy_page.missing_tests(), ["no.such.test", "unit.src, NoSuchSuite"])


class Results(unittest.TestCase):
    def test_are_read_as_written(self):
        with tempfile.TemporaryDirectory() as folder, mock.patch.object(results, "RESULTS", Path(folder)):
            results.write_results(Path(folder) / "a.json", {"commit": "c"}, rows=[("a", 1 / 3, float("nan"))], tables={
                "t": {"head": ["x"], "rows": [["1 \u00b1 2"]]}}, none=[])
            self.assertEqual(results.stored("a"), {"stamp": {"commit": "c"}, "rows": [["a", 0.333333, None]], "tables": {
                "t": {"head": ["x"], "rows": [["1 \u00b1 2"]]}}, "none": []})


class Ladders(unittest.TestCase):
    LADDER = {"reference": "full", "rungs": [{"name": name, "cost_ratio": cost} for name, cost in
                                             (("a", 0.1), ("b", 0.2), ("c", 0.5), ("full", 1))],
              "quantities": [{"quantity": "q", "mean": -2.0, "rungs": [
                  {"rung": "a", "shift": 0.01, "lower": 0, "upper": 0.02}, {"rung": "b", "shift": -0.3, "lower": -0.4, "upper": -0.2},
                  {"rung": "c", "shift": 0.09, "lower": 0.05, "upper": 0.13}]}]}

    def test_a_rung_below_a_bad_one_is_good_by_chance(self):
        self.assertEqual(rung_results.minimum_rung(self.LADDER, "q"), "c (0.50)")
        self.assertEqual(rung_results.minimum_rung(self.LADDER, "none"), "-")

    def test_shifts_are_in_per_cent(self):
        self.assertEqual(rung_results.shifts_of(self.LADDER, "q", ("c", "b")), "+4 ± 2, -15 ± 5")
        self.assertEqual(rung_results.shifts_of(self.LADDER, "none", ("c",)), "-")

    def test_a_budget_tells_what_is_resolved(self):
        error = {"value": 0.02, "lower": 0.01, "upper": 0.03}
        source = {"source": "slices", "state": "resolved", "error": error, "bound": 0.03, "standard_errors": 3}
        self.assertEqual(budget_results.cell(source, -2), "+1 ± 0.5")
        self.assertEqual(budget_results.cell(source | {"state": "unresolved"}, -2), "below 1.5")
        self.assertEqual(budget_results.cell(source | {"source": "statistical"}, -2), "±1.5")
        self.assertEqual(budget_results.cell(source | {"source": "noise", "standard_errors": 0.5}, -2), "25")


if __name__ == "__main__":
    unittest.main()
