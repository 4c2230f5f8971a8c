// `marrow render --movie` as GIF, MP4, WebM and WebP: what ffprobe finds in them, and what becomes of them when ffmpeg
// fails.
#ifdef MARROW_HAS_GLES
#include <signal.h>
#include <sys/stat.h>

#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <png.h>

#include "cli/support/process.h"

namespace marrow::test {
namespace {

bool have_ffmpeg() {
  for (const char* const program : {"ffmpeg", "ffprobe"}) {
    try {
      if (run_program({program, "-version"}).code != 0) return false;
    } catch (const std::exception&) {
      return false;
    }
  }
  return true;
}

class FilmTest : public ::testing::Test {
 protected:
  static constexpr double kWaveSeconds = 1.25;  // of the clip "wave" of tests/golden/tiny.gltf

  FilmTest() { EXPECT_EQ(run_marrow({"cook", tiny_gltf(), "-o", folder_ / "t.mrw"}).code, 0); }
  ~FilmTest() override { ::setenv("PATH", path_.c_str(), 1); }

  std::vector<std::string> arguments(const std::string& output, std::vector<std::string> options = {}) const {
    options.insert(options.begin(), {"render", folder_ / "t.mrw", "--clip", "wave", "--movie", "-o", folder_ / output});
    return options;
  }
  Ran render(const std::string& output, std::vector<std::string> options = {}) const {
    return run_marrow(arguments(output, std::move(options)));
  }
  // What ffprobe says, each frame decoded.
  std::map<std::string, std::string> probe(const std::string& output) const {
    const Ran ran = run_program({"ffprobe", "-v", "error", "-count_frames", "-select_streams", "v:0", "-show_entries",
                                 "stream=nb_read_frames,width,height,codec_name,pix_fmt,color_space:format=duration",
                                 "-of", "default=noprint_wrappers=1", folder_ / output});
    EXPECT_EQ(ran.code, 0) << ran.err;
    std::map<std::string, std::string> out;
    std::istringstream lines(ran.out);
    for (std::string line; std::getline(lines, line);)
      out[line.substr(0, line.find('='))] = line.substr(line.find('=') + 1);
    return out;
  }
  void expect_film(const std::string& output, const std::string& codec, int frames, double within_s) const {
    auto found = probe(output);
    EXPECT_EQ(found["codec_name"], codec);
    EXPECT_EQ(found["nb_read_frames"], std::to_string(frames));
    EXPECT_EQ(found["width"] + "x" + found["height"], "48x32");
    EXPECT_NEAR(std::atof(found["duration"].c_str()), kWaveSeconds, within_s) << output;
  }
  // A program that is found in ffmpeg's place.
  void put_ffmpeg(const std::string& script) const {
    std::filesystem::create_directory(folder_ / "bin");
    write_text(folder_ / "bin/ffmpeg", "#!/bin/sh\n" + script);
    ::chmod((folder_ / "bin/ffmpeg").c_str(), 0755);
    ::setenv("PATH", ((folder_ / "bin") + ":" + path_).c_str(), 1);
  }

  TemporaryFolder folder_;
  std::string path_ = std::getenv("PATH");
};

// Of ffmpeg's own.
class FfmpegTest : public FilmTest {
 protected:
  using Pixels = std::vector<std::uint8_t>;  // RGB

