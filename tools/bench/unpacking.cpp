// The rows unpack/…: packed files in whole, and what their records take, kind by kind.
#include <algorithm>
#include <array>

#include "bench/workload.h"
#include "common/aligned_bytes.h"
#include "common/check_status.h"
#include "marrow/draco.h"
#include "marrow/meshopt.h"
#include "marrow/unpack.h"
#include "unpack/clip/clip_record.h"
#include "unpack/geometry.h"
#include "unpack/records.h"
#include "unpack/structure.h"

namespace marrow::tools {
namespace {

void check_rule(const char* rule) {
  if (rule != nullptr) throw Failure(Exit::internal, "bench", "", rule, "please report this");
}

std::array<MeshDecoder, 2> both_decoders() {
  return {draco_decoder(), meshopt_decoder()};
}

// Integers of coded clips: one a frame of each component that has bits.
std::uint32_t coded_integers(const File& file) {
  std::uint32_t count = 0;
  for (std::uint32_t c = 0; c < file.clip_count(); ++c) {
    const CodedTracks& coded = file.clip(c).coded;
    if (coded.frame_count < 2) continue;
    format::CodedHeader h{};
    h.frame_count = coded.frame_count;
    h.segment_intervals = coded.segment_intervals;
    for (std::uint32_t s = 0; s < format::segment_count(h); ++s) {
      const std::uint32_t left = h.frame_count - 1 - s * h.segment_intervals;
      const std::byte* const heads = coded.payload + coded.segment_offsets[s] + 4;
      for (std::uint32_t t = 0; t < coded.track_count; ++t) {
        format::TrackHeader head;
        std::memcpy(&head, heads + t * sizeof head, sizeof head);
        const std::uint32_t widths = static_cast<std::uint32_t>(head.codes[0] >> 4 | head.codes[1] << 4);
        for (std::uint32_t shift = 0; shift < 12; shift += 4)
          if ((widths >> shift & 15) != 0) count += std::min(left, h.segment_intervals) + 1;
      }
    }
  }
  return count;
}

// A packed file and what it unpacks to, in place. All parts do again what has been done once, to the same bytes.
class PackedModel : public Workload {
 public:
  explicit PackedModel(const std::vector<std::byte>& packed) : packed_(std::span<const std::byte>(packed)) {
    UnpackSizes sizes;
    check(unpack_sizes(bytes(), sizes));
    memory_ = AlignedBytes(sizes.memory_bytes);
    PackedModel::run(1);
    check(load(unpacked_, file_));
    ByteReader reader(packed_.data() + sizeof(packed::Header), packed_.size() - sizeof(packed::Header));
    for (const File::Section& section : file_.sections()) {
      std::byte* const first = memory_.data() + section.offset;
      records_.push_back({take_record(reader), {first, static_cast<std::size_t>(unpacked_.end() - first)}});
    }
    for (std::uint32_t m = 0; m < file_.mesh_count(); ++m) vertex_count_ += file_.mesh(m).geometry.vertex_count;
  }

  std::uint32_t items() const override { return vertex_count_; }
  std::uint64_t hash_output(std::uint64_t state) const override {
    return state ^ format::checksum(unpacked_.data, unpacked_.size);
  }
  void run(std::uint64_t iterations) override {
    const auto decoders = both_decoders();
    for (std::uint64_t i = 0; i < iterations; ++i)
      check(unpack(bytes(), {decoders.data(), decoders.size()}, {memory_.data(), memory_.size()}, unpacked_));
  }

 protected:
  struct PackedRecord {
    Record record;
    Span<std::byte> section;  // where it was unpacked, and all behind
  };
  Span<const std::byte> bytes() const { return {packed_.data(), packed_.size()}; }
  Span<std::byte> scratch() {
    const std::size_t first = (unpacked_.size + 15) / 16 * 16;
    return {memory_.data() + first, memory_.size() - first};
  }
  UnpackedSkeletons skeletons() const {
    std::uint32_t count = 0;
    while (count < records_.size() && records_[count].record.kind == format::kSkeletons) ++count;
    return {memory_.data(), count, 0};
  }

