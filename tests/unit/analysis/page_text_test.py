"""Numbers and names as the pages of a report show them."""

import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "analysis" / "pages"))
import page_text  # noqa: E402
import common  # noqa: E402  beside the figures, which page_text has found
import page_parts  # noqa: E402


class PageText(unittest.TestCase):
    def test_characters_without_a_font_are_named(self):
        latin_only = lambda c: b""  # noqa: E731
        self.assertEqual(page_text.without_font("NU 205, 5 µm ≥ Ø, Δ", latin_only), "")
        self.assertRegex(page_text.without_font("轴承 NU 205", latin_only), "no font here shows 承轴: .*fonts-noto-cjk")
        self.assertEqual(page_text.without_font("轴承", lambda c: b"Noto Sans CJK"), "")

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
        self.assertEqual(page_text.percent(0.99999), "99.99 %")
        self.assertEqual(page_text.percent_down(0.98999), "98.9 %")

    def test_yields_without_a_miss_are_bounds(self):
        sound = {"missing_runs": 0, "lower_bound": 0.99, "if_unknown_fail": 1}
        self.assertEqual(page_text.estimated_percent(sound), "≥ 99.0 %")
        self.assertEqual(page_text.estimated_percent(sound | {"missing_runs": 2, "if_unknown_fail": 0.98}), "98.0 %")

    def test_an_interval_decides_the_digits(self):
        estimate = {"value": 83.4567, "lower": 82.91, "upper": 83.97}
        self.assertEqual(page_text.with_interval(estimate), "83.5<br><small>82.9 to 84.0</small>")

    def test_texts_are_no_markup_and_break_between_words(self):
        self.assertEqual(page_text.code("a<b & \"c\""), "<code>a&lt;b &amp; &#34;c&#34;</code>")
        self.assertEqual(page_text.code("cage_stress_peak_MPa"), "<code>cage_<wbr>stress_<wbr>peak_<wbr>MPa</code>")

    def test_one_name_for_a_quantity(self):
        self.assertEqual(page_text.readable("pocket_force_peak_N"), "pocket force peak")
        self.assertEqual(page_text.readable("power_loss_W@start"), "power loss @ start")

    def test_words_are_explained_where_they_are_used(self):
        words = lambda page: [word for word, _ in page_text.words_used(page)]
        self.assertEqual(words("<p>effective number of\n runs, in <b>DIR</b>/mixture</p>"),
                         ["mixture", "effective runs", "DIR"])
        self.assertEqual(words('<img alt="lot" src="data:SE"><script>"noise"</script>slots, DIRECTORY'), [])


def provenance(law, nominal=(7.65,), pitch=0.0):
    """Of a study whose cage starts by this law."""
    inputs = [{"key": "cage.pocket_width_mm", "nominal": list(nominal), "noise": None},
              {"key": "start.cage_phase_deg", "nominal": [0.0], "noise": law}]
    return {"provenance": {"inputs": inputs, "scene": {"cage": {"pocket_pitch_mrad": pitch}}}}


def judged(verdict=None, value=9.81):
    """A report with two assumptions, gravity judged so."""
    ranges = [{"key": "environment.gravity_m_s2", "value": value, "low": 0.0, "high": 9.81},
              {"key": "lubrication.oil_share", "value": 0.02, "low": 0.005, "high": 0.1}]
    alternatives = [{"key": "environment.gravity_m_s2", "verdict": verdict}] if verdict else []
    return {"assumption_verdicts": {"judged": len(alternatives), "alternatives": alternatives, "ranges": ranges}}


class PageParts(unittest.TestCase):
    def test_pockets_are_alike_where_a_cage_starts_at_any_angle(self):
        anywhere = {"law": "uniform", "lower": 0, "upper": 360}
        self.assertTrue(common.pockets_alike(provenance(anywhere)))
        self.assertTrue(common.pockets_alike(provenance(anywhere, nominal=(7.65, 7.65))))
        self.assertFalse(common.pockets_alike(provenance(None)))
        self.assertFalse(common.pockets_alike(provenance({"law": "normal", "mean": 0, "sigma": 2})))
        self.assertFalse(common.pockets_alike(provenance({"law": "uniform", "lower": 0, "upper": 10})))
        self.assertFalse(common.pockets_alike(provenance(anywhere, nominal=(7.65, 7.7))))
        self.assertFalse(common.pockets_alike(provenance(anywhere, pitch=[0.0, 1.0])))

    def test_assumptions_decide_only_when_they_were_judged(self):
        self.assertEqual(page_parts.assumptions_title(judged("holds")), "Assumptions that decide")
        for nobody in (judged(), {"assumption_verdicts": None}):
            self.assertEqual(page_parts.assumptions_title(nobody), "Assumptions that nobody has judged")

    def test_the_front_page_has_gravity_only_where_it_matters(self):
        keys = lambda report: [entry["key"] for entry in page_parts.front_ranges(report)]
        self.assertEqual(keys(judged()), ["lubrication.oil_share"])
        self.assertEqual(keys(judged("holds")), ["lubrication.oil_share"])
        self.assertEqual(len(keys(judged("fails"))), 2)
        self.assertEqual(len(keys(judged(value=1.62))), 2)

    def test_fresh_runs_without_a_result_are_named(self):
        attempts = [{"stage": "confirm-1", "runs": 368, "jammed_runs": 7, "unknown_runs": 2},
                    {"stage": "confirm-2", "runs": 368, "jammed_runs": 0, "unknown_runs": 0}]
        self.assertEqual(page_parts.fresh_losses({"confirmation": {"attempts": attempts}}),
                         ["Of 368 fresh runs in confirm-1, 7 jammed and 2 gave no result."])
        self.assertEqual(page_parts.fresh_losses({"confirmation": None}), [])

    def test_centres_are_studied_where_candidates_have_them(self):
        of = lambda *centres: {"candidates": [{"centres": [centre]} for centre in centres]}
        self.assertTrue(page_parts.centres_studied(of(7.65, 7.7)))
        self.assertFalse(page_parts.centres_studied(of(None, None)))


if __name__ == "__main__":
    unittest.main()
