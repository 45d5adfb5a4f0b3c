#include "mc/host/progress.hpp"
#include "mc/host/log.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

namespace cagetol {
namespace {

constexpr double kLineInterval = 0.5;
constexpr double kFirstPlain = 5, kPlainGrowth = 1.5, kLongestPlain = 600;
constexpr int kBarWidth = 20;

std::string duration(double seconds) {
  const auto s = static_cast<long>(std::llround(seconds));
  if (s >= 3600) return fmt::format("{} h {:02} min", s / 3600, s / 60 % 60);
  if (s >= 60) return fmt::format("{} min {:02} s", s / 60, s % 60);
  return fmt::format("{} s", s);
}

}  // namespace

void Tally::count(Status status) {
  ++done;
  if (status == Status::jammed) ++jammed;
  if (status == Status::failed) ++failed;
  if (status == Status::censored) ++censored;
  if (status == Status::poisoned) ++poisoned;
}

std::string progress_text(const Tally& tally, std::uint64_t before, std::uint64_t samples,
                          double elapsed_s) {
  std::string text = fmt::format("{}/{} done", tally.done, samples);
  const auto fresh = static_cast<double>(tally.done - before);
  const double rate = elapsed_s > 0 ? fresh / elapsed_s : 0;
  if (rate > 0) text += fmt::format(", {:.3g}/s", rate);
  const auto add = [&](std::uint64_t count, const char* name) {
    if (count > 0) text += fmt::format(", {} {}", count, name);
  };
  add(tally.jammed, "jammed");
  add(tally.failed, "failed");
  add(tally.censored, "censored");
  add(tally.poisoned, "poisoned");
  if (rate > 0 && tally.done < samples)
    text += fmt::format(", {} left", duration(static_cast<double>(samples - tally.done) / rate));
  return text;
}

std::string progress_bar(double share) {
  const double done = std::clamp(share, 0.0, 1.0);
  const auto marks = static_cast<int>(kBarWidth * done + 1e-9);
  return fmt::format("[{:#<{}}{:{}}] {:3.0f} %", "", marks, "", kBarWidth - marks, 100 * done);
}

Progress::Progress(ProgressStyle style, std::uint64_t before, std::uint64_t samples)
    : style_(style), before_(before), samples_(samples), begin_(std::chrono::steady_clock::now()) {
  if (style_ == ProgressStyle::automatic)
    style_ = ::isatty(STDERR_FILENO) ? ProgressStyle::line : ProgressStyle::plain;
  next_s_ = style_ == ProgressStyle::line ? kLineInterval : kFirstPlain;
}

double Progress::elapsed_s() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
}

void Progress::update(const Tally& tally) {
  const double elapsed = elapsed_s();
  if (style_ == ProgressStyle::off || elapsed < next_s_) return;
  next_s_ = elapsed + (style_ == ProgressStyle::line
                           ? kLineInterval
                           : std::min(kLongestPlain, (kPlainGrowth - 1) * elapsed + 1));
  print(tally, false);
}

void Progress::finish(const Tally& tally) {
  if (style_ != ProgressStyle::off) print(tally, true);
}

void Progress::print(const Tally& tally, bool last) {
  const std::string text = progress_text(tally, before_, samples_, elapsed_s());
  if (style_ == ProgressStyle::line) {
    width_ = std::max(width_, text.size());
    say("\r{:<{}}{}", text, width_, last ? "\n" : "");
  } else {
    say("{}\n", text);
  }
  std::fflush(stderr);
}

}  // namespace cagetol
