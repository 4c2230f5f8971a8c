#include "commands/diff/differences.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "common/vertex_order.h"
#include "pose/bare_skeleton.h"
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
  std::vector<char> has_partner(count, 0);
  for (const std::size_t partner : partners)
    if (partner != kNone) has_partner[partner] = 1;
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < count; ++i)
    if (has_partner[i] == 0) out.push_back(i);
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

bool is_pack(const File& file) {
  return file.reference_count() > 0;
}

// What joints are called and hang on, of a skeleton or of a pack's reference.
struct JointList {
  std::string owner;
  std::vector<std::string> names;
  std::vector<std::size_t> parents;
  std::vector<std::uint32_t> rest_hashes;  // a reference's
};

template <class Owner>
JointList joints_in(const File& file, const Owner& owner) {
  JointList out;
  out.owner = owner.name;
  for (std::uint32_t j = 0; j < owner.joint_count; ++j) {
    out.names.emplace_back(file.text(owner.names[j]));
    out.parents.push_back(owner.parents[j] == kNoJoint ? kNone : std::size_t{owner.parents[j]});
  }
  return out;
}

// Of each skeleton; of a pack of each reference.
std::vector<JointList> joints_of(const File& file) {
  std::vector<JointList> out;
  for (std::uint32_t i = 0; i < file.skeleton_count(); ++i) out.push_back(joints_in(file, file.skeleton(i)));
  for (std::uint32_t i = 0; i < file.reference_count(); ++i) {
    const SkeletonReference reference = file.reference(i);
    out.push_back(joints_in(file, reference));
    out.back().rest_hashes.assign(reference.rest_hashes, reference.rest_hashes + reference.joint_count);
  }
  return out;
}

// A file, and what its clips are posed on: itself, of a pack the character, or nothing.
struct Side {
  Side(const LoadedFile& of, const LoadedFile* on) : loaded(of), file(of.file), joints(joints_of(file)) {
    if (!is_pack(file)) on = &of;
    if (on == nullptr) return;
    posed = on->file;
    plays = plays_of(posed, file);
    character.emplace(posed);
  }
  const LoadedFile& loaded;
  const File& file;
  std::vector<JointList> joints;
  File posed;
  std::vector<Play> plays;
  std::optional<Character> character;
};

class Comparison {
 public:
  Comparison(const LoadedFile& a, const LoadedFile& b, const LoadedFile* character)
      : a_(a, character), b_(b, character) {}

