// The rows sample/ORDER/CLIP: a whole pose of a clip an iteration, at times in four orders.
#include "bench/workload.h"
#include "pose/evaluate.h"

namespace marrow::tools {
namespace {

constexpr std::size_t kMoments = 1024;  // in random order
constexpr float kFrame_s = 1.0f / 60;

struct ClipName {
  const char* row;
  const ModelSource* model;
  const char* clip;
};
constexpr ClipName kClips[] = {
    {"pab_walk_raw", &kPab, "pab_walk_raw"}, {"pab_jog_raw", &kPab, "pab_jog_raw"},
    {"pab_run_raw", &kPab, "pab_run_raw"},   {"pab_atlas_raw", &kPab, "pab_atlas_raw"},
    {"CesiumMan", &kCesiumMan, ""},          {"ruby", &kRuby, "ruby_animation"},
    {"newt_idle", &kNewt, "idle"},           {"newt_walk", &kNewt, "walk"},
    {"newt_twist", &kNewt, "twist"},         {"newt_reach", &kNewt, "reach"},
};

struct Order {
  const char* name;
  std::size_t players;  // in turn, each at its own moment and into its own pose
  float step_s;         // 0: random moments
  bool cached;          // by sample_cached()
};
constexpr Order kOrders[] = {
    {"forward", 1, kFrame_s, false}, {"random", 1, 0, false},        {"backward", 1, -kFrame_s, false},
    {"crowd", 512, kFrame_s, false}, {"playing", 1, kFrame_s, true},
};

class Sampling : public Workload {
 public:
  Sampling(const ClipOfModel& source, const Order& order)
      : source_(source), step_s_(order.step_s), cached_(order.cached), players_(order.players), times_s_(kMoments) {
    for (std::size_t i = 0; i < players_.size(); ++i) {
      players_[i].time_s = source.clip.duration_s * static_cast<float>(i) / static_cast<float>(players_.size());
      players_[i].pose.resize(source.skeleton.soa_size());
      if (order.cached) players_[i].frames.resize(sample_cache_bytes(source.clip));
      players_[i].cache.memory = players_[i].frames;
    }
    Noise noise;
    for (float& time_s : times_s_) time_s = noise.next() * source.clip.duration_s;
  }
  std::uint32_t items() const override { return source_.skeleton.joint_count; }
  std::uint32_t period() const override { return 512; }
  std::uint64_t hash_output(std::uint64_t state) const override { return hash_of(players_[last_].pose, state); }
  void run(std::uint64_t iterations) override {
    for (std::uint64_t i = 0; i < iterations; ++i) {
      last_ = last_ + 1 < players_.size() ? last_ + 1 : 0;
      Player& player = players_[last_];
      advance(player.time_s);
      check(cached_ ? sample_cached(source_.skeleton, source_.clip, player.time_s, player.pose, player.cache)
                    : sample(source_.skeleton, source_.clip, player.time_s, player.pose));
    }
  }

 private:
  struct Player {
    float time_s;
    std::vector<SoaTransform> pose;
    std::vector<std::byte> frames;
    SampleCache cache;
  };
  void advance(float& time_s) {
    if (step_s_ == 0) {
      time_s = times_s_[moment_];
      moment_ = (moment_ + 1) % kMoments;
      return;
    }
    time_s += step_s_;
    if (time_s >= source_.clip.duration_s) time_s -= source_.clip.duration_s;
    if (time_s < 0) time_s += source_.clip.duration_s;
  }

  ClipOfModel source_;
  float step_s_;
  bool cached_;
  std::vector<Player> players_;
  std::vector<float> times_s_;  // random order
  std::size_t last_ = 0, moment_ = 0;
};

}  // namespace

RowGroup sampling_rows() {
  RowGroup group;
  std::vector<std::string> orders, clips;
  for (const Order& order : kOrders) orders.emplace_back(order.name);
  for (const ClipName& clip : kClips) {
    clips.emplace_back(clip.row);
    for (const Order& order : kOrders) {
      const auto make_row = [order, clip](Models& models) {
        return std::make_unique<Sampling>(find_clip(*clip.model, models.get(*clip.model), clip.clip), order);
      };
      group.rows.push_back({fmt::format("sample/{}/{}", order.name, clip.row), clip.model, {clip.clip}, make_row});
    }
  }
  group.names = fmt::format("sample/{}/{}\n", choice(orders), choice(clips));
  return group;
}

}  // namespace marrow::tools
