// The program as users start it: exit codes, messages, JSON. Above 400 lines: one list of what a
// user may do.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>
#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <thread>

#include "analysis/study/study_data.hpp"
#include "src/input/toml_file.hpp"
#include "src/quantities/operating_point.hpp"
#include "src/quantities/quantity_table.hpp"
#include "tests/support/file_bytes.hpp"
#include "tests/support/process.hpp"
#include "tests/support/reference_scene.hpp"
#include "tests/support/shipped_input.hpp"

namespace cagetol {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

struct Ended {
  int code;
  std::string output;
};

Ended run(std::vector<std::string> arguments, const std::function<void()>& prepare = {}) {
  arguments.insert(arguments.begin(), std::string(CAGETOL_BINARY_DIR) + "/cagetol");
  Process process(arguments, prepare);
  const int code = process.wait();
  return {code, process.output()};
}

TEST(Program, HelpHasAnExampleForEachCommand) {
  const auto help = run({"--help"});
  EXPECT_EQ(help.code, 0);
  for (const char* part : {"Exit codes: 0 done", "70 a fault of the program", "75 interrupted",
                           "check", "simulate", "cagetol simulate inputs/scenes/nu205.toml"})
    EXPECT_THAT(help.output, HasSubstr(part));
  // Commands are the lines that begin with two spaces and a word of small letters.
  static const std::regex kCommand("\n  ([a-z]+) +[A-Z]");
  int commands = 0;
  for (std::sregex_iterator at(help.output.begin(), help.output.end(), kCommand), end; at != end;
       ++at, ++commands) {
    const std::string command = (*at)[1];
    const auto own = run({command, "--help"});
    EXPECT_EQ(own.code, 0) << command;
    EXPECT_THAT(own.output, HasSubstr("Example")) << command;
    EXPECT_THAT(own.output, HasSubstr("cagetol " + command + " ")) << command;
    if (own.output.find("SCENE TEXT") != std::string::npos) {
      EXPECT_THAT(own.output, HasSubstr("--set")) << command;
    }
  }
  EXPECT_GE(commands, 12);
}

TEST(Program, VersionNamesWhatItWasBuiltFrom) {
  const auto version = run({"--version"});
  EXPECT_EQ(version.code, 0);
  for (const char* part :
       {"cagetol 0.", "commit ", "built with GNU", "gsl ", "hdf5 ", "openmpi ", "sundials "})
    EXPECT_THAT(version.output, HasSubstr(part));
}

TEST(Program, NoLimitOfMemoryEndsItWithASignal) {
  for (rlim_t bytes = 64 << 20; bytes <= rlim_t{192} << 20; bytes += 8 << 20) {
    const auto version = run({"--version"}, [bytes] {
      const rlimit limit{bytes, bytes};
      setrlimit(RLIMIT_AS, &limit);
    });
    EXPECT_LT(version.code, 128) << bytes << ' ' << version.output;  // 127: libraries do not fit
  }
}

/// A limit for the program that is started.
std::function<void()> limited(__rlimit_resource resource, rlim_t amount) {
  return [resource, amount] {
    const rlimit limit{amount, amount};
    setrlimit(resource, &limit);
  };
}

TEST(Program, LimitsOfTheShellEndInDocumentedCodes) {
  const ScratchDirectory scratch;
  const std::string study = shipped("studies/nu205-rated.toml");
  const std::vector<std::vector<std::string>> commands = {
      {"check", study},
      {"simulate", study, "--set", "model.motion=quasi-static"},
      {"sweep", study, "--set", "model.motion=quasi-static", "--set", "samples=6", "--set",
       "extra_replicates=0", "--progress", "off", "-o"}};
  const std::vector<std::pair<__rlimit_resource, rlim_t>> limits = {
      {RLIMIT_STACK, 64 << 10}, {RLIMIT_STACK, 128 << 10}, {RLIMIT_STACK, 256 << 10},
      {RLIMIT_NOFILE, 4},       {RLIMIT_NOFILE, 12},       {RLIMIT_AS, 96 << 20},
      {RLIMIT_AS, 104 << 20},   {RLIMIT_AS, 128 << 20}};
  int directory = 0;
  for (const auto& [resource, amount] : limits)
    for (std::vector<std::string> command : commands) {
      if (command.back() == "-o") command.push_back(scratch / std::to_string(++directory));
      const auto ended = run(command, limited(resource, amount));
      const std::string what = command[0] + " with limit " + std::to_string(resource) + " of " +
                               std::to_string(amount) + ":\n" + ended.output;
      EXPECT_TRUE(ended.code == 0 || ended.code == 2 || ended.code == 75 || ended.code == 127)
          << ended.code << ' ' << what;  // 127: libraries do not fit
      EXPECT_THAT(ended.output, testing::Not(HasSubstr("unexpected"))) << what;
      if (ended.code == 2 || ended.code == 75) {
        EXPECT_THAT(ended.output, HasSubstr("remedy: ")) << what;
      }
    }
  EXPECT_THAT(
      run({"check", study}, limited(RLIMIT_STACK, 64 << 10)).output,
      HasSubstr("ulimit -s = 64: the stack [kB] is limited to this; the program needs 256"));
}

TEST(Program, ARankSaysWhatMpiWouldLack) {
  const ScratchDirectory scratch;
  for (const char* limit : {"ulimit -n 16", "ulimit -v 250000"}) {
    Process process(with_mpirun(
        2, {"/bin/sh", "-c", std::string(limit) + "; exec \"$0\" \"$@\"",
            std::string(CAGETOL_BINARY_DIR) + "/cagetol", "sweep",
            shipped("studies/nu205-rated.toml"), "--set", "samples=4", "-o", scratch / "out"}));
    EXPECT_EQ(process.wait(), 2) << process.output();
    EXPECT_THAT(process.output(), HasSubstr("of an MPI process"));
    EXPECT_THAT(process.output(), HasSubstr("remedy: raise the limit: ulimit -"));
  }
}

TEST(Program, PlansBeyondTheMachineAreRefusedWithTheirCounts) {
  const std::string study = shipped("studies/nu205-rated.toml");
  const auto fine = run({"check", study});
  EXPECT_THAT(fine.output,
              testing::ContainsRegex("a sweep of [0-9]+ rows, [0-9]+ samples with "
                                     "[0-9]+ numbers each: rank 0 needs up to [0-9]+"));
  const ScratchDirectory scratch;
  for (const char* command : {"check", "sweep", "recommend"}) {
    std::vector<std::string> words = {
        command, study, "--set", "samples=1000000000", "--set", "extra_replicates=0"};
    if (words[0] != "check") words.insert(words.end(), {"-o", scratch / "out"});
    const auto ended = run(words);
    EXPECT_EQ(ended.code, 2) << ended.output;
    EXPECT_THAT(ended.output,
                HasSubstr("samples = 1000000000: 1000000000 rows, 1000000000 samples"));
    EXPECT_THAT(ended.output, HasSubstr("remedy: ask for fewer samples"));
    EXPECT_FALSE(std::filesystem::exists(scratch / "out/study.toml"));
  }
  const auto tight =
      run({"check", study, "--set", "samples=1000000"}, limited(RLIMIT_AS, rlim_t{600} << 20));
  EXPECT_EQ(tight.code, 2);
  EXPECT_THAT(tight.output, HasSubstr("(ulimit -v)"));
}

TEST(Program, ReplacesNoFileThatItDidNotWrite) {
  const ScratchDirectory scratch;
  const std::string scene = scratch / "own.toml";
  std::filesystem::copy_file(shipped("scenes/nu205.toml"), scene);
  const std::string before = read_text_file(scene);
  const auto ended = run({"simulate", scene, "-o", scene});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.output, HasSubstr("did not write"));
  EXPECT_EQ(read_text_file(scene), before);
  std::ofstream(scratch / "study.h5") << "cagetol sealed HDF5, version 1\n";
  EXPECT_EQ(run({"simulate", scene, "-o", scratch / "study.h5"}).code, 2);
}

