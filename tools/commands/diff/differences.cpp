#include "commands/diff/differences.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>

#include <fmt/format.h>

#include "common/vertex_order.h"
#include "pose/evaluate.h"

namespace marrow::tools {
namespace {

using nlohmann::ordered_json;

// As the cooker measures clips: on a shell round each joint, of 3 cm on a person of 2 m where the unit is clearly not
// the metre.
constexpr double kShell = 0.03, kSmallest = 0.2, kLargest = 20, kPerson = 2;
constexpr double kMomentsPerSecond = 60;
constexpr std::size_t kMostMoments = 2000;

constexpr std::size_t kNone = SIZE_MAX;

// For each name of `a` the element of `b` that has it, or kNone.
std::vector<std::size_t> match(const std::vector<std::string>& a, const std::vector<std::string>& b) {
  std::map<std::string, std::vector<std::size_t>> places;
  for (std::size_t i = b.size(); i-- > 0;) places[b[i]].push_back(i);
  std::vector<std::size_t> out;
  for (const std::string& name : a) {
    std::vector<std::size_t>& left = places[name];
    out.push_back(left.empty() ? kNone : left.back());
    if (!left.empty()) left.pop_back();
  }
  return out;
}

std::vector<std::size_t> unmatched(const std::vector<std::size_t>& partners, std::size_t count) {
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < count; ++i)
    if (std::find(partners.begin(), partners.end(), i) == partners.end()) out.push_back(i);
  return out;
}

double shell_of(std::span<const Affine> joints) {
  double squared = 0;
  for (int r = 0; r < 3; ++r) {
    const auto at = [&](const Affine& j) { return static_cast<double>(j.rows[r][3]); };
    const auto [low, high] = std::minmax_element(joints.begin(), joints.end(),
                                                 [&](const Affine& p, const Affine& q) { return at(p) < at(q); });
    squared += (at(*high) - at(*low)) * (at(*high) - at(*low));
  }
  const double across = std::sqrt(squared);
  return across > 0 && (across < kSmallest || across > kLargest) ? kShell * across / kPerson : kShell;
}

// The largest distance between the ends of the shell's axes, which are as long as in `a`, however it is scaled.
double shell_distance(const Affine& a, const Affine& b, double shell) {
  double worst = 0;
  for (int axis = 0; axis < 3; ++axis) {
    double length = 0;
    for (const auto& row : a.rows) length += static_cast<double>(row[axis]) * static_cast<double>(row[axis]);
    length = std::sqrt(length);
    for (const double sign : {-1.0, 1.0}) {
      double squared = 0;
      for (int r = 0; r < 3; ++r) {
        const double turned = static_cast<double>(b.rows[r][axis]) - static_cast<double>(a.rows[r][axis]);
        const double apart = static_cast<double>(b.rows[r][3]) - static_cast<double>(a.rows[r][3]) +
                             (length > 0 ? sign * shell * turned / length : 0);
        squared += apart * apart;
      }
      worst = std::max(worst, std::sqrt(squared));
    }
  }
  return worst;
}

class Comparison {
 public:
  Comparison(const LoadedFile& a, const LoadedFile& b) : a_(a), b_(b), pose_a_(a.file), pose_b_(b.file) {}

  ordered_json run() {
    compare_sections();
    compare_skeletons();
    compare_meshes();
    compare_clips();
    return std::move(out_);
  }

 private:
  void say(const char* kind, const std::string& in, const std::string& text,
           ordered_json more = ordered_json::object()) {
    ordered_json entry = {{"kind", kind}, {"in", in}, {"text", text}};
    entry.update(more);
    out_.push_back(std::move(entry));
  }

