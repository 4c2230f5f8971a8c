// Drivers that are broken in one way each, made from the one at hand: the self-test must find just that.
#include <string>

#include "gl/support/self_test_run.h"

namespace marrow::test {
namespace {

TEST(SelfTest, EveryPathIsUsableHere) {
  const Outcome all = run(faulty_api(gl()), gl().caps(), {});
  expect(all, 0, Verdict::usable, "this driver");
  for (const SkinningPath path :
       {SkinningPath::ubo, SkinningPath::texture, SkinningPath::feedback, SkinningPath::compute}) {
    if (path == SkinningPath::compute && !gl().caps().compute) continue;
    // Something was compared, and the rounding of 16 bits is in it: half a step of a metre is 1.5e-5.
    EXPECT_GT(all.of(path).position_error, 1e-5f);
    EXPECT_LT(all.of(path).position_error, 1e-4f);
    EXPECT_GT(all.of(path).normal_error, 1e-5f);
    EXPECT_LT(all.of(path).normal_error, 5e-4f);
  }
  EXPECT_EQ(all.of(SkinningPath::cpu).position_error, 0.0f) << "the same arithmetic";
  EXPECT_EQ(all.of(SkinningPath::cpu).ns_per_vertex, 0.0f) << "no clock";
  gles3::Caps old = gl().caps();
  old.compute = false;
  EXPECT_EQ(run(faulty_api(gl()), old, one_deformer()).of(SkinningPath::compute).verdict, Verdict::unsupported);
}

// A compiler that reads something else than what stands there, in texts with all of the words.
struct Miscompiler {
  std::vector<std::string> words;
  std::string from, to;
  std::int64_t times = 0;
};
Miscompiler miscompiler;

gles3::Api miscompiling_api(const Miscompiler& how) {
  gles3::Api api = faulty_api(gl());
  miscompiler = how;
  api.ShaderSource = [](unsigned shader, int count, const char* const* texts, const int*) {
    std::string all;
    for (int i = 0; i < count; ++i) all += texts[i];
    bool meant = true;
    for (const std::string& word : miscompiler.words) meant = meant && all.find(word) != std::string::npos;
    const std::string& from = miscompiler.from;
    std::size_t at = meant ? all.find(from) : std::string::npos;
    for (; at != std::string::npos; at = all.find(from, at + miscompiler.to.size())) {
      all.replace(at, from.size(), miscompiler.to);
      ++miscompiler.times;
    }
    const char* const text = all.c_str();
    driver().real.ShaderSource(shader, 1, &text, nullptr);
  };
  return api;
}

// Words that only a path's own text has.
const std::vector<std::string> kTextOfUbo = {"uniform vec4 self_test", "MARROW_PALETTES 0", "MARROW_DEFORMER 2"};
const std::vector<std::string> kTextOfTexture = {"uniform vec4 self_test", "MARROW_PALETTES 1"};
const std::vector<std::string> kTextOfFeedback = {"out vec3 out_position"};
const std::vector<std::string> kTextOfCompute = {"MARROW_COMPUTE 1"};
const std::vector<std::string> kTextOfDrawing = {"uniform vec4 self_test", "MARROW_DEFORMER 0"};

TEST(SelfTest, TextsThatAreMiscompiled) {
  struct Case {
    const char* what;
    Miscompiler how;
    std::uint32_t broken;
    Verdict verdict;
  };
  // By bits: NVIDIA's compiler takes a number that is packed as a half and unpacked again for the number.
  const std::string half =
      "MarrowMatrix m = marrow_matrices[joint]; m.x = uintBitsToFloat(floatBitsToUint(m.x) & 0xFFFFE000u); return m;";
  const std::string nothing = "void main() { this is no language }";
  const Case cases[] = {
      {"16 bits", {kTextOfUbo, "return marrow_matrices[joint];", half}, kUbo, Verdict::wrong},
      {"256 vectors of a block",
       {kTextOfUbo, "marrow_matrices[joint]", "marrow_matrices[joint % 85u]"},
       kUbo,
       Verdict::wrong},
      {"no instances", {kTextOfTexture, "gl_InstanceID * marrow", "0 * marrow"}, kTexture, Verdict::wrong},
      {"no row", {kTextOfFeedback, "weight * m.z", "weight * m.y"}, kFeedback, Verdict::wrong},
      {"joints of 16 bits", {kTextOfCompute, "two >> 16", "two >> 15"}, kCompute, Verdict::wrong},
      {"influences 5 to 8", {kTextOfFeedback, "in_weights1.x", "in_weights1.y"}, kFeedback, Verdict::wrong},
      {"normals alone", {kTextOfFeedback, "cross(b, c)", "cross(c, b)"}, kFeedback, Verdict::wrong},
      {"handedness alone", {kTextOfUbo, "-mirrored : mirrored", "mirrored : mirrored"}, kUbo, Verdict::wrong},
      {"refused", {kTextOfUbo, "void main() {", nothing}, kUbo, Verdict::refused},
      {"refused", {kTextOfTexture, "void main() {", nothing}, kTexture, Verdict::refused},
      {"refused", {kTextOfFeedback, "void main() {", nothing}, kFeedback, Verdict::refused},
      {"refused", {kTextOfCompute, "void main() {", nothing}, kCompute, Verdict::refused},
      {"refused", {kTextOfDrawing, "void main() {", nothing}, kFeedback | kCompute | kCpu, Verdict::refused}};
  for (const Case& c : cases) {
    const Outcome outcome = run(miscompiling_api(c.how), gl().caps(), one_deformer());
    expect(outcome, c.broken, c.verdict, c.what);
    EXPECT_TRUE(miscompiler.times > 0 || c.broken == kCompute) << c.what << " changed nothing";
  }
}

TEST(SelfTest, TheDeformersThatAreAskedFor) {
  const Miscompiler how = {{"MARROW_DEFORMER 3"}, "q.w * m.x.xyz", "m.x.xyz"};
  const std::uint32_t on_gpu = kUbo | kTexture | kFeedback | kCompute;
  expect(run(miscompiling_api(how), gl().caps(), {}), on_gpu, Verdict::wrong, "both");
  expect(run(miscompiling_api(how), gl().caps(), one_deformer()), 0, Verdict::usable, "SSD");
  gles3::SelfTestOptions as;
  as.ssd = false;
  expect(run(miscompiling_api(how), gl().caps(), as), on_gpu, Verdict::wrong, "animation space");
}

constexpr unsigned kArrayBuffer = 0x8892, kUniformBuffer = 0x8A11;
int calls = 0;

struct Spoilt {
  const char* what;
  void (*spoil)(gles3::Api&);
  std::uint32_t broken;
  Verdict verdict;
};

void expect_each(Span<const Spoilt> cases) {
  for (const Spoilt& c : cases) {
    gles3::Api api = faulty_api(gl());
    c.spoil(api);
    expect(run(api, gl().caps(), one_deformer()), c.broken, c.verdict, c.what);
  }
}

TEST(SelfTest, UploadsThatDoNotArrive) {
  const Spoilt cases[] = {
      {"palettes at offset 0",
       [](gles3::Api& api) {
         api.BindBufferRange = [](unsigned target, unsigned index, unsigned buffer, std::ptrdiff_t offset,
                                  std::ptrdiff_t bytes) {
           driver().real.BindBufferRange(target, index, buffer, target == kUniformBuffer ? 0 : offset, bytes);
         };
       },
       kUbo | kFeedback | kCompute, Verdict::wrong},
      {"uniform uploads",
       [](gles3::Api& api) {
         api.BufferSubData = [](unsigned target, std::ptrdiff_t offset, std::ptrdiff_t bytes, const void* data) {
           if (target != kUniformBuffer) driver().real.BufferSubData(target, offset, bytes, data);
         };
       },
       kUbo | kFeedback | kCompute, Verdict::wrong},
      {"vertex uploads",
       [](gles3::Api& api) {
         api.BufferSubData = [](unsigned target, std::ptrdiff_t offset, std::ptrdiff_t bytes, const void* data) {
           if (target != kArrayBuffer) driver().real.BufferSubData(target, offset, bytes, data);
         };
       },
       kCpu, Verdict::wrong},
      {"texture uploads",
       [](gles3::Api& api) {
         api.TexSubImage2D = [](unsigned, int, int, int, int, int, unsigned, unsigned, const void*) {};
       },
       kTexture, Verdict::wrong},
      {"texture uploads but the first frame's",
       [](gles3::Api& api) {
         api.GenTextures = [](int count, unsigned* textures) {
           calls = 0;
           driver().real.GenTextures(count, textures);
           driver().live += count;
         };
         api.TexSubImage2D = [](unsigned target, int level, int x, int y, int width, int height, unsigned format,
                                unsigned type, const void* texels) {
           if (calls++ == 0) driver().real.TexSubImage2D(target, level, x, y, width, height, format, type, texels);
         };
       },
       kTexture, Verdict::wrong}};
  expect_each({cases, std::size(cases)});
}

TEST(SelfTest, CallsThatDoNothing) {
  const Spoilt cases[] = {
      {"instances",
       [](gles3::Api& api) {
         api.DrawElementsInstanced = [](unsigned mode, int count, unsigned type, const void* offset, int) {
           driver().real.DrawElements(mode, count, type, offset);
         };
       },
       kTexture, Verdict::wrong},
      {"transform feedback",
       [](gles3::Api& api) {
         api.BeginTransformFeedback = [](unsigned) {};
         api.EndTransformFeedback = [] {};
       },
       kFeedback, Verdict::wrong},
      {"transform feedback, noticed by GL", [](gles3::Api& api) { api.BeginTransformFeedback = [](unsigned) {}; },
       kFeedback, Verdict::gl_error},
      {"compute shaders", [](gles3::Api& api) { api.DispatchCompute = [](unsigned, unsigned, unsigned) {}; }, kCompute,
       Verdict::wrong},
      {"compute shaders, noticed by GL",
       [](gles3::Api& api) { api.DispatchCompute = [](unsigned, unsigned, unsigned) { driver().error = 0x0505; }; },
       kCompute, Verdict::gl_error},
      {"one reading",
       [](gles3::Api& api) {
         calls = 0;  // the first only asks whether there is reading at all
         api.ReadPixels = [](int x, int y, int width, int height, unsigned format, unsigned type, void* out) {
           if (++calls != 2) driver().real.ReadPixels(x, y, width, height, format, type, out);
         };
       },
       kUbo, Verdict::wrong}};
  expect_each({cases, std::size(cases)});
}

TEST(SelfTest, NothingCanBeReadBack) {
  gles3::Api api = faulty_api(gl());
  api.ReadPixels = [](int, int, int, int, unsigned, unsigned, void*) {};
  const Outcome outcome = run(api, gl().caps(), {});
  EXPECT_EQ(outcome.status, Status::gl_error);
  EXPECT_EQ(outcome.of(SkinningPath::cpu).verdict, Verdict::not_tried) << "written on failure";
  EXPECT_EQ(driver().live, 0);
}

}  // namespace
}  // namespace marrow::test
