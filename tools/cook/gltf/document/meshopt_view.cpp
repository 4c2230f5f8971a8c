#include "cook/gltf/document/meshopt_view.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include <meshoptimizer.h>

#include "cook/gltf/meshopt/meshopt_filters.h"
#include "cook/gltf/meshopt/meshopt_vertices.h"

namespace marrow::cook::gltf {
namespace {

constexpr std::array<std::pair<std::string_view, MeshoptView::Mode>, 3> kModes = {
    {{"ATTRIBUTES", MeshoptView::Mode::attributes},
     {"TRIANGLES", MeshoptView::Mode::triangles},
     {"INDICES", MeshoptView::Mode::indices}}};
constexpr std::array<std::pair<std::string_view, MeshoptView::Filter>, 5> kFilters = {
    {{"NONE", MeshoptView::Filter::none},
     {"OCTAHEDRAL", MeshoptView::Filter::octahedral},
     {"QUATERNION", MeshoptView::Filter::quaternion},
     {"EXPONENTIAL", MeshoptView::Filter::exponential},
     {"COLOR", MeshoptView::Filter::color}}};

// The schema has seen to it that the word is one of them.
template <class Words>
auto meaning(const Words& words, const std::string& word) {
  return std::ranges::find(words, word, &Words::value_type::first)->second;
}

bool fits(MeshoptView::Filter filter, std::uint32_t stride) {
  switch (filter) {
    case MeshoptView::Filter::octahedral:
    case MeshoptView::Filter::color:
      return stride == 4 || stride == 8;
    case MeshoptView::Filter::quaternion:
      return stride == 8;
    default:
      return true;
  }
}

void apply_filter(const MeshoptView& view, std::span<std::byte> elements) {
  switch (view.filter) {
    case MeshoptView::Filter::none:
      break;
    case MeshoptView::Filter::octahedral:
      unfold_octahedra(elements, view.stride);
      break;
    case MeshoptView::Filter::quaternion:
      restore_quaternions(elements);
      break;
    case MeshoptView::Filter::exponential:
      restore_exponents(elements);
      break;
    case MeshoptView::Filter::color:
      restore_colours(elements, view.stride);
      break;
  }
}

// Data cost at least so many bytes: a byte a triangle or an index.
std::uint64_t least_length(const MeshoptView& view, std::span<const std::byte> coded) {
  switch (view.mode) {
    case MeshoptView::Mode::attributes:
      return least_vertex_bytes(coded, view.count, view.stride);
    case MeshoptView::Mode::triangles:
      return view.count / 3;
    case MeshoptView::Mode::indices:
      break;
  }
  return view.count;
}

bool decode(const MeshoptView& view, std::span<const std::byte> coded, std::span<std::byte> to) {
  const auto* from = reinterpret_cast<const unsigned char*>(coded.data());
  switch (view.mode) {
    case MeshoptView::Mode::attributes:
      return decode_vertices(coded, view.stride, to);
    case MeshoptView::Mode::triangles:
      return meshopt_decodeIndexBuffer(to.data(), view.count, view.stride, from, coded.size()) == 0;
    case MeshoptView::Mode::indices:
      break;
  }
  return meshopt_decodeIndexSequence(to.data(), view.count, view.stride, from, coded.size()) == 0;
}

}  // namespace

const Json* find_meshopt(const Json& owner, std::string& where) {
  const auto extensions = owner.find("extensions");
  if (extensions == owner.end()) return nullptr;
  for (const char* name : {"EXT_meshopt_compression", "KHR_meshopt_compression"}) {
    const auto found = extensions->find(name);
    if (found == extensions->end()) continue;
    where = under(where, "extensions", name);
    return &*found;
  }
  return nullptr;
}

MeshoptView read_meshopt_view(const Json& extension, std::uint64_t length, std::uint32_t stride,
                              const std::string& where, const Report& report) {
  MeshoptView view;
  view.buffer = extension.at("buffer").get<std::size_t>();
  view.offset = extension.value("byteOffset", std::uint64_t{0});
  view.coded_length = extension.at("byteLength").get<std::uint64_t>();
  view.count = extension.at("count").get<std::uint64_t>();
  view.stride = extension.at("byteStride").get<std::uint32_t>();
  view.mode = meaning(kModes, extension.at("mode").get<std::string>());
  view.filter = meaning(kFilters, extension.value("filter", std::string("NONE")));
  const auto refuse = [&](const char* member, const char* why) {
    report.invalid(under(where, member), "not as the extension demands", std::string(why) + "; export again");
  };
  const bool are_attributes = view.mode == MeshoptView::Mode::attributes;
  if (are_attributes ? view.stride % 4 != 0 : view.stride != 2 && view.stride != 4)
    refuse("byteStride", are_attributes ? "a multiple of 4 is needed" : "indices take 2 or 4 bytes");
  if (view.mode == MeshoptView::Mode::triangles && view.count % 3 != 0) refuse("count", "a triangle has three corners");
  if (!are_attributes && view.filter != MeshoptView::Filter::none) refuse("filter", "indices are not filtered");
  if (!fits(view.filter, view.stride)) refuse("filter", "it is for elements of another size");
  if (view.count * view.stride != length) refuse("count", "count times byteStride must be the view's byteLength");
  if (stride != 0 && stride != view.stride) refuse("byteStride", "it must be the view's own");
  return view;
}

std::vector<std::byte> decode_meshopt(const MeshoptView& view, std::span<const std::byte> coded,
                                      const std::string& where, const Report& report) {
  if (coded.size() < least_length(view, coded))
    report.invalid(where, "damaged meshopt data", "too few bytes for so many elements; export again");
  std::vector<std::byte> elements(view.count * view.stride);
  if (!decode(view, coded, elements))
    report.invalid(where, "damaged meshopt data", "it cannot be decoded; export again");
  apply_filter(view, elements);
  return elements;
}

}  // namespace marrow::cook::gltf