/// A sweep of two equilibria, written to `directory`.
std::vector<std::string> small_sweep(const std::string& directory) {
  std::vector<std::string> command = {
      "sweep", shipped("studies/nu205-rated.toml"), "-o", directory, "--progress", "plain"};
  for (const char* setting :
       {"samples=2", "scene.cage.model=rigid", "scene.model.motion=quasi-static", "limit=[]"})
    command.insert(command.end(), {"--set", setting});
  return command;
}

TEST(Program, ClosedStreamsLeaveResultsAlone) {
  const ScratchDirectory scratch;
  const std::vector<std::pair<std::string, std::function<void()>>> ways = {
      {"closed",
       [] {
         for (const int stream : {0, 1, 2}) ::close(stream);
       }},
      {"full", [] { ::dup2(::open("/dev/full", O_WRONLY), 2); }}};
  for (const auto& [name, prepare] : ways) {
    const std::string directory = scratch / name;
    const auto ended = run(small_sweep(directory), prepare);
    EXPECT_EQ(ended.code, 0) << name << ended.output;
    EXPECT_TRUE(std::filesystem::exists(directory + "/study.h5")) << name;
    EXPECT_EQ(std::filesystem::file_size(directory + "/journal/lock"), 0u) << name;
  }
}

TEST(Program, AnUnloadedBearingHasALoadOfZero) {
  const auto ended = run({"check", shipped("scenes/nu205.toml"), "--set", "load.radial_N=0"});
  EXPECT_THAT(ended.output, HasSubstr("load.radial_N = 0 N is below the minimum load"));
}

TEST(Program, AFullDiskUnderStdoutIsNoFault) {
  const auto ended = run({"quantities"}, [] { ::dup2(::open("/dev/full", O_WRONLY), 1); });
  EXPECT_EQ(ended.code, 2);
}

TEST(Program, AReportThatDoesNotFitOnTheDiskIsNotDone) {
  const ScratchDirectory scratch;
  const std::filesystem::path directory = scratch / "sweep";
  ASSERT_EQ(run(small_sweep(directory)).code, 0);
  ASSERT_EQ(run({"report", directory}).code, 0);
  const auto numbers = std::filesystem::file_size(directory / "report.json");
  ASSERT_GT(std::filesystem::file_size(directory / "report.html"), numbers + 1000);
  for (const auto limit : {numbers + 1000, numbers / 2}) {
    const auto ended = run({"report", directory}, limited(RLIMIT_FSIZE, limit));
    EXPECT_EQ(ended.code, 75) << ended.output;
    EXPECT_THAT(ended.output, testing::AllOf(HasSubstr("File too large"), HasSubstr("remedy: ")));
    EXPECT_FALSE(std::filesystem::exists(directory / "report.html"));
    for (const auto& entry : std::filesystem::directory_iterator(directory))
      EXPECT_NE(entry.path().extension(), ".tmp");
  }
}

