#include "road/scenes/random_scene.h"

#include <algorithm>
#include <cmath>

#include "road/scenes/made_scene.h"
#include "support/rig.h"

namespace marrow::test {
namespace {

Quat operator*(const Quat& a, const Quat& b) {
  return {a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1], a[3] * b[1] - a[0] * b[2] + a[1] * b[3] + a[2] * b[0],
          a[3] * b[2] + a[0] * b[1] - a[1] * b[0] + a[2] * b[3], a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2]};
}

Vec3 times(const Vec3& v, double s) {
  return {v[0] * s, v[1] * s, v[2] * s};
}

Vec3 plus(const Vec3& a, const Vec3& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

Map inverse(const Map& m) {
  const Vec3 columns[3] = {cross(row(m, 1), row(m, 2)), cross(row(m, 2), row(m, 0)), cross(row(m, 0), row(m, 1))};
  const double d = determinant(m);
  Map out;
  for (std::size_t r = 0; r < 3; ++r) {
    out.rows[r][3] = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      out.rows[r][c] = columns[c][r] / d;
      out.rows[r][3] -= out.rows[r][c] * m.rows[c][3];
    }
  }
  return out;
}

Vec3 origin(const Map& m) {
  return {m.rows[0][3], m.rows[1][3], m.rows[2][3]};
}

class Maker {
 public:
  // Seeds far apart: those in a row would draw alike.
  explicit Maker(std::uint32_t number) : random_(number * 0x9E3779B97F4A7C15U) {
    const std::uint32_t kind = number % kSceneKinds, round = number / kSceneKinds;
    out_.number = number;
    out_.kind = static_cast<SceneKind>(kind);
    if (round >= 5)
      for (bool& one : out_.has) one = chance(0.12);
    // Clips of other files have no changes in these scenes.
    for (const SceneKind alone : {SceneKind::pack, SceneKind::pack_of_another_unit, SceneKind::additive_over_zero})
      out_.has[static_cast<std::size_t>(alone)] = false;
    out_.has[kind] = true;
    packed_ = has(SceneKind::pack) || has(SceneKind::pack_of_another_unit);
    if (packed_) out_.has[static_cast<std::size_t>(SceneKind::additive)] = false;
    if (has(SceneKind::additive_over_zero)) out_.has[static_cast<std::size_t>(SceneKind::additive)] = false;
  }
  RandomScene make();

 private:
  bool has(SceneKind kind) const { return out_.has[static_cast<std::size_t>(kind)]; }
  bool chance(double p) { return random_.between(0, 1) < p; }
  double power(double low, double high) { return std::pow(10.0, random_.between(low, high)); }
  Vec3 direction() {
    for (;;) {
      const Vec3 v = {random_.between(-1, 1), random_.between(-1, 1), random_.between(-1, 1)};
      if (length(v) > 0.1) return normalised(v);
    }
  }
  // Of two numbers in one call either may be drawn first, and scenes be others by each compiler.
  Quat turn(double most_rad) {
    const double rad = random_.between(-most_rad, most_rad);
    return axis_angle(direction(), rad);
  }
  Vec3 arrow(double long_m) { return times(direction(), long_m); }
  double distance_m() {
    return has(SceneKind::far_1_km) ? 1000 : has(SceneKind::far_50_m) ? 50 : random_.between(0, 2);
  }

  int add(const std::string& name, int parent, const Vec3& metres, const Vec3& scale);
  Map placed(int node) const;
  void make_above();
  Vec3 joint_scale(int parent, bool leaf);
  void make_skeleton(int number);
  void make_mesh(const std::vector<int>& joints);
  void make_prop();
  void morph(MadeMesh& mesh, double unit);
  void make_watcher();
  void spoil_rest();
  std::vector<float> key_times();
  void keep(MadeChannel channel, MadeClip& clip);
  void move(int node, const char* path, MadeClip& clip);
  void move_weights(const MadeMesh& mesh, MadeClip& clip);
  void make_clip(const std::string& name, bool of_pack);
  void make_additive();

