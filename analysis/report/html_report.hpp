// report.html: every chapter is made from report.json alone, so that the page shows no number the
// file does not hold.
#pragma once

#include <string>

#include "analysis/report/figure_set.hpp"
#include "analysis/report/json_parts.hpp"

namespace cagetol {

std::string html_report(const Json& report, const FigureSet& figures);

// The chapters, in the order of the page. An empty text: the study has nothing to say there.
std::string verdict_chapter(const Json& report);
std::string trends_chapter(const Json& report);
std::string response_chapter(const Json& report, const FigureSet& figures);
std::string confirmation_chapter(const Json& report);
std::string assumption_verdicts_chapter(const Json& report);
std::string limits_chapter(const Json& report);
std::string tolerance_chapter(const Json& report, const FigureSet& figures);
std::string contributors_chapter(const Json& report, const FigureSet& figures);
std::string quantities_chapter(const Json& report, const FigureSet& figures);
std::string error_budget_chapter(const Json& report, const FigureSet& figures);
std::string multifidelity_chapter(const Json& report);
std::string cage_chapter(const Json& report, const FigureSet& figures);
std::string capability_chapter(const Json& report);
std::string failures_chapter(const Json& report);
std::string convergence_chapter(const Json& report, const FigureSet& figures);
std::string health_chapter(const Json& report, const FigureSet& figures);
std::string provenance_chapter(const Json& report);

/// Part of the tolerance chapter.
std::string centre_responses_section(const Json& tolerance, const FigureSet& figures);
std::string centres_section(const Json& tolerance, const FigureSet& figures);

}  // namespace cagetol
