#include "cook/paint/paint_file.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "cook/gltf/document/json.h"
#include "deform/weights/auto_weights.h"
#include "marrow/limits.h"

namespace marrow::cook {
namespace {

using gltf::Json;
using gltf::pointer;
using gltf::under;

constexpr int kVersion = 1;
constexpr double kFarthestCoordinate = 1e29;
constexpr double kMostOff = 1e-3;   // of a sum of weights from 1
constexpr double kRounding = 1e-6;  // of the sum of eight floats

const Json& member(const Json& object, const std::string& where, const char* name, bool (Json::*is)() const noexcept,
                   const char* kind, const gltf::Report& report) {
  if (!object.is_object()) report.invalid(where, "no object", "paint it anew with `marrow view --paint`");
  const auto found = object.find(name);
  if (found == object.end()) report.invalid(where, std::string("no \"") + name + '"', std::string("it needs ") + kind);
  if (!((*found).*is)()) report.invalid(under(where, name), std::string("not ") + kind, "mend it");
  return *found;
}

double number(const Json& value, const std::string& where, const gltf::Report& report) {
  if (!value.is_number()) report.invalid(where, "not a number", "a row is x, y, z, joint, weight, joint, weight, ...");
  const double out = value.get<double>();
  if (!(std::abs(out) <= kFarthestCoordinate)) report.invalid(where, "out of range", "mend the number");
  return out;
}

std::vector<deform::Influence> read_influences(const Json& row, const std::string& where, std::size_t joints,
                                               const gltf::Report& report) {
  std::vector<deform::Influence> out;
  double sum = 0;
  for (std::size_t i = 3; i < row.size(); i += 2) {
    if (!row[i].is_number_unsigned() || row[i].get<std::uint64_t>() >= joints)
      report.invalid(under(where, i), "no such joint", fmt::format("the mesh's list has {}", joints));
    const auto joint = static_cast<std::uint32_t>(row[i].get<std::uint64_t>());
    if (std::ranges::any_of(out, [&](const deform::Influence& o) { return o.joint == joint; }))
      report.invalid(under(where, i), "joint named twice", "a vertex has one weight of a joint");
    const double weight = number(row[i + 1], under(where, i + 1), report);
    if (weight < 0 || weight > 1 + kMostOff)
      report.invalid(under(where, i + 1), "not a weight", "weights are from 0 to 1");
    out.push_back({joint, weight});
    sum += weight;
  }
  if (!(std::abs(sum - 1) <= kMostOff))
    report.invalid(where, fmt::format("weights sum to {:.4g}", sum), "a vertex's weights sum to 1");
  std::erase_if(out, [](const deform::Influence& i) { return i.weight == 0; });
  // What was written so is left so, to the bit.
  if (out.size() > kMaxInfluences || std::abs(sum - 1) > kRounding) deform::keep_largest(out, kMaxInfluences, 0);
  std::ranges::sort(out, {}, &deform::Influence::joint);
  return out;
}

PaintedVertex read_vertex(const Json& row, const std::string& where, std::size_t joints, const gltf::Report& report) {
  if (!row.is_array() || row.size() < 5 || row.size() % 2 == 0)
    report.invalid(where, "not a vertex", "a row is x, y, z, joint, weight, joint, weight, ...");
  PaintedVertex out;
  for (int c = 0; c < 3; ++c)
    out.place[c] = static_cast<float>(number(row[static_cast<std::size_t>(c)], under(where, c), report));
  out.influences = read_influences(row, where, joints, report);
  return out;
}

PaintedMesh read_mesh(const Json& mesh, const std::string& where, const gltf::Report& report) {
  PaintedMesh out;
  out.name = member(mesh, where, "name", &Json::is_string, "a text", report).get<std::string>();
  std::set<std::string> names;
  const Json& joints = member(mesh, where, "joints", &Json::is_array, "a list", report);
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const std::string at = under(where, "joints", j);
    if (!joints[j].is_string()) report.invalid(at, "not a text", "joints are names");
    out.joints.push_back(joints[j].get<std::string>());
    if (!names.insert(out.joints.back()).second) report.invalid(at, "joint named twice", "name each once");
  }
  const Json& vertices = member(mesh, where, "vertices", &Json::is_array, "a list", report);
  out.vertices.reserve(vertices.size());
  for (std::size_t v = 0; v < vertices.size(); ++v)
    out.vertices.push_back(read_vertex(vertices[v], under(where, "vertices", v), out.joints.size(), report));
  return out;
}

std::string quoted(const std::string& text) {
  return Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

std::vector<PaintedMesh> read_painted(const std::string& path, std::string_view text) {
  gltf::Report report(path);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos || text[first] != '{')
    report.invalid("", "no painted weights", "paint them with `marrow view --paint`, or give JOINT=MASK.png");
  gltf::Container container;
  container.json = text;
  const Json root = gltf::parse_json(container, report);
  const Json& version = member(root, "", "paintedWeights", &Json::is_number_integer, "its version, 1", report);
  if (version != kVersion)
    report.unsupported("/paintedWeights", "version " + version.dump(), "this program reads version 1");
  const Json& meshes = member(root, "", "meshes", &Json::is_array, "a list", report);
  std::vector<PaintedMesh> out;
  for (std::size_t m = 0; m < meshes.size(); ++m) out.push_back(read_mesh(meshes[m], pointer("meshes", m), report));
  return out;
}

std::string text_of_painted(std::span<const PaintedMesh> meshes) {
  std::string out = fmt::format("{{\"paintedWeights\": {}, \"meshes\": [", kVersion);
  const char* between_meshes = "\n";
  for (const PaintedMesh& mesh : meshes) {
    out += between_meshes;
    between_meshes = ",\n";
    out += fmt::format("{{\"name\": {}, \"joints\": [", quoted(mesh.name));
    for (std::size_t j = 0; j < mesh.joints.size(); ++j) out += (j > 0 ? ", " : "") + quoted(mesh.joints[j]);
    out += "], \"vertices\": [";
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
      const glm::vec3& p = mesh.vertices[v].place;
      out += fmt::format("{}\n[{}, {}, {}", v > 0 ? "," : "", p.x, p.y, p.z);
      for (const deform::Influence& i : mesh.vertices[v].influences)
        out += fmt::format(", {}, {}", i.joint, static_cast<float>(i.weight));
      out += ']';
    }
    out += "]}";
  }
  return out + "]}\n";
}

}  // namespace marrow::cook
