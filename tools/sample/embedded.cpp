#include "sample/embedded.h"

namespace marrow::embedded {
extern const unsigned char newt_glb[];
extern const unsigned long long newt_glb_size;
}  // namespace marrow::embedded

namespace marrow::tools {

std::span<const std::byte> sample_glb() {
  return std::as_bytes(std::span(embedded::newt_glb, embedded::newt_glb_size));
}

}  // namespace marrow::tools
