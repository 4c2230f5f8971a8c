// What machines share of one command's work: how long each part may take, and who does it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "jobs/cooker.h"

namespace marrow::tools {

// One of `count` machines, from 1.
struct Shard {
  unsigned number = 1, count = 1;
};
// "3/8". Throws Failure (usage).
Shard read_shard(const std::string& text);

// A file to cook; or, one step before, a mesh of it to learn for, whose result goes into the cache.
struct Unit {
  std::size_t order = 0;           // which
  std::optional<std::size_t> fit;  // the mesh, see cook::look()
  std::uint64_t source_bytes = 0;
  double seconds = 0;  // expected, on one thread
  bool from_history = false;
};

// What files took before: reports of several inputs, or merged ones.
class KnownTimes {
 public:
  KnownTimes() = default;
  // Throws Failure (io, invalid).
  explicit KnownTimes(const std::vector<std::string>& reports);
  std::optional<double> seconds_of(const std::string& input) const;

 private:
  std::map<std::string, double> seconds_;
};

// Of a file: by what it took before, or by the vertices and keys that its document has.
Unit file_unit(std::size_t index, const Order& order, const KnownTimes& history);
// What learning takes for a mesh with so many vertices.
double fit_seconds(const cook::LearnOptions& options, std::size_t vertices);
// A unit for each mesh that learns, file by file. Reads those files' scenes; one that cannot be read has none.
std::vector<Unit> fit_units(const std::vector<Order>& orders);

// The unit's share, from 1: the longest first, each to the share that has the least by then. The same on every machine.
std::vector<unsigned> share_out(const std::vector<Unit>& units, unsigned count);

// Of a unit, as MemoryGate has it.
std::uint64_t memory_of(const Unit& unit, const Order& order);

}  // namespace marrow::tools
