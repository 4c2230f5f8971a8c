// `marrow render --movie`: what is in an animated PNG, read chunk by chunk as its specification has it.
#ifdef MARROW_HAS_GLES
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <png.h>

#include "cli/support/process.h"

namespace marrow::test {
namespace {

constexpr double kWaveSeconds = 1.25;  // of the clip "wave" of tests/golden/tiny.gltf
constexpr int kWidth = 48, kHeight = 32;

std::uint32_t big_endian(const std::string& bytes, std::size_t at, std::size_t count = 4) {
  std::uint32_t n = 0;
  for (std::size_t i = at; i < at + count; ++i) n = n << 8 | static_cast<std::uint8_t>(bytes.at(i));
  return n;
}

std::string be32(std::size_t n) {
  std::string out;
  for (int i = 3; i >= 0; --i) out += static_cast<char>(n >> 8 * i);
  return out;
}

// As the PNG specification's annex D defines it, a bit at a time.
std::uint32_t check_sum(const std::string& bytes) {
  std::uint32_t c = 0xFFFFFFFF;
  for (const char byte : bytes) {
    c ^= static_cast<std::uint8_t>(byte);
    for (int bit = 0; bit < 8; ++bit) c = (c & 1) != 0 ? 0xEDB88320 ^ c >> 1 : c >> 1;
  }
  return ~c;
}

struct Chunk {
  std::string type, data;
};

std::vector<Chunk> chunks_of(const std::string& file) {
  std::vector<Chunk> out;
  EXPECT_EQ(file.substr(0, 8), "\x89PNG\r\n\x1a\n");
  for (std::size_t at = 8; at < file.size();) {
    const std::size_t length = big_endian(file, at);
    out.push_back({file.substr(at + 4, 4), file.substr(at + 8, length)});
    EXPECT_EQ(big_endian(file, at + 8 + length), check_sum(out.back().type + out.back().data)) << out.back().type;
    at += length + 12;
  }
  return out;
}

using Pixels = std::vector<png_byte>;

Pixels decode(const std::string& png, png_uint_32 format = PNG_FORMAT_RGB) {
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  EXPECT_NE(png_image_begin_read_from_memory(&image, png.data(), png.size()), 0) << image.message;
  image.format = format;
  Pixels out(PNG_IMAGE_SIZE(image));
  EXPECT_NE(png_image_finish_read(&image, nullptr, out.data(), 0, nullptr), 0) << image.message;
  return out;
}

struct Frame {
  std::uint32_t width, height, x, y;
  double seconds;
  std::string compressed;
};

// The frames as they are stored; expects what the specification says of the chunks' order and numbers.
std::vector<Frame> frames_of(const std::vector<Chunk>& chunks) {
  std::vector<Frame> frames;
  std::uint32_t sequence = 0, stated = 0;
  for (const Chunk& chunk : chunks) {
    const std::string& d = chunk.data;
    if (chunk.type == "acTL") {
      EXPECT_TRUE(frames.empty());
      stated = big_endian(d, 0);
      EXPECT_EQ(big_endian(d, 4), 0u) << "plays without end";
    } else if (chunk.type == "fcTL") {
      EXPECT_EQ(d.size(), 26u);
      EXPECT_EQ(big_endian(d, 0), sequence++);
      frames.push_back({big_endian(d, 4),
                        big_endian(d, 8),
                        big_endian(d, 12),
                        big_endian(d, 16),
                        double(big_endian(d, 20, 2)) / double(big_endian(d, 22, 2)),
                        {}});
      EXPECT_LE(frames.back().x + frames.back().width, std::uint32_t{kWidth});
      EXPECT_LE(frames.back().y + frames.back().height, std::uint32_t{kHeight});
      EXPECT_EQ(big_endian(d, 24, 2), frames.size() == 1 ? 0u : 1u) << "stays; replaces, or lies over what is there";
    } else if (chunk.type == "IDAT") {
      EXPECT_EQ(frames.size(), 1u);
      frames.back().compressed += d;
    } else if (chunk.type == "fdAT") {
      EXPECT_GT(frames.size(), 1u);
      EXPECT_EQ(big_endian(d, 0), sequence++);
      frames.back().compressed += d.substr(4);
    }
  }
  EXPECT_EQ(frames.size(), stated);
  return frames;
}

// What is seen while each frame is shown.
std::vector<Pixels> shown(const std::vector<Chunk>& chunks, const std::vector<Frame>& frames) {
  std::vector<Pixels> out;
  Pixels canvas(std::size_t{3} * kWidth * kHeight);
  const auto chunk = [](const std::string& type, const std::string& data) {
    return be32(data.size()) + type + data + be32(check_sum(type + data));
  };
  std::string colours;
  for (const Chunk& c : chunks)
    if (c.type == "PLTE" || c.type == "tRNS") colours += chunk(c.type, c.data);
  for (const Frame& frame : frames) {
    const std::string header = be32(frame.width) + be32(frame.height) + chunks[0].data.substr(8);
    const Pixels part = decode(
        "\x89PNG\r\n\x1a\n" + chunk("IHDR", header) + colours + chunk("IDAT", frame.compressed) + chunk("IEND", {}),
        PNG_FORMAT_RGBA);
    for (std::size_t i = 0; i < part.size() / 4; ++i) {
      EXPECT_TRUE(part[4 * i + 3] == 255 || (part[4 * i + 3] == 0 && !out.empty()));
      const std::size_t to = (frame.y + i / frame.width) * kWidth + frame.x + i % frame.width;
      if (part[4 * i + 3] != 0) std::copy_n(&part[4 * i], 3, &canvas[3 * to]);
    }
    out.push_back(canvas);
  }
  return out;
}

// In few colours, whose means over some pixels are those of the picture.
void expect_like(const Pixels& picture, const Pixels& still) {
  constexpr int kBlock = 4;
  ASSERT_EQ(picture.size(), still.size());
  double squares = 0, most = 0;
  for (int y = 0; y < kHeight; y += kBlock)
    for (int x = 0; x < 3 * kWidth; x += 3 * kBlock)
      for (int c = 0; c < 3; ++c) {
        int sum = 0;
        for (int row = y; row < y + kBlock; ++row)
          for (int at = x + c; at < x + c + 3 * kBlock; at += 3) {
            const auto i = static_cast<std::size_t>(row * 3 * kWidth + at);
            const int off = picture[i] - still[i];
            squares += off * off;
            sum += off;
          }
        most = std::max(most, std::abs(sum) / double(kBlock * kBlock));
      }
  EXPECT_LT(std::sqrt(squares / double(still.size())), 2);
  EXPECT_LT(most, 2.5);
}

class MovieTest : public ::testing::Test {
 protected:
  MovieTest() { EXPECT_EQ(run_marrow({"cook", tiny_gltf(), "-o", folder_ / "t.mrw"}).code, 0); }
  Ran render(std::vector<std::string> options, const std::string& output) const {
    options.insert(options.begin(), {"render", folder_ / "t.mrw", "--size", "48x32", "-o", folder_ / output});
    return run_marrow(options);
  }
  std::vector<Chunk> movie(std::vector<std::string> options) const {
    options.emplace_back("--movie");
    const Ran ran = render(options, "m.png");
    EXPECT_EQ(ran.code, 0) << ran.err;
    return chunks_of(read_text(folder_ / "m.png"));
  }
  Pixels still(std::vector<std::string> options) const {
    EXPECT_EQ(render(std::move(options), "s.png").code, 0);
    return decode(read_text(folder_ / "s.png"));
  }
  static double seconds(const std::vector<Frame>& frames) {
    double sum = 0;
    for (const Frame& frame : frames) sum += frame.seconds;
    return sum;
  }

