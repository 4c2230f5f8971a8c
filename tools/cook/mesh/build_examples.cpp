#include "cook/mesh/build_examples.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "asset/sections/examples_section.h"
#include "common/failure.h"
#include "deform/fit/example_weights.h"
#include "text/nearest.h"
#include "text/printable.h"

namespace marrow::cook {
namespace {

[[noreturn]] void fail(const ShapeRule& rule, const std::string& where, const std::string& why,
                       const std::string& advice) {
  throw tools::Failure(tools::Exit::usage, rule.origin.file, where, tools::printable(why), tools::printable(advice));
}

// Where a mesh has the target of each example; kNone: nowhere, or it is the mesh as it is.
std::vector<int> targets_of(const ShapeRule& rule, const BuiltMesh& mesh) {
  std::vector<int> out;
  for (const ShapeExample& example : rule.examples) {
    const auto found =
        example.target.empty()
            ? mesh.targets.end()
            : std::ranges::find_if(mesh.targets, [&](const RawTargetWeight& t) { return t.target == example.target; });
    out.push_back(found == mesh.targets.end() ? kNone : static_cast<int>(found - mesh.targets.begin()));
  }
  return out;
}

// The meshes that a rule is for, by where they have its targets.
using Places = std::map<std::vector<int>, std::vector<std::uint32_t>>;

// Every target must be in some mesh.
void check_targets(const ShapeRule& rule, const Places& places, const std::vector<BuiltMesh>& meshes) {
  for (std::size_t k = 0; k < rule.examples.size(); ++k) {
    const ShapeExample& example = rule.examples[k];
    if (example.target.empty() || std::ranges::any_of(places, [&](const auto& p) { return p.first[k] != kNone; }))
      continue;
    std::vector<std::string> names;
    for (const auto& [targets, of] : places)
      for (const std::uint32_t m : of)
        for (const RawTargetWeight& t : meshes[m].targets) names.push_back(t.target);
    fail(rule, example.where, "no morph target \"" + example.target + "\"",
         names.empty() ? "the mesh has none" : tools::suggestion(example.target, names));
  }
}

Places places_of(const ShapeRule& rule, const std::vector<BuiltMesh>& meshes) {
  Places out;
  for (std::uint32_t m = 0; m < meshes.size(); ++m) {
    if (!rule.mesh.empty() && meshes[m].name != rule.mesh) continue;
    std::vector<int> targets = targets_of(rule, meshes[m]);
    const bool has_any = std::ranges::any_of(targets, [](int t) { return t != kNone; });
    if (has_any || !rule.mesh.empty()) out[std::move(targets)].push_back(m);
  }
  if (!out.empty()) check_targets(rule, out, meshes);
  std::erase_if(out, [](const auto& p) { return std::ranges::all_of(p.first, [](int t) { return t == kNone; }); });
  return out;
}

void add_rows(const std::vector<std::vector<double>>& rows, std::vector<float>& to) {
  for (const std::vector<double>& row : rows) {
    for (const double number : row) to.push_back(static_cast<float>(number));
    to.resize(to.size() + format::example_row(static_cast<std::uint32_t>(row.size())) - row.size(), 0.0f);
  }
}

// spanned: along how many parameters the examples differ.
BuiltExampleSpace build(const ShapeRule& rule, const std::vector<int>& target_of_example, std::size_t& spanned) {
  BuiltExampleSpace out;
  out.name = rule.name;
  for (const ShapeParameter& p : rule.parameters) {
    out.parameters.push_back(p.name);
    out.rests.push_back(p.rest);
  }
  std::set<int> targets(target_of_example.begin(), target_of_example.end());
  targets.erase(kNone);
  out.targets.assign(targets.begin(), targets.end());
  std::vector<std::vector<float>> places;
  std::vector<std::vector<double>> values;
  for (std::size_t k = 0; k < rule.examples.size(); ++k) {
    places.push_back(rule.examples[k].at);
    out.places.insert(out.places.end(), places.back().begin(), places.back().end());
    for (const int target : targets)
      (target == *targets.begin() ? values.emplace_back() : values.back())
          .push_back(target == target_of_example[k] ? 1 : 0);
  }
  const std::optional<deform::ExampleFunctions> solved = deform::solve_examples(places, values);
  if (!solved)
    fail(rule, rule.origin.where, "examples whose radial functions depend on one another", "move one of them a little");
  add_rows(solved->linear, out.linear);
  add_rows(solved->radial, out.radial);
  out.inverse_widths = solved->inverse_widths;
  spanned = solved->spanned;
  return out;
}

}  // namespace

std::vector<BuiltExampleSpace> build_example_spaces(const std::vector<ShapeRule>& rules,
                                                    const std::vector<BuiltMesh>& meshes, Notes& notes) {
  std::vector<BuiltExampleSpace> out;
  std::map<std::pair<std::uint32_t, std::uint32_t>, const ShapeRule*> driven;  // by mesh and target
  for (const ShapeRule& rule : rules) {
    const Places places = places_of(rule, meshes);
    if (places.empty()) {
      notes.warnings.push_back({"/meshes", "shape-unused",
                                fmt::format("{}: {}: the shape \"{}\" fits no mesh with morph targets",
                                            rule.origin.file, rule.origin.where, rule.name)});
      continue;
    }
    std::size_t spanned = 0;
    for (const auto& [targets, of] : places) {
      BuiltExampleSpace made = build(rule, targets, spanned);
      made.meshes = of;
      for (const std::uint32_t m : made.meshes)
        for (const std::uint32_t t : made.targets)
          if (const auto [at, is_new] = driven.try_emplace({m, t}, &rule); !is_new)
            fail(rule, rule.origin.where, "the target \"" + meshes[m].targets[t].target + "\" is driven twice",
                 fmt::format("by the shape \"{}\" at {}, too; leave it out of one", at->second->name,
                             at->second->origin.where));
      out.push_back(std::move(made));
    }
    if (spanned < rule.parameters.size())
      notes.warnings.push_back(
          {"/meshes", "shape-flat",
           fmt::format("the examples of the shape \"{}\" span {} of {} parameters; along the others nothing changes",
                       rule.name, spanned, rule.parameters.size())});
  }
  return out;
}

}  // namespace marrow::cook
