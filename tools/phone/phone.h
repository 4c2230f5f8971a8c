// What the parts of marrow_phone share: the newt, JSON, and how a row is timed.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "common/aligned_bytes.h"
#include "marrow/marrow.h"

namespace marrow::phone {

// The sample character, in memory of its own.
struct Newt {
  tools::AlignedBytes bytes;
  Mesh body;
  Skeleton skeleton;
  Clip walk;
};

// Prints {"error": "WHAT: WHY"} and ends the program with 0: the part has said all that it can.
[[noreturn]] void give_up(const std::string& what, const std::string& why);
inline void must(Status status, const char* what) {
  if (status != Status::ok) give_up(what, to_string(status));
}

// JSON. Of texts only printable ASCII is kept.
std::string quoted(const std::string& text);
std::string number(double value);

using Clock = std::chrono::steady_clock;
inline double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// Of one iteration: the median of batches that take at least `batch_s` / 2. run(n): seconds of n iterations.
template <class Run>
double median_seconds(double batch_s, std::size_t batches, Run run) {
  std::uint64_t count = 1;
  while (run(count) < batch_s / 2 && count < std::uint64_t{1} << 32) count *= 2;
  std::vector<double> times(batches);
  for (double& time_s : times) time_s = run(count);
  std::nth_element(times.begin(), times.begin() + static_cast<std::ptrdiff_t>(batches / 2), times.end());
  return times[batches / 2] / static_cast<double>(count);
}

// The parts: each prints one JSON value.
void bench_cpu(const Newt& newt);
// trying: a file that keeps which paths were being tried when the process ended, as a sum of bit_of().
void self_test(const char* trying);
void bench_gpu(const Newt& newt, const std::string& path);

}  // namespace marrow::phone
