#include "mc/host/log.hpp"

#include <fcntl.h>
#include <spdlog/pattern_formatter.h>
#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <memory>
#include <string_view>

#include "src/input/printable.hpp"

namespace cagetol {
namespace {

/// "warning: " and the like; nothing for information.
class LevelWord : public spdlog::custom_flag_formatter {
 public:
  void format(const spdlog::details::log_msg& message, const std::tm&,
              spdlog::memory_buf_t& text) override {
    if (message.level <= spdlog::level::info) return;
    const auto word = spdlog::level::to_string_view(message.level);
    text.append(word.data(), word.data() + word.size());
    text.append(std::string_view(": "));
  }
  std::unique_ptr<spdlog::custom_flag_formatter> clone() const override {
    return std::make_unique<LevelWord>();
  }
};

/// The message without what would act on a terminal: names of files and keys are the user's.
class SafeText : public spdlog::custom_flag_formatter {
 public:
  void format(const spdlog::details::log_msg& message, const std::tm&,
              spdlog::memory_buf_t& text) override {
    const std::string safe =
        printable({message.payload.data(), message.payload.size()}, LineBreaks::kept);
    text.append(safe.data(), safe.data() + safe.size());
  }
  std::unique_ptr<spdlog::custom_flag_formatter> clone() const override {
    return std::make_unique<SafeText>();
  }
};

}  // namespace

void log_to_stderr() {
  auto logger = std::make_shared<spdlog::logger>("cagetol",
                                                 std::make_shared<spdlog::sinks::stderr_sink_mt>());
  auto formatter = std::make_unique<spdlog::pattern_formatter>();
  formatter->add_flag<LevelWord>('*').add_flag<SafeText>('&').set_pattern("cagetol: %*%&");
  logger->set_formatter(std::move(formatter));
  logger->flush_on(spdlog::level::trace);
  spdlog::set_default_logger(logger);
}

void open_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(stream, F_GETFD) == -1) (void)!::open("/dev/null", O_RDWR);  // the lowest number
}

}  // namespace cagetol