  Random random_;
  RandomScene out_;
  MadeScene scene_;
  bool packed_ = false;
  double metres_ = 1;         // how large the character is, roughly
  std::vector<double> unit_;  // a node: metres a unit in its space
  std::vector<std::vector<int>> skeletons_;
  std::vector<int> movers_, watchers_;
  int above_ = -1;
  float begin_s_ = 0;
  std::vector<float> times_s_;  // of the clip's last channel: most have the same
};

// metres: from its parent.
int Maker::add(const std::string& name, int parent, const Vec3& metres, const Vec3& scale) {
  const double unit = parent < 0 ? 1 : unit_[static_cast<std::size_t>(parent)];
  scene_.nodes.push_back({name, parent, times(metres, 1 / unit), normalised(random_.rotation()), scale, {}});
  unit_.push_back(unit * std::cbrt(std::fabs(scale[0] * scale[1] * scale[2])));
  return static_cast<int>(scene_.nodes.size()) - 1;
}

Map Maker::placed(int node) const {
  Map m;
  for (; node >= 0; node = scene_.nodes[static_cast<std::size_t>(node)].parent) {
    const MadeNode& n = scene_.nodes[static_cast<std::size_t>(node)];
    m = from_trs(n.translation, n.rotation, n.scale) * m;
  }
  return m;
}

void Maker::make_above() {
  double scale = 1;
  if (has(SceneKind::scale_above)) {
    scale = power(-3, 3);
    if (chance(0.5)) metres_ = scale;
  }
  Vec3 axes = {scale, scale, scale};
  if (has(SceneKind::mirrored) && chance(0.5)) axes[random_.below(3)] *= -1;
  above_ = add("above", -1, arrow(distance_m()), axes);
  if (!has(SceneKind::animated_above)) return;
  const double unit = chance(0.7) ? 100 : 0.01;
  above_ = add("mover", above_, arrow(25 * random_.between(0, 1) + 25), {unit, unit, unit});
  movers_.push_back(above_);
}

Vec3 Maker::joint_scale(int parent, bool leaf) {
  const double unit = unit_[static_cast<std::size_t>(parent)];
  double scale = 1;
  if (has(SceneKind::scale_within) && chance(0.5)) scale = std::clamp(power(-3, 3), 1e-3 / unit, 1e3 / unit);
  if (has(SceneKind::uneven_rests)) scale = (unit > 1 ? 3e-3 : 300) / unit;
  Vec3 axes = {scale, scale, scale};
  for (double& axis : axes) {
    if (leaf && chance(0.3)) axis *= random_.between(0.5, 2);
    if (has(SceneKind::mirrored) && chance(0.3)) axis *= -1;
  }
  return axes;
}

void Maker::make_skeleton(int number) {
  const bool deep = has(SceneKind::deep);
  const std::uint32_t count = deep ? 8 + random_.below(5) : 2 + random_.below(4);
  const std::uint32_t roots = has(SceneKind::several_roots) ? 2 + random_.below(2) : 1;
  std::vector<int> joints;
  for (std::uint32_t i = 0; i < count; ++i) {
    const bool root = i < roots;
    const std::size_t up = deep && !chance(0.1) ? joints.size() - 1 : random_.below(i + 1) % std::max(i, 1U);
    const int parent = root ? above_ : joints[up];
    const double far = root && i > 0 && chance(0.3) ? 30 : 1;
    const Vec3 metres = arrow(random_.between(0.05, 0.5) * far * metres_);
    joints.push_back(add("joint " + std::to_string(number) + "." + std::to_string(i), parent, metres,
                         joint_scale(parent, !root && i + 1 == count)));
  }
  skeletons_.push_back(joints);
}