  // Two columns of numbers a type of section.
  void compare_sections() {
    std::map<std::string, std::vector<std::string>> bytes[2];
    std::vector<std::string> order;
    for (const int which : {0, 1}) {
      const LoadedFile& loaded = which == 0 ? a_ : b_;
      for (const File::Section& s : loaded.stored) {
        const std::string type(reinterpret_cast<const char*>(&s.type), 4);
        if (std::find(order.begin(), order.end(), type) == order.end()) order.push_back(type);
        bytes[which][type].emplace_back(reinterpret_cast<const char*>(loaded.bytes.data()) + s.offset, s.bytes);
      }
    }
    const auto sum = [](const std::vector<std::string>& all) {
      std::size_t n = 0;
      for (const std::string& one : all) n += one.size();
      return n;
    };
    for (const std::string& type : order) {
      const auto &x = bytes[0][type], &y = bytes[1][type];
      if (x == y) continue;
      say("section", "sections " + type,
          fmt::format("{} with {} bytes, now {} with {}", x.size(), sum(x), y.size(), sum(y)),
          {{"a_count", x.size()}, {"a_bytes", sum(x)}, {"b_count", y.size()}, {"b_bytes", sum(y)}});
    }
  }

  // Says what is only in one file, and returns the others' pairs.
  std::vector<std::pair<std::size_t, std::size_t>> pairs(const char* what, const std::vector<std::string>& a,
                                                         const std::vector<std::string>& b) {
    const std::vector<std::size_t> partners = match(a, b);
    std::vector<std::pair<std::size_t, std::size_t>> out;
    for (std::size_t i = 0; i < a.size(); ++i) {
      if (partners[i] == kNone)
        say("removed", fmt::format("{} \"{}\"", what, a[i]), "only in the first file");
      else
        out.emplace_back(i, partners[i]);
    }
    for (const std::size_t i : unmatched(partners, b.size()))
      say("added", fmt::format("{} \"{}\"", what, b[i]), "only in the second file");
    return out;
  }

  static std::vector<std::string> joint_names(const File& file, const Skeleton& s) {
    std::vector<std::string> out;
    for (std::uint32_t j = 0; j < s.joint_count; ++j) out.emplace_back(file.text(s.names[j]));
    return out;
  }

  void compare_skeletons() {
    std::vector<std::string> a, b;
    for (std::uint32_t i = 0; i < a_.file.skeleton_count(); ++i) a.emplace_back(a_.file.skeleton(i).name);
    for (std::uint32_t i = 0; i < b_.file.skeleton_count(); ++i) b.emplace_back(b_.file.skeleton(i).name);
    joints_.resize(a.size());
    skeleton_.assign(a.size(), kNone);
    for (const auto& [i, k] : pairs("skeleton", a, b)) {
      skeleton_[i] = k;
      compare_joints(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(k));
      compare_rest(i, k);
    }
  }

  void compare_joints(std::uint32_t i, std::uint32_t k) {
    const Skeleton a = a_.file.skeleton(i), b = b_.file.skeleton(k);
    const std::vector<std::string> names_a = joint_names(a_.file, a), names_b = joint_names(b_.file, b);
    std::vector<std::size_t>& partners = joints_[i] = match(names_a, names_b);
    const std::string in = fmt::format("skeleton \"{}\"", a.name);
    std::vector<std::size_t> fresh = unmatched(partners, names_b.size());
    const auto parent_of = [&](std::size_t j) { return a.parents[j] == kNoParent ? kNone : partners[a.parents[j]]; };
    const auto parent_in_b = [&](std::size_t j) {
      return b.parents[j] == kNoParent ? kNone : std::size_t{b.parents[j]};
    };
    for (std::size_t j = 0; j < partners.size(); ++j) {
      if (partners[j] != kNone) continue;
      // The same place under the same parent: another name for the same joint.
      const auto same = std::find(fresh.begin(), fresh.end(), j);
      if (same != fresh.end() && parent_of(j) == parent_in_b(j)) {
        say("joint-renamed", in, fmt::format("joint \"{}\" is now \"{}\"", names_a[j], names_b[j]));
        partners[j] = j;
        fresh.erase(same);
      } else {
        say("joint-removed", in, fmt::format("joint \"{}\" is gone", names_a[j]));
      }
    }
    for (const std::size_t j : fresh) say("joint-added", in, fmt::format("joint \"{}\" is new", names_b[j]));
    for (std::size_t j = 0; j < partners.size(); ++j) {
      if (partners[j] == kNone) continue;
      const std::size_t now = parent_in_b(partners[j]);
      const bool root_in_a = a.parents[j] == kNoParent;
      if (root_in_a ? now == kNone : now != kNone && now == parent_of(j)) continue;
      say("joint-re-parented", in,
          fmt::format("joint \"{}\" now hangs below {}", names_a[j],
                      now == kNone ? "nothing" : fmt::format("\"{}\"", names_b[now])));
    }
  }

