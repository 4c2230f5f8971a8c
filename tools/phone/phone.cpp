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

// What stands behind `key` and a colon in a line of /proc/cpuinfo; "" if the line is another's.
std::string value_of(const std::string& line, const std::string& key) {
  const std::size_t colon = line.find(':');
  if (line.compare(0, key.size(), key) != 0 || colon == std::string::npos) return "";
  if (line.find_first_not_of(" \t", key.size()) != colon) return "";
  const std::size_t begin = line.find_first_not_of(" \t", colon + 1);
  return begin == std::string::npos ? "" : line.substr(begin);
}

// Chip and cores: "Qualcomm …, 4 × 0x41/0xd05, 4 × 0x41/0xd0a", with implementer and part of ARM's cores.
std::string cpu_name() {
  std::ifstream stream("/proc/cpuinfo");
  std::string chip, implementer;
  std::map<std::string, int> cores;
  for (std::string line; std::getline(stream, line);) {
    if (const std::string hardware = value_of(line, "Hardware"); !hardware.empty()) chip = hardware + ", ";
    if (const std::string maker = value_of(line, "CPU implementer"); !maker.empty()) implementer = maker;
    if (const std::string part = value_of(line, "CPU part"); !part.empty()) ++cores[implementer + "/" + part];
    if (const std::string model = value_of(line, "model name"); !model.empty() && implementer.empty()) ++cores[model];
  }
  std::string out = chip;
  for (const auto& [core, count] : cores) out += std::to_string(count) + " x " + core + ", ";
  return out.empty() ? "unknown" : out.substr(0, out.size() - 2);
}

void tell_device(std::string name) {
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
              quoted(cpu_name()).c_str(), quoted(std::string(kind) + ", kernel " + system.release).c_str(),
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
