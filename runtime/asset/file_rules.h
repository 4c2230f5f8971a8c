// The rules of docs/format.md as lines of a table, which Checker keeps to; file_rules.cpp holds the table.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/builtins.h"

namespace marrow {

// What a number of a rule belongs to.
enum class From : std::uint8_t {
  record,     // what is looked at: a header, or an element of an array
  header,     // of the section
  owner,      // header of the skeleton or reference that the section is for
  counts,     // of sections, by kind
  arrays,     // where the arrays of the section begin, by number
  constants,  // constants_of_rules()
  count
};

// An unsigned number of 1, 2 or 4 bytes, and where it stands.
struct RuleNumber {
  std::uint16_t from : 3, bytes : 3, at : 10;
};

// In this order: what ends a list, what decides on the next rule, what compares, and others.
enum class How : std::uint8_t {
  begins,  // a list of rules; ends the one before it
  ends,    // the rules of each element
  // The next rule counts if number and limit
  where_bits,    // share some bits
  where_lacks,   // share none
  where_differ,  // differ
  // A number and its limit:
  equal,
  below,
  at_most,
  at_least,
  differ,
  from_1_to,
  only_bits,     // none that the limit lacks
  not_negative,  // a float
  positive,      // a float
  // Others:
  floats,        // from the number on, `count` of them, without their signs less than the one with the limit's bits
  floats_until,  // the same, from one array to another; `count` is the limit's place among constants
  name,
  text,
  owner,  // the number of a skeleton; where `count` is 1, of a reference in files that have those
  each,   // the rules until `ends` hold for each element, of `count` bytes, from one array to another
  // The layout of what is looked at, one after the other: where the next array begins, see Checker::places_.
  array,    // number times limit elements of `count` bytes
  groups,   // an element of `count` bytes for each four of the number
  aligned,  // on four bytes
  fills,    // the section ends there
  call,     // a Check
};

// Rules that are code; most say whether they hold, and the rule where and why.
enum class Check : std::uint8_t {
  // Of clips.
  clip_size,
  clip_reference,
  track,
  track_values,
  channel,
  used_times,
  coded,
  segment_offsets,
  frame_times,
  masks,
  constants,
  segments,
  // Of geometries and meshes.
  geometry_size,
  triangles,
  indices,
  runs,
  sets,
  source_slots,
  morphs,
  pose_space,
  targets,
  examples,
  next_part,
  palette,
  target_count,
  level_targets,
  helper_count,
  mesh_joints,
  // Of others.
  joints,
  rotations,
  reference_joints,
  role,
  fallback,
  truth,
  only_of_owner,
  ascends,
  limit,
  box,
  chain_order,
  chain_colliders,
  bone,
  chain_joints,
  used_joints,
};

// Bits of floats that others stay below: of any that is finite, of what becomes matrices that are multiplied, of a part
// of a unit quaternion but for rounding, of springs' points.
inline constexpr std::uint32_t kFiniteBits = 0x7F800000, kBoundedBits = bit_cast<std::uint32_t>(1e12f) + 1,
                               kUnitBits = bit_cast<std::uint32_t>(1.01f),
                               kNearBits = bit_cast<std::uint32_t>(1e6f) + 1;
// The least that a unit quaternion's squares may add up to, and the least product with the key before it of one between
// which and that key others are found: so that neither they nor their blends come to nothing.
inline constexpr float kShortestSquare = 0.5f, kLeastProduct = -0.25f;
inline constexpr const char *kNotFinite = "a number that is not finite",
                            *kNotBounded = "a number that is not finite, or beyond 1e12",
                            *kNoUnit = "a rotation that is no unit quaternion",
                            *kFarKey = "a LINEAR rotation in the hemisphere of the one before it";

struct Rule {
  RuleNumber number, limit;
  std::uint32_t how : 5, count : 8, back : 5, text : 14;  // back: bytes from the number to the place that is told
};
static_assert(sizeof(Rule) == 8);

// Lists of rules: of each kind of section, by format::Kind, and of parts of sections, whose header the record is.
enum Part : std::uint8_t { kCodedPart = 13, kMorphArrays, kMorphPart, kPoseArrays, kPosePart, kPartCount };
// Which of the arrays of a section one is, by the layout of format.h.
#define MARROW_PLACE(layout, member) (offsetof(::marrow::format::layout, member) / sizeof(std::uint64_t))
// Where the arrays of a geometry's parts stand among its own, and how many bytes an index of it has.
inline constexpr std::size_t kMorphPlace = 12, kPosePlace = 16, kIndexBytesPlace = 22, kPlaceCount = 23;
const Rule* rules_of(std::uint32_t kind_or_part);
const char* text_of(const Rule& rule);
// What From::constants means.
const std::uint32_t* constants_of_rules();

}  // namespace marrow