TEST(Program, AReportNamesATemperatureThatIsNotHeldTheLayersOfTheSupplyAndWindows) {
  const ScratchDirectory scratch;
  std::vector<std::string> command = {"sweep", shipped("studies/nu205-rated.toml"), "-o",
                                      scratch / "s"};
  for (const char* setting :
       {"samples=2", "scene.cage.model=rigid", "limit=[]", "lubrication.temperature_C=40",
        "window.settle_revolutions=0.2", "window.measure_revolutions=0.5",
        "window.longest_settle_revolutions=0", "watch.static_consistency_max=10",
        "watch.cage_drift_max=10", "watch.power_surplus_max=10",
        "operating_point=[{name=\"hot\", \"lubrication.temperature_C\"=100, "
        "\"window.measure_revolutions\"=0.25}, {name=\"cold\"}]"})
    command.insert(command.end(), {"--set", setting});
  const auto swept = run(command);
  ASSERT_EQ(swept.code, 0) << swept.output;
  ASSERT_EQ(run({"report", scratch / "s"}).code, 0);
  std::ifstream stream(scratch / "s/report.json");
  const auto bearing = nlohmann::json::parse(stream).at("bearing");
  const StudyData study = read_study_data(scratch / "s/study.h5");
  const auto& power = find_quantity(study, "power_loss_W@cold")->values;
  char loses[100];
  std::snprintf(loses, sizeof loses, "at 40 degC the bearing loses %.3g W and sheds 23.2 W",
                (power.at(0) + power.at(1)) / 2);
  EXPECT_THAT(bearing.at("points").at(1).at("warnings").dump(), HasSubstr(loses));
  EXPECT_THAT(bearing.at("points").at(0).at("warnings").dump(), Not(HasSubstr("sheds")));
  EXPECT_THAT(bearing.at("warnings").dump(), Not(HasSubstr("sheds")));
  EXPECT_THAT(bearing.at("model").dump(),
              HasSubstr("0.5 revolutions of the cage after 0.2 to settle; 0.25 measured at hot."));
  const auto& assumed = bearing.at("assumed");
  EXPECT_EQ(assumed.at("lubrication.outer_layer_um").dump(),
            R"({"automatic":true,"unit":"um","value":200})");
  EXPECT_EQ(assumed.at("lubrication.race_layer_um").at("automatic"), false);
  EXPECT_NEAR(assumed.at("cage.guide_clearance_mm").at("value").get<double>(), 0.2, 1e-9);
}

TEST(Program, ADirectoryHoldsASweepOrARecommendation) {
  const ScratchDirectory scratch;
  ASSERT_EQ(run(small_sweep(scratch / "sweep")).code, 0);
  std::filesystem::create_directories(scratch / "verdict/pilot");
  const auto recommend =
      run({"recommend", shipped("studies/nu205-rated.toml"), "-o", scratch / "sweep"});
  EXPECT_EQ(recommend.code, 2);
  EXPECT_THAT(recommend.output, HasSubstr("holds a sweep"));
  const auto sweep = run(small_sweep(scratch / "verdict"));
  EXPECT_EQ(sweep.code, 2);
  EXPECT_THAT(sweep.output, HasSubstr("holds a recommendation"));
}

TEST(Program, NamesOfOutputsAreCheckedByEveryCommand) {
  const ScratchDirectory scratch;
  std::ofstream(scratch / "file") << "in the way";
  // No real device: root would replace it by a file, were it not refused.
  ASSERT_EQ(::mkfifo((scratch / "device").c_str(), 0600), 0);
  const std::string study = shipped("studies/nu205-rated.toml"),
                    scene = shipped("scenes/nu205.toml");
  const std::vector<std::vector<std::string>> commands = {
      {"sweep", study},    {"recommend", study},
      {"ladder", study},   {"rig", scene, "rig.csv"},
      {"chart", scene},    {"stability", "--fast"},
      {"simulate", scene}, {"replay", scratch.path(), "--sample", "1"}};
  const std::vector<std::pair<std::string, std::string>> names = {
      {"", "the name is empty"},
      {"  ", "the name is blank"},
      {scratch / "a\nb", "control character"},
      {scratch / "device", "a device, a pipe or a socket, not a f"},
      {scratch / std::string(300, 'x'), "a part of the name has 300 characters"},
      {scratch / std::string(5000, '/') + "x", "longer than the system's"},
      {scratch / "file/below", "file"}};
  for (const auto& command : commands)
    for (const auto& [name, problem] : names) {
      auto words = command;
      words.insert(words.end(), {"-o", name});
      const auto ended = run(words);
      EXPECT_EQ(ended.code, 2) << command[0] << ended.output;
      EXPECT_THAT(ended.output, HasSubstr("cagetol: -o = \"")) << command[0];
      EXPECT_THAT(ended.output, HasSubstr(problem)) << command[0];
      EXPECT_THAT(ended.output, HasSubstr("remedy: ")) << command[0];
    }
  EXPECT_EQ(run({"simulate", scene, "-o", ""}).code, 2);
  EXPECT_EQ(run({"simulate", scene, "-o", scratch.path()}).code, 2);

  std::filesystem::create_directory(scratch / "pipe");
  ASSERT_EQ(::mkfifo((scratch / "pipe/study.h5").c_str(), 0600), 0);
  for (const auto& words :
       std::vector<std::vector<std::string>>{{"report", scratch / "pipe"},
                                             {"replay", scratch / "pipe", "--sample", "1"},
                                             {"compare", scratch / "pipe", scratch / "pipe"},
                                             {"report", ""}}) {
    const auto ended = run(words);
    EXPECT_EQ(ended.code, 2) << ended.output;
    EXPECT_THAT(ended.output, HasSubstr("remedy: "));
  }
}

