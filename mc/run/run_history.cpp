#include "mc/run/run_history.hpp"

#include "mc/host/file_write.hpp"
#include "mc/study_file/h5.hpp"

namespace cagetol {

RunHistory::RunHistory(const Scene& scene)
    : scene_name_(scene.name),
      interval_(scene.history_interval),
      rollers_(static_cast<int>(scene.bearing.roller_count)),
      of_bearing_(bearing_channels().size()),
      of_rollers_(roller_channels().size()) {}

void RunHistory::record(const Instant& at) {
  if (at.t < next_time_) return;
  next_time_ = at.t + interval_;
  time_.push_back(at.t);
  for (std::size_t c = 0; c < of_bearing_.size(); ++c)
    of_bearing_[c].push_back(bearing_channels()[c].value(at));
  for (std::size_t c = 0; c < of_rollers_.size(); ++c)
    for (int j = 0; j < rollers_; ++j) of_rollers_[c].push_back(roller_channels()[c].value(at, j));
}

void RunHistory::write(const std::string& path) const {
  const H5Handle file = make_h5_memory_file();
  write_h5_attribute(file, "schema_version", std::int64_t{2});
  write_h5_attribute(file, "scene", scene_name_);
  write_h5(file, "time", time_, {"s", "time of each state"});
  for (std::size_t c = 0; c < of_bearing_.size(); ++c) {
    const BearingChannel& channel = bearing_channels()[c];
    write_h5(file, channel.name, of_bearing_[c], {channel.unit, channel.description});
  }
  for (std::size_t c = 0; c < of_rollers_.size(); ++c) {
    const RollerChannel& channel = roller_channels()[c];
    write_h5(file, channel.name, of_rollers_[c], {channel.unit, channel.description},
             static_cast<std::size_t>(rollers_));
  }
  replace_file(path, sealed_h5_image(file));
}

}  // namespace cagetol