  AlignedBytes packed_, memory_;
  Span<const std::byte> unpacked_;
  File file_;
  std::vector<PackedRecord> records_;
  std::uint32_t vertex_count_ = 0;
};

class PackedClips : public PackedModel {
 public:
  using PackedModel::PackedModel;
  std::uint32_t items() const override { return coded_integers(file_); }
  void run(std::uint64_t iterations) override {
    for (std::uint64_t i = 0; i < iterations; ++i) {
      bool has_models = false;
      for (const PackedRecord& r : records_) {
        if (r.record.kind != format::kClips) continue;
        std::uint32_t size = 0, codec = 0;
        check_rule(unpack_clip(r.record.bytes, skeletons(), has_models, scratch(), r.section, size, codec));
      }
    }
  }
};

// Skeletons, meshes without their geometry, and names.
class PackedStructure : public PackedModel {
 public:
  using PackedModel::PackedModel;
  std::uint32_t items() const override {
    std::uint32_t joints = 0;
    for (std::uint32_t s = 0; s < file_.skeleton_count(); ++s) joints += file_.skeleton(s).joint_count;
    return joints;
  }
  void run(std::uint64_t iterations) override {
    for (std::uint64_t i = 0; i < iterations; ++i) {
      NameReader names(records_.back().record.bytes);
      for (const PackedRecord& r : records_) {
        std::uint32_t size = 0;
        if (r.record.codec != packed::kCompact) continue;
        if (r.record.kind == format::kSkeletons) check_rule(unpack_skeleton(r.record.bytes, names, r.section, size));
        if (r.record.kind == format::kNames) check_rule(unpack_names(r.record.bytes, r.section, size));
        if (r.record.kind == format::kMeshes)
          check_rule(unpack_mesh(r.record.bytes, skeletons(), scratch(), r.section, size));
      }
    }
  }
};

enum class GeometryPart { decode, arrange, write };

class PackedGeometry : public PackedModel {
 public:
  PackedGeometry(const std::vector<std::byte>& packed, GeometryPart part) : PackedModel(packed), part_(part) {
    for (const PackedRecord& r : records_) {
      if (r.record.kind != format::kGeometries) continue;
      Step& step = steps_.emplace_back(Step{r, AlignedBytes(scratch().size), {}});
      decode(step);
      for (bool done = false; !done;) check_rule(finish_streams(step.work, done));
      step.decoded = step.work.scratch;
      arrange(step);
    }
  }
  void run(std::uint64_t iterations) override {
    for (std::uint64_t i = 0; i < iterations; ++i)
      for (Step& step : steps_) {
        if (part_ == GeometryPart::decode) decode(step);
        if (part_ == GeometryPart::arrange) arrange(step);
        std::uint32_t size = 0;
        if (part_ == GeometryPart::write)
          check_rule(write_geometry(step.work.streams, step.work.arrangement, step.from.section, size));
      }
  }

 private:
  struct Step {
    PackedRecord from;
    AlignedBytes memory;
    GeometryInWork work;
    Memory decoded = {};
  };
  static void decode(Step& step) {
    Status decoded = Status::ok;
    for (const MeshDecoder& decoder : both_decoders())
      if (decoder.codec == step.from.record.codec)
        check_rule(decode_geometry(step.from.record.bytes, decoder, {step.memory.data(), step.memory.size()}, step.work,
                                   decoded));
  }
  static void arrange(Step& step) {
    step.work.scratch = step.decoded;
    step.work.arrangement = {};
    check_rule(arrange_geometry(step.work.streams, step.work.scratch, step.work.arrangement));
  }

  GeometryPart part_;
  std::vector<Step> steps_;
};

struct PackedSource {
  const char* name;
  const ModelSource* model;
};
constexpr PackedSource kPackedSources[] = {
    {"newt", &kNewt}, {"CesiumMan", &kCesiumMan}, {"mannequiny", &kMannequiny}, {"ruby", &kRuby}};

}  // namespace

RowGroup unpacking_rows() {
  RowGroup group;
  const auto add = [&](const std::string& name, const ModelSource* model, const char* codec, const auto& make) {
    group.rows.push_back({name, model, {}, [=](Models& from) { return make(from.packed(*model, codec)); }, false});
  };
  std::vector<std::string> models;
  for (const PackedSource& source : kPackedSources) {
    const char* const name = source.name;
    const ModelSource* const model = source.model;
    models.emplace_back(name);
    for (const char* codec : {"draco", "meshopt"}) {
      const auto row = [&](const char* part) { return fmt::format("unpack/{}/{}/{}", codec, part, name); };
      add(row("file"), model, codec, [](const auto& bytes) { return std::make_unique<PackedModel>(bytes); });
      add(row("decode"), model, codec,
          [](const auto& bytes) { return std::make_unique<PackedGeometry>(bytes, GeometryPart::decode); });
      add(row("arrange"), model, codec,
          [](const auto& bytes) { return std::make_unique<PackedGeometry>(bytes, GeometryPart::arrange); });
      add(row("write"), model, codec,
          [](const auto& bytes) { return std::make_unique<PackedGeometry>(bytes, GeometryPart::write); });
    }
    add(fmt::format("unpack/clips/{}", name), model, "meshopt",
        [](const auto& bytes) { return std::make_unique<PackedClips>(bytes); });
    add(fmt::format("unpack/structure/{}", name), model, "meshopt",
        [](const auto& bytes) { return std::make_unique<PackedStructure>(bytes); });
  }
  group.names = fmt::format(
      "unpack/{{draco,meshopt}}/{{file,decode,arrange,write}}/{0}\nunpack/{{clips,structure}}/{0}\n", choice(models));
  return group;
}

}  // namespace marrow::tools
