#include "cook/read_inputs.h"

#include <limits>
#include <memory>
#include <utility>

#include "common/failure.h"
#include "common/hash.h"
#include "common/retold.h"
#include "cook/prepare/mirrors.h"
#include "cook/retarget/retarget.h"
#include "cook/rig/read_template.h"
#include "text/printable.h"

namespace marrow::cook {
namespace {

// What a file of more bytes is refused with.
struct Largest {
  std::uint64_t bytes;
  std::string advice;
  std::string rule = "too large";
  tools::Exit exit = tools::Exit::usage;
};
const Largest kLargestGraph = {1 << 20, "1 MiB is the limit"};
const Largest kLargestMap = {8 << 20, "8 MiB is the limit"};
const Largest kLargestTemplate = {64 << 10, "64 KiB is the limit"};
// 8192 × 8192 pixels of 16-bit RGBA, not compressed.
const Largest kLargestMask = {512'000'000, "export the picture again, at most 8192 pixels each way",
                              "too large for a mask", tools::Exit::invalid};

class Reader {
 public:
  Reader(Files& files, std::vector<Read>& reads) : files_(files), reads_(reads) {}

  std::vector<std::byte> whole(const std::string& name, const Largest& largest) {
    std::vector<std::byte> bytes = files_.read(name, largest.bytes + 1);
    if (bytes.size() > largest.bytes) throw tools::Failure(largest.exit, name, "", largest.rule, largest.advice);
    reads_.push_back({files_.full_name(name), bytes.size(), tools::hash_of(bytes)});
    return bytes;
  }

  NamedBytes kept(const std::string& name, const Largest& largest) {
    return std::make_shared<const std::vector<std::byte>>(whole(name, largest));
  }

  std::string text(const std::string& name, const Largest& largest) {
    const std::vector<std::byte> bytes = whole(name, largest);
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  }

  std::shared_ptr<const RawScene> scene(RawScene scene) {
    reads_.insert(reads_.end(), scene.reads.begin(), scene.reads.end());
    return std::make_shared<const RawScene>(std::move(scene));
  }

  void rigs(std::vector<RetargetRule>& rules) {
    for (RetargetRule& rule : rules) {
      if (!rule.rig) rule.rig = scene(read_rig(rule.file, files_));
      if (!rule.map.empty() && !rule.pairs)
        rule.pairs = std::make_shared<const RetargetMap>(parse_retarget_map(rule.map, text(rule.map, kLargestMap)));
    }
  }

  deform::SkeletonTemplate skeleton(const std::string& name) {
    const std::string_view builtin = builtin_template(name);
    if (!builtin.empty()) return parse_template(name, builtin);
    return tools::retold<tools::Failure>([&] { return parse_template(name, text(name, kLargestTemplate)); },
                                         [&](const tools::Failure& failure) {
                                           if (failure.rule() != kNoSuchFile) return failure;
                                           return tools::Failure(
                                               tools::Exit::usage, "--auto-skeleton", "",
                                               "\"" + tools::printable(name) + "\" is neither built in nor a file",
                                               "give humanoid, quadruped or a TEMPLATE.toml");
                                         });
  }

 private:
  Files& files_;
  std::vector<Read>& reads_;
};

}  // namespace

RawScene read_rig(const std::string& name, Files& files) {
  return with_one_form_of_mirrors(name.ends_with(".mrw") ? read_cooked_motion(name, files)
                                                         : read_source(name, files, {}));
}

void read_named_files(CookOptions& options, Files& files, std::vector<Read>& reads) {
  Reader reader(files, reads);
  for (GraphRule& rule : options.graphs)
    if (rule.text.empty()) rule.text = reader.text(rule.file, kLargestGraph);
  PrepareOptions& prepare = options.prepare;
  if (!prepare.auto_skeleton.empty() && !prepare.skeleton)
    prepare.skeleton = std::make_shared<const deform::SkeletonTemplate>(reader.skeleton(prepare.auto_skeleton));
  for (PaintRule& rule : prepare.weights.paint)
    if (!rule.bytes) rule.bytes = reader.kept(rule.file, kLargestMask);
  reader.rigs(options.retarget.clips);
  reader.rigs(options.retarget.poses);
  LearnOptions& learn = options.learn;
  if (learn.truth == Truth::examples && !learn.examples)
    learn.examples = reader.scene(read_gltf(learn.examples_file, files));
}

}  // namespace marrow::cook