void Maker::make_mesh(const std::vector<int>& joints) {
  MadeMesh mesh;
  mesh.joints = joints;
  const double unit = has(SceneKind::scale_above) || has(SceneKind::scale_within) ? power(-2, 2) : 1;
  const Vec3 centre = chance(0.5) ? origin(placed(joints[0])) : Vec3{0, 0, 0};
  const Map model_from_mesh = from_trs(centre, {0, 0, 0, 1}, {unit, unit, unit});
  for (const int joint : joints) {
    const Map bind = inverse(placed(joint)) * model_from_mesh;
    for (int c = 0; c < 4; ++c)
      for (int r = 0; r < 4; ++r)
        mesh.inverse_bind.push_back(r < 3 ? static_cast<float>(bind.rows[r][c]) : c < 3 ? 0.0f : 1.0f);
  }
  const auto count = static_cast<std::uint32_t>(joints.size());
  for (std::uint32_t v = 0; v < std::min(50U, 4 * count); ++v) {
    const Vec3 at = plus(origin(placed(joints[v % count])), arrow(random_.between(0.02, 0.2) * metres_));
    for (const double x : times(plus(at, times(centre, -1)), 1 / unit)) mesh.positions.push_back(static_cast<float>(x));
    double left = 1;
    for (std::uint32_t i = 0; i < 4; ++i) {
      const double weight = i == 3 ? left : left * (chance(0.3) ? 1 : random_.between(0.2, 1));
      left -= weight;
      const auto other = static_cast<unsigned char>((v + i) % count);
      mesh.of.push_back(i < count ? other : static_cast<unsigned char>(0));
      mesh.weights.push_back(static_cast<float>(weight));
    }
  }
  mesh.node = add("body " + std::to_string(scene_.meshes.size()), -1, {0, 0, 0}, {1, 1, 1});
  if (has(SceneKind::morphed)) morph(mesh, unit);
  scene_.meshes.push_back(std::move(mesh));
}

// A mesh that hangs on a joint.
void Maker::make_prop() {
  MadeMesh mesh;
  const std::vector<int>& joints = skeletons_[random_.below(static_cast<std::uint32_t>(skeletons_.size()))];
  mesh.node = joints[random_.below(static_cast<std::uint32_t>(joints.size()))];
  const double unit = unit_[static_cast<std::size_t>(mesh.node)];
  for (int v = 0; v < 5; ++v)
    for (const double x : arrow(random_.between(0.02, 0.3) * metres_ / unit))
      mesh.positions.push_back(static_cast<float>(x));
  if (has(SceneKind::morphed) && chance(0.5)) morph(mesh, unit);
  scene_.meshes.push_back(std::move(mesh));
}

void Maker::morph(MadeMesh& mesh, double unit) {
  mesh.targets.resize(1 + random_.below(3));
  for (std::vector<float>& target : mesh.targets) {
    for (std::size_t v = 0; v < mesh.positions.size() / 3; ++v)
      for (const double x : arrow(chance(0.7) ? power(-3, 0.5) * metres_ / unit : 0))
        target.push_back(static_cast<float>(x));
    mesh.target_weights.push_back(static_cast<float>(chance(0.5) ? random_.between(-0.5, 1) : 0));
  }
}

// What draws nothing, and goes far away.
void Maker::make_watcher() {
  const int parent = chance(0.7) ? -1 : skeletons_[0].back();
  for (const MadeNodeKind kind : {MadeNodeKind::camera, MadeNodeKind::light}) {
    if (kind == MadeNodeKind::light && chance(0.5)) continue;
    watchers_.push_back(
        add(kind == MadeNodeKind::camera ? "camera" : "light", parent, arrow(power(1.8, 3)), {1, 1, 1}));
    scene_.nodes.back().kind = kind;
  }
}

// Meshes are bound by now.
void Maker::spoil_rest() {
  for (const std::vector<int>& joints : skeletons_)
    for (const int joint : joints) {
      MadeNode& node = scene_.nodes[static_cast<std::size_t>(joint)];
      if (has(SceneKind::rest_is_not_bind)) {
        node.rotation = normalised(turn(0.5) * node.rotation);
        node.translation = times(node.translation, random_.between(0.8, 1.25));
      }
    }
  // A scale of 0 is mended to a millionth, which is not little where scales are as small.
  if (has(SceneKind::additive_over_zero) && chance(0.5) && !has(SceneKind::uneven_rests) &&
      !has(SceneKind::scale_within))
    scene_.nodes[static_cast<std::size_t>(skeletons_[0].back())].scale = {0, 0, 0};
}

