#include "jobs/units.h"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <numeric>
#include <queue>

#include <nlohmann/json.hpp>

#include "common/failure.h"
#include "common/formats.h"
#include "common/parallel.h"
#include "disk/disk_files.h"
#include "disk/files.h"
#include "disk/thread_pool.h"

namespace marrow::tools {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

// Measured on real models by one thread; docs/cooking/many_machines.md says how well they foretell.
constexpr double kStart_s = 0.01, kSecondsAByte = 2e-8, kSecondsAKey = 4e-5, kSecondsAVertex = 3e-5;
constexpr double kFit_s = 0.3, kFitSecondsAVertex = 1.5e-4, kElastic_s = 25, kElasticSecondsAVertex = 6e-4;

// What a scene's document says of how much there is, without its buffers.
struct Amounts {
  std::uint64_t bytes = 0;  // with buffers beside it
  double vertices = 0, keys = 0;
};

std::uint64_t size_of(const std::string& path) {
  std::error_code error;
  const std::uintmax_t bytes = fs::file_size(path, error);
  return error ? 0 : bytes;
}

// The text of a .gltf, or of a .glb's first chunk.
std::string document_of(const std::string& path) {
  constexpr std::uint64_t kMostText = 64'000'000;
  constexpr std::size_t kHeader = 20, kLengthAt = 12;
  DiskFiles files;
  if (has_extension(path, ".gltf")) {
    const std::vector<std::byte> bytes = files.read(path, kMostText);
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  }
  const std::vector<std::byte> header = files.read(path, kHeader);
  std::uint32_t length = 0;
  if (header.size() < kHeader) return "";
  std::memcpy(&length, header.data() + kLengthAt, sizeof length);
  const std::vector<std::byte> bytes = files.read(path, std::min<std::uint64_t>(kHeader + length, kMostText));
  return {reinterpret_cast<const char*>(bytes.data()) + kHeader, bytes.size() - kHeader};
}

double count_at(const json& document, const json& accessor) {
  constexpr double kMost = 1e9;
  return std::clamp(document.at("accessors").at(accessor.get<std::size_t>()).at("count").get<double>(), 0.0, kMost);
}

void add_amounts(const std::string& path, const json& document, Amounts& out) {
  DiskFiles files;
  for (const json& buffer : document.value("buffers", json::array()))
    if (const std::string uri = buffer.value("uri", ""); !uri.empty() && !uri.starts_with("data:"))
      out.bytes += size_of(files.beside(path, uri));
  for (const json& mesh : document.value("meshes", json::array()))
    for (const json& primitive : mesh.at("primitives"))
      out.vertices += count_at(document, primitive.at("attributes").at("POSITION"));
  for (const json& clip : document.value("animations", json::array()))
    for (const json& sampler : clip.at("samplers")) out.keys += count_at(document, sampler.at("input"));
}

// Whatever is wrong there, cooking tells.
Amounts amounts_of(const std::string& path) {
  Amounts out{size_of(path), 0, 0};
  if (is_named_bvh(path)) return out;
  try {
    add_amounts(path, json::parse(document_of(path)), out);
  } catch (const Failure&) {
  } catch (const json::exception&) {
  }
  return out;
}

bool learns(const cook::LearnOptions& options) {
  return options.animation_space == cook::AnimationSpace::fit || options.helpers != 0;
}

}  // namespace

Shard read_shard(const std::string& text) {
  Shard out;
  const char* const end = text.data() + text.size();
  const auto [slash, wrong] = std::from_chars(text.data(), end, out.number);
  const auto [rest, wrong_count] = std::from_chars(slash == end ? end : slash + 1, end, out.count);
  if (wrong != std::errc() || wrong_count != std::errc() || *slash != '/' || rest != end || out.number < 1 ||
      out.number > out.count)
    throw Failure(Exit::usage, "--shard", "", "not a share: " + text, "give it as 3/8, from 1/8 to 8/8");
  return out;
}

