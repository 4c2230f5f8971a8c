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
// The folder of bad inputs: MARROW_CORPUS, or the one beside the checkout. It need not exist.
std::string corpus_folder();
// The folder of real models: MARROW_ASSETS, or the one beside the checkout. It need not exist.
std::string assets_folder();
// Whether tests run in their long form, every model on every path: MARROW_TESTS=all. The short form has the same
// assertions on less.
bool in_long_form();
// Whether a model of the folder takes part: in the short form those of less than 800 kB, which have every feature among
// them.
bool takes_part(const std::string& model);
// The program `marrow`, in builds with the tools.
std::string program();
// A library that makes contexts say that they were reset, in builds with `marrow view`; else empty.
std::string reset_shim();
// A library that is a hand at a window, likewise.
std::string hand_shim();
// A library that changes the last bits of what the C library's functions give, in builds without sanitizers.
std::string last_bit_shim();
// A library that makes the program's calls fail, in builds without sanitizers.
std::string fault_shim();

}  // namespace marrow::test