TEST(Program, BadCommandLinesEndWithTwo) {
  EXPECT_EQ(run({}).code, 2);
  EXPECT_EQ(run({"simulate"}).code, 2);
  EXPECT_EQ(run({"simulaet", "x"}).code, 2);
  EXPECT_EQ(run({"simulate", shipped("scenes/nu205.toml"), "--jsn"}).code, 2);
  EXPECT_EQ(run({"--dump-default", "everything"}).code, 2);
  EXPECT_EQ(run({"bench", shipped("scenes/nu205.toml"), "--methods", "rodas5"}).code, 2);
  EXPECT_EQ(run({"simulate", shipped("scenes/nu205.toml"), "--sample", "-1"}).code, 2);
  const auto absent = run({"simulate", shipped("scenes/nu205.toml"), "--sample", "7"});
  EXPECT_EQ(absent.code, 2);
  EXPECT_THAT(absent.output, HasSubstr("--sample = 7: the study has the samples 0 to 0"));
}

TEST(Program, BadInputEndsWithTwoAndSaysWhy) {
  const ScratchDirectory scratch;
  const auto written = [&](const std::string& text) {
    std::ofstream(scratch / "file.toml", std::ios::binary) << text;
    return scratch / "file.toml";
  };
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"[cage]\npocket_widht_mm = 7.6\n", "file.toml:2: cage.pocket_widht_mm = 7.6: no such key"},
      {"[cage]\npocket_width_um = 7650\n", "wrong unit"},
      {"[cage]\nwidth_mm = -14\n", "file.toml:2: cage.width_mm = -14: outside the range"},
      {"[cage]\npocket_width_mm = 7.4\n",
       "file.toml: the scene leaves out 18 keys that have no default"},
      {reference_scene_text("[cage]\npocket_width_mm = 7.4\n"),
       "the nominal pocket is not wider than its roller"},
      {"[cage\n", "file.toml:1: not valid TOML"},
      {std::string("\x7f"
                   "ELF\0\0\1\2\xff\xfe",
                   10),
       "file.toml:1: not valid TOML"},
  };
  for (const auto& [text, message] : cases)
    for (const char* command : {"check", "simulate"}) {
      const auto ended = run({command, written(text)});
      EXPECT_EQ(ended.code, 2) << ended.output;
      EXPECT_THAT(ended.output, HasSubstr(message));
      EXPECT_THAT(ended.output, HasSubstr("remedy: "));
    }
  const auto absent = run({"check", scratch / "absent.toml"});
  EXPECT_EQ(absent.code, 2);
  EXPECT_THAT(absent.output, HasSubstr("absent.toml: no such file"));
  EXPECT_EQ(run({"check", scratch.path()}).code, 2);
  EXPECT_EQ(run({"check", shipped("scenes/nu205.toml"), "--set", "load.radial_N=-5"}).code, 2);
}

TEST(Program, EquilibriaAreToldApartFromMotion) {
  const ScratchDirectory scratch;
  const auto still = [&](std::vector<std::string> arguments) {
    for (const char* more : {"--set", "model.motion=quasi-static"}) arguments.push_back(more);
    return run(arguments);
  };
  const std::string scene = shipped("scenes/nu205.toml");
  const auto plain = still({"simulate", scene});
  EXPECT_EQ(plain.code, 0) << plain.output;
  EXPECT_THAT(plain.output, HasSubstr("note: quasi-static: "));
  EXPECT_THAT(plain.output, testing::ContainsRegex("cage_slip_ratio +-"));
  EXPECT_THAT(plain.output, testing::ContainsRegex("ring_displacement_mean_um +[0-9]"));
  const auto history = still({"simulate", scene, "-o", scratch / "run.h5"});
  EXPECT_EQ(history.code, 2);
  EXPECT_THAT(history.output, HasSubstr("a quasi-static run has no time history"));
  EXPECT_THAT(history.output, HasSubstr("remedy: set model.motion = \"dynamic\""));
  EXPECT_EQ(still({"bench", scene}).code, 2);
  EXPECT_EQ(still({"chart", scene, "-o", scratch / "chart"}).code, 2);
}