  TemporaryFolder folder_;
};

TEST_F(MovieTest, FramesAreTheClipsMoments) {
  const std::vector<Chunk> chunks = movie({"--clip", "wave", "--fps", "4"});
  EXPECT_EQ(chunks.front().type, "IHDR");
  EXPECT_EQ(chunks.back().type, "IEND");
  const std::vector<Frame> frames = frames_of(chunks);
  ASSERT_EQ(frames.size(), 5u) << "duration × fps";
  EXPECT_NEAR(seconds(frames), kWaveSeconds, 1e-9);
  const std::vector<Pixels> pictures = shown(chunks, frames);
  std::vector<Pixels> stills;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    stills.push_back(still({"--clip", "wave", "--time", std::to_string(0.25 * double(i))}));
    expect_like(pictures[i], stills[i]);
  }
  EXPECT_NE(pictures[0], pictures[2]);
  std::size_t at_rest = 0;
  for (std::size_t i = 1; i < frames.size(); ++i)
    for (std::size_t p = 0; p < pictures[i].size(); p += 3) {
      if (!std::equal(&stills[i][p], &stills[i][p] + 3, &stills[i - 1][p])) continue;
      ++at_rest;
      EXPECT_TRUE(std::equal(&pictures[i][p], &pictures[i][p] + 3, &pictures[i - 1][p])) << "what rests flickers";
    }
  EXPECT_GT(at_rest, 1000u);
  EXPECT_EQ(decode(read_text(folder_ / "m.png")), pictures[0]) << "to who knows PNG alone";
}

// 1.25 s at 15 frames a second are 18.75: frames last a little less than a fifteenth, so that the loop closes.
TEST_F(MovieTest, AWholeNumberOfFramesLastsAsLongAsTheClip) {
  const std::vector<Frame> frames = frames_of(movie({"--clip", "wave"}));
  EXPECT_EQ(frames.size(), 19u);
  EXPECT_NEAR(seconds(frames), kWaveSeconds, 1e-9);
  for (const Frame& frame : frames) EXPECT_NEAR(frame.seconds, kWaveSeconds / 19, 1e-4);
}

TEST_F(MovieTest, NumberedFramesAreTheClipsMomentsInAllColours) {
  ASSERT_EQ(render({"--clip", "wave", "--fps", "4", "--movie"}, "frames/").code, 0);
  ASSERT_EQ(render({"--clip", "wave", "--fps", "4", "--movie"}, "100%_%02d.png").code, 0);
  for (std::size_t i = 0; i < 5; ++i) {
    const std::string number = std::to_string(i);
    const Pixels picture = still({"--clip", "wave", "--time", std::to_string(0.25 * double(i))});
    EXPECT_EQ(decode(read_text(folder_ / ("frames/000" + number + ".png"))), picture) << i;
    EXPECT_EQ(decode(read_text(folder_ / ("100%_0" + number + ".png"))), picture) << i;
  }
  EXPECT_FALSE(std::filesystem::exists(folder_ / "frames/0005.png"));
}

TEST_F(MovieTest, Turntables) {
  // Without a clip, of a clip that stands still, and of a moment: 60° a second.
  for (const std::vector<std::string>& what :
       {std::vector<std::string>{}, {"--clip", "point"}, {"--clip", "wave", "--time", "0.5"}}) {
    std::vector<std::string> options = {"--fps", "1"};
    options.insert(options.end(), what.begin(), what.end());
    const std::vector<Chunk> chunks = movie(options);
    const std::vector<Frame> frames = frames_of(chunks);
    ASSERT_EQ(frames.size(), 6u);
    EXPECT_NEAR(seconds(frames), 6, 1e-9);
    std::vector<Pixels> pictures = shown(chunks, frames);
    std::sort(pictures.begin(), pictures.end());
    EXPECT_EQ(std::unique(pictures.begin(), pictures.end()), pictures.end()) << "six sides";
  }
  // 120° take 2 s: the clip is played twice.
  const std::vector<Frame> frames = frames_of(movie({"--clip", "wave", "--turn", "120", "--fps", "2"}));
  EXPECT_EQ(frames.size(), 5u);
  EXPECT_NEAR(seconds(frames), 2 * kWaveSeconds, 1e-9);
}

TEST_F(MovieTest, HeatMapsShareOneScale) {
  const Ran ran = render({"--clip", "wave", "--heatmap", "rigid:ssd", "--movie", "--fps", "4"}, "h.png");
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(std::count(ran.out.begin(), ran.out.end(), '\n'), 1) << ran.out;
  EXPECT_EQ(ran.out.find("rigid:ssd: largest distance "), 0u) << ran.out;
  EXPECT_EQ(ran.out.find("e-"), std::string::npos) << "plain numbers: " << ran.out;
  EXPECT_EQ(frames_of(chunks_of(read_text(folder_ / "h.png"))).size(), 5u);
}

// What is loaded whole to be shown is smaller by default than a picture, which has 960x720.
TEST_F(MovieTest, HasFewerPixelsByDefault) {
  const Ran ran =
      run_marrow({"render", folder_ / "t.mrw", "--clip", "wave", "--movie", "--fps", "1", "-o", folder_ / "one.png"});
  EXPECT_EQ(ran.code, 0) << ran.err;
  const std::string png = read_text(folder_ / "one.png");
  EXPECT_EQ(std::pair(big_endian(png, 16), big_endian(png, 20)), std::pair(480u, 360u));
  EXPECT_EQ(big_endian(png, 24, 2), 0x0803u) << "bytes that name colours";
}

}  // namespace
}  // namespace marrow::test
#endif
