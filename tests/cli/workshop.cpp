// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
#include "workshop.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <sstream>
#include <stdexcept>

namespace sweepkit::test {
namespace {

std::string read_whole(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

// Short enough to read in a failed test's message.
std::string digest(const std::string& bytes) {
  return std::to_string(bytes.size()) + " bytes, hash " + std::to_string(std::hash<std::string>()(bytes));
}

// In the child: never returns.
[[noreturn]] void become(const std::vector<std::string>& command, const std::filesystem::path& folder,
                         int out, int err) {
  // A shell without a terminal has Ctrl-C ignored for what it starts in the background.
  for (const int signal : {SIGINT, SIGTERM, SIGPIPE, SIGHUP}) std::signal(signal, SIG_DFL);
  std::vector<char*> arguments;
  for (const std::string& argument : command) arguments.push_back(const_cast<char*>(argument.c_str()));
  arguments.push_back(nullptr);
  const int nothing = open("/dev/null", O_RDONLY);
  if (chdir(folder.c_str()) == 0 && dup2(nothing, 0) == 0 && dup2(out, 1) == 1 && dup2(err, 2) == 2) {
    execv(arguments[0], arguments.data());
  }
  _exit(126);
}

}  // namespace

int exit_status(int wait_status) {
  return WIFSIGNALED(wait_status) ? 128 + WTERMSIG(wait_status) : WEXITSTATUS(wait_status);
}

std::string scene_of(const std::string& objects, const std::string& more) {
  return "{\"sweepkit\": 1,\n \"objects\": [\n" + objects + "\n ]" + (more.empty() ? "" : ",\n" + more) +
         "}\n";
}

Workshop::Workshop() {
  std::string name = (std::filesystem::temp_directory_path() / "sweepkit-test.XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder: " + name);
  folder_ = name;
}

Workshop::~Workshop() {
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

void Workshop::write(const std::string& name, const std::string& text) const {
  std::ofstream(folder_ / name, std::ios::binary) << text;
}

std::string Workshop::read(const std::string& name) const {
  if (!std::filesystem::exists(folder_ / name)) throw std::runtime_error("there is no file " + name);
  return read_whole(folder_ / name);
}

std::map<std::string, std::string> Workshop::contents() const {
  std::map<std::string, std::string> contents;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_)) {
    const std::string name = std::filesystem::relative(entry.path(), folder_);
    contents[name] = entry.is_regular_file() ? digest(read_whole(entry.path())) : "(no file)";
  }
  return contents;
}

Outcome Workshop::sweepkit(const std::vector<std::string>& arguments) const {
  std::vector<std::string> command = {SWEEPKIT_PROGRAM};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return run(command);
}

Outcome Workshop::shell(const std::string& command) const {
  return run({"/bin/bash", "-c", "sweepkit() { " SWEEPKIT_PROGRAM " \"$@\"; }\n" + command});
}

pid_t Workshop::start(const std::vector<std::string>& arguments) const {
  std::vector<std::string> command = {SWEEPKIT_PROGRAM};
  command.insert(command.end(), arguments.begin(), arguments.end());
  const pid_t child = fork();
  if (child == 0) {
    const int nothing = open("/dev/null", O_WRONLY);
    become(command, folder_, nothing, nothing);
  }
  return child;
}

Outcome Workshop::run(const std::vector<std::string>& command) const {
  // Outputs go to files without a name, so that none can fill up and stop the program.
  std::array<FILE*, 2> outputs = {std::tmpfile(), std::tmpfile()};
  const auto start = std::chrono::steady_clock::now();
  const pid_t child = fork();
  if (child == 0) become(command, folder_, fileno(outputs[0]), fileno(outputs[1]));
  int wait_status = 0;
  rusage used{};
  while (wait4(child, &wait_status, 0, &used) < 0 && errno == EINTR) {
  }
  Outcome result;
  result.time = std::chrono::steady_clock::now() - start;
  result.status = exit_status(wait_status);
  for (const timeval& part : {used.ru_utime, used.ru_stime})
    result.cpu_seconds += static_cast<double>(part.tv_sec) + 1e-6 * static_cast<double>(part.tv_usec);
  result.peak_bytes = std::size_t{1024} * static_cast<std::size_t>(used.ru_maxrss);
  for (std::size_t i = 0; i < 2; ++i) {
    std::string& text = i == 0 ? result.out : result.err;
    std::rewind(outputs[i]);
    std::array<char, 65536> block;
    while (const std::size_t count = std::fread(block.data(), 1, block.size(), outputs[i])) {
      text.append(block.data(), count);
    }
    std::fclose(outputs[i]);
  }
  return result;
}

}  // namespace sweepkit::test