TEST(Program, MotionNeedsAWordOfOil) {
  const ScratchDirectory scratch;
  const std::string silent = scratch / "silent.toml";
  std::ofstream(silent) << reference_scene_without_oil();
  const auto says = AllOf(HasSubstr("lubrication.model: "), HasSubstr("whether there is oil"),
                          HasSubstr("remedy: give lubrication.model = \"film\""));
  const std::vector<std::string> still = {"--set", "model.motion=quasi-static"};
  for (const std::string command : {"check", "simulate", "ladder", "sweep"}) {
    std::vector<std::string> arguments = {command, silent};
    if (command == "ladder" || command == "sweep")
      arguments.insert(arguments.end(), {"-o", scratch / "out"});
    if (command == "ladder") arguments.insert(arguments.end(), {"--samples", "2"});
    const auto moving = run(arguments);
    EXPECT_EQ(moving.code, 2) << command;
    EXPECT_THAT(moving.output, says) << command;
    if (command == "sweep") continue;
    arguments.insert(arguments.end(), still.begin(), still.end());
    const auto resting = run(arguments);
    EXPECT_EQ(resting.code, command == "ladder" ? 2 : 0) << resting.output;
    EXPECT_EQ(resting.output.find("whether there is oil") != std::string::npos, command == "ladder")
        << resting.output;
  }
  EXPECT_EQ(run({"check", silent, "--set", "lubrication.model=none"}).code, 0);
  EXPECT_EQ(run({"check", silent, "--set", "lubrication.model=film"}).code, 0);
}

TEST(Program, ALadderSaysWhyItCannotBeClimbed) {
  const ScratchDirectory scratch;
  const auto ladder = [&](const std::string& setting) {
    return run({"ladder", shipped("scenes/nu205.toml"), "-o", scratch / "out", "--set", setting});
  };
  EXPECT_EQ(
      run({"ladder", shipped("scenes/nu205.toml"), "-o", scratch / "out", "--samples", "1"}).code,
      2);
  const auto wrong = ladder("load.radial_N=-5");
  EXPECT_EQ(wrong.code, 2);
  EXPECT_THAT(wrong.output, HasSubstr("outside the range"));
  const auto scattered = ladder(
      "integration.tolerance={ law = 'uniform', lower = 0, upper = 0.0001, nominal = 0.001 }");
  EXPECT_EQ(scattered.code, 2);
  EXPECT_THAT(scattered.output, HasSubstr("switches this key from rung to rung"));
  const auto limitless = run({"sweep", shipped("studies/nu205-rated.toml"), "-o", scratch / "out",
                              "--set", "fidelity=auto", "--set", "limit=[]"});
  EXPECT_EQ(limitless.code, 2);
  EXPECT_THAT(limitless.output, HasSubstr("nothing to judge a rung by"));
  EXPECT_THAT(limitless.output, HasSubstr("remedy: "));
}

TEST(Program, ChecksEveryShippedFile) {
  for (const char* path :
       {"scenes/nu205.toml", "scenes/nu205-thin.toml", "scenes/nu205-paper.toml",
        "scenes/nu205-paper-tight.toml", "scenes/speed-z16.toml", "scenes/speed-z16-skew.toml",
        "studies/nu205.toml", "studies/nu205-rated.toml", "studies/nu205-centre.toml",
        "studies/nu205-slip.toml", "studies/nu205-displacement.toml", "studies/nu205-fit.toml",
        "studies/nu205-measured.toml", "studies/nightly.toml", "studies/nu205-duty.toml",
        "studies/own-bearing-lips.toml", "scenes/nu2206-moulded.toml"}) {
    // A million cages with lips are drawn for their jams.
    if (std::string(path).find("-lips") != std::string::npos && !std::getenv("CAGETOL_NIGHTLY"))
      continue;
    const auto ended = run({"check", shipped(path)});
    EXPECT_EQ(ended.code, 0) << path << ended.output;
    EXPECT_THAT(ended.output, HasSubstr("no mistakes found"));
  }
}

TEST(Program, CheckShowsWhatChangesTheClearanceWhereSomethingDoes) {
  const auto check = [](std::vector<std::string> settings) {
    settings.insert(settings.begin(), {"check", shipped("scenes/nu205.toml")});
    const auto ended = run(settings);
    EXPECT_EQ(ended.code, 0) << ended.output;
    return ended.output;
  };
  EXPECT_THAT(check({}), AllOf(HasSubstr("  internal_clearance_um "), Not(HasSubstr("change_um")),
                               Not(HasSubstr("as_made"))));
  EXPECT_THAT(check({"--set", "fit.inner_interference_um=25"}),
              AllOf(HasSubstr("internal_clearance_as_made_um                   30  um"),
                    HasSubstr("inner_fit_change_um                       -19.8413  um"),
                    HasSubstr("inner_fit_pressure_MPa ")));
  EXPECT_THAT(check({"--set", "fit.inner_interference_um=50"}),
              HasSubstr("warning: the internal clearance in operation is -9.7 um, a preload"));
}

