// Probes of study.h5.
#include "tests/support/stored_file_probes.hpp"

#include <hdf5.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <vector>

#include "analysis/study/study_data.hpp"
#include "mc/study_file/file_seal.hpp"
#include "mc/study_file/h5.hpp"
#include "mc/study_file/study_file_error.hpp"
#include "mc/sweep/stored_study.hpp"
#include "tests/support/probe_folder.hpp"
#include "tests/support/standin_study.hpp"

namespace cagetol {
namespace {

/// A study file with every kind of object.
const std::string& whole_study_file() {
  static const std::string bytes = [] {
    const SweepPlan plan = make_standin_plan({.samples = 6, .mean_ms = 0, .failure_share = 0.3});
    OutcomesById outcomes;
    for (std::uint64_t id = 0; id < plan.samples; ++id)
      outcomes[id] =
          make_stored_outcome(id, plan.job(plan.draw(id), [] { return false; }), 0.25, 1);
    return make_study_file(plan, outcomes, build_info());
  }();
  return bytes;
}

struct Objects {
  std::vector<std::string> datasets, groups;
};

extern "C" herr_t list_object(hid_t, const char* name, const H5O_info_t* info, void* to) noexcept {
  auto& objects = *static_cast<Objects*>(to);
  if (std::strcmp(name, ".") != 0)
    (info->type == H5O_TYPE_DATASET ? objects.datasets : objects.groups).emplace_back(name);
  return 0;
}

/// Takes what is asked for from the front of the fuzzed bytes, zeros behind their end.
class Commands {
 public:
  explicit Commands(std::string_view bytes) : bytes_(bytes) {}
  bool left() const { return !bytes_.empty(); }
  std::size_t number() {
    const std::string two = text(2);
    return static_cast<unsigned char>(two[0]) + 256u * static_cast<unsigned char>(two[1]);
  }
  std::string text(std::size_t count) {
    std::string taken(bytes_.substr(0, count));
    bytes_.remove_prefix(taken.size());
    taken.resize(count);
    return taken;
  }

 private:
  std::string_view bytes_;
};

/// Puts another dataset in the place of `name`: numbers or texts, as many as it likes.
void replace_dataset(hid_t file, const std::string& name, Commands& commands) {
  H5Ldelete(file, name.c_str(), H5P_DEFAULT);
  const std::size_t kind = commands.number(), count = commands.number() % 40;
  switch (kind % 4) {
    case 0: {
      std::vector<double> values(count);
      for (double& value : values) std::memcpy(&value, commands.text(8).data(), 8);
      write_h5(file, name, values, {"-", "fuzzed"},
               kind & 4 ? std::max<std::size_t>(count / 2, 1) : 0);
      break;
    }
    case 1: {
      std::vector<std::int64_t> values(count);
      for (auto& value : values) std::memcpy(&value, commands.text(8).data(), 8);
      write_h5(file, name, values, {"-", "fuzzed"});
      break;
    }
    case 2:
      write_h5(file, name, commands.text(commands.number() % 2000), {"-", "fuzzed"});
      break;
    default:
      write_h5(file, name, std::vector<std::string>(count, commands.text(5)), {"-", "fuzzed"});
  }
}

void edit(hid_t file, const Objects& objects, Commands& commands) {
  const std::size_t what = commands.number(), which = commands.number();
  const std::string& dataset = objects.datasets[which % objects.datasets.size()];
  const std::string& group = objects.groups[which % objects.groups.size()];
  static const char* attributes[] = {"schema_version", "pockets",        "seed",
                                     "study_hash",     "build",          "design",
                                     "rows_planned",   "samples_planned"};
  const std::string attribute = attributes[which % std::size(attributes)];
  switch (what % 6) {
    case 0:
      H5Ldelete(file, (what & 8 ? group : dataset).c_str(), H5P_DEFAULT);
      break;
    case 1:
      H5Adelete(file, attribute.c_str());
      if (what & 8) write_h5_attribute(file, attribute, commands.text(commands.number() % 50));
      break;
    case 2: {
      std::int64_t value = 0;
      std::memcpy(&value, commands.text(8).data(), 8);
      H5Adelete(file, attribute.c_str());
      write_h5_attribute(file, attribute, value);
      break;
    }
    case 3: {  // a text of the study, edited
      const std::string name = what & 8 ? "study/toml" : "study/json";
      std::string text(static_cast<std::size_t>(which), ' ');
      const H5Handle old(H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose, "open");
      const H5Handle type(H5Dget_type(old), H5Tclose, "type");
      if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) > 0) break;
      text.assign(H5Tget_size(type), '\0');
      const H5Handle space(H5Dget_space(old), H5Sclose, "space");
      if (H5Sget_simple_extent_npoints(space) != 1) break;
      H5Dread(old, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data());
      const std::string piece = commands.text(commands.number() % 60);
      text = text.c_str();
      text.replace(which % (text.size() + 1), commands.number() % 20, piece);
      H5Ldelete(file, name.c_str(), H5P_DEFAULT);
      write_h5(file, name, text, {"-", "fuzzed"});
      break;
    }
    default:
      replace_dataset(file, dataset, commands);
  }
}

