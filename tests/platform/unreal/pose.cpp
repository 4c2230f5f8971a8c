// Behind the C++ of docs/platforms/unreal.md: corner.py's joint at the end of its clip, by that page's axes.
#include <cmath>
#include <cstdio>
#include <vector>

int main(int argc, char** argv) {
  std::FILE* const stream = argc > 1 ? std::fopen(argv[1], "rb") : nullptr;
  alignas(16) static char bytes[1 << 16];
  if (stream == nullptr) return 1;
  const size_t size = std::fread(bytes, 1, sizeof bytes, stream);
  std::fclose(stream);
  mrw_soa_transform local;
  mrw_affine joint;
  if (PoseAt(bytes, size, "no such clip", 1, &local, 1, &joint, 1) || PoseAt(bytes, 9, "turn", 1, &local, 1, &joint, 1))
    return 1;
  if (!PoseAt(bytes, size, "turn", 1, &local, 1, &joint, 1)) return 1;
  const float x = joint.rows[0][3], y = joint.rows[1][3], z = joint.rows[2][3];
  std::printf("Unreal: the joint is at %g %g %g cm\n", double(100 * z), double(-100 * x), double(100 * y));
  return std::fabs(z - 30) + std::fabs(x - 10) + std::fabs(y - 20) < 1e-4f ? 0 : 1;
}
