// GL errors with the call that caused them.
#include <thread>

#include <gtest/gtest.h>

#include "common/failure.h"
#include "gl/support/faulty_driver.h"
#include "gl/support/feedback.h"
#include "gl/support/reports.h"
#include "gles3/palettes.h"

namespace marrow::test {
namespace {

TEST(ApiErrors, AreReportedWithTheirCall) {
  std::vector<Report> first, second;
  gles3::ErrorWatch watches[] = {watch_into(first), watch_into(second)};
  gles3::Api a = gl(), b = gl();
  gles3::watch_errors(a, &watches[0]);
  gles3::watch_errors(b, &watches[1]);
  unsigned buffer = 0;
  a.GenBuffers(1, &buffer);
  a.BindBufferRange(0x1234, 0, buffer, 0, 16);
  a.BindBuffer(GL_ARRAY_BUFFER, buffer);
  EXPECT_EQ(first, (std::vector<Report>{{"glBindBufferRange", GL_INVALID_ENUM}}));
  EXPECT_EQ(a.GetError(), unsigned{GL_INVALID_ENUM}) << "still told";
  EXPECT_EQ(a.GetError(), 0u);
  // The other one's, and a result that comes through.
  EXPECT_EQ(b.CreateShader(0x1234), 0u);
  EXPECT_EQ(second, (std::vector<Report>{{"glCreateShader", GL_INVALID_ENUM}}));
  EXPECT_EQ(a.GetError(), 0u);
  EXPECT_EQ(b.GetError(), unsigned{GL_INVALID_ENUM});
  EXPECT_EQ(first.size(), 1u);
  a.DeleteBuffers(1, &buffer);
  EXPECT_EQ(gl().GetError(), 0u);
}

TEST(ApiErrors, OfOthersAreToldButNotReported) {
  std::vector<Report> reports;
  gles3::ErrorWatch watch = watch_into(reports);
  gles3::Api api = gl();
  gles3::watch_errors(api, &watch);
  gl().Enable(0x1234);
  api.BindBuffer(GL_ARRAY_BUFFER, 0);
  EXPECT_TRUE(reports.empty());
  EXPECT_EQ(api.GetError(), unsigned{GL_INVALID_ENUM});
  gles3::watch_errors(api, nullptr);
  api.Enable(0x1234);
  EXPECT_TRUE(reports.empty());
  EXPECT_EQ(gl().GetError(), unsigned{GL_INVALID_ENUM});
  EXPECT_EQ(gl().GetError(), 0u);
}

TEST(ApiErrors, ChecksSeeThemUnderAWatch) {
  std::vector<Report> reports;
  gles3::Api api = faulty_api(gl());
  gles3::ErrorWatch watch = watch_into(reports);
  gles3::watch_errors(api, &watch);
  driver().full_after = 0;
  gles3::PaletteRing ring;
  EXPECT_EQ(gles3::create_palette_ring(api, gl().caps(), 10, 1, ring), Status::gl_error);
  EXPECT_EQ(reports, (std::vector<Report>{{"glBufferData", GL_OUT_OF_MEMORY}}));
  EXPECT_EQ(driver().live, 0);
}

TEST(ApiErrors, OfTheToolsFunctionsAreReportedToo) {
  std::vector<Report> reports;
  gles3::ErrorWatch watch = watch_into(reports);
  tools::GlFunctions functions = gl();
  tools::watch_all_errors(functions, &watch);
  functions.BindRenderbuffer(0x1234, 0);
  functions.BindBuffer(0x1234, 0);
  EXPECT_EQ(reports, (std::vector<Report>{{"glBindRenderbuffer", GL_INVALID_ENUM}, {"glBindBuffer", GL_INVALID_ENUM}}));
  EXPECT_EQ(functions.GetError(), unsigned{GL_INVALID_ENUM});
  EXPECT_EQ(functions.GetError(), 0u);
  EXPECT_EQ(gl().GetError(), 0u);
  tools::watch_all_errors(functions, nullptr);
  EXPECT_EQ(functions.Scissor.watch, nullptr);
}

#ifndef NDEBUG
TEST(ApiErrors, ToolsPrintThem) {
  std::thread([] {
    ::testing::internal::CaptureStderr();
    const tools::Gl tool;
    tool.DepthMask(GL_TRUE);
    tool.BlendFunc(0x1234, GL_ONE);
    EXPECT_EQ(::testing::internal::GetCapturedStderr(), "OpenGL ES: glBlendFunc: error 0x0500\n");
    EXPECT_THROW(tool.check("testing"), tools::Failure);
  }).join();
}
#endif

// Which a lost context tells for ever.
TEST(ApiErrors, ALossIsReportedOnce) {
  std::vector<Report> reports;
  gles3::Api api = faulty_api(gl());
  gles3::ErrorWatch watch = watch_into(reports);
  gles3::watch_errors(api, &watch);
  driver().lost_after = 1;
  gles3::PaletteRing ring;
  EXPECT_EQ(gles3::create_palette_ring(api, gl().caps(), 10, 1, ring), Status::gl_error);
  EXPECT_EQ(reports, (std::vector<Report>{{"glBindBuffer", 0x0507}}));  // the second call
  driver().lost_after = -1;
  gl().BindBuffer(GL_UNIFORM_BUFFER, 0);
}

}  // namespace
}  // namespace marrow::test
