// Runs the built program as a user would, in a folder of its own that is gone afterwards.
#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace marrow::test {

// Exit codes that docs/reference/command_line.md promises.
enum ExitCode { kUsage = 1, kIo = 2, kInvalid = 3, kUnsupported = 4, kInterrupted = 130 };

struct Ran {
  int code = -1;  // exit code; 1000 + signal if killed
  std::string out, err;
  double processor_s = 0;
  std::size_t peak_bytes = 0;  // of memory
  // Lines of stderr that are no warnings about the source.
  std::vector<std::string> complaints() const;
};

// Arguments behind the program's name; stdin is empty. Throws std::runtime_error if the program cannot be started.
Ran run_marrow(const std::vector<std::string>& arguments);
// The same with stderr on a terminal; interrupted (SIGINT) as soon as `interrupt_at` is shown there, unless that is
// empty.
Ran run_marrow_on_terminal(const std::vector<std::string>& arguments, const std::string& interrupt_at = "");

// Any program, looked for as a shell does; killed (SIGKILL) after `kill_after` unless that is 0.
Ran run_program(const std::vector<std::string>& program_and_arguments,
                std::chrono::microseconds kill_after = std::chrono::microseconds(0));

class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  std::string operator/(const std::string& name) const { return (path_ / name).string(); }
  // Names of what it holds, sorted.
  std::vector<std::string> listing() const;
  std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

// The program, or another that is looked for as a shell does, while it runs; killed at the end if it still does.
class RunningMarrow {
 public:
  explicit RunningMarrow(const std::vector<std::string>& arguments, const std::string& other_program = "");
  ~RunningMarrow();
  RunningMarrow(const RunningMarrow&) = delete;
  RunningMarrow& operator=(const RunningMarrow&) = delete;
  // What it has written so far.
  std::string out() const;
  std::string err() const;
  // Processor time that it has used so far.
  double processor_s() const;
  // SIGINT, and what became of it.
  Ran interrupt();

 private:
  TemporaryFolder folder_;
  int child_;
};

std::string read_text(const std::string& path);
void write_text(const std::string& path, const std::string& bytes);
// A scene with one triangle of this size, in metres, whose numbers are in a file of their own beside it.
void write_triangle(const std::string& gltf, const std::string& bin, float size);

// The source of the golden file.
std::string tiny_gltf();

}  // namespace marrow::test
