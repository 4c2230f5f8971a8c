#include "jobs/plan.h"

#include <algorithm>

#include "common/parallel.h"
#include "disk/disk_files.h"
#include "disk/thread_pool.h"
#include "jobs/program_hash.h"
#include "jobs/units.h"

namespace marrow::tools {
namespace {

using nlohmann::ordered_json;

ordered_json unit_of(std::size_t index, const Order& order, const KnownTimes& history) {
  const Unit unit = file_unit(index, order, history);
  ordered_json out = {{"in", order.job.in}, {"out", order.job.out}};
  DiskFiles files;
  try {
    const cook::Looked looked = cook::look(order.job.in, order.given, {files, &all_cores(), {}, nullptr});
    for (const cook::Read& read : looked.reads)
      out["inputs"].push_back({{"file", read.name}, {"bytes", read.bytes}, {"hash", read.hash}});
    out["options"] = cook::write_options(order.given);
    out["fits"] = ordered_json::array();
    for (const std::size_t vertices : looked.fits)
      out["fits"].push_back({{"vertices", vertices}, {"seconds", fit_seconds(order.options.learn, vertices)}});
  } catch (const Failure& failure) {
    if (failure.code() == Exit::interrupted) throw;
    out["failure"] = failure.what();
  }
  out["seconds"] = unit.seconds;
  out["seconds_from"] = unit.from_history ? "history" : "size";
  out["memory_bytes"] = memory_of(unit, order);
  return out;
}

}  // namespace

ordered_json plan_of(const std::vector<Order>& orders, const std::vector<std::string>& reports) {
  const KnownTimes history(reports);
  std::vector<ordered_json> units(orders.size());
  for_each_in_parallel(orders.size(), [&](std::size_t i) { units[i] = unit_of(i, orders[i], history); });
  std::ranges::stable_sort(units, std::greater(), [](const ordered_json& u) { return u.at("seconds").get<double>(); });
  double sum = 0;
  std::uint64_t memory = 0;
  for (const ordered_json& unit : units) {
    sum += unit.at("seconds").get<double>();
    memory = std::max(memory, unit.at("memory_bytes").get<std::uint64_t>());
  }
  return {{"program", program_hash()},
          {"seconds", sum},
          {"longest_s", units.empty() ? 0.0 : units.front().at("seconds").get<double>()},
          {"memory_bytes", memory},
          {"units", units}};
}

}  // namespace marrow::tools
