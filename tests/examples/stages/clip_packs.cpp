// Clips from a file of their own, and why they might not fit.
// $ clip_packs hero.mrw pack.mrw stranger.mrw
#include "asset.h"

using marrow::Status;

int main(int argc, char** argv) {
  Asset hero, pack, stranger;
  if (argc < 4 || hero.open(argv[1]) != Status::ok || pack.open(argv[2]) != Status::ok ||
      stranger.open(argv[3]) != Status::ok)
    return 1;

  // Once a load: what the pack's clips were made for must be this skeleton.
  if (bind_clips(pack.file, 0, hero.file, 0) != Status::ok) return 1;

  // Then they are clips like any others.
  const marrow::Skeleton skeleton = hero.file.skeleton(0);
  const marrow::Clip walk = pack.file.clip(pack.file.find_clip("walk"));
  std::vector<marrow::SoaTransform> local(skeleton.soa_size());
  if (sample(skeleton, walk, 0.3f, local) != Status::ok) return 1;
  marrow::JointTransform hand;
  if (get_joint(local, hero.file.find_joint(skeleton, "hand.L"), hand) != Status::ok) return 1;
  std::printf("hand.L is turned by %.4f %.4f %.4f %.4f\n", double(hand.rotation[0]), double(hand.rotation[1]),
              double(hand.rotation[2]), double(hand.rotation[3]));

  // A character of which they know nothing: the first joints that are in the way.
  marrow::JointMisfit misfits[2];
  std::size_t count = 0;
  const Status status = bind_clips(pack.file, 0, stranger.file, 0, misfits, &count);
  std::printf("of a stranger: %s, %zu joints are in the way\n", to_string(status), count);
  for (std::size_t i = 0; i < std::min<std::size_t>(count, 2); ++i)
    if (misfits[i].how == marrow::Misfit::missing)
      std::printf("it has no joint \"%s\"\n", pack.file.text(pack.file.reference(0).names[misfits[i].joint]));
}

// Prints:
//   hand.L is turned by 0.0194 0.0018 -0.1099 0.9937
//   of a stranger: does not fit, 51 joints are in the way
//   it has no joint "pelvis"
//   it has no joint "spine_1"
