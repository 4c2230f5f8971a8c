// Where the files are that tests read and the program that they run.
#pragma once

#include <string>

namespace marrow::test {

// A file of the checkout: "docs/limits.schema.json".
std::string in_source(const std::string& path);
// A file of tests/golden.
std::string in_golden(const std::string& name);
// The sample character.
std::string newt_glb();
// The folder of real models: MARROW_ASSETS, or the one beside the checkout. It need not exist.
std::string assets_folder();
// The program `marrow`, in builds with the tools.
std::string program();
// A library that makes contexts say that they were reset, in builds with `marrow view`; else empty.
std::string reset_shim();

}  // namespace marrow::test
