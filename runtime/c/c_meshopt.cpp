// Made by tools/c_api from the descriptions in runtime/c: one line of C++ a function. Do not edit.
#include "c/twin.h"

#include "marrow/meshopt.h"

// clang-format off
using namespace marrow;
using namespace marrow::c;

extern "C" {

mrw_status mrw_meshopt_decoder(mrw_mesh_decoder* out) {
  MRW_NEEDS(leads_to<MeshDecoder>(out), MRW_BAD_ARGUMENT);
  give<MeshDecoder>(out, marrow::meshopt_decoder());
  return MRW_OK;
}

}  // extern "C"