TEST(Program, SimulatePrintsJsonWithEveryQuantity) {
  const auto ended =
      run({"simulate", shipped("scenes/nu205.toml"), "--json", "--set",
           "window.settle_revolutions=0.2", "--set", "window.measure_revolutions=0.2", "--set",
           "watch.energy_residual_max=1000", "--set", "watch.static_consistency_max=1000"});
  ASSERT_EQ(ended.code, 0) << ended.output;
  const auto json = nlohmann::json::parse(ended.output);
  EXPECT_EQ(json["status"], "ok");
  for (const auto& quantity : quantity_table()) {
    ASSERT_TRUE(json["qoi"].contains(quantity.key)) << quantity.key;
    EXPECT_TRUE(json["qoi"][quantity.key].is_number() || json["qoi"][quantity.key].is_null());
  }
  for (const char* key : {"simulated_s", "wall_s", "steps", "rhs_evaluations", "energy_residual"})
    EXPECT_TRUE(json["run"][key].is_number()) << key;
  EXPECT_EQ(json["units"]["friction_torque_Nmm"], "N mm");
  EXPECT_EQ(json["units"]["simulated_s"], "s");
  const auto& at = json["operating_point"];
  EXPECT_NEAR(at["values"]["rating_ratio"].get<double>(), 28.6, 1e-9);
  EXPECT_EQ(at["units"]["roller_load_max_N"], "N");
  EXPECT_TRUE(at["warnings"].empty());
}

TEST(Program, JudgeReadsTheRunsOfASweepByOtherLimits) {
  const ScratchDirectory scratch;
  const std::string directory = scratch / "sweep", name = "ring_displacement_mean_um";
  ASSERT_EQ(run({"sweep", shipped("studies/nu205-displacement.toml"), "-o", directory, "--progress",
                 "off", "--set", "samples=60", "--set", "scene.model.motion=quasi-static", "--set",
                 "scene.window.measure_revolutions=1"})
                .code,
            0);
  const StudyData runs = read_study_data(directory + std::string("/study.h5"));
  const auto bytes = [&] {
    std::string all = file_bytes(directory + "/study.h5") + file_bytes(directory + "/study.toml");
    for (const auto& entry : std::filesystem::directory_iterator(directory + "/journal"))
      all += file_bytes(entry.path());
    return all;
  };
  const std::string before = bytes();
  std::vector<double> values = find_quantity(runs, name)->values;
  std::sort(values.begin(), values.end());
  const std::string stated = name + ".max=" + std::to_string((values[44] + values[45]) / 2);
  const auto judged = run({"judge", directory, "--limit", stated, "--json"});
  ASSERT_EQ(judged.code, 0) << judged.output;
  const auto found = nlohmann::json::parse(judged.output);
  EXPECT_EQ(found["runs"], 60);
  bool seen = false;
  for (const auto& limit : found["limits"])
    if (limit["quantity"] == name && limit["max"].is_number()) {
      seen = true;
      EXPECT_EQ(limit["missed"], 15);
      EXPECT_TRUE(limit["model_error"].is_null());
    }
  EXPECT_TRUE(seen);
  for (const auto& quantity : found["quantities"])
    EXPECT_LE(quantity["p5"].get<double>(), quantity["p99"].get<double>());
  EXPECT_THAT(run({"judge", directory}).output,
              AllOf(HasSubstr("error of the model not measured"), HasSubstr("--refine -o ")));
  EXPECT_FALSE(std::filesystem::exists(directory + "/judged"));
  // Killed at any time, and again to the end.
  for (const int milliseconds : {20, 100, 300, 700}) {
    Process killed({std::string(CAGETOL_BINARY_DIR) + "/cagetol", "judge", directory, "--limit",
                    stated, "--name", "n1"});
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
    killed.signal(SIGKILL);
    killed.wait();
    EXPECT_EQ(bytes(), before);
  }
  ASSERT_EQ(run({"judge", directory, "--limit", stated, "--name", "n1", "--target", "0.5"}).code,
            0);
  const auto report = nlohmann::json::parse(file_bytes(directory + "/judged/n1/report.json"));
  EXPECT_EQ(report["verdict"]["target_yield"], 0.5);
  EXPECT_LE(report["limits"]["joint"]["if_unknown_fail"].get<double>(), 0.75);
  EXPECT_TRUE(std::filesystem::exists(directory + "/judged/n1/limit_curves.csv"));
  EXPECT_EQ(bytes(), before);
  for (const auto& [option, value, message] : std::vector<std::array<std::string, 3>>{
           {"--limit", "nonsense=3", "the runs have no quantity nonsense"},
           {"--limit", name, "this is no quantity with a number"},
           {"--limit", name + "=x", "this is no quantity with a number"},
           {"--limit", "friction_torque_Nmm=3", "no"},
           {"--target", "1", "not in range"},
           {"--name", "../up", "letters, digits, - and _ make a name"}}) {
    const auto refused = run({"judge", directory, option, value});
    EXPECT_EQ(refused.code, 2) << value;
    EXPECT_THAT(refused.output, HasSubstr(message));
  }
}

