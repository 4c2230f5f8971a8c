// What a piece of code costs in instructions.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

namespace marrow::tools {

// How many instructions `work` executes in this thread, outside the kernel; a few of them are the counting's own.
// Nothing where the processor's counter cannot be read: on other systems than Linux, in most virtual machines and
// containers, and where /proc/sys/kernel/perf_event_paranoid is above 2.
std::optional<std::uint64_t> count_instructions(const std::function<void()>& work);

}  // namespace marrow::tools
