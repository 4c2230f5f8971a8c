#include "sample/embedded.h"

namespace marrow::embedded {
extern const unsigned char newt_glb[], newt_moves_glb[], newt_anim_toml[];
extern const unsigned long long newt_glb_size, newt_moves_glb_size, newt_anim_toml_size;
}  // namespace marrow::embedded

namespace marrow::tools {

std::span<const std::byte> sample_glb() {
  return std::as_bytes(std::span(embedded::newt_glb, embedded::newt_glb_size));
}

std::span<const std::byte> sample_moves_glb() {
  return std::as_bytes(std::span(embedded::newt_moves_glb, embedded::newt_moves_glb_size));
}

std::span<const std::byte> sample_graph() {
  return std::as_bytes(std::span(embedded::newt_anim_toml, embedded::newt_anim_toml_size));
}

}  // namespace marrow::tools
