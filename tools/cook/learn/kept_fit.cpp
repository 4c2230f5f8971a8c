#include "cook/learn/kept_fit.h"

#include <cmath>
#include <cstring>
#include <type_traits>
#include <utility>

#include "common/hash.h"

namespace marrow::cook {
namespace {

// Values one after the other, lists with their length in front.
class Writer {
 public:
  template <typename T>
  requires std::is_arithmetic_v<T> || std::is_enum_v<T>
  void add(T value) {
    char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    out_.append(bytes, sizeof value);
  }
  template <glm::length_t N>
  void add(const glm::vec<N, double>& v) {
    for (glm::length_t i = 0; i < N; ++i) add(v[i]);
  }
  template <glm::length_t C, glm::length_t R>
  void add(const glm::mat<C, R, double>& m) {
    for (glm::length_t i = 0; i < C; ++i) add(m[i]);
  }
  void add(const deform::Influence& i) {
    add(i.joint);
    add(i.weight);
  }
  void add(const deform::Coordinate& c) {
    add(c.joint);
    add(c.q);
  }
  void add(const deform::Helper& h) {
    add(h.first);
    add(h.second);
    add(h.share);
    add(h.centre);
    add(h.by_dual_quaternions);
  }
  void add(const ShownPose& p) {
    add(p.pose);
    add(p.positions);
    add(p.clip);
    add(p.time_s);
    add(p.share);
  }
  void add(const deform::TrainingPose& p) {
    add(p.pose);
    add(p.fold);
    add(p.shipped);
    add(p.learnt);
  }
  void add(const deform::MotionPose& p) {
    add(p.joint);
    add(p.kind);
    add(p.angle_rad);
    add(p.axis);
    add(p.centre);
    add(*p.turns);
  }
  void add(const deform::FramesInARow& frames) {
    for (const deform::Pose& pose : frames) add(pose);
  }
  void add(const std::vector<char>& bytes) {
    add(static_cast<std::uint64_t>(bytes.size()));
    out_.append(bytes.data(), bytes.size());
  }
  template <typename T>
  void add(const std::vector<T>& list) {
    add(static_cast<std::uint64_t>(list.size()));
    for (const T& item : list) add(item);
  }
  std::string take() { return std::move(out_); }

 private:
  std::string out_;
};

// Reads what Writer has written. Once something does not fit, all is 0 and ok() false.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : rest_(bytes) {}
  template <typename T>
  requires std::is_arithmetic_v<T>
  void get(T& out) {
    out = T{};
    if (rest_.size() < sizeof out) return fail();
    std::memcpy(&out, rest_.data(), sizeof out);
    rest_.remove_prefix(sizeof out);
    if constexpr (std::is_floating_point_v<T>) ok_ = ok_ && std::isfinite(out);
  }
  void get(bool& out) {
    std::uint8_t byte = 0;
    get(byte);
    out = byte != 0;
  }
  template <glm::length_t N>
  void get(glm::vec<N, double>& out) {
    for (glm::length_t i = 0; i < N; ++i) get(out[i]);
  }
  void get(deform::Influence& out) {
    get(out.joint);
    get(out.weight);
  }
  void get(deform::Coordinate& out) {
    get(out.joint);
    get(out.q);
  }
  void get(deform::Helper& out) {
    get(out.first);
    get(out.second);
    get(out.share);
    get(out.centre);
    get(out.by_dual_quaternions);
  }
  template <typename T>
  void get(std::vector<T>& out) {
    std::uint64_t count = 0;
    get(count);
    if (count > rest_.size()) return fail();  // each takes a byte at least
    for (std::uint64_t i = 0; i < count && ok_; ++i) get(out.emplace_back());
  }
  void fail() {
    ok_ = false;
    rest_ = {};
  }
  bool ok() const { return ok_; }
  bool at_end() const { return rest_.empty(); }

 private:
  std::string_view rest_;
  bool ok_ = true;
};

// By ascending joint, each below `count`.
template <typename Item>
bool ascends(const std::vector<Item>& items, std::size_t count) {
  for (std::size_t i = 0; i < items.size(); ++i)
    if (items[i].joint >= count || (i > 0 && items[i].joint <= items[i - 1].joint)) return false;
  return true;
}

bool fits(const Learnt& learnt, const deform::SkinnedMesh& mesh) {
  const std::size_t vertices = mesh.positions.size(), entries = mesh.joint_count + learnt.helpers.size();
  if (learnt.coordinates.size() != vertices || learnt.weights.size() != vertices) return false;
  for (std::size_t h = 0; h < learnt.helpers.size(); ++h)
    if (std::max(learnt.helpers[h].first, learnt.helpers[h].second) >= mesh.joint_count) return false;
  for (std::size_t v = 0; v < vertices; ++v)
    if (!ascends(learnt.coordinates[v], entries) || !ascends(learnt.weights[v], entries)) return false;
  return true;
}

}  // namespace

std::string fit_key(const DeformSource& source, const std::vector<deform::TrainingPose>& poses,
                    const LearnOptions& options) {
  Writer w;
  w.add(source.mesh.positions);
  w.add(source.mesh.indices);
  w.add(source.mesh.influences);
  w.add(source.mesh.joint_count);
  w.add(source.parents);
  w.add(source.centres);
  w.add(source.inverse_bind);
  w.add(source.shown);
  w.add(source.motion);
  w.add(source.frames);
  w.add(poses);
  w.add(options.animation_space);
  w.add(options.truth);
  w.add(options.delta_mush.iterations);
  w.add(options.delta_mush.step);
  w.add(options.delta_mush.weights);
  w.add(options.elastic.volume);
  w.add(options.elastic.keep);
  w.add(options.helpers);
  w.add(options.influences);
  w.add(options.keep_bind_pose);
  const std::string all = w.take();
  return tools::hash_of(std::as_bytes(std::span(all.data(), all.size())));
}

std::string to_bytes(const Learnt& learnt) {
  Writer w;
  w.add(learnt.coordinates);
  w.add(learnt.weights);
  w.add(learnt.helpers);
  w.add(learnt.quality.share);
  w.add(learnt.quality.worse_share);
  w.add(learnt.rms_m);
  return w.take();
}

std::optional<Learnt> from_bytes(std::string_view bytes, const deform::SkinnedMesh& mesh) {
  Reader r(bytes);
  Learnt out;
  r.get(out.coordinates);
  r.get(out.weights);
  r.get(out.helpers);
  r.get(out.quality.share);
  r.get(out.quality.worse_share);
  r.get(out.rms_m);
  if (!r.ok() || !r.at_end() || !fits(out, mesh)) return std::nullopt;
  return out;
}

Learnt learn_or_find(const DeformSource& source, std::vector<deform::TrainingPose> poses, const LearnOptions& options,
                     Notes& notes) {
  const deform::Progress progress = notes.progress_of(Stage::learn);
  Fits* const kept = notes.host != nullptr ? notes.host->fits : nullptr;
  if (kept == nullptr) return learn(source, std::move(poses), options, progress);
  const std::string key = fit_key(source, poses, options);
  if (const std::optional<std::string> bytes = kept->find(key))
    if (std::optional<Learnt> learnt = from_bytes(*bytes, source.mesh)) return std::move(*learnt);
  Learnt learnt = learn(source, std::move(poses), options, progress);
  kept->keep(key, to_bytes(learnt));
  return learnt;
}

}  // namespace marrow::cook