  void SetUp() override {
    if (!have_ffmpeg()) GTEST_SKIP() << "SKIPPED: ffmpeg and ffprobe are missing: tools/packages/test.txt";
  }
  Pixels still(const std::string& time) const {
    EXPECT_EQ(run_marrow({"render", folder_ / "t.mrw", "--clip", "wave", "--time", time, "--size", "320x240", "-o",
                          folder_ / "s.png"})
                  .code,
              0);
    png_image image = {};
    image.version = PNG_IMAGE_VERSION;
    EXPECT_NE(png_image_begin_read_from_file(&image, (folder_ / "s.png").c_str()), 0);
    image.format = PNG_FORMAT_RGB;
    Pixels out(PNG_IMAGE_SIZE(image));
    EXPECT_NE(png_image_finish_read(&image, nullptr, out.data(), 0, nullptr), 0);
    return out;
  }
  // Mean difference of a channel, of 255.
  static double difference(const std::uint8_t* a, const Pixels& b) {
    double sum = 0;
    for (std::size_t i = 0; i < b.size(); ++i) sum += std::abs(int{a[i]} - int{b[i]});
    return sum / double(b.size());
  }
};

TEST_F(FfmpegTest, AllThreeKindsHaveTheClipsFrames) {
  // 1.25 s at 15 frames a second are 18.75: 19 frames last as long as the clip, a GIF's to a hundredth.
  for (const auto& [name, codec] : {std::pair("w.gif", "gif"), {"w.mp4", "h264"}, {"w.WEBM", "vp9"}}) {
    const Ran ran = render(name, {"--size", "48x32"});
    ASSERT_EQ(ran.code, 0) << ran.err;
    expect_film(name, codec, 19, 0.0101);
  }
  EXPECT_EQ(render("four.mp4", {"--size", "48x32", "--fps", "4"}).code, 0);
  expect_film("four.mp4", "h264", 5, 0.001);
  EXPECT_EQ(folder_.listing(), (std::vector<std::string>{"four.mp4", "t.mrw", "w.WEBM", "w.gif", "w.mp4"}));
}

// By the container's specification (Google, "WebP Container Specification"), as ffprobe reads the first frame alone.
TEST_F(FfmpegTest, AnAnimatedWebPHasTheClipsFrames) {
  const Ran ran = render("w.webp", {"--size", "47x31"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  const std::string webp = read_text(folder_ / "w.webp");
  const auto number = [&](std::size_t at, int bytes) {
    std::size_t out = 0;
    for (int i = bytes - 1; i >= 0; --i) out = 256 * out + static_cast<unsigned char>(webp.at(at + std::size_t(i)));
    return out;
  };
  ASSERT_EQ(webp.substr(0, 4) + webp.substr(8, 4), "RIFFWEBP");
  EXPECT_EQ(number(4, 4) + 8, webp.size());
  std::size_t frames = 0, ms = 0;
  for (std::size_t at = 12; at + 8 <= webp.size(); at += 8 + number(at + 4, 4) + number(at + 4, 4) % 2) {
    const std::string kind = webp.substr(at, 4);
    if (kind == "VP8X") EXPECT_EQ(number(at + 12, 3) + 1, 47u);
    if (kind == "VP8X") EXPECT_EQ(number(at + 15, 3) + 1, 31u);
    if (kind == "ANIM") EXPECT_EQ(number(at + 12, 2), 0u) << "again and again";
    if (kind != "ANMF") continue;
    ++frames;
    ms += number(at + 20, 3);
    // Whole, so that nothing of the frame before is left.
    EXPECT_EQ(number(at + 14, 3) + 1, 47u);
    EXPECT_EQ(number(at + 17, 3) + 1, 31u);
  }
  EXPECT_EQ(frames, 19u);
  EXPECT_NEAR(double(ms), 1000 * kWaveSeconds, 20);
}

TEST_F(FfmpegTest, WhatPlayersAskFor) {
  ASSERT_EQ(render("w.mp4", {"--size", "47x31"}).code, 0);
  expect_film("w.mp4", "h264", 19, 0.001);  // even sides
  EXPECT_EQ(probe("w.mp4")["pix_fmt"], "yuv420p");
  EXPECT_EQ(probe("w.mp4")["color_space"], "bt709");
  const std::string mp4 = read_text(folder_ / "w.mp4");
  EXPECT_LT(mp4.find("moov"), mp4.find("mdat")) << "starts before it is there";
  ASSERT_EQ(render("w.gif", {"--size", "47x31"}).code, 0);
  EXPECT_EQ(probe("w.gif")["width"], "47");
  // The application extension of looping: three bytes, 1 and the count, 0 for ever.
  const std::string gif = read_text(folder_ / "w.gif");
  const std::size_t at = gif.find("NETSCAPE2.0");
  ASSERT_NE(at, std::string::npos);
  EXPECT_EQ(gif.substr(at + 11, 4), std::string("\x03\x01\x00\x00", 4));
}

TEST_F(FfmpegTest, FramesAreThePicturesInTheirOrderAndColours) {
  const Pixels first = still("0"), third = still("0.5");
  for (const char* const name : {"w.gif", "w.mp4", "w.webm"}) {
    ASSERT_EQ(render(name, {"--size", "320x240", "--fps", "4"}).code, 0);
    ASSERT_EQ(run_program({"ffmpeg", "-v", "error", "-y", "-i", folder_ / name, "-f", "rawvideo", "-pix_fmt", "rgb24",
                           folder_ / "raw"})
                  .code,
              0);
    const std::string raw = read_text(folder_ / "raw");
    const std::size_t frame = 3 * 320 * 240;
    ASSERT_EQ(raw.size(), 5 * frame) << name;
    const auto* const pixels = reinterpret_cast<const std::uint8_t*>(raw.data());
    EXPECT_LT(difference(pixels, first), 2) << name;
    EXPECT_LT(difference(pixels + 2 * frame, third), 2) << name;
    EXPECT_GT(difference(pixels + 2 * frame, first), 2 * difference(pixels + 2 * frame, third)) << name;
  }
}

TEST_F(FfmpegTest, NamesAreNobodysCommands) {
  const std::string name = "-i a;touch 'x' \"$(touch y)\" pipe:1 \\.gif";
  EXPECT_EQ(render(name, {"--size", "16x16"}).code, 0);
  EXPECT_EQ(folder_.listing(), (std::vector<std::string>{name, "t.mrw"}));
  EXPECT_EQ(probe(name)["codec_name"], "gif");
}

TEST_F(FfmpegTest, WhatAGifCannotShow) {
  const Ran ran = render("w.gif", {"--size", "16x16", "--fps", "60"});
  EXPECT_EQ(ran.code, kUsage);
  EXPECT_NE(ran.err.find("a GIF shows at most 50 frames a second: lower --fps"), std::string::npos) << ran.err;
}

TEST_F(FilmTest, WithoutFfmpegTheErrorSaysWhatToDo) {
  write_text(folder_ / "w.mp4", "precious");
  std::filesystem::create_directory(folder_ / "ffmpeg");  // a folder of that name is no program
  for (const std::string& path : {std::string(""), folder_.path(), std::string("::")}) {
    ::setenv("PATH", path.c_str(), 1);
    const Ran ran = render("w.mp4");
    EXPECT_EQ(ran.code, kUnsupported);
    EXPECT_EQ(ran.complaints().size(), 1u) << ran.err;
    for (const char* const part : {"w.mp4", "no program ffmpeg on the PATH", "install it", ".png"})
      EXPECT_NE(ran.err.find(part), std::string::npos) << ran.err;
  }
  EXPECT_EQ(read_text(folder_ / "w.mp4"), "precious");
}

TEST_F(FilmTest, WhenFfmpegFailsItsLastLineIsShown) {
  write_text(folder_ / "w.mp4", "precious");
  // At once, when all frames are there, and without a word.
  for (const auto& [script, said] :
       {std::pair("echo nothing >&2; echo 'no \x1b[31mcodec' >&2; exit 1", "ffmpeg failed: no ?[31mcodec"),
        {"cat > /dev/null; echo 'no room' >&2; exit 1", "ffmpeg failed: no room"},
        {"cat > /dev/null; kill -9 $$", "ffmpeg failed: it said nothing"},
        {"cat > /dev/null", "ffmpeg failed: it said nothing"}}) {
    put_ffmpeg(script);
    const Ran ran = render("w.mp4", {"--size", "320x240", "--fps", "3"});  // more than a pipe holds
    EXPECT_EQ(ran.code, kIo) << ran.err;
    EXPECT_NE(ran.err.find(said), std::string::npos) << ran.err;
    EXPECT_EQ(ran.complaints().size(), 1u) << ran.err;
    EXPECT_EQ(read_text(folder_ / "w.mp4"), "precious");
    EXPECT_EQ(folder_.listing(), (std::vector<std::string>{"bin", "t.mrw", "w.mp4"}));
  }
}

TEST_F(FilmTest, AnInterruptLeavesNothing) {
  // One that would wait for ever, but sees the end of what it is fed.
  put_ffmpeg("echo $$ > '" + (folder_ / "pid") + "'; echo half >&3; exec cat > /dev/null");
  const Ran ran = run_marrow_on_terminal(arguments("w.mp4", {"--size", "64x64", "--turn", "3600"}), "[9/900] drawing");
  EXPECT_EQ(ran.code, kInterrupted) << ran.err;
  const pid_t child = std::atoi(read_text(folder_ / "pid").c_str());
  ASSERT_GT(child, 0);
  std::filesystem::remove(folder_ / "pid");
  EXPECT_EQ(folder_.listing(), (std::vector<std::string>{"bin", "t.mrw"}));
  for (int i = 0; i < 500 && ::kill(child, 0) == 0; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_NE(::kill(child, 0), 0) << "ffmpeg runs on";
}

}  // namespace
}  // namespace marrow::test
#endif
