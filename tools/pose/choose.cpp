#include "pose/choose.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <vector>

#include "common/failure.h"
#include "marrow/clip_pack.h"
#include "pose/misfits_text.h"
#include "text/nearest.h"
#include "text/number.h"
#include "text/printable.h"

namespace marrow::tools {
namespace {

// "hand_l" is missing, …
std::string describe(const File& pack, std::uint32_t reference, const File& file, std::uint32_t skeleton) {
  std::vector<JointMisfit> misfits(kMostMisfits);
  std::size_t count = 0;
  if (bind_clips(pack, reference, file, skeleton, misfits, &count) == Status::ok) return {};
  return misfits_text(
      misfits, count, [&](std::uint32_t joint) { return pack.text(pack.reference(reference).names[joint]); },
      [&](std::uint32_t joint) { return file.text(file.skeleton(skeleton).names[joint]); }, "the pack");
}

std::size_t count_misfits(const File& pack, std::uint32_t reference, const File& file, std::uint32_t skeleton) {
  std::size_t count = 0;
  return bind_clips(pack, reference, file, skeleton, {}, &count) == Status::ok ? 0 : std::max<std::size_t>(count, 1);
}

// Clips of this reference fit no skeleton that is left: throws Failure with what keeps them from the closest.
[[noreturn]] void refuse(const std::string& pack_path, const File& pack, std::uint32_t reference,
                         const std::string& path, const File& file, const Play& play) {
  const std::string name = pack.reference(reference).name;
  std::vector<std::uint32_t> order;
  for (std::uint32_t i = 0; i < file.skeleton_count(); ++i)
    if (!play.clip(i)) order.push_back(i);
  const std::string rule = "skeleton \"" + name + "\" does not fit " + path;
  if (order.empty()) throw Failure(Exit::invalid, pack_path, "", rule, "all its skeletons play another clip");
  std::stable_partition(order.begin(), order.end(), [&](std::uint32_t i) { return file.skeleton(i).name == name; });
  const std::uint32_t closest =
      *std::ranges::min_element(order, {}, [&](std::uint32_t i) { return count_misfits(pack, reference, file, i); });
  throw Failure(Exit::invalid, pack_path, "", rule,
                "in \"" + std::string(file.skeleton(closest).name) + "\" " + describe(pack, reference, file, closest) +
                    "; cook the pack again with --skeleton");
}

void expect_pack(const std::string& path, const File& file) {
  if (file.reference_count() > 0) return;
  throw Failure(Exit::invalid, path, "", "not a clip pack", "cook it with --clips-only");
}

Play play_pack(const std::string& pack_path, const File& pack, const std::string& wanted, const std::string& path,
               const File& file) {
  expect_pack(pack_path, pack);
  const NamedClip named = find_clip(pack_path, pack, wanted);
  const Clip first = pack.clip(named.clip);
  const Play play = play_together(file, pack, named.clip);
  for (std::uint32_t r = 0; r < pack.reference_count(); ++r) {
    const std::uint32_t clip = first.skeleton == r                ? named.clip
                               : *first.name != 0 && !named.alone ? pack.find_clip(first.name, r)
                                                                  : pack.clip_count();
    if (clip < pack.clip_count() && !skeleton_of(play, clip)) refuse(pack_path, pack, r, path, file, play);
  }
  return named.alone ? only(file, play, *skeleton_of(play, named.clip)) : play;
}

Play play_own(const std::string& path, const File& file, const std::string& wanted) {
  const NamedClip named = find_clip(path, file, wanted);
  const Play play = play_together(file, named.clip);
  return named.alone ? only(file, play, file.clip(named.clip).skeleton) : play;
}

std::uint32_t number_in(const std::string& text, std::uint32_t count) {
  std::uint32_t index = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, index);
  return error == std::errc() && stop == end ? std::min(index, count) : count;
}

// What clips move: skeletons, or the references of a pack.
struct Owners {
  explicit Owners(const File& of) : file(of), pack(of.reference_count() > 0) {}
  std::uint32_t count() const { return pack ? file.reference_count() : file.skeleton_count(); }
  std::string name(std::uint32_t owner) const { return pack ? file.reference(owner).name : file.skeleton(owner).name; }
  std::uint32_t find(const std::string& wanted) const {
    std::uint32_t owner = 0;
    while (owner < count() && name(owner) != wanted) ++owner;
    return owner < count() ? owner : number_in(wanted, count());
  }
  const File& file;
  bool pack;
};

std::uint32_t clip_called(const File& file, const std::string& wanted) {
  const std::uint32_t by_name = file.find_clip(wanted.c_str());
  return by_name < file.clip_count() ? by_name : number_in(wanted, file.clip_count());
}

std::uint32_t clip_called(const File& file, const std::string& wanted, std::uint32_t owner) {
  const std::uint32_t by_name = file.find_clip(wanted.c_str(), owner);
  if (by_name < file.clip_count()) return by_name;
  const std::uint32_t by_number = number_in(wanted, file.clip_count());
  return by_number < file.clip_count() && file.clip(by_number).skeleton == owner ? by_number : file.clip_count();
}

[[noreturn]] void refuse(const std::string& path, const File& file, const Owners& owners, const std::string& wanted) {
  std::vector<std::string> names, numbered;
  for (std::uint32_t i = 0; i < file.clip_count(); ++i) {
    const Clip clip = file.clip(i);
    const std::string full = clip.name + (owners.count() > 1 ? "@" + owners.name(clip.skeleton) : std::string());
    names.emplace_back(wanted.find('@') == std::string::npos ? clip.name : full);
    numbered.push_back(std::to_string(i) + " \"" + printable(full) + "\"");
  }
  const std::string question = did_you_mean(wanted, names);
  throw Failure(Exit::usage, path, "", "no clip \"" + printable(wanted) + "\"",
                names.empty() ? "the file has no clips"
                              : question + (question.empty() ? "" : " ") + "there are " + listed(numbered));
}

}  // namespace