  struct Farthest {
    double distance = 0;
    std::size_t joint = 0;
    double time_s = 0;
  };
  void farthest(std::size_t i, std::size_t k, double time_s, Farthest& worst) const {
    const std::span<const Affine> a = pose_a_.scene_from_joint(static_cast<std::uint32_t>(i)),
                                  b = pose_b_.scene_from_joint(static_cast<std::uint32_t>(k));
    const double shell = shell_of(a);
    for (std::size_t j = 0; j < a.size(); ++j) {
      if (joints_[i][j] == kNone) continue;
      const double distance = shell_distance(a[j], b[joints_[i][j]], shell);
      if (distance > worst.distance) worst = {distance, j, time_s};
    }
  }
  std::string joint_name(std::size_t skeleton, std::size_t joint) const {
    return a_.file.text(a_.file.skeleton(static_cast<std::uint32_t>(skeleton)).names[joint]);
  }

  void compare_rest(std::size_t i, std::size_t k) {
    pose_a_.pose({}, 0);
    pose_b_.pose({}, 0);
    Farthest worst;
    farthest(i, k, 0, worst);
    if (worst.distance == 0) return;
    const std::string joint = joint_name(i, worst.joint);
    say("rest-moved", fmt::format("skeleton \"{}\"", a_.file.skeleton(static_cast<std::uint32_t>(i)).name),
        fmt::format("the rest pose differs by up to {:.3g} m, at joint \"{}\"", worst.distance, joint),
        {{"distance_m", worst.distance}, {"joint", joint}});
  }

  void compare_meshes() {
    std::vector<std::string> a, b;
    for (std::uint32_t i = 0; i < a_.file.mesh_count(); ++i) a.emplace_back(a_.file.mesh(i).name);
    for (std::uint32_t i = 0; i < b_.file.mesh_count(); ++i) b.emplace_back(b_.file.mesh(i).name);
    for (const auto& [i, k] : pairs("mesh", a, b))
      compare_mesh(a_.file.mesh(static_cast<std::uint32_t>(i)), b_.file.mesh(static_cast<std::uint32_t>(k)));
  }

  void compare_mesh(const Mesh& a, const Mesh& b) {
    const std::string in = fmt::format("mesh \"{}\"", a.name);
    const auto number = [&](const char* what, std::uint32_t x, std::uint32_t y) {
      if (x != y) say("mesh", in, fmt::format("{} {}, now {}", x, what, y), {{"a", x}, {"b", y}});
    };
    number("vertices", a.geometry.vertex_count, b.geometry.vertex_count);
    number("triangles", a.geometry.index_count / 3, b.geometry.index_count / 3);
    number("joints", a.joint_count, b.joint_count);
    number("levels of detail", static_cast<std::uint32_t>(a.lods.size), static_cast<std::uint32_t>(b.lods.size));
    if (std::strcmp(a.material, b.material) != 0)
      say("mesh-material", in, fmt::format("material \"{}\", now \"{}\"", a.material, b.material));
    if (std::memcmp(a.base_colour, b.base_colour, sizeof a.base_colour) != 0 || a.double_sided != b.double_sided)
      say("mesh-material", in, "the material's colour or sides differ");
    compare_positions(in, a.geometry, b.geometry);
  }

