#include "tests/support/reader_probes.hpp"

#include <algorithm>
#include <boost/crc.hpp>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "mc/study/sample.hpp"
#include "mc/study/study.hpp"
#include "mc/study/tolerance_filling.hpp"
#include "mc/sweep/journal.hpp"
#include "src/input/measurement_csv.hpp"
#include "src/input/toml_file.hpp"
#include "src/reading/idle_notes.hpp"
#include "src/reading/scene_keys.hpp"
#include "tests/support/probe_folder.hpp"
#include "tests/support/shipped_input.hpp"
#include "tests/support/stored_file_probes.hpp"

namespace cagetol {
namespace {

/// Parts of an input that stands for several files are separated by this character.
constexpr char kNextPart = '\x1e';

std::vector<std::string> parts_of(std::string_view bytes, std::size_t count) {
  std::vector<std::string> parts;
  while (parts.size() + 1 < count && bytes.find(kNextPart) != std::string_view::npos) {
    parts.emplace_back(bytes.substr(0, bytes.find(kNextPart)));
    bytes.remove_prefix(parts.back().size() + 1);
  }
  parts.emplace_back(bytes);
  parts.resize(count);
  return parts;
}

std::string file_text(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// Whether `read` reads; an InputError must name a remedy.
template <class Read>
bool read_or_refused(const Read& read) {
  try {
    read();
    return true;
  } catch (const InputError& error) {
    if (std::strstr(error.what(), "remedy: ") == nullptr) throw std::logic_error(error.what());
    return false;
  }
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

/// A shipped file without its comments, which would take most edits and do nothing.
std::string bare(const std::string& path) {
  std::istringstream lines(read_text_file(shipped(path)));
  std::string text;
  for (std::string line; std::getline(lines, line);)
    if (line = line.substr(0, line.find("#")); !line.empty())
      text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  return text;
}

/// A duty over time with phases, keys of scenes.
constexpr const char* kDuty =
    "[duty]\ntime_s = [0, 0.02, 0.1]\ninner_rpm = [0, 6000, 0]\nradial_N = [500, 2000, 500]\n"
    "direction_deg = [0, 90, 360]\nrepeat_s = 0.1\n"
    "[[phase]]\nname = 'braking'\nfrom_s = 0.03\nto_s = 0.09\n"
    "[[phase]]\nname = 'start'\nfrom_s = 0\nto_s = 0.02\n";

/// Reads a scene and all that is said of it.
void read_whole_scene(const toml::table& root, const std::string& file) {
  const Scene scene = read_scene(root, file);
  scene_doubts(scene);
  idle_notes(scene);
}

bool read_scene_bytes(std::string_view bytes) {
  return read_or_refused([&] { read_whole_scene(parse_toml(bytes, "fuzz.toml"), "fuzz.toml"); });
}
std::vector<std::string> scene_seeds() {
  std::vector<std::string> seeds;
  for (const char* name : {"nu205", "speed-z16-skew", "nu205-paper", "nj308-axial", "nu208-planet"})
    seeds.push_back(bare("scenes/" + std::string(name) + ".toml"));
  const std::string guided = replaced(seeds[0], "guidance = \"outer\"", "guidance = \"roller\"");
  for (const char* pockets : {"retention_width_outer_mm = 6.8", "face_radius_mm = 3.83"})
    seeds.push_back(replaced(guided, "[cage]", "[cage]\n" + std::string(pockets)));
  seeds.push_back(seeds[0] + kDuty);
  return seeds;
}

/// What a scene adds to the NU 205, and the CSV of its duty.
bool read_duty_bytes(std::string_view bytes) {
  static const toml::table nu205 = read_toml(shipped("scenes/nu205.toml"));
  const auto parts = parts_of(bytes, 2);
  probe_folder().write("duty.csv", parts[1]);
  const std::string file = (probe_folder().path() / "scene.toml").string();
  return read_or_refused([&] {
    toml::table scene = nu205;
    merge_tables(scene, parse_toml(parts[0], file), is_distribution);
    read_whole_scene(scene, file);
  });
}
std::vector<std::string> duty_seeds() {
  const std::string file = "[duty]\nfile = 'duty.csv'\n";
  const std::string phase = "[[phase]]\nname = 'start'\nfrom_s = 0\nto_s = 0.05\n";
  return {
      file + phase + kNextPart + "# measured\ntime_ms,radial_kN,inner_rpm\n0,1.5,0\n100,2,3e3\n",
      file + "repeat_s = 2\n" + kNextPart + "time_s;direction_deg;outer_rpm\n0;0;+1\n1;360;-2.5\n",
      file + "[model]\nring_tilt = 'free'\n" + kNextPart +
          "moment_y_N_m\ttime_s\tmoment_z_N_m\r\n1\t0\t-1\r\n",
      kDuty};
}

/// Draws of a study, and all that is said of it. Its own text must give it again.
void use(const Study& study) {
  const Sampler sampler(study);
  sampler.draw(0);
  sampler.draw(sample_count(study) - 1);
  study_notes(study);
  tolerance_warnings(study);
  tolerance_notes(study);
  try {
    if (read_resolved_study(study.resolved_toml, "again").resolved_toml == study.resolved_toml)
      return;
  } catch (const InputError& problem) {
    throw std::logic_error(std::string("its own text is refused: ") + problem.what());
  }
  throw std::logic_error("its own text gives another study");
}

/// A study, its scene and its measurements.
bool read_study_bytes(std::string_view bytes) {
  const auto parts = parts_of(bytes, 3);
  probe_folder().write("scene.toml", parts[1]);
  probe_folder().write("parts.csv", parts[2]);
  const std::string study = probe_folder().write("study.toml", parts[0]);
  return read_or_refused([&] { use(read_study(study)); });
}
std::vector<std::string> study_seeds() {
  std::vector<std::string> seeds;
  for (const char* name :
       {"nu205", "nu205-measured", "nu205-slip", "nu205-stress", "nu205-duty", "nu205-fit",
        "nu205-centre", "axial", "own-bearing", "own-bearing-lips", "spindle"}) {
    std::string study = bare("studies/" + std::string(name) + ".toml");
    const auto scene = study.find("../scenes/") + 10;
    const std::string scene_file = study.substr(scene, study.find('"', scene) - scene);
    study = replaced(study, "../scenes/" + scene_file, "scene.toml");
    study = replaced(study, "../measurements/pockets-synthetic.csv", "parts.csv");
    const std::string duty = name == std::string("nu205-slip") ? kDuty : "";
    seeds.push_back(study + kNextPart + bare("scenes/" + scene_file) + duty + kNextPart +
                    bare("measurements/pockets-synthetic.csv"));
  }
  return seeds;
}

bool read_resolved_bytes(std::string_view bytes) {
  return read_or_refused([&] { use(read_resolved_study(std::string(bytes), "fuzz.toml")); });
}
std::vector<std::string> resolved_seeds() {
  std::vector<std::string> seeds;
  for (const char* name : {"studies/nu205-rated.toml", "studies/nu205-measured.toml",
                           "studies/nu205-centre.toml", "studies/nu205-duty.toml"})
    seeds.push_back(read_study(shipped(name)).resolved_toml);
  return seeds;
}

/// One setting a line, on the default study.
bool read_setting_bytes(std::string_view bytes) {
  static const std::string study = shipped("studies/nu205-rated.toml");
  std::vector<std::string> settings;
  std::istringstream lines{std::string(bytes)};
  for (std::string line; settings.size() < 8 && std::getline(lines, line);)
    if (line.find("file") == std::string::npos)
      settings.push_back(line);  // no file but the study's
  return read_or_refused([&] { read_study(study, settings); });
}
std::vector<std::string> setting_seeds() {
  return {"load.radial_N=3000\nscene.speed.inner_rpm=3000\n",
          "samples=16\ndesign=lhs\n",
          "scene.cage.pocket_pitch_mrad={ law = 'normal', sigma = 0.1 }\n",
          "limit=[{ quantity = 'cage_slip_ratio', max = 0.1, source = 'x' }]\n",
          "operating_point=[{ name = 'idle', weight = 2, 'speed.inner_rpm' = 250 }]\n",
          "duty.time_s=[0, 1]\nduty.radial_N=[1, 2]\n"
          "phase=[{ name = 'a', from_s = 0, to_s = 1 }]\n",
          "tolerance.target_yield=0.9\nname=\"a text\"\n"};
}

/// The first character chooses column, unit and decimal mark.
bool read_csv_bytes(std::string_view bytes) {
  const unsigned choice = bytes.empty() ? 0 : static_cast<unsigned char>(bytes[0]);
  bytes.remove_prefix(bytes.empty() ? 0 : 1);
  static const char* names[] = {"width", "b", "width_deviation_mm", "Width [um]"};
  return read_or_refused([&] {
    csv_column(std::string(bytes), "fuzz.csv",
               {names[choice % 4], choice & 4 ? "mm" : "", (choice & 8) != 0});
  });
}
std::vector<std::string> csv_seeds() {
  using namespace std::string_literals;
  return {"6" + read_text_file(shipped("measurements/pockets-synthetic.csv")),
          "<# note\na;width [mm];b;\r\n1;+7,65;\"2\"\r\n;;;\r\n3;7,66;\"4;\"\"x\"\"\"\r\n",
          "<width / um\tb\r7,65\t1\r-7,66\t2\r",
          "4sep=;\nwidth;b\n1;2\n",
          "4\xff\xfew\0i\0d\0t\0h\0\n\0"
          "1\0\n\0"s,
          "4\xef\xbb\xbfWidth in \xc2\xb5m\n1\n",
          "0width\n+1\n\xe2\x88\x92"
          "1\n"};
}

std::uint32_t crc32c(std::string_view bytes) {
  boost::crc_optimal<32, 0x1EDC6F41, 0xFFFFFFFF, 0xFFFFFFFF, true, true> crc;
  crc.process_bytes(bytes.data(), bytes.size());
  return crc.checksum();
}

/// Rights the length and checksum of every record: the bytes behind a marker up to the next one.
std::string with_right_frames(std::string bytes) {
  constexpr std::string_view marker = "\xC7REC";
  constexpr std::size_t frame = 12;
  for (auto at = bytes.find(marker); at != std::string::npos;) {
    const auto next = bytes.find(marker, at + marker.size());
    const std::size_t end = std::min(next, bytes.size());
    if (end >= at + frame) {
      const auto length = static_cast<std::uint32_t>(end - at - frame);
      std::memcpy(&bytes[at + 4], &length, 4);
      const std::uint32_t crc = crc32c(bytes.substr(at + 4, 4) + bytes.substr(at + frame, length));
      std::memcpy(&bytes[at + 8], &crc, 4);
    }
    at = next;
  }
  return bytes;
}

/// The first character says whether records are made right.
bool read_journal_bytes(std::string_view bytes) {
  const bool right = !bytes.empty() && bytes[0] % 4 != 0;
  bytes.remove_prefix(bytes.empty() ? 0 : 1);
  const std::string text(bytes);
  const auto content =
      read_journal(probe_folder().write("fuzz.journal", right ? with_right_frames(text) : text));
  if (!content.readable && content.notes.empty()) throw std::logic_error("damage without a note");
  return content.readable && content.notes.empty();
}
std::vector<std::string> journal_seeds() {
  StoredOutcome stored;
  stored.reason = "roller 4 is too large";
  stored.quantities = {-0.0, 1.5};
  stored.run = {0.25};
  std::string path;
  std::string bytes;
  {
    Journal journal(probe_folder().path().string(), {"0123456789abcdef", "build 1", 3});
    path = journal.path();
    for (std::uint64_t id = 0; id < 3; ++id) {
      stored.id = id;
      journal.started(id);
      journal.finished(stored);
    }
    journal.started(3);
    journal.dropped(3);
    journal.started(4);
    bytes = file_text(path);
  }
  std::filesystem::remove(path);
  return {"1" + bytes, "0" + bytes};
}

}  // namespace

const std::vector<ReaderProbe>& reader_probes() {
  static const std::vector<ReaderProbe> probes = [] {
    std::vector<ReaderProbe> all = {
        {"scene", read_scene_bytes, scene_seeds},
        {"duty", read_duty_bytes, duty_seeds},
        {"study", read_study_bytes, study_seeds},
        {"resolved", read_resolved_bytes, resolved_seeds},
        {"settings", read_setting_bytes, setting_seeds},
        {"csv", read_csv_bytes, csv_seeds},
        {"journal", read_journal_bytes, journal_seeds},
    };
    for (const ReaderProbe& probe : study_file_probes()) all.push_back(probe);
    for (const ReaderProbe& probe : cage_table_probes()) all.push_back(probe);
    return all;
  }();
  return probes;
}

const ReaderProbe& reader_probe(const std::string& name) {
  for (const ReaderProbe& probe : reader_probes())
    if (name == probe.name) return probe;
  throw std::out_of_range("no reader is called " + name);
}

}  // namespace cagetol
