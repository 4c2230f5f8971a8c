#include "export/export_targets.h"

#include <bit>

#include "common/vertex_order.h"

namespace marrow::tools {
namespace {

constexpr const char* kAttributes[] = {"POSITION", "NORMAL", "TANGENT"};

// Where most vertices move every one is written; elsewhere those that do. What moves nothing says so of its first
// vertex: accessors without any data are not read everywhere.
std::size_t add_changes(Glb& glb, const std::vector<float>& changes) {
  std::vector<std::uint32_t> at;
  std::vector<float> moving;
  for (std::uint32_t v = 0; v < changes.size() / 3; ++v) {
    const float* const change = &changes[std::size_t{3} * v];
    if (change[0] == 0 && change[1] == 0 && change[2] == 0) continue;
    at.push_back(v);
    moving.insert(moving.end(), change, change + 3);
  }
  if (at.size() * 4 > changes.size()) return glb.add_bounded(changes, kVec3, Target::vertices);
  if (at.empty()) return glb.add_sparse(changes.size() / 3, {0}, {0, 0, 0}, kVec3);
  return glb.add_sparse(changes.size() / 3, at, moving, kVec3);
}

std::vector<const std::int16_t*> records_of(const Geometry& g, const MorphTarget& target) {
  std::vector<const std::int16_t*> out(g.slot_count / 4, nullptr);
  const auto each = static_cast<std::size_t>(std::popcount(target.attributes));
  for (std::size_t i = 0; i < target.block_count; ++i) {
    const std::size_t entry = target.first_block + i;
    const std::uint32_t block = g.index_bytes == 2 ? static_cast<const std::uint16_t*>(g.target_blocks)[entry]
                                                   : static_cast<const std::uint32_t*>(g.target_blocks)[entry];
    out[block] = g.target_records + 12 * (target.first_record + i * each);
  }
  return out;
}

// What a target does to one of its attributes, in all parts.
std::vector<float> changes_of(std::span<const Geometry> parts, std::size_t target, std::uint32_t attribute,
                              const std::vector<PartSlot>& order) {
  struct Records {
    std::vector<const std::int16_t*> of_block;  // null: the block stays
    int which = 0;                              // of a block's records
    float step = 0;
  };
  std::vector<Records> records(parts.size());
  for (std::size_t part = 0; part < parts.size(); ++part) {
    const MorphTarget& t = parts[part].targets[target];
    if ((t.attributes >> attribute & 1u) == 0) continue;
    const float steps[] = {t.position_step, t.normal_step, t.tangent_step};
    records[part] = {records_of(parts[part], t), std::popcount(t.attributes & ((1u << attribute) - 1)),
                     steps[attribute]};
  }
  std::vector<float> out;
  out.reserve(order.size() * 3);
  for (const auto& [part, slot] : order)
    for (std::size_t c = 0; c < 3; ++c) {
      const Records& from = records[part];
      const std::int16_t* const record = from.of_block.empty() ? nullptr : from.of_block[slot / 4];
      const float whole = record == nullptr ? 0.0f : record[12 * from.which + static_cast<int>(4 * c + slot % 4)];
      out.push_back(whole == 0 ? 0.0f : whole * from.step);
    }
  return out;
}

}  // namespace

Json export_targets(Glb& glb, std::span<const Geometry> parts) {
  const std::vector<PartSlot> order = vertex_order(parts);
  std::uint32_t attributes = kMorphsPositions;
  for (const Geometry& g : parts)
    for (const MorphTarget& target : g.targets) attributes |= target.attributes;
  Json out = Json::array();
  for (std::size_t t = 0; t < parts[0].targets.size; ++t) {
    Json changes = Json::object();
    for (std::uint32_t a = 0; a < 3; ++a)
      if ((attributes >> a & 1u) != 0) changes[kAttributes[a]] = add_changes(glb, changes_of(parts, t, a, order));
    out.push_back(changes);
  }
  return out;
}

Json still_targets(Glb& glb, std::size_t positions, std::size_t count) {
  const std::size_t vertices = glb.json["accessors"][positions]["count"];
  const Json still = {{kAttributes[0], add_changes(glb, std::vector<float>(vertices * 3, 0.0f))}};
  return Json(count, still);
}

}  // namespace marrow::tools
