// Reading glTF: containers, URIs and files.
#include "cook/gltf/read.h"

#include <sys/stat.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "unit/cook/gltf/document.h"

namespace marrow::cook {
namespace {

void append_u32(std::string& text, std::uint32_t value) {
  for (int i = 0; i < 4; ++i) text += static_cast<char>(value >> (8 * i) & 0xFF);
}

std::string chunk(const std::string& type, std::string content, char padding) {
  while (content.size() % 4 != 0) content += padding;
  std::string text;
  append_u32(text, static_cast<std::uint32_t>(content.size()));
  return text + type + content;
}

std::string glb(const std::string& chunks, std::uint32_t version = 2, int excess = 0) {
  std::string text = "glTF";
  append_u32(text, version);
  append_u32(text, static_cast<std::uint32_t>(static_cast<int>(chunks.size()) + 12 + excess));
  return text + chunks;
}

const std::string kBin("BIN\0", 4);

std::string triangle_json() {
  Builder b;
  b.primitive({{"POSITION", b.curve(3)}});
  b.root["buffers"] = {{{"byteLength", b.bytes.size()}}};
  return b.root.dump();
}

std::string triangle_bin() {
  Builder b;
  b.curve(3);
  return {reinterpret_cast<const char*>(b.bytes.data()), b.bytes.size()};
}

TEST(GltfContainer, BinaryChunkIsTheFirstBuffer) {
  const RawScene scene = read_text(glb(chunk("JSON", triangle_json(), ' ') + chunk(kBin, triangle_bin(), '\0')));
  EXPECT_TRUE(scene.warnings.empty());
  EXPECT_EQ(scene.meshes[0].primitives[0].positions[2], glm::vec3(2, 4, 0));
}

TEST(GltfContainer, BytesAfterTheEndAreDropped) {
  const std::string file = glb(chunk("JSON", triangle_json(), ' ') + chunk(kBin, triangle_bin(), '\0'));
  const RawScene scene = read_text(file + "and more");
  EXPECT_TRUE(warns(scene, "glb-trailing-bytes", "@" + std::to_string(file.size())));
}

TEST(GltfContainer, BreachesAreLocated) {
  const std::string json = chunk("JSON", R"({"asset":{"version":"2.0"}})", ' ');  // 8 + 28 bytes
  const std::string bin = chunk(kBin, "data", '\0');
  expect_refused("glTF", Exit::invalid, "@4", "cut short");
  expect_refused(glb(json, 1), Exit::unsupported, "@4", "version 1");
  expect_refused(glb(json, 3), Exit::invalid, "@4", "version 3");
  expect_refused(glb(""), Exit::invalid, "@8", "too small");
  expect_refused(glb(json, 2, 4), Exit::invalid, "@48", "cut short");
  expect_refused(glb(bin + json), Exit::invalid, "@12", "not JSON");
  expect_refused(glb(chunk("JSON", "", ' ')), Exit::invalid, "@12", "empty");
  expect_refused(glb(json + json), Exit::invalid, "@48", "second JSON");
  expect_refused(glb(json + bin + bin), Exit::invalid, "@60", "second BIN");
  expect_refused(glb(json + chunk("XXXX", "data", ' ') + bin), Exit::invalid, "@60", "misplaced");
  expect_refused(glb(json + "abc"), Exit::invalid, "@51", "header cut short");
  std::string huge;
  append_u32(huge, 0xFFFFFFFC);
  expect_refused(glb(huge + "JSON{}  "), Exit::invalid, "@12", "too long");
  std::string odd;
  append_u32(odd, 3);
  expect_refused(glb(odd + "JSON{} "), Exit::invalid, "@12", "multiple of 4");
  const RawScene scene = read_text(glb(json + chunk("XXXX", "data", ' ')));
  EXPECT_TRUE(warns(scene, "unknown-chunk", "@48"));
}

TEST(GltfContainer, EveryPrefixIsRefused) {
  const std::string file = glb(chunk("JSON", triangle_json(), ' ') + chunk(kBin, triangle_bin(), '\0'));
  std::size_t refused = 0;
  for (std::size_t length = 0; length < file.size(); ++length) {
    EXPECT_THROW(read_text(file.substr(0, length)), Failure) << length;
    ++refused;
  }
  EXPECT_EQ(refused, file.size());
}

TEST(GltfContainer, OtherFilesAreNamedAsSuch) {
  // As the formats' own documents have their first bytes.
  const struct {
    std::string bytes;
    const char *says, *advice;
  } others[] = {{std::string("Kaydara FBX Binary  \0\x1a\0", 23), "Autodesk FBX", "tools/fbx_to_glb.sh"},
                {"; FBX 7.4.0 project file\n", "Autodesk FBX", "tools/fbx_to_glb.sh"},
                {"BLENDER-v304", "Blender's own file", "docs/cooking/from_dcc.md"},
                {std::string("PK\x03\x04\x14\0", 6), "a zip archive", "unpack"},
                {"\x1f\x8b\x08", "packed by gzip", "unpack"},
                {"\x28\xb5\x2f\xfd", "packed by Zstandard", "unpack"},
                {"\x89PNG\r\n\x1a\n", "a PNG picture", "model"},
                {"\xff\xd8\xff\xe0", "a JPEG picture", "model"},
                {"version https://git-lfs.github.com/spec/v1\n", "a pointer of Git LFS", "git lfs pull"},
                {"<!DOCTYPE html>", "XML or a web page", "export"}};
  for (const auto& other : others) {
    expect_refused(other.bytes, Exit::invalid, "@0", "not a glTF file but, as it begins, " + std::string(other.says));
    std::string advice;
    try {
      read_text(other.bytes);
    } catch (const Failure& failure) {
      advice = failure.advice();
    }
    EXPECT_NE(advice.find(other.advice), std::string::npos) << other.says << ": " << advice;
  }
  for (const char* const unknown : {"PK", "Kaydara", "\x1f", "hello"})
    expect_refused(unknown, Exit::invalid, "@0", "not a glTF file");
  expect_refused("", Exit::invalid, "@0", "empty file");
}

class GltfFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string name = (std::filesystem::temp_directory_path() / "gltf_test_XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    outer_ = name;
    folder_ = outer_ / "scene";
    std::filesystem::create_directory(folder_);
    write(outer_ / "secret.bin", std::string(64, 's'));
  }
  void TearDown() override { std::filesystem::remove_all(outer_); }

