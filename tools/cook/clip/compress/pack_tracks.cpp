#include "cook/clip/compress/pack_tracks.h"

#include <cstring>

namespace marrow::cook {
namespace {

// Least significant bit first.
class BitWriter {
 public:
  explicit BitWriter(std::vector<std::byte>& to) : to_(to) {}
  void put(std::uint32_t value, std::uint32_t bits) {
    for (std::uint32_t i = 0; i < bits; ++i, ++used_) {
      if (used_ % 8 == 0) to_.push_back(std::byte{0});
      if ((value >> i & 1u) != 0) to_.back() |= std::byte{1} << (used_ % 8);
    }
  }

 private:
  std::vector<std::byte>& to_;
  std::size_t used_ = 0;
};

template <class T>
void append(std::vector<std::byte>& to, const T& value) {
  const auto* first = reinterpret_cast<const std::byte*>(&value);
  to.insert(to.end(), first, first + sizeof value);
}

format::TrackHeader header_of(const CodedTrack& track) {
  format::TrackHeader h{};
  h.codes[0] = static_cast<std::uint8_t>(track.shift | track.width_codes[0] << 4);
  h.codes[1] = static_cast<std::uint8_t>(track.width_codes[1] | track.width_codes[2] << 4);
  h.step = static_cast<std::uint8_t>(track.step_code);
  for (std::size_t c = 0; c < 3; ++c) h.least[c] = static_cast<std::int16_t>(track.least[c]);
  return h;
}

std::uint16_t mask_of(const TrackId& id) {
  const int first = id.path == TrackPath::rotation ? 0 : id.path == TrackPath::translation ? 4 : 8;
  return static_cast<std::uint16_t>(1 << (first + static_cast<int>(id.joint % 4)));
}

}  // namespace

Packer::Packer(const std::vector<TrackId>& moving, const std::vector<ConstantTrack>& constant,
               std::size_t joint_count) {
  out_.masks.resize(soa_count(joint_count));
  for (const TrackId& id : moving) out_.masks[id.joint / 4].moving |= mask_of(id);
  for (const ConstantTrack& track : constant) {
    out_.masks[track.id.joint / 4].constant |= mask_of(track.id);
    out_.constants.push_back(track.numbers);
  }
  out_.header.track_count = static_cast<std::uint32_t>(moving.size());
  out_.header.constant_count = static_cast<std::uint32_t>(constant.size());
}

void Packer::add(const std::vector<CodedTrack>& tracks) {
  out_.offsets.push_back(static_cast<std::uint32_t>(out_.payload.size()));
  std::uint32_t frame_bits = 0;
  for (const CodedTrack& track : tracks) frame_bits += track.frame_bits;
  append(out_.payload, (frame_bits + 7) / 8);
  for (const CodedTrack& track : tracks) append(out_.payload, header_of(track));
  for (std::size_t frame = 0; !tracks.empty() && frame < tracks[0].values.size(); ++frame) {
    BitWriter record(out_.payload);
    for (const CodedTrack& track : tracks)
      for (std::size_t c = 0; c < 3; ++c) {
        const std::int32_t least = track.least[c] * (1 << track.shift);
        record.put(static_cast<std::uint32_t>(track.values[frame][c] - least),
                   format::component_bits(track.width_codes[c]));
      }
  }
}

BuiltCoded Packer::finish(const Grid& grid, std::size_t segment_intervals) {
  out_.payload.insert(out_.payload.end(), format::kPayloadPadding, std::byte{0});
  out_.header.frame_count = static_cast<std::uint32_t>(grid.intervals + 1);
  out_.header.segment_intervals = static_cast<std::uint32_t>(segment_intervals);
  out_.header.frames_per_s = static_cast<float>(static_cast<double>(grid.intervals) /
                                                (static_cast<double>(grid.end_s) - static_cast<double>(grid.start_s)));
  out_.header.start_s = grid.start_s;
  out_.header.time_count = static_cast<std::uint32_t>(grid.times_s.size());
  out_.times_s = grid.times_s;
  out_.header.payload_bytes = static_cast<std::uint32_t>(out_.payload.size());
  return std::move(out_);
}

}  // namespace marrow::cook
