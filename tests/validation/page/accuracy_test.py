"""accuracy_page.py --check sees what is wrong with a page, and results survive being stored."""

import tempfile
import unittest
from pathlib import Path
from unittest import mock

import accuracy_page
import results


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


if __name__ == "__main__":
    unittest.main()
