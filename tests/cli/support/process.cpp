#include "cli/support/process.h"
#include "support/places.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <thread>
#include <utility>

namespace marrow::test {

namespace fs = std::filesystem;

TemporaryFolder::TemporaryFolder() {
  std::string name = (fs::temp_directory_path() / "marrow_cli_XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make a temporary folder");
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

std::vector<std::string> TemporaryFolder::listing() const {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(path_)) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::string read_text(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void write_text(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

void write_triangle(const std::string& gltf, const std::string& bin, float size) {
  const float xyz[9] = {0, 0, 0, size, 0, 0, 0, size, 0};
  std::string bytes(sizeof xyz, '\0');
  std::memcpy(bytes.data(), xyz, sizeof xyz);
  write_text(bin, bytes);
  std::string uri;
  for (const char c : fs::path(bin).filename().string()) {
    if (std::string(" #%").find(c) == std::string::npos) {
      uri += c;
    } else {
      uri += c == ' ' ? "%20" : c == '#' ? "%23" : "%25";
    }
  }
  write_text(gltf,
             R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"name":"n","mesh":0}],)"
             R"("meshes":[{"name":"m","primitives":[{"attributes":{"POSITION":0}}]}],"accessors":[{"bufferView":0,)"
             R"("componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[)" +
                 std::to_string(size) + "," + std::to_string(size) +
                 R"(,0]}],"bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,"uri":")" + uri +
                 "\"}]}");
}

std::string tiny_gltf() {
  return in_golden("tiny.gltf");
}

std::vector<std::string> Ran::complaints() const {
  std::vector<std::string> lines;
  std::istringstream in(err);
  for (std::string line; std::getline(in, line);)
    if (line.find(": warning: ") == std::string::npos) lines.push_back(line);
  return lines;
}

Ran run_marrow(const std::vector<std::string>& arguments) {
  std::vector<std::string> all = {program()};
  all.insert(all.end(), arguments.begin(), arguments.end());
  return run_program(all);
}

namespace {

pid_t start(const std::vector<std::string>& program_and_arguments, const std::string& out, const std::string& err) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, 1, out.c_str(), O_WRONLY | O_CREAT, 0600);
  posix_spawn_file_actions_addopen(&actions, 2, err.c_str(), O_WRONLY | O_CREAT | O_NOCTTY, 0600);
  std::vector<std::string> texts = program_and_arguments;
  std::vector<char*> argv;
  for (std::string& text : texts) argv.push_back(text.data());
  argv.push_back(nullptr);
  pid_t child = 0;
  const int failed = posix_spawnp(&child, argv[0], &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failed != 0) throw std::runtime_error("cannot start " + texts[0]);
  return child;
}

void wait_for(pid_t child, Ran& ran) {
  int status = 0;
  rusage used{};
  if (wait4(child, &status, 0, &used) != child) throw std::runtime_error("cannot wait for the program");
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  ran.code = WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
  ran.processor_s = seconds(used.ru_utime) + seconds(used.ru_stime);
  ran.peak_bytes = static_cast<std::size_t>(used.ru_maxrss) * 1024;
}

}  // namespace

Ran run_program(const std::vector<std::string>& program_and_arguments, std::chrono::microseconds kill_after) {
  const TemporaryFolder folder;
  const std::string out = folder / "out", err = folder / "err";
  const pid_t child = start(program_and_arguments, out, err);
  if (kill_after.count() > 0) {
    std::this_thread::sleep_for(kill_after);
    ::kill(child, SIGKILL);
  }
  Ran ran;
  wait_for(child, ran);
  ran.out = read_text(out);
  ran.err = read_text(err);
  return ran;
}

RunningMarrow::RunningMarrow(const std::vector<std::string>& arguments, const std::string& other_program) {
  std::vector<std::string> all = {other_program.empty() ? program() : other_program};
  all.insert(all.end(), arguments.begin(), arguments.end());
  child_ = start(all, folder_ / "out", folder_ / "err");
}

RunningMarrow::~RunningMarrow() {
  if (child_ < 0) return;
  ::kill(child_, SIGKILL);
  ::waitpid(child_, nullptr, 0);
}

std::string RunningMarrow::out() const {
  return read_text(folder_ / "out");
}

std::string RunningMarrow::err() const {
  return read_text(folder_ / "err");
}

double RunningMarrow::processor_s() const {
  clockid_t clock;
  timespec used{};
  if (clock_getcpuclockid(child_, &clock) != 0 || clock_gettime(clock, &used) != 0)
    throw std::runtime_error("cannot read the program's processor time");
  return static_cast<double>(used.tv_sec) + 1e-9 * static_cast<double>(used.tv_nsec);
}

Ran RunningMarrow::interrupt() {
  ::kill(child_, SIGINT);
  Ran ran;
  wait_for(std::exchange(child_, -1), ran);
  ran.out = out();
  ran.err = err();
  return ran;
}

Ran run_marrow_on_terminal(const std::vector<std::string>& arguments, const std::string& interrupt_at) {
  const TemporaryFolder folder;
  const int terminal = ::posix_openpt(O_RDWR | O_NOCTTY);
  if (terminal < 0 || ::grantpt(terminal) != 0 || ::unlockpt(terminal) != 0)
    throw std::runtime_error("cannot make a terminal");
  std::vector<std::string> all = {program()};
  all.insert(all.end(), arguments.begin(), arguments.end());
  const pid_t child = start(all, folder / "out", ::ptsname(terminal));
  std::string err;
  char bytes[4096];
  bool to_interrupt = !interrupt_at.empty();
  for (ssize_t n = 0; (n = ::read(terminal, bytes, sizeof bytes)) > 0;) {
    err.append(bytes, static_cast<std::size_t>(n));
    if (!to_interrupt || err.find(interrupt_at) == std::string::npos) continue;
    ::kill(child, SIGINT);
    to_interrupt = false;
  }
  ::close(terminal);
  Ran ran;
  wait_for(child, ran);
  ran.out = read_text(folder / "out");
  ran.err = err;
  return ran;
}

}  // namespace marrow::test