  ordered_json run() {
    compare_sections();
    if (is_pack(a_.file) != is_pack(b_.file)) {
      const auto what = [](const Side& side) { return is_pack(side.file) ? "a clip pack" : "no clip pack"; };
      say("pack", "file", fmt::format("{}, now {}", what(a_), what(b_)));
      return std::move(out_);
    }
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
      const LoadedFile& loaded = which == 0 ? a_.loaded : b_.loaded;
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

  void compare_skeletons() {
    std::vector<std::string> a, b;
    for (const JointList& joints : a_.joints) a.push_back(joints.owner);
    for (const JointList& joints : b_.joints) b.push_back(joints.owner);
    joints_.resize(a.size());
    skeleton_.assign(a.size(), kNone);
    if (a_.character) a_.character->pose({}, 0);  // all skeletons
    if (b_.character) b_.character->pose({}, 0);
    for (const auto& [i, k] : pairs("skeleton", a, b)) {
      skeleton_[i] = k;
      const std::string in = fmt::format("skeleton \"{}\"", a[i]);
      compare_joints(in, a_.joints[i], b_.joints[k], joints_[i]);
      if (is_pack(a_.file)) {
        compare_rests(in, a_.joints[i], b_.joints[k], joints_[i]);
      } else {
        compare_rest(in, i, k);
      }
    }
  }

  // partners: becomes which joint of `b` each of `a` is.
  void compare_joints(const std::string& in, const JointList& a, const JointList& b,
                      std::vector<std::size_t>& partners) {
    partners = match(a.names, b.names);
    std::vector<std::size_t> fresh = unmatched(partners, b.names.size());
    const auto parent_of = [&](std::size_t j) { return a.parents[j] == kNone ? kNone : partners[a.parents[j]]; };
    for (std::size_t j = 0; j < partners.size(); ++j) {
      if (partners[j] != kNone) continue;
      // The same place under the same parent: another name for the same joint.
      const auto same = std::lower_bound(fresh.begin(), fresh.end(), j);
      if (same != fresh.end() && *same == j && parent_of(j) == b.parents[j]) {
        say("joint-renamed", in, fmt::format("joint \"{}\" is now \"{}\"", a.names[j], b.names[j]));
        partners[j] = j;
        fresh.erase(same);
      } else {
        say("joint-removed", in, fmt::format("joint \"{}\" is gone", a.names[j]));
      }
    }
    for (const std::size_t j : fresh) say("joint-added", in, fmt::format("joint \"{}\" is new", b.names[j]));
    for (std::size_t j = 0; j < partners.size(); ++j) {
      if (partners[j] == kNone) continue;
      const std::size_t now = b.parents[partners[j]];
      const bool root_in_a = a.parents[j] == kNone;
      if (root_in_a ? now == kNone : now != kNone && now == parent_of(j)) continue;
      say("joint-re-parented", in,
          fmt::format("joint \"{}\" now hangs below {}", a.names[j],
                      now == kNone ? "nothing" : fmt::format("\"{}\"", b.names[now])));
    }
  }

  // A pack knows that a joint rests elsewhere, but not where.
  void compare_rests(const std::string& in, const JointList& a, const JointList& b,
                     const std::vector<std::size_t>& partners) {
    for (std::size_t j = 0; j < partners.size(); ++j)
      if (partners[j] != kNone && a.rest_hashes[j] != b.rest_hashes[partners[j]])
        say("rest-moved", in, fmt::format("the rest pose of joint \"{}\" differs", a.names[j]),
            {{"joint", a.names[j]}});
  }

  struct Farthest {
    double distance = 0;
    std::size_t joint = 0;
    double time_s = 0;
  };
  // Between the joints of skeletons that are posed. partners: which joint of the second each of the first is.
  void farthest(std::uint32_t i, std::uint32_t k, const std::vector<std::size_t>& partners, double time_s,
                Farthest& worst) const {
    const std::span<const Affine> a = a_.character->model_from_joint(i), b = b_.character->model_from_joint(k);
    const double shell = shell_of(a);
    for (std::size_t j = 0; j < a.size(); ++j) {
      if (partners[j] == kNone) continue;
      const double distance = shell_distance(a[j], b[partners[j]], shell);
      if (distance > worst.distance) worst = {distance, j, time_s};
    }
  }

  void compare_rest(const std::string& in, std::size_t i, std::size_t k) {
    Farthest worst;
    farthest(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(k), joints_[i], 0, worst);
    if (worst.distance == 0) return;
    const std::string& joint = a_.joints[i].names[worst.joint];
    say("rest-moved", in,
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
    if (a_.character) {
      compare_motion(in, i, k);
    } else {
      compare_keys(in, a, b);
    }
  }

  static std::size_t moments(const Clip& a, const Clip& b) {
    const double end_s = static_cast<double>(std::max(a.duration_s, b.duration_s));
    return static_cast<std::size_t>(
        std::clamp(std::ceil(end_s * kMomentsPerSecond), 1.0, static_cast<double>(kMostMoments)));
  }

  void compare_motion(const std::string& in, std::uint32_t i, std::uint32_t k) {
    const Clip a = a_.file.clip(i), b = b_.file.clip(k);
    const auto at_a = skeleton_of(a_.plays[i], i), at_b = skeleton_of(b_.plays[k], k);
    if (!at_a || !at_b) return;  // of a pack whose joints differ, which is said
    const double end_s = static_cast<double>(std::max(a.duration_s, b.duration_s));
    const std::size_t steps = moments(a, b);
    Farthest worst;
    const Play play_a = only(a_.posed, a_.plays[i], *at_a), play_b = only(b_.posed, b_.plays[k], *at_b);
    for (std::size_t m = 0; m <= steps; ++m) {
      const double time_s = end_s * static_cast<double>(m) / static_cast<double>(steps);
      a_.character->pose(play_a, static_cast<float>(time_s));
      b_.character->pose(play_b, static_cast<float>(time_s));
      farthest(*at_a, *at_b, joints_[a.skeleton], time_s, worst);
    }
    if (worst.distance == 0) return;
    const std::string& joint = a_.joints[a.skeleton].names[worst.joint];
    say("clip-moved", in,
        fmt::format("poses differ by up to {:.3g} m, at joint \"{}\" and {:.3f} s", worst.distance, joint,
                    worst.time_s),
        {{"distance_m", worst.distance}, {"joint", joint}, {"time_s", worst.time_s}});
  }

  // Of packs alone: whether they differ, but not how far, as they do not know where joints are.
  void compare_keys(const std::string& in, const Clip& a, const Clip& b) {
    const BareSkeleton on_a(a_.file.reference(a.skeleton)), on_b(b_.file.reference(b.skeleton));
    const std::size_t steps = moments(a, b);
    const float end_s = std::max(a.duration_s, b.duration_s);
    for (std::size_t m = 0; m <= steps; ++m) {
      const float time_s = end_s * static_cast<float>(m) / static_cast<float>(steps);
      const std::vector<SoaTransform> p = on_a.pose(a, time_s), q = on_b.pose(b, time_s);
      if (p.size() == q.size() && std::memcmp(p.data(), q.data(), p.size() * sizeof p[0]) == 0) continue;
      return say("clip-keys", in, "the motion differs; --skeleton CHARACTER.mrw says by how far");
    }
  }

  Side a_, b_;
  std::vector<std::size_t> skeleton_;             // of a → of b; of packs references
  std::vector<std::vector<std::size_t>> joints_;  // a skeleton of a: joint → of b
  ordered_json out_ = ordered_json::array();
};

}  // namespace

ordered_json compare(const LoadedFile& a, const LoadedFile& b, const LoadedFile* character) {
  return Comparison(a, b, character).run();
}

}  // namespace marrow::tools
