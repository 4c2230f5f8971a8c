// Links all solvers, limits and springs to the page's program, which says what they weigh there.
#include <marrow/marrow.h>

#include <emscripten.h>

namespace {
template <class Function>
const void* address(Function* function) {
  return reinterpret_cast<const void*>(function);
}
}  // namespace

extern "C" EMSCRIPTEN_KEEPALIVE const void* solver(int i) {
  const void* const all[] = {
      address(marrow::solve_two_bone), address(marrow::two_bone_x4),  address(marrow::solve_aim),
      address(marrow::solve_look_at),  address(marrow::solve_ik),     address(marrow::solve_ik_genetic),
      address(marrow::place_feet),     address(marrow::make_springs), address(marrow::simulate_springs),
      address(marrow::make_limit),     address(marrow::limit_pose),   address(marrow::follow_pose)};
  return all[i];
}
