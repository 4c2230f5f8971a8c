// `marrow bench --gpu`: what drawing characters costs on this machine's OpenGL ES, by every path.
#pragma once

#include <string>
#include <vector>

#include "gpu_bench/gpu_rows.h"

namespace marrow::tools {

struct GpuBenchArguments {
  bool wanted = false;
  std::string only = "*";
  std::string chart;  // OUT.svg; empty: none
  bool json = false;
};

// Throws Failure: unsupported without OpenGL ES; usage if no row is selected.
void run_gpu_bench(const GpuBenchArguments& arguments);

// The names of all rows, alternatives in braces.
std::string gpu_row_names();

// Bars of ns a vertex: a group a case, a pair of SSD and animation space a path.
std::string gpu_chart(const std::vector<GpuRow>& rows, const std::string& driver);

}  // namespace marrow::tools
