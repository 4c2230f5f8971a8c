// `marrow bench`: what each stage of the road costs, a joint or a vertex. It selects rows, times them, prints them.
// Google Benchmark would not do: a row is to run exactly the iterations asked for with nothing around them that grows,
// and to say by a hash what it computed.
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <iterator>
#include <string>

#include <fnmatch.h>
#include <nlohmann/json.hpp>

#include "bench/workload.h"
#include "commands/command.h"
#include "common/failure.h"

#ifdef MARROW_HAS_GLES
#include "commands/bench/gpu.h"
#endif

namespace marrow::tools {
namespace {

struct BenchArguments {
  std::string only = "*";        // rows by a pattern of their names, as fnmatch(3) has it; * also stands for slashes
  std::uint64_t iterations = 0;  // 0: as many as a steady figure needs
  bool json = false;
};

constexpr double kBatch_s = 8e-3;  // what a clock measures well
constexpr std::size_t kBatches = 15;

struct Result {
  std::string name;
  std::uint32_t items;
  double ns_per_item;
  std::uint64_t hash;
};

RowGroup all_rows(const Models& models) {
  RowGroup all;
  for (const RowGroup& group :
       {sampling_rows(), pose_rows(models), reaching_rows(), chain_rows(), body_rows(), limit_rows(), following_rows(),
        moving_rows(), behaving_rows(), skinning_rows(), morphing_rows(), weighing_rows(), unpacking_rows()}) {
    all.names += group.names;
    all.rows.insert(all.rows.end(), group.rows.begin(), group.rows.end());
  }
  return all;
}

std::vector<Row> select_rows(const std::string& pattern, const Models& models) {
  const RowGroup all = all_rows(models);
  std::vector<Row> selected;
  std::copy_if(all.rows.begin(), all.rows.end(), std::back_inserter(selected),
               [&](const Row& row) { return fnmatch(pattern.c_str(), row.name.c_str(), 0) == 0; });
  if (selected.empty())
    throw Failure(Exit::usage, "--only", "", "no row is called \"" + pattern + "\"", "there are\n" + all.names);
  return selected;
}

// Leaves out rows whose models are missing, and says so.
void drop_missing(const Models& models, std::vector<Row>& rows) {
  const auto note = [&](const char* file, std::size_t count, const char* effect) {
    if (count > 0) fmt::print(stderr, "marrow: note: no {} in {}: {}: {}\n", file, models.folder(), effect, count);
  };
  for (const ModelSource* model : {&kPab, &kCesiumMan, &kRuby, &kMannequiny}) {
    if (models.has(*model)) continue;
    note(model->file, std::erase_if(rows, [&](const Row& row) { return row.model == model; }), "rows left out");
  }
  const auto stand_ins = std::count_if(rows.begin(), rows.end(), [](const Row& row) { return row.stand_in; });
  note(kPab.file, static_cast<std::size_t>(stand_ins), "rows on the sample instead");
  if (rows.empty())
    throw Failure(Exit::io, models.folder(), "", "no model of the selected rows is there",
                  "let MARROW_ASSETS name the folder that has them");
}

double seconds(Workload& workload, std::uint64_t iterations) {
  const auto start = std::chrono::steady_clock::now();
  workload.run(iterations);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Of one iteration: the median of batches that are long enough to be measured.
double steady_seconds(Workload& workload) {
  std::uint64_t batch = 1;
  while (seconds(workload, batch) < kBatch_s / 2) batch *= 2;
  std::vector<double> times;
  for (std::size_t i = 0; i < kBatches; ++i) times.push_back(seconds(workload, batch));
  std::nth_element(times.begin(), times.begin() + kBatches / 2, times.end());
  return times[kBatches / 2] / static_cast<double>(batch);
}

Result measure(const Row& row, std::uint64_t iterations, Models& models) {
  const std::unique_ptr<Workload> workload = row.make(models);
  Result result = {row.name, workload->items(), 0, 0};
  for (std::uint32_t i = 0; i < workload->period(); ++i) {
    workload->run(1);
    result.hash = workload->hash_output(result.hash);
  }
  const double each_s =
      iterations > 0 ? seconds(*workload, iterations) / static_cast<double>(iterations) : steady_seconds(*workload);
  result.ns_per_item = 1e9 * each_s / result.items;
  return result;
}

// Throws Failure: usage if no row is selected, io if the models of all selected rows are missing.
void run_bench(const BenchArguments& arguments) {
  Models models;
  std::vector<Row> rows = select_rows(arguments.only, models);
  drop_missing(models, rows);
  for (const Row& row : rows)
    for (const std::string& clip : row.clips) models.want(*row.model, clip);
  nlohmann::ordered_json results = nlohmann::ordered_json::array();
  if (!arguments.json) fmt::print("{:<34}{:>8}{:>12}  {}\n", "name", "items", "ns/item", "hash");
  for (const Row& row : rows) {
    const Result r = measure(row, arguments.iterations, models);
    const std::string hash = fmt::format("{:016x}", r.hash);
    if (arguments.json) {
      results.push_back({{"name", r.name}, {"items", r.items}, {"ns_per_item", r.ns_per_item}, {"hash", hash}});
    } else {
      fmt::print("{:<34}{:>8}{:>12.3f}  {}\n", r.name, r.items, r.ns_per_item, hash);
      std::fflush(stdout);  // rows take a while
    }
  }
  if (arguments.json) fmt::print("{}\n", results.dump(2));
}

// The names of all rows, alternatives in braces, a line each.
std::string bench_row_names() {
  return all_rows(Models()).names;
}

}  // namespace

void add_bench(CLI::App& app, int&) {
  static BenchArguments a;  // as long as the options that point at it
  CLI::App* const command = app.add_subcommand("bench", "Measure every stage, a joint or a vertex");
  command->add_option("--only", a.only, "rows by name; * and ? stand for any characters, slashes too")
      ->type_name("GLOB")
      ->capture_default_str();
  command
      ->add_option("--iterations", a.iterations, "run each row exactly so often; without it, as often as steadies it")
      ->type_name("N")
      ->check(CLI::Range(1u, 1000000000u));
  command->add_flag("--json", a.json,
                    "as JSON: [{name, items, ns_per_item, hash}]; with --gpu {driver, rows: [{name, frames_per_s, "
                    "ns_per_vertex, gpu_ns_per_vertex}]}");
#ifdef MARROW_HAS_GLES
  static GpuBenchArguments on_gpu;  // as long as the options that point at it
  CLI::Option* const gpu =
      command->add_flag("--gpu", on_gpu.wanted, "frames drawn by OpenGL ES, by every skinning path");
  command->add_option("-o,--output", on_gpu.chart, "with --gpu also a chart")->type_name("OUT.svg")->needs(gpu);
  gpu->excludes(command->get_option("--iterations"));
#endif
  command->footer([] {
    std::string names = bench_row_names();
#ifdef MARROW_HAS_GLES
    names += "with --gpu\n" + gpu_row_names();
#endif
    return "Models are looked for in the folder that the environment variable MARROW_ASSETS names. Rows:\n" + names;
  });
  command->callback([] {
#ifdef MARROW_HAS_GLES
    on_gpu.only = a.only;
    on_gpu.json = a.json;
    if (on_gpu.wanted) return run_gpu_bench(on_gpu);
#endif
    run_bench(a);
  });
}

}  // namespace marrow::tools
