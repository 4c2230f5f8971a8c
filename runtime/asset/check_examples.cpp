// Rules of SHAP sections, and the view of one that keeps them.
#include "asset/checker.h"
#include "asset/example_format.h"
#include "core/check.h"
#include "core/mark.h"
#include "math/finite.h"

namespace marrow {

using format::layout;

namespace {

// Whether numbers ascend and stay below a limit.
bool ascend(Span<const std::uint32_t> numbers, std::uint32_t limit) {
  for (std::size_t i = 0; i < numbers.size; ++i)
    if (numbers[i] >= limit || (i > 0 && numbers[i] <= numbers[i - 1])) return false;
  return true;
}

ExampleSpace view(const std::byte* base) {
  const auto& h = *reinterpret_cast<const format::ExampleHeader*>(base);
  const format::ExampleLayout l = layout(h);
  const auto floats = [&](std::uint64_t from, std::uint64_t to) {
    return Span<const float>(reinterpret_cast<const float*>(base + from), static_cast<std::size_t>(to - from) / 4);
  };
  const auto words = [&](std::uint64_t from, std::uint64_t to) {
    return Span<const std::uint32_t>(reinterpret_cast<const std::uint32_t*>(base + from),
                                     static_cast<std::size_t>(to - from) / 4);
  };
  ExampleSpace s;
  s.example_count = h.example_count;
  s.parameters = {reinterpret_cast<const ExampleParameter*>(base + l.parameters), h.parameter_count};
  s.targets = words(l.targets, l.meshes);
  s.meshes = words(l.meshes, l.bytes);
  s.linear = floats(l.linear, l.radial);
  s.radial = floats(l.radial, l.places);
  s.places = floats(l.places, l.widths);
  s.inverse_widths = floats(l.widths, l.parameters);
  return s;
}

}  // namespace

bool Checker::example_space(std::uint32_t index) {
  const File::Section& section = nth(format::kExamples, index);
  if (!has_header(section, sizeof(format::ExampleHeader), format::kCodecRaw)) return false;
  const auto* h = at<format::ExampleHeader>(start_of(section), 0);
  const format::ExampleLayout l = layout(*h);
  if (section.bytes != l.bytes) return fail(h, "section size differs from its counts");
  if (!name(h->name)) return false;
  if (h->reserved != 0) return fail(&h->reserved, "reserved must be 0");
  if (h->parameter_count == 0 || h->parameter_count > kMaxExampleParameters)
    return fail(&h->parameter_count, "1 to 8 parameters");
  if (h->example_count == 0 || h->example_count > kMaxExamples) return fail(&h->example_count, "1 to 64 examples");
  if (h->target_count == 0 || h->target_count > kMaxExamples) return fail(&h->target_count, "1 to 64 targets");
  if (h->mesh_count == 0) return fail(&h->mesh_count, "a space of no mesh");
  if (const void* const beyond = first_beyond(kFiniteBits, at<float>(h, l.linear), l.parameters - l.linear))
    return fail(beyond, kNotFinite);
  const ExampleSpace s = view(block_.data + section.offset);
  const std::uint32_t row = format::example_row(h->target_count);
  for (std::uint64_t i = 0; i < (l.places - l.linear) / 4; ++i)
    if (i % row >= h->target_count && s.linear.data[i] != 0) return fail(s.linear.data + i, "padding must be 0");
  for (const float& width : s.inverse_widths)
    if (!(width > 0)) return fail(&width, "a width that is not above 0");
  for (const ExampleParameter& p : s.parameters)
    if (!name(p.name) || (!is_finite(p.rest) && !fail(&p.rest, kNotFinite))) return false;
  if (!ascend(s.meshes, counts_[format::kMeshes])) return fail(s.meshes.data, "meshes of the file, ascending");
  for (const std::uint32_t& mesh : s.meshes) {
    const std::uint32_t targets = at<format::MeshHeader>(start_of(nth(format::kMeshes, mesh)), 0)->target_count;
    if (!ascend(s.targets, targets)) return fail(s.targets.data, "targets of each mesh, ascending");
  }
  return true;
}

Status File::example_space(std::uint32_t index, ExampleSpace& out, DataError* error) const {
  MARROW_MARK;
  if (error != nullptr) *error = {Status::bad_argument, 0, "an index below example_space_count()"};
  MARROW_REQUIRE(index < example_space_count());
  const Span<const std::byte> block(block_, reinterpret_cast<const format::Header*>(block_)->file_bytes);
  Checker checker(block, sections_, first_, counts_);
  const bool good = checker.example_space(index);
  if (error != nullptr) *error = checker.error();
  if (!good) return checker.error().status;
  const std::byte* const base = section(format::kExamples, index);
  ExampleSpace made = view(base);
  made.name = text(reinterpret_cast<const format::ExampleHeader*>(base)->name);
  out = made;
  return Status::ok;
}

}  // namespace marrow
