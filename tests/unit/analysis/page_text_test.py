"""Numbers and names as the pages of a report show them."""

import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "analysis" / "pages"))
import page_text  # noqa: E402


class PageText(unittest.TestCase):
    def test_numbers_are_rounded_sensibly(self):
        self.assertEqual(page_text.rounded(1234), "1234")
        self.assertEqual(page_text.rounded(0.0123456), "0.0123")
        self.assertEqual(page_text.rounded(83.4567), "83.5")
        self.assertEqual(page_text.rounded(0.0000123), "1.23e-05")
        self.assertEqual(page_text.rounded(None), "-")
        self.assertEqual(page_text.fixed(-0.0001, 2), "0.00")

    def test_shares_keep_their_distance_from_one(self):
        self.assertEqual(page_text.percent(0.99853), "99.9 %")
        self.assertEqual(page_text.percent(0.99953), "99.95 %")
        self.assertEqual(page_text.percent(0.99999), "> 99.99 %")
        self.assertEqual(page_text.percent_down(0.98999), "98.9 %")

    def test_an_interval_decides_the_digits(self):
        estimate = {"value": 83.4567, "lower": 82.91, "upper": 83.97}
        self.assertEqual(page_text.with_interval(estimate), "83.5<br><small>82.9 to 84.0</small>")

    def test_texts_are_no_markup_and_break_between_words(self):
        self.assertEqual(page_text.code("a<b & \"c\""), "<code>a&lt;b &amp; &#34;c&#34;</code>")
        self.assertEqual(page_text.code("cage_stress_peak_MPa"), "<code>cage_<wbr>stress_<wbr>peak_<wbr>MPa</code>")

    def test_one_name_for_a_quantity(self):
        self.assertEqual(page_text.readable("pocket_force_peak_N"), "pocket force peak")
        self.assertEqual(page_text.readable("power_loss_W@start"), "power loss @ start")


if __name__ == "__main__":
    unittest.main()
