// Numbers of multi-weight enveloping and pose-space deformation: from double precision to streams.
#include <algorithm>
#include <bit>
#include <cmath>

#include <glm/geometric.hpp>

#include "common/failure.h"
#include "cook/geometry/owned_streams.h"

namespace marrow::cook {
namespace {

[[noreturn]] void refuse(const char* rule) {
  throw tools::Failure(tools::Exit::unsupported, "", "", "deformer-data", rule);
}

bool is_sane(double x) {
  return std::abs(x) < 1e6;  // false for NaN
}

// What rounding has left of a vertex's influences: for each place of the streams an index into its binding, and the
// weight that the runtime will see.
struct KeptInfluences {
  std::vector<std::size_t> of_binding;
  std::vector<double> weights;
};

KeptInfluences kept_influences(OwnedStreams& s, const Binding& binding, std::size_t v) {
  const std::vector<std::int32_t>* const joints = s.values_of(StreamKind::joints);
  const Stream* const weights = s.find(StreamKind::weights);
  KeptInfluences out;
  double left = 1;
  for (std::size_t j = 0; j < s.mesh.influences; ++j) {
    const std::int32_t joint = joints == nullptr ? std::int32_t{binding.set[0]} : (*joints)[v * s.mesh.influences + j];
    const auto found = std::find(binding.set.begin(), binding.set.end(), joint);
    const auto place = static_cast<std::size_t>(found - binding.set.begin());
    if (!out.of_binding.empty() && out.of_binding.back() == place) break;  // the last repeats
    out.of_binding.push_back(place);
    double w = 0;
    if (weights != nullptr && j + 1 < s.mesh.influences) {
      const std::int32_t n = (*s.values_of(StreamKind::weights))[v * weights->components + j];
      w = weights->bits == 0 ? double{std::bit_cast<float>(n)} : static_cast<double>(n) * double{weights->step};
    }
    out.weights.push_back(w);
    left -= w;
  }
  out.weights.back() += left;
  return out;
}

double reach_of(const RawPrimitive& p, double& diagonal) {
  glm::dvec3 low(p.positions.front()), high(low);
  double most = 0;
  for (const glm::vec3& v : p.positions) {
    low = glm::min(low, glm::dvec3(v));
    high = glm::max(high, glm::dvec3(v));
    most = std::max(most, std::abs(double{v.x}) + std::abs(double{v.y}) + std::abs(double{v.z}));
  }
  diagonal = glm::length(high - low);
  return most;
}

// A place's residuals, twelve a vertex; of vertices with fewer influences none.
std::vector<double> residuals_of(const MultiWeightData& data, const std::vector<KeptInfluences>& kept, std::size_t j) {
  std::vector<double> out(kept.size() * 12, 0);
  for (std::size_t v = 0; v < kept.size(); ++v) {
    if (j >= kept[v].of_binding.size()) continue;
    for (std::size_t i = 0; i < 12; ++i)
      out[v * 12 + i] = data.weights[v][kept[v].of_binding[j]][i] - kept[v].weights[j];
  }
  return out;
}

void check_multi_weights(const MultiWeightData& data, const std::vector<Binding>& bindings, std::uint32_t joint_count) {
  if (data.root >= joint_count || data.weights.size() != bindings.size()) refuse("multi-weights of other vertices");
  for (std::size_t v = 0; v < bindings.size(); ++v) {
    if (data.weights[v].size() != bindings[v].set.size()) refuse("multi-weights of other influences");
    for (const auto& twelve : data.weights[v])
      for (const double x : twelve)
        if (!is_sane(x)) refuse("a multi-weight that is no sane number");
  }
}

// The sum over influences and columns of |error of a weight| · |element| · |coordinate| is below half a step times
// `reach` times the influences in each row; rows are perpendicular.
void add_multi_weights(const RawPrimitive& p, const std::vector<Binding>& bindings, const MultiWeightData& data,
                       const MeshGrid& grid, OwnedStreams& out, MeshError& error) {
  check_multi_weights(data, bindings, out.mesh.joint_count);
  std::vector<KeptInfluences> kept;
  for (std::size_t v = 0; v < bindings.size(); ++v) kept.push_back(kept_influences(out, bindings[v], v));
  std::vector<std::vector<double>> residuals;
  double most = 0;
  for (std::size_t j = 0; j < out.mesh.influences; ++j) {
    residuals.push_back(residuals_of(data, kept, j));
    for (const double x : residuals[j]) most = std::max(most, std::abs(x));
  }
  double diagonal = 0;
  const double reach = reach_of(p, diagonal) + diagonal;
  const double of_a_step = 0.5 * std::sqrt(3.0) * static_cast<double>(out.mesh.influences) * reach;
  constexpr double kMost = (1 << (packed::kMaxValueBits - 1)) - 1;
  float step = 1;
  std::uint32_t bits = 0;
  if (grid.step > 0) {
    const double finest = of_a_step > 0 ? grid.step / of_a_step : 1;
    step = static_cast<float>(std::max(finest, most / kMost * 1.0001));
    bits = 1 + static_cast<std::uint32_t>(std::bit_width(static_cast<std::uint32_t>(std::lround(most / double{step}))));
    error.multi_weight = of_a_step * double{step};
  }
  for (std::size_t j = 0; j < out.mesh.influences; ++j) {
    Stream& s = out.add(StreamKind::multi_weight, 12, bits);
    s.step = step;
    s.target = static_cast<std::uint32_t>(j);
    for (const double x : residuals[j])
      out.values.back().push_back(bits == 0
                                      ? std::bit_cast<std::int32_t>(static_cast<float>(x))
                                      : (1 << (bits - 1)) + static_cast<std::int32_t>(std::lround(x / double{step})));
  }
  out.mesh.mwe_root = data.root;
  out.mesh.flags |= format::kHasMwe;
}

void add_rotations(const PoseSpaceData& data, const PoseSpaceData::Example& example, OwnedStreams& out) {
  for (std::size_t j = 0; j < data.parents.size(); ++j) {
    const bool turns = data.parents[j] != kNoJoint;
    const glm::dquat q = turns ? example.rotations[j] : glm::dquat(1, 0, 0, 0);
    const double length = glm::length(q);
    if (!(length > 1e-3) || !is_sane(length)) refuse("a rotation that is none");
    for (const double c : {q.x, q.y, q.z, q.w})
      out.rotations.push_back(static_cast<std::int16_t>(std::lround(c / length * 32767)));
  }
}

// Each delta is weighed by at most 1, so the errors of all examples add up.
void add_pose_space(const RawPrimitive& p, const PoseSpaceData& data, const MeshGrid& grid, OwnedStreams& out,
                    MeshError& error) {
  const std::size_t count = data.examples.size();
  if (count > kMaxPoseExamples) refuse("too many examples");
  if (!(data.sigma >= double{format::kLeastSigma} && data.sigma <= double{format::kMostSigma})) refuse("sigma");
  if (data.parents.size() != out.mesh.joint_count) refuse("parents of another palette");
  for (const std::uint16_t parent : data.parents)
    if (parent != kNoJoint && parent >= out.mesh.joint_count) refuse("a parent outside the palette");
  for (std::size_t k = 0; k < count; ++k) {
    const PoseSpaceData::Example& e = data.examples[k];
    if (e.deltas.size() != p.positions.size() || e.rotations.size() != data.parents.size())
      refuse("an example of other vertices or joints");
    for (const glm::dvec3& d : e.deltas)
      if (!is_sane(d.x) || !is_sane(d.y) || !is_sane(d.z)) refuse("a delta that is no sane number");
    double worst = 0;
    if (add_changes(StreamKind::pose_delta, e.deltas, static_cast<std::uint32_t>(k), 0,
                    grid.step / static_cast<double>(count), out, worst))
      error.pose_space += worst;
    add_rotations(data, e, out);
  }
  out.parents = data.parents;
  out.mesh.example_count = static_cast<std::uint32_t>(count);
  out.mesh.sigma = static_cast<float>(data.sigma);
  out.mesh.flags |= format::kHasPoseSpace;
}

}  // namespace

void add_deformers(const RawPrimitive& p, const std::vector<Binding>& bindings, const DeformerData& data,
                   const MeshGrid& grid, OwnedStreams& streams, MeshError& error) {
  if (!data.multi_weight.weights.empty()) add_multi_weights(p, bindings, data.multi_weight, grid, streams, error);
  if (!data.pose_space.examples.empty()) add_pose_space(p, data.pose_space, grid, streams, error);
}

}  // namespace marrow::cook