std::vector<Play> plays_of_pack(const std::string& pack_path, const File& pack, const std::string& path,
                                const File& file) {
  expect_pack(pack_path, pack);
  std::vector<Play> plays = plays_of(file, pack);
  for (std::uint32_t i = 0; i < pack.clip_count(); ++i)
    if (!skeleton_of(plays[i], i)) refuse(pack_path, pack, pack.clip(i).skeleton, path, file, plays[i]);
  return plays;
}

void expect_joints(const std::string& path, const File& file) {
  if (file.reference_count() == 0) return;
  throw Failure(Exit::invalid, path, "", "a clip pack has nothing to move",
                "name the character's file, and this one with --clips");
}

Chosen choose(const std::string& path, const File& file, const Choice& choice, bool dressed) {
  expect_joints(path, file);
  if (file.mesh_count() == 0 && !dressed) throw Failure(Exit::invalid, path, "", "no mesh", "name a file that has one");
  Chosen out;
  if (!choice.clips.empty()) {
    if (choice.clip.empty())
      throw Failure(Exit::usage, "--clips", "", "no clip is named", "give --clip too, by name or number");
    out.pack = load_mrw(choice.clips);
    out.play = play_pack(choice.clips, out.pack->file, choice.clip, path, file);
  } else if (!choice.clip.empty()) {
    out.play = play_own(path, file, choice.clip);
  }
  return out;
}

std::map<std::string, float> set_parameters(const std::string& path, const File& file, const Choice& choice) {
  const ShapeWeights shapes(file);
  std::vector<std::string> names;
  for (const ExampleSpace& space : shapes.spaces())
    for (const ExampleParameter& p : space.parameters) names.emplace_back(file.text(p.name));
  std::map<std::string, float> out;
  for (const std::string& given : choice.set) {
    const std::size_t divide = given.rfind('=');
    const std::string name = given.substr(0, divide);
    double value = 0;
    const char* const end = given.data() + given.size();
    const char* const number = divide == std::string::npos ? end : given.data() + divide + 1;
    const auto [stop, error] = read_double(number, end, value);
    if (error != std::errc() || stop != end || !std::isfinite(static_cast<float>(value)))
      throw Failure(Exit::usage, "--set", "", "\"" + printable(given) + "\" gives no number",
                    "give NAME=VALUE, as in joy=0.5");
    if (std::ranges::find(names, name) == names.end())
      throw Failure(Exit::usage, path, "", "no parameter \"" + printable(name) + "\"",
                    names.empty() ? "no shapes are in the file" : suggestion(name, names));
    out[name] = static_cast<float>(value);
  }
  return out;
}

NamedClip find_clip(const std::string& path, const File& file, const std::string& wanted) {
  const std::uint32_t whole = clip_called(file, wanted);
  if (whole < file.clip_count()) return {whole, false};
  const Owners owners(file);
  // Names may have an @ of their own.
  for (std::size_t at = wanted.find('@'); at != std::string::npos; at = wanted.find('@', at + 1)) {
    const std::uint32_t owner = owners.find(wanted.substr(at + 1));
    if (owner == owners.count()) continue;
    const std::uint32_t clip = clip_called(file, wanted.substr(0, at), owner);
    if (clip < file.clip_count()) return {clip, true};
  }
  refuse(path, file, owners, wanted);
}

}  // namespace marrow::tools