  static void write(const std::filesystem::path& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
  }

  std::string scene_with_uri(const std::string& uri, std::size_t length = 36) {
    Builder b;
    b.primitive({{"POSITION", b.curve(3)}});
    b.root["buffers"] = {{{"byteLength", length}, {"uri", uri}}};
    const std::string path = (folder_ / "scene.gltf").string();
    write(path, b.root.dump());
    return path;
  }

  std::filesystem::path outer_, folder_;
};

TEST_F(GltfFiles, ExternalBufferIsRead) {
  write(folder_ / "a b.bin", triangle_bin() + "rest");
  const std::string path = scene_with_uri("a%20b.bin");
  const RawScene scene = read_gltf(path);
  EXPECT_EQ(scene.meshes[0].primitives[0].positions[1], glm::vec3(1, 1, 0));
  EXPECT_EQ(scene.source, path);
  EXPECT_EQ(scene.source_bytes, std::filesystem::file_size(path) + 36);
}

TEST_F(GltfFiles, HostileUrisAreRefused) {
  const char* uris[] = {"../secret.bin",
                        "..%2fsecret.bin",
                        "%2e%2e/secret.bin",
                        "x/../../secret.bin",
                        "/etc/passwd",
                        "file:///etc/passwd",
                        "http://127.0.0.1/x",
                        "c:\\x",
                        "c:x",
                        "\\\\host\\x",
                        "..\\secret.bin",
                        "a%00b",
                        "a%0ab",
                        "%",
                        "%zz",
                        "~/x",
                        ""};
  std::size_t refused = 0;
  for (const char* uri : uris) {
    SCOPED_TRACE(uri);
    const std::string path = scene_with_uri(uri);
    const bool malformed = std::string(uri).starts_with("%") && std::string(uri).size() < 4;
    expect_failure([&] { read_gltf(path); }, Exit::invalid, "/buffers/0/uri",
                   malformed ? "malformed URI" : "not allowed");
    ++refused;
  }
  EXPECT_EQ(refused, std::size(uris));
}

TEST_F(GltfFiles, UrisAreDecodedOnce) {
  expect_failure([&] { read_gltf(scene_with_uri("..%252fsecret.bin")); }, Exit::io, "/buffers/0/uri", "no such file");
}

TEST_F(GltfFiles, LinksMayNotLeaveTheFolder) {
  std::filesystem::create_symlink(outer_ / "secret.bin", folder_ / "link.bin");
  expect_failure([&] { read_gltf(scene_with_uri("link.bin")); }, Exit::invalid, "/buffers/0/uri", "not allowed");
  write(folder_ / "real.bin", triangle_bin());
  std::filesystem::create_symlink("real.bin", folder_ / "good.bin");
  EXPECT_EQ(read_gltf(scene_with_uri("good.bin")).meshes.size(), 1U);
}

TEST_F(GltfFiles, OnlyRegularFilesAreOpened) {
  expect_failure([&] { read_gltf(scene_with_uri("none.bin")); }, Exit::io, "/buffers/0/uri", "no such file");
  expect_failure([&] { read_gltf(scene_with_uri(".")); }, Exit::io, "/buffers/0/uri", "is a directory");
  ASSERT_EQ(mkfifo((folder_ / "pipe.bin").c_str(), 0600), 0);
  expect_failure([&] { read_gltf(scene_with_uri("pipe.bin")); }, Exit::io, "/buffers/0/uri", "not a regular file");
  expect_failure([&] { read_gltf((folder_ / "pipe.bin").string()); }, Exit::io, "@0", "not a regular file");
  expect_failure([&] { read_gltf(folder_.string()); }, Exit::io, "@0", "is a directory");
  expect_failure([&] { read_gltf((folder_ / "none.gltf").string()); }, Exit::io, "@0", "no such file");
  expect_failure([&] { read_gltf("/dev/zero"); }, Exit::io, "@0", "not a regular file");
}

TEST_F(GltfFiles, ShortBuffersAreRefused) {
  write(folder_ / "short.bin", "abc");
  expect_failure([&] { read_gltf(scene_with_uri("short.bin")); }, Exit::invalid, "/buffers/0/byteLength",
                 "longer than the data");
}

TEST(GltfUris, MemoryHasNoFolder) {
  Builder b;
  b.root["buffers"] = {{{"byteLength", 4}, {"uri", "x.bin"}}};
  expect_failure([&] { read(b); }, Exit::io, "/buffers/0/uri", "cannot read");
}

TEST(GltfUris, DataUrisAreStrict) {
  const auto with = [](const std::string& uri) {
    return Json{{"asset", {{"version", "2.0"}}}, {"buffers", {{{"byteLength", 1}, {"uri", uri}}}}}.dump();
  };
  for (const char* good : {"data:application/octet-stream;base64,AA==", "data:application/gltf-buffer;base64,AAAA",
                           "data:application/gltf-buffer,%00", "data:application/octet-stream;charset=x;base64,AAA="}) {
    EXPECT_NO_THROW(read_text(with(good))) << good;
  }
  for (const char* bad : {"data:", "data:application/octet-stream;base64", "data:application/octet-stream;;base64,AA==",
                          "data:application/octet-stream;base64;x=y,AA==", "data:application/octet-stream;base64,AA",
                          "data:application/octet-stream;base64,AB==", "data:application/octet-stream;base64,====",
                          "data:application/octet-stream;base64,A A=", "data:application/octet-stream;base64,!!!!",
                          "data:application/octet-stream,%0", "data:text/plain;base64,AA=="}) {
    EXPECT_THROW(read_text(with(bad)), Failure) << bad;
  }
}

}  // namespace
}  // namespace marrow::cook
