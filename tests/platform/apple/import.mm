// The C++ headers of the package, as Objective-C++ includes them.
#include <marrow/gles3_skinner.h>
#include <marrow/marrow.h>

marrow::Status in_cpp(marrow::Span<const std::byte> block, marrow::File& file) {
  return load(block, file);
}