  static std::vector<std::uint32_t> triangles(const Geometry& g) {
    const std::vector<std::uint32_t> order = vertex_order(g);
    std::vector<std::uint32_t> number(g.slot_count, 0), out;
    for (std::uint32_t i = 0; i < order.size(); ++i) number[order[i]] = i;
    for (std::uint32_t i = 0; i < g.index_count; ++i) out.push_back(number[index_at(g, i)]);
    return out;
  }
  static std::vector<std::array<double, 3>> positions(const Geometry& g) {
    std::vector<std::array<double, 3>> slots;
    const float* block = g.skin;
    for (const Run& run : g.runs)
      for (std::uint32_t v = 0; v < run.vertex_count; v += 4, block += 12 + std::size_t{run.influences - 1} * 4)
        for (std::size_t lane = 0; lane < 4; ++lane)
          slots.push_back({static_cast<double>(block[lane]), static_cast<double>(block[4 + lane]),
                           static_cast<double>(block[8 + lane])});
    std::vector<std::array<double, 3>> out;
    for (const std::uint32_t slot : vertex_order(g)) out.push_back(slots[slot]);
    return out;
  }

  void compare_positions(const std::string& in, const Geometry& a, const Geometry& b) {
    if (a.vertex_count != b.vertex_count || a.index_count != b.index_count) return;
    if (triangles(a) != triangles(b)) return say("mesh-topology", in, "the triangles or the order of vertices differ");
    const auto p = positions(a), q = positions(b);
    double worst = 0;
    for (std::size_t v = 0; v < std::min(p.size(), q.size()); ++v)
      worst = std::max(worst, std::hypot(p[v][0] - q[v][0], p[v][1] - q[v][1], p[v][2] - q[v][2]));
    if (worst > 0)
      say("mesh-moved", in, fmt::format("bind positions differ by up to {:.3g} m", worst), {{"distance_m", worst}});
  }

  void compare_clips() {
    std::vector<std::string> a, b;
    for (std::uint32_t i = 0; i < a_.file.clip_count(); ++i) a.emplace_back(a_.file.clip(i).name);
    for (std::uint32_t i = 0; i < b_.file.clip_count(); ++i) b.emplace_back(b_.file.clip(i).name);
    for (const auto& [i, k] : pairs("clip", a, b))
      compare_clip(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(k));
  }

  void compare_clip(std::uint32_t i, std::uint32_t k) {
    const Clip a = a_.file.clip(i), b = b_.file.clip(k);
    const std::string in = fmt::format("clip \"{}\"", a.name);
    if (a.duration_s != b.duration_s)
      say("clip-duration", in, fmt::format("{:.6g} s, now {:.6g} s", a.duration_s, b.duration_s),
          {{"a", a.duration_s}, {"b", b.duration_s}});
    if (a.additive != b.additive) say("clip-additive", in, a.additive ? "no longer additive" : "now additive");
    if (skeleton_[a.skeleton] != b.skeleton) return say("clip-skeleton", in, "moves another skeleton");
    const double end_s = static_cast<double>(std::max(a.duration_s, b.duration_s));
    const auto steps = static_cast<std::size_t>(
        std::clamp(std::ceil(end_s * kMomentsPerSecond), 1.0, static_cast<double>(kMostMoments)));
    Farthest worst;
    const Play play_a = only(a_.file, play_together(a_.file, i), a.skeleton),
               play_b = only(b_.file, play_together(b_.file, k), b.skeleton);
    for (std::size_t m = 0; m <= steps; ++m) {
      const double time_s = end_s * static_cast<double>(m) / static_cast<double>(steps);
      pose_a_.pose(play_a, static_cast<float>(time_s));
      pose_b_.pose(play_b, static_cast<float>(time_s));
      farthest(a.skeleton, b.skeleton, time_s, worst);
    }
    if (worst.distance == 0) return;
    const std::string joint = joint_name(a.skeleton, worst.joint);
    say("clip-moved", in,
        fmt::format("poses differ by up to {:.3g} m, at joint \"{}\" and {:.3f} s", worst.distance, joint,
                    worst.time_s),
        {{"distance_m", worst.distance}, {"joint", joint}, {"time_s", worst.time_s}});
  }

  const LoadedFile &a_, &b_;
  Character pose_a_, pose_b_;
  std::vector<std::size_t> skeleton_;             // of a → of b
  std::vector<std::vector<std::size_t>> joints_;  // a skeleton of a: joint → of b
  ordered_json out_ = ordered_json::array();
};

}  // namespace

ordered_json compare(const LoadedFile& a, const LoadedFile& b) {
  return Comparison(a, b).run();
}

}  // namespace marrow::tools