KnownTimes::KnownTimes(const std::vector<std::string>& reports) {
  for (const std::string& path : reports) {
    const AlignedBytes bytes = read_file(path);
    const char* const text = reinterpret_cast<const char*>(bytes.data());
    try {
      const json list = json::parse(text, text + bytes.size());
      for (const json& report : list)
        if (report.contains("run"))
          seconds_[report.at("source").at("file").get<std::string>()] = report.at("run").at("cooking_s").get<double>();
    } catch (const json::exception& e) {
      throw Failure(Exit::invalid, path, "", "no list of reports", e.what());
    }
  }
}

std::optional<double> KnownTimes::seconds_of(const std::string& input) const {
  const auto found = seconds_.find(input);
  return found == seconds_.end() ? std::nullopt : std::optional(found->second);
}

double fit_seconds(const cook::LearnOptions& options, std::size_t vertices) {
  const bool elastic = options.animation_space == cook::AnimationSpace::fit && options.truth == cook::Truth::elastic;
  const auto count = static_cast<double>(vertices);
  return elastic ? kElastic_s + kElasticSecondsAVertex * count : kFit_s + kFitSecondsAVertex * count;
}

Unit file_unit(std::size_t index, const Order& order, const KnownTimes& history) {
  const Amounts amounts = amounts_of(order.job.in);
  Unit out{index, std::nullopt, amounts.bytes, 0, false};
  if (const std::optional<double> before = history.seconds_of(order.job.in)) {
    out.seconds = *before;
    out.from_history = true;
    return out;
  }
  out.seconds = kStart_s + kSecondsAByte * static_cast<double>(amounts.bytes) + kSecondsAKey * amounts.keys +
                kSecondsAVertex * amounts.vertices;
  if (learns(order.options.learn) && !order.options.clips_only)
    out.seconds += fit_seconds(order.options.learn, static_cast<std::size_t>(amounts.vertices));
  return out;
}

std::vector<Unit> fit_units(const std::vector<Order>& orders) {
  std::vector<std::vector<Unit>> of(orders.size());
  for_each_in_parallel(orders.size(), [&](std::size_t i) {
    DiskFiles files;
    try {
      if (!learns(orders[i].options.learn)) return;
      const std::vector<std::size_t> vertices =
          cook::look(orders[i].job.in, orders[i].given, {files, &all_cores(), {}, nullptr}).fits;
      for (std::size_t mesh = 0; mesh < vertices.size(); ++mesh)
        of[i].push_back(
            {i, mesh, size_of(orders[i].job.in), fit_seconds(orders[i].options.learn, vertices[mesh]), false});
    } catch (const Failure& failure) {
      if (failure.code() == Exit::interrupted) throw;
    }
  });
  std::vector<Unit> out;
  for (const std::vector<Unit>& units : of) out.insert(out.end(), units.begin(), units.end());
  return out;
}

std::vector<unsigned> share_out(const std::vector<Unit>& units, unsigned count) {
  std::vector<std::size_t> longest_first(units.size());
  std::iota(longest_first.begin(), longest_first.end(), std::size_t{0});
  std::ranges::stable_sort(longest_first, std::greater(), [&](std::size_t i) { return units[i].seconds; });
  using Load = std::pair<double, unsigned>;
  std::priority_queue<Load, std::vector<Load>, std::greater<>> loads;
  for (unsigned i = 1; i <= count; ++i) loads.emplace(0, i);
  std::vector<unsigned> out(units.size());
  for (const std::size_t i : longest_first) {
    const auto [load, share] = loads.top();
    loads.pop();
    out[i] = share;
    loads.emplace(load + units[i].seconds, share);
  }
  return out;
}

std::uint64_t memory_of(const Unit& unit, const Order& order) {
  return MemoryGate::need(unit.source_bytes << (2 * order.options.mesh.subdivide));
}

}  // namespace marrow::tools