TEST(Program, QuantitiesAreListedWithUnitDefinitionNeedsAndUse) {
  const auto all = run({"quantities", "--json"});
  ASSERT_EQ(all.code, 0) << all.output;
  const auto list = nlohmann::json::parse(all.output);
  ASSERT_EQ(list.size(), quantity_table().size() + operating_rows().size());
  for (std::size_t i = 0; i < quantity_table().size(); ++i) {
    EXPECT_EQ(list[i]["name"], quantity_table()[i].key);
    EXPECT_EQ(list[i]["unit"], quantity_table()[i].unit);
  }
  for (const auto& entry : list)
    for (const char* part : {"definition", "needs", "over", "use"})
      EXPECT_FALSE(entry[part].get<std::string>().empty()) << entry["name"] << part;

  const auto one = run({"quantities", "cage_fatigue_utilisation"});
  EXPECT_EQ(one.code, 0);
  EXPECT_THAT(one.output, AllOf(HasSubstr("modified Goodman line"), HasSubstr("window.peak"),
                                HasSubstr("cage.model = \"flexible\""),
                                Not(HasSubstr("cage_fatigue_pocket\n"))));
  EXPECT_EQ(nlohmann::json::parse(run({"quantities", "power_", "--json"}).output).size(), 11U);
  const auto none = run({"quantities", "friction_tork"});
  EXPECT_EQ(none.code, 2);
  EXPECT_THAT(none.output, HasSubstr("did you mean friction_torque_Nmm?"));
}

TEST(Program, WritesScenesOfCatalogueBearings) {
  ScratchDirectory directory;
  const std::string scene = directory / "nu2205.toml";
  const auto written = run({"scene", "nu", "2205", "--cage", "brass-machined", "--clearance", "C3",
                            "--lubricant", "iso-vg-32", "--load", "2000", "--rigid"});
  ASSERT_EQ(written.code, 0) << written.output;
  std::ofstream(scene) << written.output;
  const auto checked = run({"check", scene});
  EXPECT_EQ(checked.code, 0) << checked.output;
  EXPECT_THAT(checked.output, AllOf(HasSubstr("scene NU 2205 ECP: 13 rollers, rigid cage, 2000 N"),
                                    HasSubstr("no mistakes found"), Not(HasSubstr("warning"))));
  EXPECT_EQ(run({"simulate", scene, "--set", "window.settle_revolutions=0.1", "--set",
                 "window.measure_revolutions=0.5"})
                .code,
            0);
}

TEST(Program, ListsCatalogueBearingsAndNamesNearOnes) {
  const auto list = run({"scene", "--list", "nu 22"});
  EXPECT_EQ(list.code, 0);
  EXPECT_THAT(list.output, AllOf(HasSubstr("\nNU 2205 ECP "), Not(HasSubstr("NU 205 ECP"))));
  EXPECT_THAT(run({"scene", "--list"}).output, HasSubstr("\nNU 330 ECM "));
  const auto unknown = run({"scene", "NUP1005"});
  EXPECT_EQ(unknown.code, 2);
  EXPECT_THAT(unknown.output,
              AllOf(HasSubstr("no bearing of this designation"), HasSubstr("near ones: NU 1005")));
  for (const auto& [arguments, words] :
       {std::pair<std::vector<std::string>, std::string>{{"scene"}, "no bearing is named"},
        {{"scene", "NU208", "--cage", "gold"}, "brass-machined"},
        {{"scene", "NU208", "--clearance", "C9"}, "C4"},
        {{"scene", "NU208", "--lubricant", "water"}, "iso-vg-460"},
        {{"scene", "NU208", "--axial", "300"}, "take an NJ or NUP of this size"},
        {{"scene", "N208", "--axial", "300"}, "flanges on one ring alone"},
        {{"scene", "NJ208", "--axial", "-3"}, "--axial"},
        {{"scene", "NU208", "--load", "-1"}, "load.radial_N"}}) {
    const auto refused = run(arguments);
    EXPECT_EQ(refused.code, 2) << refused.output;
    EXPECT_THAT(refused.output, HasSubstr(words));
  }
}

TEST(Program, CheckShowsTheOperatingPointAndWarns) {
  const auto quiet = run({"check", shipped("studies/nu205-rated.toml")});
  EXPECT_THAT(quiet.output, AllOf(HasSubstr("life_L10_h"), HasSubstr("cage_mass_g"),
                                  HasSubstr("speed_factor_mm_min                         234000"),
                                  HasSubstr("cage.pocket_width_mm off centre by 0.018 mm 1.93 %"),
                                  Not(HasSubstr("warning: "))));
  const auto loud = run({"check", shipped("scenes/nu205.toml"), "--set", "load.radial_N=600000",
                         "--set", "speed.inner_rpm=300000"});
  EXPECT_EQ(loud.code, 0);
  EXPECT_THAT(loud.output,
              AllOf(HasSubstr("warning: load.radial_N = 600 kN is above the static load rating"),
                    HasSubstr("warning: load.radial_N = 600 kN is above the dynamic load rating"),
                    HasSubstr("warning: speed.inner_rpm = 300000 is above "
                              "bearing.limiting_speed_rpm = 16000")));
}

/// What a command prints on stdout alone, where cage tables cannot be kept.
Ended stdout_without_cache(const std::vector<std::string>& arguments) {
  return run(arguments, [] {
    ::setenv("CAGETOL_CACHE", "/dev/null/cache", 1);
    ::dup2(::open("/dev/null", O_WRONLY), STDERR_FILENO);
  });
}

TEST(Program, WarningsNeverStandBeforeJson) {
  const std::string scene = shipped("scenes/nu205.toml"), coarse = "cage.mesh_density=1",
                    sharp = "cage.corner_radius_mm=0";
  const std::vector<std::vector<std::string>> commands = {
      {"cage", scene, "--json", "--set", coarse, "--set", sharp, "--set", "cage.model=flexible"},
      {"simulate", scene, "--json", "--set", coarse, "--set", sharp, "--set", "cage.model=flexible",
       "--set", "window.settle_revolutions=0.05", "--set", "window.measure_revolutions=0.05"}};
  for (const auto& command : commands) {
    const auto ended = stdout_without_cache(command);
    EXPECT_TRUE(nlohmann::json::accept(ended.output)) << ended.output;
  }
}