std::vector<float> Maker::key_times() {
  if (!times_s_.empty() && chance(0.8)) return times_s_;
  const bool many = chance(0.5), even = chance(0.6);
  const std::uint32_t count = many ? 12 + random_.below(10) : 2 + random_.below(5);
  std::vector<float> out;
  double time_s = static_cast<double>(begin_s_);
  for (std::uint32_t i = 0; i < count; ++i) {
    out.push_back(static_cast<float>(time_s));
    time_s += (many ? 1.0 : 8.0) * (even ? 1.0 / 30 : random_.between(0.02, 0.06));
  }
  times_s_ = out;
  return out;
}

// Tangents for splines, and a second key at a time where the scene has such.
void Maker::keep(MadeChannel channel, MadeClip& clip) {
  const std::size_t keys = channel.times_s.size(), size = channel.values.size() / keys;
  const double draw = random_.between(0, 1);
  const bool mixed = has(SceneKind::interpolations);
  channel.interpolation = draw < (mixed ? 0.33 : 0.05)  ? "STEP"
                          : draw < (mixed ? 0.66 : 0.2) ? "CUBICSPLINE"
                                                        : "LINEAR";
  if (has(SceneKind::two_keys_at_once) && keys > 3 && channel.path != "weights") {
    const std::size_t k = 1 + random_.below(static_cast<std::uint32_t>(keys - 3));
    channel.times_s[k + 1] = channel.times_s[k];
  }
  if (channel.interpolation == "CUBICSPLINE") {
    std::vector<float> all;
    for (std::size_t k = 0; k < keys; ++k)
      for (int part = 0; part < 3; ++part)
        for (std::size_t i = 0; i < size; ++i) {
          const float value = channel.values[k * size + i];
          all.push_back(part == 1 ? value : static_cast<float>(random_.between(-0.5, 0.5)) * value);
        }
    channel.values = std::move(all);
  }
  clip.channels.push_back(std::move(channel));
}

// Along smooth curves, but for jumps that the scene has.
void Maker::move(int node, const char* path, MadeClip& clip) {
  const MadeNode& at = scene_.nodes[static_cast<std::size_t>(node)];
  MadeChannel channel{node, path, "", key_times(), {}};
  const bool turns = channel.path == "rotation", shifts = channel.path == "translation";
  const Vec3 axis = direction();
  const double size = shifts ? length(at.translation) * 0.4 : turns ? 1 : 0.4;
  const double speed = random_.between(2, 9), amplitude = random_.between(0, 1);
  const bool zero = has(SceneKind::additive_over_zero) && clip.name == "layer" && node == skeletons_[0].back();
  for (const float time_s : channel.times_s) {
    const double wave = size * amplitude * std::sin(speed * static_cast<double>(time_s - begin_s_) + 3 * amplitude);
    std::vector<double> value;
    if (turns)
      for (const double q : axis_angle(axis, wave) * at.rotation) value.push_back(q);
    for (std::size_t i = 0; !turns && i < 3; ++i)
      value.push_back(shifts ? at.translation[i] + wave * axis[i] : at.scale[i] * (1 + wave * axis[i]));
    if (zero && channel.path == "scale") value.assign(3, std::min(1.0, 4 * static_cast<double>(time_s - begin_s_)));
    for (const double x : value) channel.values.push_back(static_cast<float>(x));
  }
  keep(std::move(channel), clip);
}

