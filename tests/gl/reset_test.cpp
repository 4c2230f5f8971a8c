// Resets of the graphics processor: which contexts tell of them, where the entry point comes from, what it tells.
#include <dlfcn.h>

#include <cstring>
#include <thread>

#include <gtest/gtest.h>

#include "gl/support/faulty_driver.h"
#include "gl/support/feedback.h"
#include "marrow/egl.h"

namespace {

constexpr int kEglNone = 0x3038;
bool refuse_robust = false;
int robust_refused = 0;

// Whether a list of EGL attributes has "lose context on reset", by either name.
bool is_robust(const int* attributes) {
  for (; attributes != nullptr && *attributes != kEglNone; attributes += 2)
    if ((attributes[0] == 0x3138 || attributes[0] == 0x31BD) && attributes[1] == 0x31BF) return true;
  return false;
}

}  // namespace

// Stands before EGL's own: a driver that refuses what it has offered.
extern "C" void* eglCreateContext(void* display, void* config, void* share, const int* attributes) {
  using Create = void* (*)(void*, void*, void*, const int*);
  static const auto next = reinterpret_cast<Create>(dlsym(RTLD_NEXT, "eglCreateContext"));
  if (refuse_robust && is_robust(attributes)) {
    ++robust_refused;
    return nullptr;
  }
  return next(display, config, share, attributes);
}

namespace marrow::test {
namespace {

constexpr GLenum kStrategy = 0x8256, kLoseContextOnReset = 0x8252, kNoNotification = 0x8261;

bool offers_robustness() {
  const auto query = reinterpret_cast<const char* (*)(void*, int)>(dlsym(RTLD_DEFAULT, "eglQueryString"));
  const auto display = reinterpret_cast<void* (*)()>(dlsym(RTLD_DEFAULT, "eglGetCurrentDisplay"));
  const char* const extensions = query(display(), 0x3055);
  return extensions != nullptr && std::strstr(extensions, "EGL_EXT_create_context_robustness") != nullptr;
}

// What the context itself says it does on a reset; 0 where it does not know.
int strategy(const gles3::Api& api) {
  int out = 0;
  if (api.GetGraphicsResetStatus != nullptr) api.GetIntegerv(kStrategy, &out);
  return out;
}

TEST(Reset, ContextsTellOfThemWhereTheDriverCan) {
  std::thread([] {
    egl::HeadlessContext context;
    ASSERT_EQ(context.create(), Status::ok) << context.error();
    EXPECT_EQ(context.tells_of_resets(), offers_robustness());
    gles3::Api api;
    ASSERT_EQ(gles3::load_api(api, egl::load_proc), Status::ok);
    std::printf("resets: %s\n", !context.tells_of_resets()              ? "not told of"
                                : api.GetGraphicsResetStatus == nullptr ? "the context knows, the API does not"
                                                                        : "told of");
    EXPECT_FALSE(gles3::context_was_reset(api));
    if (context.tells_of_resets() && api.GetGraphicsResetStatus != nullptr) {
      EXPECT_EQ(strategy(api), static_cast<int>(kLoseContextOnReset));
    }
    EXPECT_EQ(api.GetError(), 0u);
  }).join();
}

TEST(Reset, AContextThatIsRefusedIsMadeAnOrdinaryOne) {
  std::thread([] {
    refuse_robust = true;
    robust_refused = 0;
    egl::HeadlessContext context;
    EXPECT_EQ(context.create(), Status::ok) << context.error();
    refuse_robust = false;
    EXPECT_EQ(robust_refused, offers_robustness() ? 1 : 0);
    EXPECT_FALSE(context.tells_of_resets());
    gles3::Api api;
    ASSERT_EQ(gles3::load_api(api, egl::load_proc), Status::ok);
    EXPECT_FALSE(gles3::context_was_reset(api));
    const int own = strategy(api);
    EXPECT_TRUE(own == 0 || own == static_cast<int>(kNoNotification)) << own;
    EXPECT_EQ(api.GetError(), 0u);
  }).join();
}

TEST(Reset, AnyReasonIsAReset) {
  gles3::Api api = faulty_api(gl());
  for (const unsigned reason : {0x8253u, 0x8254u, 0x8255u}) {  // guilty, innocent, unknown
    driver().reset = reason;
    EXPECT_TRUE(gles3::context_was_reset(api));
    EXPECT_FALSE(gles3::context_was_reset(api)) << "told once";
  }
  api.GetGraphicsResetStatus = nullptr;
  driver().reset = 0x8253u;
  EXPECT_FALSE(gles3::context_was_reset(api)) << "nobody to ask";
  driver().reset = 0;
}

// A loader that has something for every name.
const char* pretended_version = nullptr;
const char* pretended_extensions = nullptr;
void of_khr() {}
void of_ext() {}
void of_es() {}
void any() {}
const unsigned char* pretended_string(unsigned name) {
  return reinterpret_cast<const unsigned char*>(name == GL_VERSION ? pretended_version : pretended_extensions);
}
void* pretended_proc(const char* name) {
  if (std::strcmp(name, "glGetString") == 0) return reinterpret_cast<void*>(pretended_string);
  if (std::strcmp(name, "glGetGraphicsResetStatusKHR") == 0) return reinterpret_cast<void*>(of_khr);
  if (std::strcmp(name, "glGetGraphicsResetStatusEXT") == 0) return reinterpret_cast<void*>(of_ext);
  if (std::strcmp(name, "glGetGraphicsResetStatus") == 0) return reinterpret_cast<void*>(of_es);
  return reinterpret_cast<void*>(any);
}

TEST(Reset, CanBeAskedForIfTheContextSaysSo) {
  struct Case {
    const char *version, *extensions;
    void (*expected)();
  };
  const Case cases[] = {
      {"OpenGL ES 3.0 Somebody", "GL_OES_one GL_KHR_robustness GL_EXT_robustness", of_khr},
      {"OpenGL ES 3.0 Somebody", "GL_OES_one GL_EXT_robustness", of_ext},
      {"OpenGL ES 3.2 Somebody", "GL_EXT_robustness", of_ext},
      {"OpenGL ES 3.2 Somebody", "GL_OES_one", of_es},
      {"OpenGL ES 3.1 Somebody", "GL_EXT_robustnesses GL_KHR_robust", nullptr},
      {"OpenGL ES 3.1 Somebody", "", nullptr},
      {"4.6.0 Somebody", "GL_KHR_robustness", nullptr},
  };
  for (const Case& one : cases) {
    pretended_version = one.version;
    pretended_extensions = one.extensions;
    gles3::Api api;
    ASSERT_EQ(gles3::load_api(api, pretended_proc), Status::ok);
    EXPECT_EQ(reinterpret_cast<void*>(api.GetGraphicsResetStatus.function), reinterpret_cast<void*>(one.expected))
        << one.version << " " << one.extensions;
  }
}

}  // namespace
}  // namespace marrow::test
