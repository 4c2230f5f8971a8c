// `marrow bench`: what each stage of the road costs, a joint or a vertex.
#pragma once

#include <cstdint>
#include <string>

namespace marrow::tools {

struct BenchArguments {
  std::string only = "*";        // rows by a pattern of their names, as fnmatch(3) has it; * also stands for slashes
  std::uint64_t iterations = 0;  // 0: as many as a steady figure needs
  bool json = false;
};

// Throws Failure: usage if no row is selected, io if the models of all selected rows are missing.
void run_bench(const BenchArguments& arguments);

// The names of all rows, alternatives in braces, a line each.
std::string bench_row_names();

}  // namespace marrow::tools
