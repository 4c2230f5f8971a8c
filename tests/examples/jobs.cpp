// Two hundred characters over a game's own threads. Meanwhile another file is unpacked, a millisecond a frame, and
// takes the place of theirs while they walk.
#include <marrow/block.h>
#include <marrow/draco.h>
#include <marrow/marrow.h>
#include <marrow/meshopt.h>

#include <atomic>
#include <barrier>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <functional>
#include <iterator>
#include <memory>
#include <thread>
#include <vector>

using Clock = std::chrono::steady_clock;
constexpr std::size_t kCharacters = 200;
constexpr float kFrame_s = 1.0f / 60;

double ms_since(Clock::time_point then) {
  return std::chrono::duration<double, std::milli>(Clock::now() - then).count();
}

// Stands for the job system that a game has: its threads take numbers until there are none left.
class Jobs {
 public:
  explicit Jobs(unsigned threads) : begin_(threads), end_(threads) {
    for (unsigned i = 1; i < threads; ++i) threads_.emplace_back([this] { work(); });
  }
  ~Jobs() {
    job_ = nullptr;
    begin_.arrive_and_wait();
    for (std::thread& thread : threads_) thread.join();
  }
  void run(std::size_t count, std::function<void(std::size_t)> job) {
    job_ = std::move(job);
    count_ = count;
    next_ = 0;
    begin_.arrive_and_wait();
    take();
    end_.arrive_and_wait();
  }

 private:
  void work() {
    for (begin_.arrive_and_wait(); job_ != nullptr; begin_.arrive_and_wait()) {
      take();
      end_.arrive_and_wait();
    }
  }
  void take() {
    for (std::size_t i = next_++; i < count_; i = next_++) job_(i);
  }
  std::barrier<> begin_, end_;
  std::function<void(std::size_t)> job_;
  std::size_t count_ = 0;
  std::atomic<std::size_t> next_ = 0;
  std::vector<std::thread> threads_;
};

// A packed file on its way into memory.
struct Loading {
  std::vector<char> packed;
  std::vector<std::byte> memory;
  marrow::Unpacking unpacking;
};

bool begin(const char* path, Loading& out) {
  static const marrow::MeshDecoder decoders[] = {marrow::draco_decoder(), marrow::meshopt_decoder()};
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return std::perror(path), false;
  out.packed.assign(std::istreambuf_iterator<char>(stream), {});
  const marrow::Span<const std::byte> packed(reinterpret_cast<const std::byte*>(out.packed.data()), out.packed.size());
  marrow::UnpackSizes sizes;
  if (unpack_sizes(packed, sizes) != marrow::Status::ok) return false;
  out.memory.resize(marrow::block_bytes(sizes.memory_bytes));
  return begin_unpack(packed, decoders, marrow::block_in(out.memory), out.unpacking) == marrow::Status::ok;
}

// A file with its animations, and characters that play them. All threads read the file; each writes to its characters.
struct Cast {
  std::vector<std::byte> memory, shared, own;
  marrow::File file;
  marrow::Animations animations;
  const marrow::Animation* walk = nullptr;
  std::vector<marrow::Character> characters;
};

std::unique_ptr<Cast> make_cast(Loading& loading) {
  auto cast = std::make_unique<Cast>();
  cast->memory = std::move(loading.memory);
  if (load(loading.unpacking.file, cast->file) != marrow::Status::ok) return nullptr;
  const std::size_t bytes = character_bytes(cast->file, {});
  cast->shared.resize(animations_bytes(cast->file, cast->file));
  cast->own.resize(kCharacters * bytes);
  cast->characters.resize(kCharacters);
  if (make_animations(cast->file, cast->file, cast->shared, cast->animations) != marrow::Status::ok) return nullptr;
  cast->walk = find_animation(cast->animations, "walk");
  for (std::size_t i = 0; i < kCharacters; ++i)
    if (make_character(cast->file, {}, {cast->own.data() + i * bytes, bytes}, cast->characters[i]) !=
        marrow::Status::ok)
      return nullptr;
  return cast->walk == nullptr ? nullptr : std::move(cast);
}

int main(int argc, char** argv) {
  Loading first, second;
  if (argc < 3 || !begin(argv[1], first)) return 1;
  while (first.unpacking.file.empty())
    if (unpack_step(first.unpacking) != marrow::Status::ok) return 1;
  std::unique_ptr<Cast> cast = make_cast(first);
  if (cast == nullptr || !begin(argv[2], second)) return 1;

  std::vector<marrow::Playback> playbacks(kCharacters);
  for (std::size_t i = 0; i < kCharacters; ++i) playbacks[i].time_s = 0.005 * double(i);
  std::atomic<bool> failed = false;
  int steps = 0, changed_at = -1;
  double longest_ms = 0;
  Jobs jobs(std::thread::hardware_concurrency());
  for (int frame = 0; frame < 120 && !failed; ++frame) {
    // Jobs touch one character each, so that they never wait for one another.
    jobs.run(kCharacters, [&](std::size_t i) {
      if (advance(playbacks[i], cast->walk->duration_s, kFrame_s) != marrow::Status::ok ||
          pose_character(cast->characters[i], {{cast->walk, clip_time(playbacks[i])}}) != marrow::Status::ok ||
          finish_character(cast->characters[i]) != marrow::Status::ok)
        failed = true;
    });
    if (changed_at >= 0) continue;
    for (const Clock::time_point begun = Clock::now(); second.unpacking.file.empty() && ms_since(begun) < 1; ++steps) {
      const Clock::time_point step = Clock::now();
      if (unpack_step(second.unpacking) != marrow::Status::ok) return 1;
      longest_ms = ms_since(step) > longest_ms ? ms_since(step) : longest_ms;
    }
    if (second.unpacking.file.empty()) continue;
    // No job runs now: what they read may go. Playbacks go on, for they know no file.
    cast = make_cast(second);
    if (cast == nullptr) return 1;
    changed_at = frame;
  }
  if (failed || changed_at < 0) return 1;
  std::printf("%zu characters; the other file took %d steps, the longest %.2f ms, and their place in frame %d\n",
              kCharacters, steps, longest_ms, changed_at);
}
