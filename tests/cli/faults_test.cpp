// Memory that ends and files that fail, at every call in turn: the program says so and ends in order, and what it was
// to write is the old file or the new one.
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cli/support/process.h"
#include "support/places.h"

namespace marrow::test {
namespace {

struct Command {
  const char* name;
  std::vector<std::string> arguments;
  std::string output;  // what it writes; empty: to stdout
};

// Each with its output in the folder.
std::vector<Command> commands(const TemporaryFolder& folder) {
  const std::string packed = folder / "in.mrw";
  EXPECT_EQ(run_marrow({"cook", in_golden("dance.gltf"), "-o", packed}).code, 0);
  const std::string mrw = folder / "out.mrw", glb = folder / "out.glb", bin = folder / "out.bin";
  return {{"cook", {"cook", in_golden("dance.gltf"), "-o", mrw, "--jobs", "1"}, mrw},
          {"info", {"info", packed}, ""},
          {"export", {"export", packed, "-o", glb}, glb},
          {"pose", {"pose", packed, "-o", bin}, bin},
          {"diff", {"diff", packed, packed}, ""}};
}

Ran run_with(const std::string& fault, const Command& command) {
  std::vector<std::string> all = {"env", "LD_PRELOAD=" + fault_shim(), "MARROW_FAULT=" + fault, program()};
  all.insert(all.end(), command.arguments.begin(), command.arguments.end());
  return run_program(all);
}

// Runs with the fault at `number`. True if it was reached.
bool fails_in_order(const std::string& kind, int number, const Command& command, const std::string& whole) {
  constexpr const char* kOld = "precious";
  if (!command.output.empty()) write_text(command.output, kOld);
  const std::string fault = kind + " " + std::to_string(number);
  const Ran ran = run_with(fault, command);
  SCOPED_TRACE(std::string(command.name) + ", " + fault + ": " + ran.err);
  const std::string result = command.output.empty() ? ran.out : read_text(command.output);
  if (ran.code == 0) {
    EXPECT_EQ(result, whole) << "success is said, but not had";
    return false;
  }
  EXPECT_TRUE(ran.code == 2 || ran.code == 5) << ran.code;
  EXPECT_FALSE(ran.complaints().empty()) << "no word of why";
  EXPECT_TRUE(command.output.empty() || result == kOld || result == whole) << "something in between";
  return true;
}

std::string whole_result(const Command& command) {
  const Ran ran = run_with("files 1000000", command);
  EXPECT_EQ(ran.code, 0) << command.name << ": " << ran.err;
  return command.output.empty() ? ran.out : read_text(command.output);
}

TEST(Faults, EveryCallOnAFile) {
  const TemporaryFolder folder;
  for (const Command& command : commands(folder)) {
    const std::string whole = whole_result(command);
    int failed = 0;
    // Closing what was read, and flushing a folder that cannot be flushed, may fail in silence.
    for (int number = 1, silent = 0; silent < 12; ++number) {
      const bool reached = fails_in_order("files", number, command, whole);
      failed += reached;
      silent = reached ? 0 : silent + 1;
    }
    EXPECT_GE(failed, command.output.empty() ? 2 : 6) << command.name;
  }
}

// Every request, or the first ones and more and more thinly those that follow.
void end_memory(const std::string& kind, bool every) {
  const TemporaryFolder folder;
  for (const Command& command : commands(folder)) {
    const std::string whole = whole_result(command);
    int failed = 0;
    for (int number = 1, silent = 0; silent < 20 && !::testing::Test::HasFailure();) {
      const bool reached = fails_in_order(kind, number, command, whole);
      failed += reached;
      silent = reached ? 0 : silent + 1;
      number += every || !reached ? 1 : 1 + number / 12;
    }
    if (::testing::Test::HasFailure()) return;
    EXPECT_GE(failed, 40) << command.name;
  }
}

TEST(Faults, EveryRequestForMemory) {
  end_memory("memory", in_long_form());
}

TEST(Faults, AllMemoryFromSomeRequestOn) {
  end_memory("memory-from", false);
}

TEST(Faults, AFullStandardOutput) {
  const Ran ran = run_program({"sh", "-c", "'" + program() + "' info '" + in_golden("tiny_v1.mrw") + "' >/dev/full"});
  EXPECT_EQ(ran.code, 2);
  EXPECT_NE(ran.err.find("No space left"), std::string::npos) << ran.err;
}

}  // namespace
}  // namespace marrow::test