TEST(Program, ACageThatCannotBeSolvedIsBadInput) {
  const auto ended = run({"simulate", shipped("scenes/nu205.toml"), "--set", "cage.mesh_density=1",
                          "--set", "cage.model=flexible", "--set", "cage.density_kg_m3=1e-300"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.output,
              AllOf(HasSubstr("cage.mesh_density = 1: the finite elements of the flexible cage "
                              "cannot be solved: "),
                    HasSubstr("remedy: choose another density"), Not(HasSubstr("unexpected"))));
}

TEST(Program, CagePrintsModesAndSaysWhichPocketIsWrong) {
  const ScratchDirectory scratch;
  const auto cage = [&](double last_width) {
    const auto pockets = [](const std::string& key, double value, double last) {
      std::string list;
      for (int j = 0; j < 12; ++j) list += std::to_string(value) + ", ";
      return "cage.pocket_" + key + " = [" + list + std::to_string(last) + "]";
    };
    return run(
        {"cage", shipped("scenes/nu205.toml"), "--json", "--set", "cage.model=flexible", "--set",
         "cage.mesh_density=2", "--set", "cage.corner_radius_mm=0", "--set",
         pockets("width_mm", 7.67, last_width), "--set", pockets("length_mm", 9.24, 9.33), "--set",
         pockets("pitch_mrad", 0.3, 0), "--set", pockets("squareness_mrad", 0.2, 0)},
        [&] { ::setenv("CAGETOL_CACHE", (scratch / "cache").c_str(), 1); });
  };
  const auto ended = cage(7.6);
  ASSERT_EQ(ended.code, 0) << ended.output;
  const auto json = nlohmann::json::parse(ended.output.substr(ended.output.find('{')));
  EXPECT_EQ(json["modes_Hz"].size(), 10U);
  EXPECT_EQ(json["shapes"][0], "in-plane 2");
  EXPECT_EQ(json["dofs"], 11115);
  EXPECT_NEAR(json["mass_kg"].get<double>(), 0.0211, 2e-4);
  EXPECT_NEAR(json["inertia_kg_m2"][0][0].get<double>(), 8.6e-6, 1e-7);
  EXPECT_LT(json["largest_frequency_error"].get<double>(), 2e-3);
  for (const char* seconds : {"seconds_sample", "seconds_full", "seconds_table"})
    EXPECT_GT(json[seconds].get<double>(), 0) << seconds;

  const auto far = cage(8.1);
  EXPECT_EQ(far.code, 2);
  EXPECT_THAT(far.output,
              HasSubstr("pocket 12 (the first is 0): pocket width deviates by 0.3969 mm "
                        "from 7.7031, the cage table covers"));
}

TEST(Program, AJamIsAnOutcome) {
  const auto ended = run({"simulate", shipped("scenes/nu205.toml"), "--json", "--set",
                          "cage.pocket_width_mm={ nominal = 7.65, lot = { law = 'normal', mean = "
                          "-0.2, sigma = 0 } }"});
  EXPECT_EQ(ended.code, 0) << ended.output;
  const auto json = nlohmann::json::parse(ended.output);
  EXPECT_EQ(json["status"], "jammed");
  EXPECT_THAT(json["reason"].get<std::string>(), HasSubstr("50 um too large"));
  EXPECT_TRUE(json["qoi"]["cage_slip_ratio"].is_null());
}

TEST(Program, OutputThatCannotBeWrittenIsSaid) {
  const auto ended =
      run({"simulate", shipped("scenes/nu205.toml"), "--set", "window.settle_revolutions=0.01",
           "--set", "window.measure_revolutions=0.01", "-o", "/no/such/folder/run.h5"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.output, HasSubstr("/no/such/folder"));
  EXPECT_THAT(ended.output, HasSubstr("remedy: "));
  Process full({"/bin/sh", "-c",
                std::string(CAGETOL_BINARY_DIR) + "/cagetol --dump-default keys > /dev/full"});
  EXPECT_EQ(full.wait(), 2);
  EXPECT_THAT(full.output(), HasSubstr("cannot write the output: No space left on device"));
}

TEST(Program, DumpedDefaultsAreValidFiles) {
  const ScratchDirectory scratch;
  for (const char* what : {"scene", "study"}) {
    const auto dumped = run({"--dump-default", what});
    ASSERT_EQ(dumped.code, 0);
    std::ofstream(scratch / "dumped.toml") << dumped.output;
    EXPECT_EQ(run({"check", scratch / "dumped.toml"}).code, 0);
  }
}

TEST(Program, TheTablesOfKeysAreTrue) {
  const auto keys = run({"--dump-default", "keys"});
  ASSERT_EQ(keys.code, 0);
  EXPECT_THAT(read_text_file(shipped("KEYS.md")),
              testing::EndsWith("<!-- keys -->\n" + keys.output))
      << "write the output of `cagetol --dump-default keys` below the mark in inputs/KEYS.md";
}

}  // namespace
}  // namespace cagetol
