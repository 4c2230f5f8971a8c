#include "commands/bench/bench.h"
#include "commands/command.h"
#ifdef MARROW_HAS_GLES
#include "commands/bench/gpu.h"
#endif

namespace marrow::tools {

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