void Maker::move_weights(const MadeMesh& mesh, MadeClip& clip) {
  MadeChannel channel{mesh.node, "weights", "", key_times(), {}};
  for (std::size_t i = 0; i < channel.times_s.size() * mesh.targets.size(); ++i)
    channel.values.push_back(static_cast<float>(random_.between(-0.5, 1.5)));
  keep(std::move(channel), clip);
}

void Maker::make_clip(const std::string& name, bool of_pack) {
  begin_s_ = has(SceneKind::late_clip) ? static_cast<float>(random_.between(60, 900))
             : chance(0.7)             ? 0.0f
                                       : static_cast<float>(random_.between(0, 0.2));
  times_s_.clear();
  MadeClip clip{name, of_pack, {}};
  for (const std::vector<int>& joints : skeletons_)
    for (const int joint : joints) {
      if (joint == joints[0] || chance(0.6)) move(joint, "rotation", clip);
      if (chance(0.25)) move(joint, "translation", clip);
      const bool grows = has(SceneKind::additive_over_zero) && joint == skeletons_[0].back();
      if (chance(0.15) || grows) move(joint, "scale", clip);
    }
  for (const int mover : movers_)
    for (const char* path : {"translation", "rotation"}) move(mover, path, clip);
  for (const int watcher : watchers_)
    if (!of_pack) move(watcher, "translation", clip);
  for (const MadeMesh& mesh : scene_.meshes)
    if (!mesh.targets.empty() && !of_pack) move_weights(mesh, clip);
  scene_.clips.push_back(std::move(clip));
}

void Maker::make_additive() {
  make_clip("layer", false);
  const bool rests_at_zero = scene_.nodes[static_cast<std::size_t>(skeletons_[0].back())].scale[0] == 0;
  const std::uint32_t over = has(SceneKind::additive_over_zero) && !rests_at_zero ? 0 : random_.below(3);
  out_.additive.emplace_back("layer", over == 0 ? "first" : over == 1 ? "rest" : "move");
}

RandomScene Maker::make() {
  make_above();
  make_skeleton(0);
  if (has(SceneKind::several_skins)) make_skeleton(1);
  for (const std::vector<int>& joints : skeletons_) make_mesh(joints);
  if (chance(0.3)) make_prop();
  if (has(SceneKind::far_camera)) make_watcher();
  spoil_rest();
  make_clip("move", false);
  if (has(SceneKind::additive) || has(SceneKind::additive_over_zero)) make_additive();
  if (packed_) {
    make_clip("of a pack", true);
    constexpr double kUnits[] = {100, 0.01, 39.37, 1000};
    if (has(SceneKind::pack_of_another_unit)) scene_.pack_unit = kUnits[random_.below(4)];
    if (chance(0.4)) {
      scene_.turned = skeletons_[0].back();
      scene_.turned_to = normalised(turn(1) * scene_.nodes[static_cast<std::size_t>(scene_.turned)].rotation);
    }
    out_.pack = pack_text_of(scene_);
  }
  out_.character = text_of(scene_, false);
  out_.together = text_of(scene_, true);
  constexpr double kErrors[] = {1e-4, 5e-4, 2e-3};
  out_.clip_error = kErrors[random_.below(3)];
  return std::move(out_);
}

}  // namespace

const char* name_of(SceneKind kind) {
  static constexpr std::array<const char*, kSceneKinds> kNames = {"plain",
                                                                  "deep",
                                                                  "scale above",
                                                                  "scale within",
                                                                  "mirrored",
                                                                  "50 m away",
                                                                  "1 km away",
                                                                  "animated above",
                                                                  "far camera",
                                                                  "several roots",
                                                                  "several skins",
                                                                  "additive",
                                                                  "additive over zero",
                                                                  "morphed",
                                                                  "uneven rests",
                                                                  "rest is not bind",
                                                                  "pack",
                                                                  "pack of another unit",
                                                                  "interpolations",
                                                                  "two keys at once",
                                                                  "late clip"};
  return kNames[static_cast<std::size_t>(kind)];
}

RandomScene random_scene(std::uint32_t number) {
  return Maker(number).make();
}

}  // namespace marrow::test
