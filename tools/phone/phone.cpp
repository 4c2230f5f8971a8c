// marrow_phone: measures Marrow on the device that it runs on. Each call prints one part of the result as JSON, so that
// a driver that crashes costs that part alone; the kit's run.sh joins them. See tools/phone.sh.
// usage: marrow_phone device NAME | cpu NEWT | self-test TRYING | gpu PATH NEWT
//   NAME     what the device is called; "": as the kernel says
//   NEWT     the sample character, cooked, not packed
//   TRYING   a file that keeps which paths have crashed; it may be missing
//   PATH     ubo, texture, feedback, compute or cpu
#include "phone/phone.h"

#include <sys/utsname.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>

namespace marrow::phone {
namespace {

std::string contents(const char* path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

// Chip and cores of /proc/cpuinfo: "Qualcomm …, 4 x 0x41/0xd05, 4 x 0x41/0xd0a", implementer and part of ARM's cores.
std::string cpu_name(std::istream& lines) {
  std::string chip, implementer;
  std::map<std::string, int> parts, models;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t colon = std::min(line.find(':'), line.size());
    const std::string key = line.substr(0, line.find_last_not_of(" \t:", colon) + 1);
    const std::string value = line.substr(std::min(colon + 2, line.size()));
    if (key == "Hardware") chip = value + ", ";
    if (key == "CPU implementer") implementer = value + "/";
    if (key == "CPU part") ++parts[implementer + value];
    if (key == "model name") ++models[value];
  }
  std::string out = chip;
  for (const auto& [core, count] : parts.empty() ? models : parts) out += std::to_string(count) + " x " + core + ", ";
  return out.empty() ? "unknown" : out.substr(0, out.size() - 2);
}

void tell_device(std::string name) {
  std::ifstream cpuinfo("/proc/cpuinfo");
  utsname system = {};
  uname(&system);
  if (name.empty()) name = contents("/proc/device-tree/model").c_str();  // ends with a zero
  if (name.empty()) name = "unnamed";
#if defined(__ANDROID__)
  const char* const kind = "Android";
#else
  const char* const kind = "GNU/Linux";
#endif
  std::printf("{\"name\": %s, \"cpu\": %s, \"system\": %s, \"machine\": %s}\n", quoted(name).c_str(),
              quoted(cpu_name(cpuinfo)).c_str(), quoted(std::string(kind) + ", kernel " + system.release).c_str(),
              quoted(system.machine).c_str());
}

Newt load_newt(const char* path) {
  const std::string text = contents(path);
  Newt out;
  out.bytes = tools::AlignedBytes(std::as_bytes(std::span(text.data(), text.size())));
  File file;
  must(load({out.bytes.data(), out.bytes.size()}, file), path);
  for (std::uint32_t m = 0; m < file.mesh_count(); ++m)
    if (file.mesh(m).geometry.slot_count > out.body.geometry.slot_count) out.body = file.mesh(m);
  const std::uint32_t walk = file.find_clip("walk");
  if (walk >= file.clip_count() || out.body.geometry.slot_count == 0) give_up(path, "not the sample character");
  out.walk = file.clip(walk);
  out.skeleton = file.skeleton(out.walk.skeleton);
  return out;
}

int run(int count, char** words) {
  const std::string part = count > 1 ? words[1] : "";
  if (part == "device" && count == 3)
    tell_device(words[2]);
  else if (part == "cpu" && count == 3)
    bench_cpu(load_newt(words[2]));
  else if (part == "self-test" && count == 3)
    self_test(words[2]);
  else if (part == "gpu" && count == 4)
    bench_gpu(load_newt(words[3]), words[2]);
  else
    return std::fputs("usage: marrow_phone device NAME | cpu NEWT | self-test TRYING | gpu PATH NEWT\n", stderr), 2;
  return std::fflush(stdout) == 0 ? 0 : 1;
}

}  // namespace

void give_up(const std::string& what, const std::string& why) {
  std::printf("{\"error\": %s}\n", quoted(what + ": " + why).c_str());
  std::exit(std::fflush(stdout) == 0 ? 0 : 1);
}

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    if (c >= ' ' && c <= '~') out += c;
  }
  return out + "\"";
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return std::isfinite(value) ? text : "null";
}

}  // namespace marrow::phone

int main(int count, char** words) {
  return marrow::phone::run(count, words);
}