/// The whole file after the edits that the bytes stand for, sealed anew: HDF5's own reader is not
/// what is tested.
std::string edited_study_file(std::string_view bytes) {
  const H5Quiet quiet;
  std::string image = whole_study_file().substr(kSealSize);
  const H5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "make a property list");
  H5Pset_fapl_core(access, 1 << 16, false);
  H5Pset_file_image(access, image.data(), image.size());
  const H5Handle file(H5Fopen("fuzzed", H5F_ACC_RDWR, access), H5Fclose, "open the image");
  Objects objects;
  H5Ovisit2(file, H5_INDEX_NAME, H5_ITER_INC, list_object, &objects, H5O_INFO_BASIC);
  Commands commands(bytes);
  for (int edits = 0; edits < 6 && commands.left(); ++edits) {
    try {
      edit(file, objects, commands);
    } catch (const H5Error&) {  // what an edit before has removed
    }
  }
  return sealed_h5_image(file);
}

/// The first character: edits, or raw bytes written over the file from some place on, which the
/// seal must find.
std::string study_file_of(std::string_view bytes) {
  if (bytes.empty()) return whole_study_file();
  if (bytes[0] % 8 != 0) return edited_study_file(bytes.substr(1));
  Commands commands(bytes.substr(1));
  std::string file = whole_study_file();
  while (commands.left()) {
    const std::size_t at = (commands.number() * 256 + commands.number()) % file.size();
    file[at] = commands.text(1)[0];
  }
  return file;
}

template <class Read>
bool read_or_refused_file(const Read& read) {
  try {
    read();
    return true;
  } catch (const StudyFileError& error) {
    if (std::strstr(error.what(), "remedy: ") == nullptr) throw std::logic_error(error.what());
    return false;
  }
}

bool read_study_file_bytes(std::string_view bytes) {
  const std::string path = probe_folder().write("fuzz.h5", study_file_of(bytes));
  return read_or_refused_file([&] { read_study_file(path); });
}

bool read_study_data_bytes(std::string_view bytes) {
  const std::string path = probe_folder().write("fuzz.h5", study_file_of(bytes));
  return read_or_refused_file([&] { read_study_data(path); });
}

/// Commands of every kind, on the objects of a whole file.
std::vector<std::string> study_file_seeds() {
  using namespace std::string_literals;
  return {"",
          "\1\0\0\1\0"s,
          "\1\0\0\2\0"s,
          "\1\1\0\3\0"s,
          "\1\2\0\0\0\2\0\0\0\0\0\0\0"s,
          "\1\3\0\10\0\5\0nan, \2\0"s,
          "\1\4\0\7\0\0\0\3\0abcdefghabcdefghabcdefgh"s,
          "\1\5\0\4\0\2\0\20\0a text of some"s};
}

}  // namespace

std::vector<ReaderProbe> study_file_probes() {
  return {{"study_file", read_study_file_bytes, study_file_seeds},
          {"study_data", read_study_data_bytes, study_file_seeds}};
}

}  // namespace cagetol
