// Finds out at start-up which paths the driver can be trusted with, and keeps the answer. See docs/gles/paths.md.
#include <marrow/gles3_self_test.h>

#include <chrono>
#include <cstring>
#include <string>

#include "stage.h"

// Where a game keeps what it knows between two starts.
struct Store {
  std::string folder;

  std::vector<char> read(const char* name) const {
    std::ifstream stream(folder + "/" + name, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  void write(const char* name, const void* bytes, std::size_t size) const {
    std::ofstream(folder + "/" + name, std::ios::binary).write(static_cast<const char*>(bytes), std::streamsize(size));
  }
};

gles3::SelfTest find_paths(Stage& stage, Store& store) {
  gles3::SelfTestOptions options;
  options.timed_vertices = 6789;  // what this game draws most of
  options.timed_characters = 4;
  options.seconds = [](void*) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  };
  // A driver may crash. So the path goes on record before it is tried, and is left out at the next start.
  options.user = &store;
  options.about_to_try = [](void* user, gles3::SkinningPath path) {
    static_cast<Store*>(user)->write("trying", &path, 1);
  };
  const std::vector<char> crashed = store.read("trying");
  if (!crashed.empty()) options.crashed = gles3::bit_of(gles3::SkinningPath(crashed[0]));

  gles3::SelfTest test;
  const std::vector<char> saved = store.read("paths");
  const marrow::Span<const std::byte> kept(reinterpret_cast<const std::byte*>(saved.data()), saved.size());
  if (restore(stage.gl, stage.caps, options, kept, test) == marrow::Status::ok) {
    std::printf("as it was\n");
    return test;
  }
  std::vector<std::byte> memory(gles3::self_test_bytes(options)), out(gles3::kSavedSelfTestBytes);
  must(self_test(stage.gl, stage.caps, options, memory, test), "the self-test");
  must(save(test, out), "saving");
  store.write("paths", out.data(), out.size());
  store.write("trying", nullptr, 0);
  for (std::uint32_t i = 0; i < gles3::kPathCount; ++i)
    std::printf("%-8s %s %.2g m off\n", to_string(gles3::SkinningPath(i)), to_string(test.paths[i].verdict),
                double(test.paths[i].position_error));
  return test;
}

// Says which call an error is of. For debugging: it costs two calls of glGetError around each.
void watch(gles3::Api& gl) {
  static gles3::ErrorWatch errors;
  errors.report = [](void*, const char* call, unsigned error) { std::printf("%s: error 0x%04X\n", call, error); };
  watch_errors(gl, &errors);
}

int main(int argc, char** argv) {
  if (argc < 3) return 1;
  const Asset asset(argv[1]);
  Store store{argv[2]};
  Stage stage;
  stage.open();
  watch(stage.gl);
  const gles3::SelfTest test = find_paths(stage, store);

  gles3::PathNeed need;
  need.passes = 2;  // shadow and colour
  need.characters = 4;
  need.joints = asset.file.mesh(0).palette_size();
  gles3::SkinnerOptions options;
  must(choose(test, need, options.path), "no path is usable");
  options.instances = need.characters;
  std::printf("taken: %s\n", to_string(options.path));

  stage.gl.BindTexture(0x1234, 0);  // a mistake, to see the watch at work
  watch_errors(stage.gl, nullptr);
}
