#include "asset/file_rules.h"

#include <array>
#include <cstddef>
#include <iterator>

#include "asset/rule_words.h"

namespace marrow {

namespace rule_table {
namespace {

constexpr std::uint32_t kHighFinite = 0x7FF00000;  // upper half of a double
constexpr std::uint32_t kBelowOne = bit_cast<std::uint32_t>(1.0f) - 1;
constexpr std::uint32_t kSigmaFrom = bit_cast<std::uint32_t>(format::kLeastSigma),
                        kSigmaTo = bit_cast<std::uint32_t>(format::kMostSigma);

constexpr std::uint32_t kLastInterpolation = static_cast<std::uint32_t>(Interpolation::cubic_spline);
constexpr const char *kNoInterpolation = "unknown interpolation", *kFrames = "2 to 16777216 frames",
                     *kOutside = "a joint outside the skeleton", *kNoRoot = "a root outside the palette, or of nothing",
                     *kNoGeometry = "no such geometry", *kNoHelper = "a helper blends two joints of the mesh",
                     *kPalette = "as many palette entries as the geometry", *kNoSuchImage = "no such image",
                     *kSigma = "sigma from 0.001 to 1000", *kNoWrap = "unknown wrap mode",
                     *kNoFilter = "unknown filter", *kNotNear = "a collider that is not finite, or beyond 1e6";

using namespace format;

constexpr Line kLines[] = {
    // Kinds stand in one order, so a section may lean on those before it.
    begins(kSkeletons),
    array_of(MARROW_IN(SkeletonHeader, root_count), sizeof(Affine)),
    array_of_groups(MARROW_IN(SkeletonHeader, joint_count), sizeof(SoaTransform)),
    array_of(MARROW_IN(SkeletonHeader, joint_count), sizeof(std::uint32_t)),
    array_of(MARROW_IN(SkeletonHeader, joint_count), sizeof(std::uint16_t)),
    fills(),
    reserved(MARROW_IN(SkeletonHeader, reserved)),
    from_1_to(MARROW_IN(SkeletonHeader, joint_count), kMaxJoints, "1 to 32767 joints"),
    from_1_to(MARROW_IN(SkeletonHeader, root_count), MARROW_IN(SkeletonHeader, joint_count),
              "1 root to as many as joints"),
    call(Check::joints),
    name(MARROW_IN(SkeletonHeader, name)),
    bounded_until(MARROW_PLACE(SkeletonLayout, roots), MARROW_PLACE(SkeletonLayout, rest)),
    bounded_until(MARROW_PLACE(SkeletonLayout, rest), MARROW_PLACE(SkeletonLayout, names)),
    each(MARROW_PLACE(SkeletonLayout, rest), MARROW_PLACE(SkeletonLayout, names), sizeof(SoaTransform)),
    short_rotations(),
    long_rotations(),
    ends(),

    begins(kReferences),
    array_of(MARROW_IN(ReferenceHeader, joint_count), sizeof(std::uint32_t)),
    array_of(MARROW_IN(ReferenceHeader, joint_count), sizeof(std::uint32_t)),
    array_of(MARROW_IN(ReferenceHeader, joint_count), sizeof(std::uint16_t)),
    fills(),
    where_differ(count_of(kSkeletons), 0u),
    below(word(0), 0u, "skeletons or references, not both"),
    from_1_to(MARROW_IN(ReferenceHeader, joint_count), kMaxJoints, "1 to 32767 joints"),
    call(Check::reference_joints),
    name(MARROW_IN(ReferenceHeader, name)),

    begins(kClips),
    array_of(MARROW_IN(ClipHeader, reference_groups), sizeof(SoaTransform)),
    array_of(MARROW_IN(ClipHeader, track_count), sizeof(Track)),
    array_of(MARROW_IN(ClipHeader, channel_count), sizeof(Channel)),
    array_of(MARROW_IN(ClipHeader, time_count), sizeof(float)),
    array_of(MARROW_IN(ClipHeader, value_count), sizeof(float)),
    call(Check::clip_size, "section size differs from its counts"),
    owner_or_reference(MARROW_IN(ClipHeader, skeleton)),
    at_most(MARROW_IN(ClipHeader, additive), 1u, "additive is 0 or 1"),
    call(Check::clip_reference, "a reference is an additive clip's and has all joints",
         MARROW_IN(ClipHeader, reference_groups)),
    bounded_until(MARROW_PLACE(ClipLayout, reference), MARROW_PLACE(ClipLayout, tracks)),
    each(MARROW_PLACE(ClipLayout, reference), MARROW_PLACE(ClipLayout, tracks), sizeof(SoaTransform)),
    short_rotations(),
    long_rotations(),
    ends(),
    name(MARROW_IN(ClipHeader, name)),
    bounded(MARROW_IN(ClipHeader, duration_s), 1),
    not_negative(MARROW_IN(ClipHeader, duration_s), "a duration is not negative"),
    finite_until(MARROW_PLACE(ClipLayout, times), MARROW_PLACE(ClipLayout, bytes)),
    each(MARROW_PLACE(ClipLayout, tracks), MARROW_PLACE(ClipLayout, channels), sizeof(Track)),
    below(MARROW_IN(Track, joint), kJointCount, "track's joint outside the skeleton"),
    at_most(MARROW_IN(Track, path), last(TrackPath::scale), "unknown path").at(offsetof(Track, path)),
    at_most(MARROW_IN(Track, interpolation), kLastInterpolation, kNoInterpolation).at(offsetof(Track, interpolation)),
    call(Check::track),
    ends(),
    call(Check::track_values),
    each(MARROW_PLACE(ClipLayout, channels), MARROW_PLACE(ClipLayout, times), sizeof(Channel)),
    reserved(byte(21)),
    reserved(half(22)).at(1),
    name(MARROW_IN(Channel, name)),
    finite(MARROW_IN(Channel, rest)),
    at_most(MARROW_IN(Channel, interpolation), kLastInterpolation, kNoInterpolation)
        .at(offsetof(Channel, interpolation)),
    call(Check::channel),
    ends(),
    call(Check::used_times, "times that no track uses", MARROW_IN(ClipHeader, time_count)),
    call(Check::coded),

    // The record is the part's header.
    begins(kCodedPart),
    where_differ(MARROW_IN(CodedHeader, time_count), 0u),
    equal(MARROW_IN(CodedHeader, time_count), MARROW_IN(CodedHeader, frame_count), "a time a frame or none"),
    from_1_to(MARROW_IN(CodedHeader, frame_count), kMaxFrames, kFrames),
    at_least(MARROW_IN(CodedHeader, frame_count), 2u, kFrames),
    at_least(MARROW_IN(CodedHeader, segment_intervals), 1u, "a segment has intervals"),
    finite(MARROW_IN(CodedHeader, start_s), 2),
    positive(MARROW_IN(CodedHeader, frames_per_s), "frames a second"),
    at_least(MARROW_IN(CodedHeader, payload_bytes), kPayloadPadding, "payload without padding"),
    array_of(MARROW_IN(CodedHeader, time_count), sizeof(float)),
    call(Check::segment_offsets),
    array_of_groups(kJointCount, sizeof(GroupMasks)),
    array_of(MARROW_IN(CodedHeader, constant_count), sizeof(Constant)),
    array_of(MARROW_IN(CodedHeader, payload_bytes), 1),
    fills(),
    finite_until(MARROW_PLACE(CodedLayout, times), MARROW_PLACE(CodedLayout, offsets)),
    call(Check::frame_times),
    call(Check::masks),
    call(Check::constants),
    call(Check::segments),

    // The layout subtracts one weight a block, so every block must have an influence before sizes mean anything.
    begins(kGeometries),
    at_least(MARROW_IN(GeometryHeader, influence_blocks), MARROW_IN(GeometryHeader, block_count),
             "a block has influences"),
    call(Check::geometry_size, "section size differs from its counts"),
    only_bits(MARROW_IN(GeometryHeader, flags), kAllGeometryFlags, "unknown flag"),
    at_most(MARROW_IN(GeometryHeader, block_count), 0x3FFFFFFFu, "too many vertices"),
    from_1_to(MARROW_IN(GeometryHeader, joint_count), kMaxJoints, "1 to 32767 palette entries"),
    where_bits(MARROW_IN(GeometryHeader, flags), kHasMwe),
    below(MARROW_IN(GeometryHeader, mwe_root), MARROW_IN(GeometryHeader, joint_count), kNoRoot),
    where_lacks(MARROW_IN(GeometryHeader, flags), kHasMwe),
    at_most(MARROW_IN(GeometryHeader, mwe_root), 0u, kNoRoot),
    call(Check::triangles, "three indices a triangle", MARROW_IN(GeometryHeader, index_count)),
    where_lacks(MARROW_IN(GeometryHeader, flags), kHasSourceSlots),
    at_most(MARROW_IN(GeometryHeader, source_vertex_count), 0u, "source vertices without slots"),
    call(Check::indices),
    each(MARROW_PLACE(GeometryLayout, runs), MARROW_PLACE(GeometryLayout, source_slots), sizeof(Run)),
    at_least(MARROW_IN(Run, vertex_count), 1u, "a run has vertices").at(offsetof(Run, vertex_count)),
    from_1_to(MARROW_IN(Run, influences), kMaxInfluences, "1 to 8 influences").at(offsetof(Run, influences)),
    ends(),
    call(Check::runs, "runs do not add up to the geometry's counts"),
    call(Check::sets),
    call(Check::source_slots),
    finite(MARROW_IN(GeometryHeader, box_min), 6),
    finite_until(MARROW_PLACE(GeometryLayout, skin), MARROW_PLACE(GeometryLayout, colours)),
    where_bits(MARROW_IN(GeometryHeader, flags), kHasMorphTargets),
    call(Check::morphs),
    where_bits(MARROW_IN(GeometryHeader, flags), kHasPoseSpace),
    call(Check::pose_space),

    begins(kMorphArrays),
    array_of(MARROW_IN(MorphHeader, target_count), sizeof(MorphTarget)),
    array_of(MARROW_IN(MorphHeader, block_count), 1, kIndexBytes),
    array_of(MARROW_IN(MorphHeader, record_count), kMorphRecordBytes),

    begins(kMorphPart),
    at_least(MARROW_IN(MorphHeader, target_count), 1u, "a flag without morph targets"),
    reserved(MARROW_IN(MorphHeader, reserved)),
    call(Check::targets),

    begins(kPoseArrays),
    from_1_to(MARROW_IN(PoseSpaceHeader, example_count), kMaxPoseExamples, "1 to 32 example poses"),
    array_of(MARROW_IN(PoseSpaceHeader, example_count), sizeof(MorphTarget)),
    array_of(MARROW_IN(PoseSpaceHeader, example_count), 8, MARROW_OF_HEADER(GeometryHeader, joint_count)),
    array_of(MARROW_IN(PoseSpaceHeader, block_count), 1, kIndexBytes),
    array_of(MARROW_IN(PoseSpaceHeader, block_count), kMorphRecordBytes),
    array_of(MARROW_OF_HEADER(GeometryHeader, joint_count), sizeof(std::uint16_t)),

    begins(kPosePart),
    reserved(MARROW_IN(PoseSpaceHeader, reserved)),
    at_least(MARROW_IN(PoseSpaceHeader, sigma), kSigmaFrom, kSigma),
    at_most(MARROW_IN(PoseSpaceHeader, sigma), kSigmaTo, kSigma),
    each(kPosePlace + 4, kPosePlace + 5, 2),
    where_differ(half(0), kNoParent),
    below(half(0), MARROW_OF_HEADER(GeometryHeader, joint_count), "a parent outside the palette"),
    ends(),
    call(Check::examples),

    begins(kMeshes),
    array_of(MARROW_IN(MeshHeader, joint_count), sizeof(Affine)),
    array_of(MARROW_IN(MeshHeader, target_count), sizeof(MeshTarget)),
    array_of(MARROW_IN(MeshHeader, joint_count), sizeof(std::uint16_t)),
    where_differ(MARROW_IN(MeshHeader, helper_count), 0u),
    aligned(),
    where_differ(MARROW_IN(MeshHeader, lod_count), 0u),
    aligned(),
    array_of(MARROW_IN(MeshHeader, helper_count), sizeof(Helper)),
    where_bits(MARROW_IN(MeshHeader, flags), std::uint32_t{kHelpersHaveCentres}),
    array_of(MARROW_IN(MeshHeader, helper_count), kCentreBytes),
    where_lacks(MARROW_IN(MeshHeader, flags), std::uint32_t{kHelpersHaveCentres}),
    array_of(0),
    array_of(MARROW_IN(MeshHeader, lod_count), sizeof(MeshLod)),
    fills(),
    at_most(MARROW_IN(MeshHeader, material_section), count_of(kMaterials), "no such material"),
    only_bits(MARROW_IN(MeshHeader, flags), std::uint32_t{kAllMeshFlags}, "unknown flag"),
    owner(MARROW_IN(MeshHeader, skeleton)),
    below(MARROW_IN(MeshHeader, geometry), count_of(kGeometries), kNoGeometry),
    call(Check::next_part,
         "a next part has the skeleton, attributes, morph targets and source vertices of the part before it",
         MARROW_IN(MeshHeader, flags)),
    at_least(MARROW_IN(MeshHeader, joint_count), 1u, kPalette),
    call(Check::palette, kPalette, MARROW_IN(MeshHeader, joint_count), MARROW_IN(MeshHeader, geometry)),
    call(Check::target_count, "as many morph targets as the geometry", MARROW_IN(MeshHeader, target_count),
         MARROW_IN(MeshHeader, geometry)),
    each(MARROW_PLACE(MeshLayout, targets), MARROW_PLACE(MeshLayout, joints), sizeof(MeshTarget)),
    name(MARROW_IN(MeshTarget, name)),
    name(MARROW_IN(MeshTarget, channel)),
    finite(MARROW_IN(MeshTarget, weight)),
    ends(),
    where_bits(MARROW_IN(MeshHeader, flags), std::uint32_t{kHelpersHaveCentres}),
    call(Check::helper_count, "centres without helpers", MARROW_IN(MeshHeader, flags)),
    each(MARROW_PLACE(MeshLayout, helpers), MARROW_PLACE(MeshLayout, centres), sizeof(Helper)),
    below(MARROW_IN(Helper, first), MARROW_OF_HEADER(MeshHeader, joint_count), kNoHelper),
    below(MARROW_IN(Helper, second), MARROW_OF_HEADER(MeshHeader, joint_count), kNoHelper).at(offsetof(Helper, second)),
    from_1_to(MARROW_IN(Helper, share), kBelowOne, kNoHelper).at(offsetof(Helper, share)),
    differ(MARROW_IN(Helper, first), MARROW_IN(Helper, second), kNoHelper),
    ends(),
    bounded_until(MARROW_PLACE(MeshLayout, centres), MARROW_PLACE(MeshLayout, lods)),
    each(MARROW_PLACE(MeshLayout, lods), MARROW_PLACE(MeshLayout, bytes), sizeof(MeshLod)),
    below(MARROW_IN(MeshLod, geometry), count_of(kGeometries), kNoGeometry),
    call(Check::palette, "a level has the mesh's palette", word(0), MARROW_IN(MeshLod, geometry)),
    call(Check::level_targets, "a level has the mesh's morph targets or none", word(0), MARROW_IN(MeshLod, geometry)),
    finite(MARROW_IN(MeshLod, error_m)),
    not_negative(MARROW_IN(MeshLod, error_m), "an error is not below 0"),
    ends(),
    name(MARROW_IN(MeshHeader, name)),
    name(MARROW_IN(MeshHeader, material)),
    finite(MARROW_IN(MeshHeader, base_colour), 4),
    bounded_until(MARROW_PLACE(MeshLayout, inverse_bind), MARROW_PLACE(MeshLayout, targets)),
    call(Check::mesh_joints),

    begins(kMaterials),
    array_of(MARROW_IN(MaterialHeader, texture_count), sizeof(Texture)),
    where_bits(MARROW_IN(MaterialHeader, flags), std::uint32_t{kEmits}),
    array_of(3 * sizeof(float)),
    where_lacks(MARROW_IN(MaterialHeader, flags), std::uint32_t{kEmits}),
    array_of(0),
    fills(),
    at_most(MARROW_IN(MaterialHeader, flags), std::uint32_t{kAllMaterialFlags}, "unknown flags of a material"),
    at_most(MARROW_IN(MaterialHeader, alpha), last(AlphaMode::blend), "unknown alpha mode"),
    name(MARROW_IN(MaterialHeader, name)),
    finite(MARROW_IN(MaterialHeader, alpha_cutoff)),
    not_negative(MARROW_IN(MaterialHeader, alpha_cutoff), "a cutoff is not negative"),
    finite_until(MARROW_PLACE(MaterialLayout, emissive), MARROW_PLACE(MaterialLayout, bytes)),
    each(MARROW_PLACE(MaterialLayout, emissive), MARROW_PLACE(MaterialLayout, bytes), sizeof(float)),
    not_negative(word(0), "light that is emitted is not negative"),
    ends(),
    each(MARROW_PLACE(MaterialLayout, textures), MARROW_PLACE(MaterialLayout, emissive), sizeof(Texture)),
    below(MARROW_IN(Texture, image), count_of(kImages), kNoSuchImage),
    at_most(MARROW_IN(Texture, role), last(TextureRole::specular_glossiness), "unknown role of a texture"),
    at_most(MARROW_IN(Texture, wrap_u), last(Wrap::mirrored_repeat), kNoWrap),
    at_most(MARROW_IN(Texture, wrap_v), last(Wrap::mirrored_repeat), kNoWrap).at(1),
    at_most(MARROW_IN(Texture, mag), last(MagFilter::linear), kNoFilter),
    at_most(MARROW_IN(Texture, min), last(MinFilter::linear_mipmap_linear), kNoFilter).at(1),
    reserved(MARROW_IN(Texture, reserved)),
    call(Check::role, "a role twice in one material", MARROW_IN(Texture, role)),
    ends(),

    begins(kImages),
    array_of(MARROW_IN(ImageHeader, byte_count), 1),
    fills(),
    reserved(MARROW_IN(ImageHeader, reserved)),
    at_most(MARROW_IN(ImageHeader, format), last(ImageFormat::dds), "unknown format of an image"),
    where_differ(MARROW_IN(ImageHeader, byte_count), 0u),
    at_least(MARROW_IN(ImageHeader, format), 1u, "bytes of an unknown format"),
    where_differ(MARROW_IN(ImageHeader, fallback), 0u),
    call(Check::fallback, "a fallback that is no PNG or JPEG image", MARROW_IN(ImageHeader, fallback)),
    name(MARROW_IN(ImageHeader, name)),
    text(MARROW_IN(ImageHeader, uri)),

    begins(kNodes),
    array_of(MARROW_IN(NodeHeader, property_count), sizeof(Property)),
    fills(),
    reserved(MARROW_IN(NodeHeader, reserved)),
    owner(MARROW_IN(NodeHeader, skeleton)),
    where_differ(MARROW_IN(NodeHeader, joint), kNoJoint),
    below(MARROW_IN(NodeHeader, joint), kJointCount, kOutside),
    name(MARROW_IN(NodeHeader, name)),
    bounded(MARROW_IN(NodeHeader, joint_from_node), 12),
    // A text's number is short; else it is finite, and 0 or 1 of a truth.
    each(MARROW_PLACE(NodeLayout, properties), MARROW_PLACE(NodeLayout, bytes), sizeof(Property)),
    reserved(byte(5)),
    reserved(half(6)).at(1),
    at_most(MARROW_IN(Property, type), last(PropertyType::text), "unknown type of a property"),
    text(MARROW_IN(Property, name)),
    where_bits(MARROW_IN(Property, type), 2u),
    reserved(word(12)).at(4),
    where_bits(MARROW_IN(Property, type), 2u),
    text(word(8)),
    where_lacks(MARROW_IN(Property, type), 2u),
    floats(word(12), 1, kHighFinite, kNotFinite).at(4),
    where_bits(MARROW_IN(Property, type), 1u),
    call(Check::truth, "a boolean is 0 or 1", word(8)),
    ends(),

    begins(kLimits),
    array_of(MARROW_IN(LimitHeader, limit_count), sizeof(JointLimit)),
    fills(),
    call(Check::only_of_owner, "one section of limits a skeleton, in their order"),
    at_least(MARROW_IN(LimitHeader, limit_count), 1u, "a section of limits without one"),
    each(MARROW_PLACE(LimitLayout, limits), MARROW_PLACE(LimitLayout, bytes), sizeof(JointLimit)),
    below(MARROW_IN(JointLimit, joint), kJointCount, kOutside),
    call(Check::ascends, "limits ascend by joint"),
    call(Check::limit, "no limit of a joint"),
    ends(),

    begins(kSprings),
    array_of(MARROW_IN(SpringHeader, chain_count), sizeof(SpringRecord)),
    array_of(MARROW_IN(SpringHeader, joint_count), sizeof(SpringJoint)),
    array_of(MARROW_IN(SpringHeader, collider_count), sizeof(SpringCollider)),
    fills(),
    call(Check::only_of_owner, "one section of springs a skeleton, in their order"),
    at_least(MARROW_IN(SpringHeader, chain_count), 1u, "a section of springs without a chain"),
    at_most(MARROW_IN(SpringHeader, joint_count), kJointCount, "more joints than the skeleton has"),
    at_most(MARROW_IN(SpringHeader, collider_count), kMaxSpringColliders, "at most 64 colliders"),
    each(MARROW_PLACE(SpringLayout, chains), MARROW_PLACE(SpringLayout, joints), sizeof(SpringRecord)),
    call(Check::chain_order, "chains share out the joints, one after the other"),
    floats(MARROW_IN(SpringRecord, tip), 3, kNearBits, "a tip that is not finite, or beyond 1e6")
        .at(offsetof(SpringRecord, tip)),
    reserved(MARROW_IN(SpringRecord, reserved)).at(offsetof(SpringRecord, reserved)),
    call(Check::chain_colliders, "a collider that is not there"),
    call(Check::bone, "a chain without a bone"),
    call(Check::chain_joints),
    ends(),
    call(Check::used_joints, "joints of no chain", MARROW_IN(SpringHeader, joint_count)),
    each(MARROW_PLACE(SpringLayout, colliders), MARROW_PLACE(SpringLayout, bytes), sizeof(SpringCollider)),
    below(MARROW_IN(SpringCollider, joint), kJointCount, kOutside),
    reserved(MARROW_IN(SpringCollider, reserved)).at(offsetof(SpringCollider, reserved)),
    floats(MARROW_IN(SpringCollider, from), 7, kNearBits, kNotNear).at(offsetof(SpringCollider, from)),
    not_negative(MARROW_IN(SpringCollider, radius_m), kNotNear).at(offsetof(SpringCollider, radius_m)),
    ends(),

    begins(kBounds),
    array_of(MARROW_IN(BoundsHeader, clip_count), sizeof(BoundsCodes), MARROW_IN(BoundsHeader, mesh_count)),
    fills(),
    call(Check::only_of_owner, "one section of bounds a skeleton, in their order"),
    from_1_to(MARROW_IN(BoundsHeader, clip_count), count_of(kClips), "1 to as many as clips"),
    from_1_to(MARROW_IN(BoundsHeader, mesh_count), count_of(kMeshes), "1 to as many as meshes"),
    each(MARROW_PLACE(BoundsLayout, codes), MARROW_PLACE(BoundsLayout, bytes), sizeof(BoundsCodes)),
    call(Check::box, "no box"),
    ends(),
    begins(kPartCount),
};

constexpr std::size_t kRuleCount = std::size(kLines);

constexpr bool same(const char* a, const char* b) {
  for (; *a == *b; ++a, ++b)
    if (*a == 0) return true;
  return false;
}

// Where each rule's text stands among all, each once and with its zero; and the size of all.
struct TextPlaces {
  std::size_t at[kRuleCount] = {}, size = 0;
};
constexpr TextPlaces place_texts() {
  TextPlaces out;
  for (std::size_t i = 0; i < kRuleCount; ++i) {
    std::size_t before = 0;
    while (!same(kLines[before].text, kLines[i].text)) ++before;
    out.at[i] = before < i ? out.at[before] : out.size;
    if (before < i) continue;
    for (const char* letter = kLines[i].text; *letter != 0; ++letter) ++out.size;
    ++out.size;
  }
  return out;
}
constexpr TextPlaces kPlaces = place_texts();

constexpr std::array<char, kPlaces.size> write_texts() {
  std::array<char, kPlaces.size> out{};
  for (std::size_t i = 0; i < kRuleCount; ++i)
    for (std::size_t n = 0; kLines[i].text[n] != 0; ++n) out[kPlaces.at[i] + n] = kLines[i].text[n];
  return out;
}

struct Constants {
  std::uint32_t values[64] = {1};
  std::size_t size = 1;
  constexpr std::size_t place_of(std::uint32_t value) {
    for (std::size_t i = 0; i < size; ++i)
      if (values[i] == value) return i;
    values[size] = value;
    return size++;
  }
};
struct Written {
  Rule rules[kRuleCount] = {};
  Constants constants;
};
constexpr Written write_rules() {
  Written out;
  for (std::size_t i = 0; i < kRuleCount; ++i) {
    const Line& l = kLines[i];
    const RuleNumber limit =
        l.limit.is_constant ? number(From::constants, 4 * out.constants.place_of(l.limit.value), 4) : l.limit.number;
    const std::size_t count =
        l.how == How::floats_until ? out.constants.place_of(static_cast<std::uint32_t>(l.count)) : l.count;
    Rule& r = out.rules[i];
    r.number = l.number;
    r.limit = limit;
    r.how = static_cast<unsigned>(l.how) & 31u;
    r.count = fitting(count, 255u) & 255u;
    r.back = fitting(l.back, 31u) & 31u;
    r.text = fitting(kPlaces.at[i], 16383u) & 16383u;
  }
  return out;
}
constexpr std::array<std::uint16_t, kPartCount> find_parts() {
  std::array<std::uint16_t, kPartCount> out{};
  for (std::size_t i = 0; i < kRuleCount; ++i)
    if (kLines[i].how == How::begins && kLines[i].count < kPartCount)
      out[kLines[i].count] = static_cast<std::uint16_t>(i + 1);
  return out;
}

constexpr auto kTexts = write_texts();
constexpr auto kParts = find_parts();
constexpr Written kWritten = write_rules();

}  // namespace
}  // namespace rule_table

const Rule* rules_of(std::uint32_t kind_or_part) {
  return rule_table::kWritten.rules + rule_table::kParts[kind_or_part];
}
const std::uint32_t* constants_of_rules() {
  return rule_table::kWritten.constants.values;
}
const char* text_of(const Rule& rule) {
  return &rule_table::kTexts[rule.text];
}

}  // namespace marrow
