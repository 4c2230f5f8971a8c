// Reads and cleans positions, normals, tangents, colours, texture coordinates, joints and weights.
#include "cook/gltf/import/import_vertices.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

namespace marrow::cook::gltf {
namespace {

constexpr float kFarthest_m = 1e9F;          // beyond every scene; squares of it still fit a float
constexpr float kDirectionSlack = 0.02F;     // an 8-bit normal is off by up to one part in 64
constexpr float kSmallestDirection = 1e-6F;  // shorter vectors have no direction worth keeping
constexpr float kClampSlack = 1e-3F;

// While decoding: Draco's corner table and attribute maps.
constexpr std::uint64_t kDracoBytesPerPoint = 64;
constexpr std::uint64_t kDracoBytesPerFace = 32;
constexpr std::uint64_t kFacesPerPoint = 8;  // where the document is silent; a closed surface has two

const tinygltf::Value* find_draco(const tinygltf::Primitive& primitive) {
  const auto found = primitive.extensions.find("KHR_draco_mesh_compression");
  return found == primitive.extensions.end() ? nullptr : &found->second;
}

bool is_finite(const float* values, std::size_t count) {
  return std::all_of(values, values + count, [](float value) { return std::isfinite(value); });
}

// One a vertex, weighted by area; made only when the file's are damaged.
std::vector<glm::vec3> computed_normals(const RawPrimitive& raw) {
  std::vector<glm::dvec3> sums(raw.positions.size());
  for (std::size_t i = 0; i + 2 < raw.indices.size(); i += 3) {
    const glm::dvec3 a(raw.positions[raw.indices[i]]);
    const glm::dvec3 b(raw.positions[raw.indices[i + 1]]);
    const glm::dvec3 c(raw.positions[raw.indices[i + 2]]);
    const glm::dvec3 area = glm::cross(b - a, c - a);
    for (std::size_t corner = 0; corner < 3; ++corner) sums[raw.indices[i + corner]] += area;
  }
  std::vector<glm::vec3> normals;
  normals.reserve(sums.size());
  for (const glm::dvec3& sum : sums) {
    const double length = glm::length(sum);
    normals.emplace_back(length > 0 ? glm::vec3(sum / length) : glm::vec3(0, 1, 0));
  }
  return normals;
}

glm::vec3 any_perpendicular(const glm::vec3& normal) {
  const glm::vec3 other = std::abs(normal.x) < 0.5F ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
  return glm::normalize(glm::cross(normal, other));
}

}  // namespace

VertexSource::VertexSource(const Document& document, const tinygltf::Primitive& primitive, std::string where,
                           Budget& budget, Report& report)
    : document_(document), primitive_(primitive), where_(std::move(where)), budget_(budget), report_(report) {
  count_ = document_.accessor(primitive.attributes.begin()->second).count;
  if (find_draco(primitive) != nullptr) open_draco();
}

void VertexSource::open_draco() {
  const std::string where = under(where_, "extensions", "KHR_draco_mesh_compression");
  if (primitive_.mode != TINYGLTF_MODE_TRIANGLES && primitive_.mode != TINYGLTF_MODE_TRIANGLE_STRIP) {
    report_.invalid(under(where_, "mode"), "not triangles", "Draco data holds triangles only; export again");
  }
  const View& view = document_.view(find_draco(primitive_)->Get("bufferView").GetNumberAsInt());
  if (!view.present) report_.invalid(under(where, "bufferView"), "no data", "the buffer has no bytes; export again");
  const bool promised = primitive_.indices >= 0 && primitive_.mode == TINYGLTF_MODE_TRIANGLES;
  const std::uint64_t most_faces =
      promised ? document_.accessor(primitive_.indices).count / 3 : count_ * kFacesPerPoint;
  budget_.take(count_ * kDracoBytesPerPoint + most_faces * kDracoBytesPerFace, where, report_);
  draco_ = std::make_unique<DracoGeometry>(view.bytes, DracoGeometry::Promise{count_, most_faces}, where, report_);
}

const Accessor& VertexSource::accessor_of(const std::string& attribute) const {
  return document_.accessor(primitive_.attributes.at(attribute));
}

std::size_t VertexSource::components(const std::string& attribute) const {
  return accessor_of(attribute).components();
}

bool VertexSource::has_data(const std::string& attribute) const {
  return draco_ != nullptr || accessor_of(attribute).has_data();
}

std::vector<float> VertexSource::read(const std::string& attribute) {
  const Accessor& accessor = accessor_of(attribute);
  budget_.take(accessor.count * accessor.components() * sizeof(float), pointer_of(attribute), report_);
  if (draco_) {
    const tinygltf::Value& ids = find_draco(primitive_)->Get("attributes");
    if (ids.Has(attribute)) {
      const auto id = static_cast<std::uint32_t>(ids.Get(attribute).GetNumberAsInt());
      return draco_->attribute(id, accessor, pointer_of(attribute));
    }
  }
  return read_floats(accessor);
}

std::vector<std::uint32_t> VertexSource::read_vertex_indices() {
  const std::string where = under(where_, "indices");
  std::vector<std::uint32_t> indices;
  if (draco_) {
    indices = draco_->indices();
    if (primitive_.indices >= 0 && primitive_.mode == TINYGLTF_MODE_TRIANGLES) {
      const Accessor& promised = document_.accessor(primitive_.indices);
      if (promised.count != indices.size()) {
        report_.invalid(where, "differs from the Draco data in count",
                        std::to_string(indices.size()) + " indices are decoded");
      }
    }
  } else if (primitive_.indices >= 0) {
    const Accessor& accessor = document_.accessor(primitive_.indices);
    budget_.take(accessor.count * 2 * sizeof(std::uint32_t), where, report_);
    indices = read_indices(accessor);
    const std::uint32_t restart = accessor.component == Component::u8    ? 0xFF
                                  : accessor.component == Component::u16 ? 0xFFFF
                                                                         : 0xFFFFFFFF;
    for (std::size_t i = 0; i < indices.size(); ++i) {
      if (indices[i] == restart)
        report_.invalid(where, "primitive restart value", "index " + std::to_string(i) + "; split the strip");
    }
  } else {
    budget_.take(count_ * sizeof(std::uint32_t), where, report_);
    indices.resize(count_);
    for (std::size_t i = 0; i < count_; ++i) indices[i] = static_cast<std::uint32_t>(i);
  }
  for (std::size_t i = 0; i < indices.size(); ++i) {
    if (indices[i] < count_) continue;
    report_.invalid(where, "vertex that does not exist",
                    "index " + std::to_string(i) + " is " + std::to_string(indices[i]) + " of " +
                        std::to_string(count_) + "; export again");
  }
  return indices;
}

void import_positions(VertexSource& source, RawPrimitive& raw, Report& report) {
  const std::vector<float> values = source.read("POSITION");
  const std::string where = source.pointer_of("POSITION");
  std::vector<std::size_t> lost;
  glm::dvec3 sum(0);
  raw.positions.reserve(source.count());
  for (std::size_t v = 0; v < source.count(); ++v) {
    const float* from = &values[v * 3];
    if (!is_finite(from, 3))
      report.invalid(where, "not a finite number", "vertex " + std::to_string(v) + "; export again");
    raw.positions.emplace_back(from[0], from[1], from[2]);
    const bool near = std::all_of(from, from + 3, [](float x) { return std::abs(x) <= kFarthest_m; });
    if (near) sum += glm::dvec3(raw.positions.back());
    if (!near) lost.push_back(v);
  }
  if (lost.empty()) return;
  report.mend(where, "position-out-of-reach",
              std::to_string(lost.size()) + " vertices, first " + std::to_string(lost.front()) +
                  ", are beyond a million kilometres; moved to the middle of the others");
  const std::size_t others = source.count() - lost.size();
  const glm::vec3 middle = others == 0 ? glm::vec3(0) : glm::vec3(sum / static_cast<double>(others));
  for (const std::size_t v : lost) raw.positions[v] = middle;
}

void import_normals(VertexSource& source, RawPrimitive& raw, Report& report) {
  if (!source.has("NORMAL")) return;
  const std::vector<float> values = source.read("NORMAL");
  std::vector<glm::vec3> made;
  std::size_t remade = 0;
  std::size_t rescaled = 0;
  raw.normals.reserve(source.count());
  for (std::size_t v = 0; v < source.count(); ++v) {
    const glm::vec3 normal(values[v * 3], values[v * 3 + 1], values[v * 3 + 2]);
    const float length = static_cast<float>(glm::length(glm::dvec3(normal)));
    if (std::isfinite(length) && length > kSmallestDirection) {
      if (std::abs(length - 1) > kDirectionSlack) ++rescaled;
      raw.normals.push_back(normal / length);
      continue;
    }
    if (made.empty()) made = computed_normals(raw);
    raw.normals.push_back(made[v]);
    ++remade;
  }
  const std::string where = source.pointer_of("NORMAL");
  if (remade > 0 && source.has_data("NORMAL")) {
    report.mend(where, "normals-remade",
                std::to_string(remade) + " normals have no direction; computed from the triangles");
  }
  if (rescaled > 0) report.mend(where, "normals-not-unit", std::to_string(rescaled) + " normals were normalised");
}

void import_tangents(VertexSource& source, RawPrimitive& raw, Report& report) {
  if (!source.has("TANGENT")) return;
  const std::string where = source.pointer_of("TANGENT");
  if (raw.normals.empty()) {
    report.warn(where, "tangents-dropped", "tangents without normals are left out");
    return;
  }
  const std::vector<float> values = source.read("TANGENT");
  std::size_t mended = 0;
  raw.tangents.reserve(source.count());
  for (std::size_t v = 0; v < source.count(); ++v) {
    const float* from = &values[v * 4];
    glm::vec3 direction(from[0], from[1], from[2]);
    const float length = static_cast<float>(glm::length(glm::dvec3(direction)));
    const bool usable = std::isfinite(length) && length > kSmallestDirection;
    direction = usable ? direction / length : any_perpendicular(raw.normals[v]);
    const bool sign_ok = std::abs(std::abs(from[3]) - 1) <= kDirectionSlack;
    if (!usable || std::abs(length - 1) > kDirectionSlack || !sign_ok) ++mended;
    raw.tangents.emplace_back(direction, from[3] < 0 ? -1.0F : 1.0F);
  }
  if (mended > 0 && source.has_data("TANGENT")) {
    report.mend(where, "tangents-mended",
                std::to_string(mended) + " tangents were not of unit length with a sign of one");
  }
}

void import_uvs(VertexSource& source, const UvMapping& mapping, RawPrimitive& raw, Report& report) {
  const std::string wanted = "TEXCOORD_" + std::to_string(mapping.set);
  const std::string carried = source.has(wanted) ? wanted : "TEXCOORD_0";
  for (const char* name : {"TEXCOORD_0", "TEXCOORD_1"})
    if (source.has(name) && name != carried)
      report.warn(source.pointer_of(name), "extra-uvs-dropped", "the mesh carries " + carried + " alone");
  if (!source.has(carried)) return;
  const std::vector<float> values = source.read(carried);
  const UvMapping used = source.has(wanted) ? mapping : UvMapping{};
  const bool plain = used == UvMapping{mapping.set};
  std::size_t mended = 0;
  raw.uvs.reserve(source.count());
  for (std::size_t v = 0; v < source.count(); ++v) {
    glm::vec2 uv(values[v * 2], values[v * 2 + 1]);
    if (!plain) uv = used.apply(uv);
    for (int c = 0; c < 2; ++c) {
      if (std::abs(uv[c]) <= kFarthest_m) continue;  // false for NaN too
      uv[c] = 0;
      ++mended;
    }
    raw.uvs.push_back(uv);
  }
  if (mended > 0) {
    report.mend(source.pointer_of(carried), "uvs-mended", std::to_string(mended) + " are out of reach; now zero");
  }
}

void import_colours(VertexSource& source, RawPrimitive& raw, Report& report) {
  if (source.has("COLOR_0")) {
    const std::vector<float> values = source.read("COLOR_0");
    const std::size_t components = source.components("COLOR_0");
    std::size_t mended = 0;
    raw.colours.reserve(source.count());
    for (std::size_t v = 0; v < source.count(); ++v) {
      glm::vec4 colour(1);
      for (std::size_t c = 0; c < components; ++c) {
        const float value = values[v * components + c];
        const float clamped = std::isfinite(value) ? std::clamp(value, 0.0F, 1.0F) : 1.0F;
        if (!(std::abs(value - clamped) <= kClampSlack)) ++mended;
        colour[static_cast<int>(c)] = clamped;
      }
      raw.colours.push_back(colour);
    }
    if (mended > 0) {
      report.mend(source.pointer_of("COLOR_0"), "colours-clamped", std::to_string(mended) + " lie outside of 0 to 1");
    }
  }
  if (source.has("COLOR_1")) {
    report.warn(source.pointer_of("COLOR_1"), "extra-colours-dropped", "only COLOR_0 is carried");
  }
}

namespace {

constexpr std::size_t kMostSets = 16;  // 64 influences a vertex; the most that real scenes have is three sets
constexpr double kSumSlack = 0.02;     // eight influences of 8-bit weights drift by up to 4/255
constexpr double kLargestSum = 1e6;    // beyond every unit that weights are painted in

// What was wrong with a primitive's weights, counted so that it is said once.
struct Findings {
  std::size_t not_finite = 0;
  std::size_t negative = 0;
  std::size_t tiny = 0;
  std::size_t merged = 0;
  std::size_t unweighted = 0;
  std::size_t bad_sums = 0;
};

// Joints and weights of one set, four a vertex.
struct Set {
  std::vector<float> joints, weights;
};

std::vector<Set> read_sets(VertexSource& source, Report& report) {
  std::vector<Set> sets;
  std::string attribute = "JOINTS_0";
  for (; source.has(attribute); attribute = "JOINTS_" + std::to_string(sets.size())) {
    const std::string where = source.pointer_of(attribute);
    if (sets.size() == kMostSets)
      report.unsupported(where, "too many joint sets", "at most " + std::to_string(kMostSets) + " are read");
    Set& set = sets.emplace_back();
    set.joints = source.read(attribute);
    set.weights = source.read("WEIGHTS_" + std::to_string(sets.size() - 1));
    for (std::size_t i = 0; i < set.joints.size(); ++i) {
      // Draco data may hold any type of number here.
      const float joint = set.joints[i];
      if (!(joint >= 0 && joint <= 65535) || joint != std::floor(joint))
        report.invalid(where, "not a joint", "vertex " + std::to_string(i / 4) + "; export again");
    }
  }
  return sets;
}

// A weight as it counts: what is none counts as zero.
float counted(float weight, Findings& findings) {
  if (!std::isfinite(weight)) {
    ++findings.not_finite;
    return 0;
  }
  if (weight < 0) {
    ++findings.negative;
    return 0;
  }
  if (weight > 0 && weight < std::numeric_limits<float>::min()) {
    ++findings.tiny;
    return 0;
  }
  return weight;
}

// Of one vertex, each joint once. Weights so large that they would add up to infinity are made shares of their sum.
std::vector<RawInfluence> influences_of(const std::vector<Set>& sets, std::size_t vertex, Findings& findings) {
  std::vector<RawInfluence> out;
  double sum = 0;
  for (const Set& set : sets)
    for (std::size_t i = vertex * 4; i < vertex * 4 + 4; ++i) {
      const float weight = counted(set.weights[i], findings);
      if (weight == 0) continue;
      sum += double{weight};
      out.push_back({static_cast<std::uint32_t>(set.joints[i]), weight});
    }
  if (sum > kLargestSum) {
    for (RawInfluence& influence : out) influence.weight = static_cast<float>(double{influence.weight} / sum);
    std::erase_if(out, [](const RawInfluence& i) { return i.weight < std::numeric_limits<float>::min(); });
  }
  if (!out.empty() && std::abs(sum - 1) > kSumSlack) ++findings.bad_sums;
  // A joint that is listed twice gets the sum, at its first place.
  for (std::size_t i = 0; i < out.size();) {
    const auto first = std::ranges::find(out, out[i].joint, &RawInfluence::joint);
    const auto at = out.begin() + static_cast<std::ptrdiff_t>(i);
    if (first == at) {
      ++i;
      continue;
    }
    first->weight += at->weight;
    ++findings.merged;
    out.erase(at);
  }
  return out;
}

void report_findings(const Findings& findings, const std::string& where, Report& report) {
  const auto say = [&](std::size_t count, const char* rule, const char* text) {
    if (count > 0) report.mend(where, rule, std::to_string(count) + text);
  };
  say(findings.not_finite, "weights-not-finite", " weights are not finite numbers; taken as zero");
  say(findings.negative, "weights-negative", " weights are below zero; taken as zero");
  say(findings.tiny, "weights-denormal", " weights are too small to compute with; taken as zero");
  say(findings.merged, "joints-listed-twice",
      " influences name a joint that the vertex has already; the weights are added");
  say(findings.unweighted, "weights-zero", " vertices have no weight at all; they follow the first joint listed");
  say(findings.bad_sums, "weights-not-normalised",
      " vertices have weights that do not add up to one; they will be scaled to do so");
}

}  // namespace

void import_influences(VertexSource& source, RawPrimitive& raw, Report& report) {
  if (!source.has("JOINTS_0")) return;
  const std::vector<Set> sets = read_sets(source, report);
  Findings findings;
  raw.influences.resize(source.count());
  for (std::size_t v = 0; v < source.count(); ++v) {
    std::vector<RawInfluence>& vertex = raw.influences[v];
    vertex = influences_of(sets, v, findings);
    if (!vertex.empty()) continue;
    vertex.push_back({static_cast<std::uint32_t>(sets.front().joints[v * 4]), 1});
    ++findings.unweighted;
  }
  if (!source.has_data("WEIGHTS_0")) return;
  report_findings(findings, source.pointer_of("WEIGHTS_0"), report);
}

}  // namespace marrow::cook::gltf
