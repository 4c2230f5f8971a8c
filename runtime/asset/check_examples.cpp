// What is asked of SHAP sections, and the view of one that keeps it.
#include "asset/checker.h"
#include "asset/sections/examples_section.h"
#include "core/check.h"
#include "core/zone.h"

namespace marrow {

namespace {

// Whether numbers ascend and stay below a limit.
bool ascend(Span<const std::uint32_t> numbers, std::uint32_t limit) {
  for (std::size_t i = 0; i < numbers.size; ++i)
    if (numbers[i] >= limit || (i > 0 && numbers[i] <= numbers[i - 1])) return false;
  return true;
}

ExampleSpace view(const format::ExampleHeader& h, const format::ExampleLayout& l) {
  ExampleSpace s;
  s.example_count = h.example_count;
  s.parameters = l.parameters.in(&h);
  s.targets = l.targets.in(&h);
  s.meshes = l.meshes.in(&h);
  s.linear = l.linear.in(&h);
  s.radial = l.radial.in(&h);
  s.places = l.places.in(&h);
  s.inverse_widths = l.widths.in(&h);
  return s;
}

bool check_rows(Checker& c, Span<const float> rows, std::uint32_t target_count) {
  const std::uint32_t row = format::example_row(target_count);
  for (std::size_t i = 0; i < rows.size; ++i)
    if (i % row >= target_count && rows[i] != 0) return c.fail(&rows[i], "padding must be 0");
  return true;
}

bool check_space(Checker& c, const ExampleSpace& s) {
  const auto target_count = static_cast<std::uint32_t>(s.targets.size);
  if (!check_rows(c, s.linear, target_count) || !check_rows(c, s.radial, target_count)) return false;
  for (const float& width : s.inverse_widths)
    if (!(width > 0)) return c.fail(&width, "a width that is not above 0");
  if (!ascend(s.meshes, c.count_of(format::kMeshes))) return c.fail(s.meshes.data, "meshes of the file, ascending");
  for (const std::uint32_t mesh : s.meshes)
    if (!ascend(s.targets, c.nth<format::MeshHeader>(format::kMeshes, mesh).target_count))
      return c.fail(s.targets.data, "targets of each mesh, ascending");
  return true;
}

}  // namespace

Status File::example_space(std::uint32_t index, ExampleSpace& out, DataError* error) const {
  MARROW_ZONE;
  if (error != nullptr) *error = {Status::bad_argument, 0, "an index below example_space_count()"};
  MARROW_REQUIRE(index < example_space_count());
  const Span<const std::byte> block(block_, reinterpret_cast<const format::Header*>(block_)->file_bytes);
  Checker checker(block, sections_, first_, counts_);
  const auto& h = *reinterpret_cast<const format::ExampleHeader*>(section(format::kExamples, index));
  format::ExampleLayout l;
  ExampleSpace made;
  if (checker.begin(sections_[first_[format::kExamples] + index], sizeof h, format::kCodecRaw) &&
      check_fields(checker, h, l)) {
    made = view(h, l);
    made.name = text(h.name);
    check_space(checker, made);
  }
  if (error != nullptr) *error = checker.error();
  if (!checker.good()) return checker.error().status;
  out = made;
  return Status::ok;
}

}  // namespace marrow
