// What the self-test does besides: taking times, saying what it tries, and leaving a context as it was.
#include <array>
#include <chrono>
#include <cstdio>
#include <limits>
#include <thread>

#include "gl/support/self_test_run.h"
#include "marrow/egl.h"

namespace marrow::test {
namespace {

// Seconds that each path takes a frame; the clock moves when GL is waited for.
struct FakeTime {
  double now = 0;
  double frame[gles3::kPathCount] = {1, 1, 1, 1, 1};
  double draw[gles3::kPathCount] = {};  // and so much for each character in each pass
  std::size_t path = 0;
  std::int64_t waits = 0;
  double between = 0;  // every third frame takes so much longer
};
FakeTime fake;

Outcome run_timed(const FakeTime& time, double (*seconds)(void*), std::uint32_t vertices = 2048,
                  std::uint32_t characters = 4) {
  fake = time;
  gles3::Api api = faulty_api(gl());
  api.Finish = [] { fake.now += fake.frame[fake.path] + (++fake.waits % 3 == 1 ? fake.between : 0); };
  api.DrawElements = [](unsigned mode, int count, unsigned type, const void* offset) {
    fake.now += fake.draw[fake.path];
    driver().real.DrawElements(mode, count, type, offset);
  };
  api.DrawElementsInstanced = [](unsigned mode, int count, unsigned type, const void* offset, int instances) {
    fake.now += instances * fake.draw[fake.path];
    driver().real.DrawElementsInstanced(mode, count, type, offset, instances);
  };
  gles3::SelfTestOptions options = one_deformer();
  options.timed_vertices = vertices;
  options.timed_characters = characters;
  options.seconds = seconds;
  options.user = &fake;
  options.about_to_try = [](void* user, SkinningPath path) {
    static_cast<FakeTime*>(user)->path = static_cast<std::size_t>(path);
  };
  return run(api, gl().caps(), options);
}

double fake_seconds(void* user) {
  return static_cast<FakeTime*>(user)->now;
}

TEST(SelfTest, SlowIsFourTimesTheFastest) {
  FakeTime time;
  // ubo, texture, feedback, compute, cpu
  const double seconds[] = {0.001, 0.0039, 0.0041, 0.0039, 0.1};
  for (std::size_t i = 0; i < gles3::kPathCount; ++i) time.frame[i] = seconds[i];
  time.between = 0.5;
  const Outcome outcome = run_timed(time, fake_seconds);
  expect(outcome, kFeedback, Verdict::slow, "feedback");
  // Four characters of 2048 slots: 0.001 s / 8192 = 122.07 ns.
  EXPECT_NEAR(outcome.of(SkinningPath::ubo).ns_per_vertex, 122.07f, 0.01f);
  EXPECT_NEAR(outcome.of(SkinningPath::cpu).ns_per_vertex, 12207.03f, 1.0f);
  time.frame[4] = 1e-6;
  expect(run_timed(time, fake_seconds), kFeedback, Verdict::slow, "a fast CPU rules nothing out");
  time.frame[2] = 0.0009;
  time.frame[0] = 0.004;
  expect(run_timed(time, fake_seconds), kUbo | kTexture | kCompute, Verdict::slow, "the fastest is feedback");
}

// What skins once a frame, and what a character costs in each pass, as measured by a driver's own clock.
TEST(SelfTest, TheFastestPathIsChosenOnDriversThatAreFastInEach) {
  constexpr double kMs = 1e-3;
  for (std::size_t fast = 0; fast < 4; ++fast) {
    if (fast == 3 && !gl().caps().compute) continue;
    FakeTime time;
    for (std::size_t i = 0; i < gles3::kPathCount; ++i) {
      const bool ahead = i >= 2;
      time.frame[i] = ahead ? 3 * kMs : 0.5 * kMs;
      time.draw[i] = ahead ? 0.1 * kMs : 0.6 * kMs;
    }
    time.frame[fast] *= 0.4;
    time.draw[fast] *= 0.4;
    const Outcome outcome = run_timed(time, fake_seconds, 1000, 3);  // 992 vertices
    expect(outcome, 0, Verdict::usable, "all are right");
    const gles3::PathResult& result = outcome.test.paths[fast];
    EXPECT_NEAR(result.ns_per_vertex, 1e9 * (time.frame[fast] + 3 * time.draw[fast]) / (992 * 3), 0.1);
    EXPECT_NEAR(result.ns_per_pass, 1e9 * 3 * time.draw[fast] / (992 * 3), 0.1);
    SkinningPath chosen = SkinningPath::cpu;
    // 0.92 ms and 0.72 ms a pass more, against 1.32 and 0.12 of one that skins once.
    EXPECT_EQ(gles3::choose(outcome.test, {fast < 2 ? 1u : 2u, 3, 20}, chosen), Status::ok);
    EXPECT_EQ(to_string(chosen), to_string(static_cast<SkinningPath>(fast)));
    EXPECT_EQ(gles3::choose(outcome.test, {1, 3, 1000}, chosen), Status::ok);
    EXPECT_EQ(to_string(chosen), to_string(SkinningPath::texture)) << "the only one with room";
  }
  // With more passes the ones that skin once win, by hand: 0.5 + 1.8 p against 3 + 0.3 p ms is even at 1.67.
  FakeTime time;
  for (std::size_t i = 0; i < gles3::kPathCount; ++i) {
    time.frame[i] = i >= 2 ? 3 * kMs : 0.5 * kMs;
    time.draw[i] = i >= 2 ? 0.1 * kMs : 0.6 * kMs;
  }
  time.frame[2] = 2.8 * kMs;  // feedback before compute
  const Outcome outcome = run_timed(time, fake_seconds, 2048, 3);
  SkinningPath chosen = SkinningPath::cpu;
  EXPECT_EQ(gles3::choose(outcome.test, {1, 1, 20}, chosen), Status::ok);
  EXPECT_EQ(to_string(chosen), to_string(SkinningPath::ubo)) << "alike, so the first of the table";
  EXPECT_EQ(gles3::choose(outcome.test, {1, 100, 20}, chosen), Status::ok);
  EXPECT_EQ(to_string(chosen), to_string(SkinningPath::texture)) << "alike, and drawn together";
  EXPECT_EQ(gles3::choose(outcome.test, {2, 100, 20}, chosen), Status::ok);
  EXPECT_EQ(to_string(chosen), to_string(SkinningPath::feedback));
  EXPECT_EQ(gles3::choose(outcome.test, {4'000'000'000u, 1, 20}, chosen), Status::ok);
}

TEST(SelfTest, AClockThatGoesAstrayRulesNothingOut) {
  const auto nan = [](void*) { return std::numeric_limits<double>::quiet_NaN(); };
  const auto back = [](void* user) { return static_cast<FakeTime*>(user)->now -= 1; };
  const auto still = [](void*) { return 0.0; };
  const auto leaping = [](void* user) {
    return static_cast<FakeTime*>(user)->now = 1e300 - static_cast<FakeTime*>(user)->now;
  };
  for (double (*const seconds)(void*) : {+nan, +back, +still, +leaping}) {
    const Outcome outcome = run_timed({}, seconds);
    expect(outcome, 0, Verdict::usable, "astray");
    for (const gles3::PathResult& path : outcome.test.paths) EXPECT_EQ(path.ns_per_vertex, 0.0f);
  }
}

TEST(SelfTest, TakesTimeByARealClock) {
  gles3::SelfTestOptions options;
  options.seconds = [](void*) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  };
  const Outcome outcome = run(faulty_api(gl()), gl().caps(), options);
  ASSERT_EQ(outcome.status, Status::ok);
  for (std::uint32_t i = 0; i < gles3::kPathCount; ++i) {
    const gles3::PathResult& result = outcome.test.paths[i];
    std::printf("%-8s %.5f %.5f %6.0f ns %s\n", to_string(static_cast<SkinningPath>(i)), double{result.position_error},
                double{result.normal_error}, double{result.ns_per_vertex}, to_string(result.verdict));
    EXPECT_TRUE(result.verdict != Verdict::usable || result.ns_per_vertex > 0.1f);
  }
}

// What the game would find stored if the process came to its end in the middle of a path.
TEST(SelfTest, SaysWhatItIsAboutToTry) {
  static std::vector<SkinningPath> tried;
  static int calls_seen = 0;
  tried.clear();
  calls_seen = 0;
  gles3::Api api = faulty_api(gl());
  api.BeginTransformFeedback = [](unsigned mode) {
    EXPECT_EQ(tried.back(), SkinningPath::feedback);
    ++calls_seen;
    driver().real.BeginTransformFeedback(mode);
  };
  api.TexSubImage2D = [](unsigned target, int level, int x, int y, int width, int height, unsigned format,
                         unsigned type, const void* texels) {
    EXPECT_EQ(tried.back(), SkinningPath::texture);
    ++calls_seen;
    driver().real.TexSubImage2D(target, level, x, y, width, height, format, type, texels);
  };
  api.CompileShader = [](unsigned shader) {
    EXPECT_FALSE(tried.empty());
    driver().real.CompileShader(shader);
  };
  gles3::SelfTestOptions options = one_deformer();
  options.about_to_try = [](void*, SkinningPath path) { tried.push_back(path); };
  options.paths = kUbo | kTexture | kFeedback | kCpu;
  options.crashed = kUbo;
  const Outcome outcome = run(api, gl().caps(), options);
  EXPECT_EQ(tried, (std::vector<SkinningPath>{SkinningPath::texture, SkinningPath::feedback, SkinningPath::cpu}));
  EXPECT_GT(calls_seen, 4);
  EXPECT_EQ(outcome.of(SkinningPath::ubo).verdict, Verdict::crashed);
  EXPECT_EQ(outcome.of(SkinningPath::texture).verdict, Verdict::usable);
  EXPECT_EQ(outcome.of(SkinningPath::compute).verdict, Verdict::not_tried);
}

TEST(SelfTest, RefusesBadCalls) {
  const gles3::SelfTestOptions good;
  std::vector<SoaTransform> memory(gles3::self_test_bytes(good) / sizeof(SoaTransform) + 2);
  std::byte* const first = reinterpret_cast<std::byte*>(memory.data());
  const std::size_t bytes = gles3::self_test_bytes(good);
  const auto test = [&](const gles3::SelfTestOptions& options, std::size_t shift, std::size_t size) {
    gles3::SelfTest out;
    return gles3::self_test(gl(), gl().caps(), options, {first + shift, size}, out);
  };
  EXPECT_EQ(test(good, 0, bytes - 1), Status::bad_argument);
  EXPECT_EQ(test(good, 8, bytes), Status::bad_argument);
  gles3::SelfTestOptions none = good;
  none.ssd = none.as = false;
  EXPECT_EQ(test(none, 0, bytes), Status::bad_argument);
  gles3::SelfTestOptions timed = good;
  timed.seconds = fake_seconds;
  timed.user = &fake;
  EXPECT_GT(gles3::self_test_bytes(timed), bytes);
  EXPECT_LT(gles3::self_test_bytes(timed), 500000u);
  EXPECT_LT(bytes, 150000u);
  timed.slow = std::numeric_limits<float>::quiet_NaN();
  std::vector<SoaTransform> room(gles3::self_test_bytes(timed) / sizeof(SoaTransform) + 1);
  gles3::SelfTest out;
  EXPECT_EQ(gles3::self_test(gl(), gl().caps(), timed,
                             {reinterpret_cast<std::byte*>(room.data()), room.size() * sizeof(SoaTransform)}, out),
            Status::bad_argument);
  timed.slow = 4;
  for (const std::uint32_t vertices : {0u, 15u, 65521u, 0xFFFFFFFFu}) {
    gles3::SelfTestOptions beyond = timed;
    beyond.timed_vertices = vertices;
    EXPECT_EQ(gles3::self_test(gl(), gl().caps(), beyond,
                               {reinterpret_cast<std::byte*>(room.data()), room.size() * sizeof(SoaTransform)}, out),
              Status::bad_argument);
  }
  timed.timed_characters = 257;
  EXPECT_EQ(gles3::self_test(gl(), gl().caps(), timed,
                             {reinterpret_cast<std::byte*>(room.data()), room.size() * sizeof(SoaTransform)}, out),
            Status::bad_argument);
  gles3::SelfTestOptions nothing = good;
  nothing.paths = 0;
  EXPECT_EQ(test(nothing, 0, bytes), Status::ok);
}

// State that a game may have set; some of it would spoil every picture.
TEST(SelfTest, LeavesTheStateAsItWas) {
  const tools::GlFramebuffer framebuffers[] = {tools::GlFramebuffer(gl()), tools::GlFramebuffer(gl())};
  const tools::GlBuffer buffers[] = {tools::GlBuffer(gl()), tools::GlBuffer(gl()), tools::GlBuffer(gl()),
                                     tools::GlBuffer(gl())};
  const tools::GlVertexArray array(gl());
  const tools::GlTexture textures[] = {tools::GlTexture(gl()), tools::GlTexture(gl())};
  struct Whole {
    GLenum target, binding;
  };
  const Whole kinds[] = {{GL_ARRAY_BUFFER, GL_ARRAY_BUFFER_BINDING},
                         {GL_UNIFORM_BUFFER, GL_UNIFORM_BUFFER_BINDING},
                         {GL_PIXEL_PACK_BUFFER, GL_PIXEL_PACK_BUFFER_BINDING},
                         {GL_PIXEL_UNPACK_BUFFER, GL_PIXEL_UNPACK_BUFFER_BINDING}};
  gl().BindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffers[0]);
  gl().BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffers[1]);
  gl().Viewport(3, 4, 50, 60);
  gl().BindVertexArray(array);
  gl().ActiveTexture(GL_TEXTURE0);
  gl().BindTexture(GL_TEXTURE_2D, textures[0]);
  gl().ActiveTexture(GL_TEXTURE5);
  gl().BindTexture(GL_TEXTURE_2D, textures[1]);
  for (std::size_t i = 0; i < 4; ++i) gl().BindBuffer(kinds[i].target, buffers[i]);
  gl().Enable(GL_SCISSOR_TEST);
  gl().Enable(GL_RASTERIZER_DISCARD);
  gl().ColorMask(0, 1, 0, 1);
  const auto get = [](GLenum name) {
    std::array<int, 4> out = {};
    gl().GetIntegerv(name, out.data());
    return out;
  };
  const GLenum names[] = {GL_DRAW_FRAMEBUFFER_BINDING,
                          GL_READ_FRAMEBUFFER_BINDING,
                          GL_VIEWPORT,
                          GL_VERTEX_ARRAY_BINDING,
                          GL_ACTIVE_TEXTURE,
                          GL_TEXTURE_BINDING_2D,
                          GL_SCISSOR_TEST,
                          GL_RASTERIZER_DISCARD,
                          GL_COLOR_WRITEMASK,
                          GL_CURRENT_PROGRAM,
                          GL_ARRAY_BUFFER_BINDING,
                          GL_UNIFORM_BUFFER_BINDING,
                          GL_PIXEL_PACK_BUFFER_BINDING,
                          GL_PIXEL_UNPACK_BUFFER_BINDING};
  std::vector<std::array<int, 4>> before;
  for (const GLenum name : names) before.push_back(get(name));
  EXPECT_EQ(before[0][0], static_cast<int>(GLuint{framebuffers[0]}));
  expect(run(faulty_api(gl()), gl().caps(), one_deformer()), 0, Verdict::usable, "a game's state");
  for (std::size_t i = 0; i < std::size(names); ++i) EXPECT_EQ(get(names[i]), before[i]) << std::hex << names[i];
  gl().ActiveTexture(GL_TEXTURE0);
  EXPECT_EQ(get(GL_TEXTURE_BINDING_2D)[0], static_cast<int>(GLuint{textures[0]}));
  gl().BindTexture(GL_TEXTURE_2D, 0);
  gl().BindVertexArray(0);
  for (const Whole& kind : kinds) gl().BindBuffer(kind.target, 0);
  gl().Disable(GL_SCISSOR_TEST);
  gl().Disable(GL_RASTERIZER_DISCARD);
  gl().ColorMask(1, 1, 1, 1);
  gl().BindFramebuffer(GL_FRAMEBUFFER, 0);
}

TEST(SelfTest, RunsOutOfMemoryAnywhere) {
  int failures = 0;
  for (std::uint32_t i = 0; i < gles3::kPathCount; ++i) {
    const SkinningPath path = static_cast<SkinningPath>(i);
    if (path == SkinningPath::compute && !gl().caps().compute) continue;
    gles3::SelfTestOptions options = one_deformer();
    options.paths = bit_of(path);
    for (std::int64_t room = 0;; ++room) {
      const gles3::Api api = faulty_api(gl());
      driver().full_after = room;
      const Outcome outcome = run(api, gl().caps(), options);
      EXPECT_EQ(driver().live, 0) << to_string(path) << ", allocation " << room;
      EXPECT_EQ(outcome.status, room == 0 ? Status::gl_error : Status::ok) << "the picture comes first";
      const Verdict verdict = outcome.of(path).verdict;
      if (verdict == Verdict::usable) break;
      EXPECT_TRUE(room == 0 || verdict == Verdict::refused || verdict == Verdict::gl_error) << to_string(verdict);
      ASSERT_LT(room, 100);
      ++failures;
    }
  }
  EXPECT_GE(failures, 40);
  std::printf("%d failures\n", failures);
}

TEST(SelfTest, SurvivesTheLossOfTheContextAnywhere) {
  // On a thread of its own, so that it does not disturb the other tests' context.
  std::thread([] {
    int losses = 0;
    std::int64_t calls_of_all = 0;
    for (std::int64_t part = 0; part <= 16; ++part) {
      egl::HeadlessContext context;
      ASSERT_EQ(context.create(), Status::ok) << context.error();
      gles3::Api real;
      gles3::Caps caps;
      ASSERT_EQ(gles3::load_api(real, egl::load_proc), Status::ok);
      ASSERT_EQ(gles3::query_caps(real, caps), Status::ok);
      const gles3::Api api = faulty_api(real);
      driver().lost_after = part == 0 ? -1 : (part - 1) * calls_of_all / 16;
      const Outcome outcome = run(api, caps, one_deformer());
      if (part == 0) calls_of_all = driver().calls;
      EXPECT_EQ(outcome.status, part == 0 ? Status::ok : Status::gl_error) << "part " << part;
      losses += outcome.status == Status::gl_error;
    }
    EXPECT_EQ(losses, 16);
  }).join();
}

}  // namespace
}  // namespace marrow::test
