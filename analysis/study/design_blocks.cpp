#include "analysis/study/design_blocks.hpp"

#include <algorithm>
#include <map>

#include "analysis/study/refused.hpp"

namespace cagetol {
namespace {

/// Sample of the first run of each row.
std::map<std::int64_t, std::size_t> sample_of_row(const StudyData& study) {
  std::map<std::int64_t, std::size_t> samples;
  for (std::size_t i = 0; i < study.size(); ++i)
    if (study.replicate[i] == 0) samples[study.row[i]] = i;
  return samples;
}

/// Groups in which two samples differ.
std::vector<std::string> moved_groups(const StudyDesign& design, std::size_t a, std::size_t b) {
  const std::size_t width = design.columns.size();
  std::vector<std::string> moved;
  for (std::size_t c = 0; c < width; ++c)
    if (design.point[a * width + c] != design.point[b * width + c] &&
        std::find(moved.begin(), moved.end(), design.groups[c]) == moved.end())
      moved.push_back(design.groups[c]);
  return moved;
}

/// Rows 2 .. count-1 of the base that starts at `row` each move one group of row A; the list of
/// these groups.
bool pick_freeze_base(const StudyData& study, const std::map<std::int64_t, std::size_t>& samples,
                      std::int64_t row, std::size_t count, std::vector<std::string>& groups) {
  groups.clear();
  for (std::size_t block = 2; block < count; ++block) {
    const auto a = samples.find(row), b = samples.find(row + static_cast<std::int64_t>(block));
    if (a == samples.end() || b == samples.end()) return false;
    const auto moved = moved_groups(study.design, a->second, b->second);
    if (moved.size() > 1) return false;
    groups.push_back(moved.empty() ? "noise" : moved.front());
  }
  return true;
}

DesignBlocks pick_freeze_blocks(const StudyData& study) {
  const auto names = group_names(study.design);
  const auto samples = sample_of_row(study);
  for (const std::size_t extra : {3u, 2u}) {  // with a noise group, and without
    DesignBlocks blocks{names.size() + extra, {}};
    std::vector<std::string> second;
    const auto next = static_cast<std::int64_t>(blocks.rows_per_base);
    if (pick_freeze_base(study, samples, 0, blocks.rows_per_base, blocks.groups) &&
        (study.design.rows_planned <= next ||
         (pick_freeze_base(study, samples, next, blocks.rows_per_base, second) &&
          second == blocks.groups)))
      return blocks;
  }
  throw Refused("pick-freeze indices refused: the stored points do not vary one group at a time");
}

DesignBlocks morris_blocks(const StudyData& study) {
  DesignBlocks blocks{group_names(study.design).size() + 1, {}};
  return blocks;
}

}  // namespace

std::vector<std::string> group_names(const StudyDesign& design) {
  std::vector<std::string> names;
  for (const std::string& group : design.groups)
    if (std::find(names.begin(), names.end(), group) == names.end()) names.push_back(group);
  return names;
}

DesignBlocks design_blocks(const StudyData& study) {
  if (study.design.kind == "pick-freeze") return pick_freeze_blocks(study);
  if (study.design.kind == "morris") return morris_blocks(study);
  return {};
}

}  // namespace cagetol
