// How deep the soles of the hero of platform/sdl/game.cpp sink, and how high they hover, as its vertices have it: they
// are skinned on the CPU over two strides, at a frame time that varies. Fails beyond 1 cm, and if no foot stands.
#define main game_main
#include "../../../platform/sdl/game.cpp"
#undef main

namespace {

// The vertices below 5 mm at rest, of the foot on one side.
std::vector<std::uint32_t> sole_of(const std::vector<float>& at, float side) {
  std::vector<std::uint32_t> out;
  for (std::uint32_t v = 0; 3 * v < at.size(); ++v)
    if (at[3 * v + 1] < 0.005f && at[3 * v] * side > 0) out.push_back(v);
  return out;
}

}  // namespace

int main(int, char** argv) {
  options.frames = 1;
  options.file = argv[1];
  const marrow::File file = open_file(options.file);
  Hero hero;
  hero.make(file);
  const marrow::Mesh mesh = file.mesh(file.find_mesh("body"));
  std::vector<marrow::Affine> palette(mesh.palette_size());
  std::vector<float> at(3 * std::size_t(mesh.geometry.slot_count));
  const auto skin = [&] {
    must(build_palette(mesh, hero.body.skeletons[0].pose.model_from_joint, palette), "the palette");
    must(skin_ssd(mesh, palette, {.positions = at}), "skinning");
  };
  skin();  // the rest pose
  const std::vector<std::uint32_t> soles[] = {sole_of(at, 1), sole_of(at, -1)};
  float deepest = 0, highest = 0, steepest = 0;
  int standing = 0;
  float time_s = 0;
  for (int frame = 0; frame < 400; ++frame) {
    const float dt_s = 0.003f + 0.002f * float(frame * 7 % 5);
    time_s += dt_s;
    const float walked = kWalk_mps * time_s;
    hero.move(dt_s, walked);
    skin();
    for (int i = 0; i < 2; ++i) {
      if (!hero.ground[i].planted) continue;
      ++standing;
      float lowest = 1;
      for (const std::uint32_t v : soles[i])
        lowest = std::min(lowest, at[3 * v + 1] - hill(at[3 * v], at[3 * v + 2] + walked));
      deepest = std::max(deepest, -lowest);
      highest = std::max(highest, lowest);
      const float* const n = hero.ground[i].normal;
      steepest = std::max(steepest, std::sqrt(n[0] * n[0] + n[2] * n[2]) / n[1]);
    }
  }
  std::printf(
      "%zu and %zu vertices of soles, %d times a foot stands, on slopes up to 1 in %.1f: "
      "at most %.1f mm deep, %.1f mm high\n",
      soles[0].size(), soles[1].size(), standing, double(1 / steepest), double(1000 * deepest), double(1000 * highest));
  return standing > 300 && deepest < 0.01f && highest < 0.01f ? 0 : 1;
}
