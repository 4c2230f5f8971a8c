// marrow_bits: prints a hash for every stage and one of them all; exit code 1 if any is not the one that is stored
// here.
//
// A hash that differs on one processor only is a bug there. One that differs on all is a change of results: see that
// the road tests still hold, then store what this prints and say why in the commit.
#include <cinttypes>
#include <cstdio>
#include <cstring>
#include <iterator>
#include <new>

#include "bits/stages.h"

namespace marrow::test {
namespace {

constexpr StageHash kStored[] = {
    {"the creature of noise", 0x9710868BCF1CFB79},
    {"sample", 0xD7885F5C53EEE295},
    {"local_to_model", 0xC37D058FF32F6F79},
    {"build_palette", 0x5EF9EA3346008E53},
    {"skin_rigid", 0xCD9A9BD3C93216B7},
    {"skin_ssd", 0x7DB7971F09C904D5},
    {"skin_as", 0x329A05E316075D1B},
    {"skin_rigid, normals blended", 0x415B8FE16EAAC0D2},
    {"skin_ssd, normals blended", 0x47F9E5D7F59CCF70},
    {"skin_as, normals blended", 0x9BFC5D5F8DE93A9E},
    {"sample", 0x864A09F7B392E4DA},
    {"local_to_model", 0x87E0E1E053627420},
    {"build_palette", 0x2991113F2FC9A40C},
    {"skin_rigid", 0x734C3F0E1F5BA270},
    {"skin_ssd", 0x2B2438A337C8A20D},
    {"skin_as", 0xA1D01A567C91AB9D},
    {"skin_rigid, normals blended", 0x5F06B979E1A57093},
    {"skin_ssd, normals blended", 0xBE3F31E331E3B350},
    {"skin_as, normals blended", 0xD288E1A55DA013D6},
    {"helpers", 0x35DBC2D9FFD35E9B},
    {"helpers about centres", 0x2D8D2A182BFC1AF4},
    {"evaluate_curve", 0xA7B621FF61A04C56},
    {"splines, lengths, Bezier curves", 0x0971799CF199F8C9},
    {"ease", 0x103498BA5D13A5C3},
    {"blend, overlay, add", 0x39971F46061DD487},
    {"inertia, fades", 0x6D13E9D127642971},
    {"advance", 0x4F2CABAC9C6F885C},
    {"morph", 0xE3E4EDF40629573D},
    {"skin_mwe", 0xDBFEE162F0108126},
    {"skin_psd", 0x1A75385F8B210DF4},
    {"as_tangents", 0x4C48EC061FD99C0B},
    {"skin_as, normals by tangents", 0xEAA4E4084A861FF4},
    {"as_tangents of helpers", 0x88DE759EC2604C6A},
    {"events, root steps", 0xDA96F53CC100549F},
    {"phases, speeds", 0xB5AF884CDB21D73B},
    {"retarget_pose", 0xA02B0A58EA9005C8},
    {"two_bone", 0xFC85513CFED75780},
    {"aim, look_at", 0x83567333D10CAD52},
    {"FABRIK", 0x59BF1DB2BBFC7AF8},
    {"CCD", 0x4209EFB1F92DCC49},
    {"damped least squares", 0x2148B4E2182A5225},
    {"Gauss-Newton", 0x3047529D24C37E3C},
    {"genetic", 0x6C81F2D2CA90592A},
    {"place_feet", 0x82CF36B3A416A874},
    {"simulate_springs", 0x4A1D786CE4FB058A},
    {"a file", 0x78953D31C3739208},
    {"channels, additive clips", 0xEF110E22CF468C32},
    {"a clip at uneven times", 0xAFBEA18630CBECCA},
    {"a coded clip", 0xBB8AF45716A068AD},
    {"some joints of a coded clip", 0x2DFBA8D1072E0E34},
    {"a clip pack", 0xF85BB1BE447E2F8D},
    {"half-joints", 0x11C9ABFE8ADD36CB},
    {"a helper about a centre", 0x356396B41926B66C},
    {"materials, nodes", 0x3D5A416F8608F33C},
    {"levels of detail", 0x309F339A0F2B5A38},
    {"limits", 0x29D2E77DC9998191},
    {"example shapes", 0x799DAEC328666B4F},
    {"an animator", 0x1390DD6027AC81AC},
    {"unpack, a coded clip", 0xF85BB1BE447E2F8D},
    {"unpack", 0x97846384F63C80E5},
    {"unpack, deformers", 0xEA4789054240AE97},
    {"unpack, a residual apart", 0xC7586506C8AFD90B},
};

int run() {
  set_call_error_handler(nullptr);  // of clips of both kinds each is tried as the other
  StageHashes found;
  hash_poses(found);
  hash_motions(found);
  hash_reach(found);
  hash_files(found);
  std::uint64_t all = kHashStart;
  std::size_t different = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const auto [stage, value] = found[i];
    all = hash(all, &value, sizeof value);
    const bool same = i < std::size(kStored) && kStored[i].hash == value && std::strcmp(kStored[i].stage, stage) == 0;
    different += same ? 0 : 1;
    std::printf("    {\"%s\", 0x%016" PRIX64 "},%s\n", stage, value, same ? "" : "  // not what is stored");
  }
  if (found.size() != std::size(kStored)) ++different;
  std::printf("bits %016" PRIX64 "%s\n", all, different == 0 ? "" : " DIFFERS");
  return different == 0 ? 0 : 1;
}

}  // namespace
}  // namespace marrow::test

// The arrays of a mesh lie on boundaries of 16 bytes, which 32-bit ARM's allocator does not give of itself.
void* operator new(std::size_t bytes) {
  return ::operator new (bytes, std::align_val_t{16});
}
void operator delete(void* memory) noexcept {
  ::operator delete (memory, std::align_val_t{16});
}
void operator delete(void* memory, std::size_t) noexcept {
  ::operator delete (memory, std::align_val_t{16});
}

int main() {
  return marrow::test::run();
}
