// The tables of VRM's objects, versions 0 and 1 (github.com/vrm-c/vrm-specification). Only what is read is looked at,
// and lists may be empty, as exporters write them so. Numbers of version 0 that name something may be -1: nothing.
#include "cook/gltf/rules/schema_tables.h"

namespace marrow::cook::gltf {
namespace {

constexpr Schema kOpen{{}, true};

constexpr Property number(std::string_view name) {
  return {.name = name, .kind = Kind::number};
}
constexpr Property list(std::string_view name, const Schema& of) {
  return {.name = name, .kind = Kind::objects, .shortest = 0, .schema = &of};
}
constexpr Property map(std::string_view name, const Schema& of) {
  return {.name = name, .kind = Kind::object_map, .schema = &of};
}
constexpr Property references(std::string_view name) {
  return {.name = name, .kind = Kind::numbers, .min = -1, .max = kLargestInteger, .shortest = 0};
}

// Version 0.
constexpr Property kPoint[] = {number("x"), number("y"), number("z")};
constexpr Schema kPointSchema{kPoint, true};
constexpr Property kBone0[] = {text("bone"), count_of("node", -1)};
constexpr Schema kBone0Schema{kBone0, true};
constexpr Property kHumanoid0[] = {list("humanBones", kBone0Schema)};
constexpr Schema kHumanoid0Schema{kHumanoid0, true};
constexpr Property kDegreeMap[] = {number("xRange"), number("yRange")};
constexpr Schema kDegreeMapSchema{kDegreeMap, true};
constexpr Property kAnnotation0[] = {count_of("mesh", -1), text("firstPersonFlag")};
constexpr Schema kAnnotation0Schema{kAnnotation0, true};
constexpr Property kFirstPerson0[] = {object("firstPersonBoneOffset", kPointSchema),
                                      list("meshAnnotations", kAnnotation0Schema),
                                      text("lookAtTypeName"),
                                      object("lookAtHorizontalInner", kDegreeMapSchema),
                                      object("lookAtHorizontalOuter", kDegreeMapSchema),
                                      object("lookAtVerticalDown", kDegreeMapSchema),
                                      object("lookAtVerticalUp", kDegreeMapSchema)};
constexpr Schema kFirstPerson0Schema{kFirstPerson0, true};
constexpr Property kBind0[] = {count_of("mesh", -1), count_of("index", -1), number("weight")};
constexpr Schema kBind0Schema{kBind0, true};
constexpr Property kGroup0[] = {text("name"), text("presetName"), flag("isBinary"), list("binds", kBind0Schema),
                                list("materialValues", kOpen)};
constexpr Schema kGroup0Schema{kGroup0, true};
constexpr Property kMaster0[] = {list("blendShapeGroups", kGroup0Schema)};
constexpr Schema kMaster0Schema{kMaster0, true};
constexpr Property kSpring0[] = {number("stiffiness"), number("gravityPower"),      object("gravityDir", kPointSchema),
                                 number("dragForce"),  count_of("center", -1),      number("hitRadius"),
                                 references("bones"),  references("colliderGroups")};
constexpr Schema kSpring0Schema{kSpring0, true};
constexpr Property kCollider0[] = {object("offset", kPointSchema), number("radius")};
constexpr Schema kCollider0Schema{kCollider0, true};
constexpr Property kColliders0[] = {count_of("node", -1), list("colliders", kCollider0Schema)};
constexpr Schema kColliders0Schema{kColliders0, true};
constexpr Property kSecondary0[] = {list("boneGroups", kSpring0Schema), list("colliderGroups", kColliders0Schema)};
constexpr Schema kSecondary0Schema{kSecondary0, true};
constexpr Property kVrm0[] = {object("meta", kOpen), object("humanoid", kHumanoid0Schema),
                              object("firstPerson", kFirstPerson0Schema), object("blendShapeMaster", kMaster0Schema),
                              object("secondaryAnimation", kSecondary0Schema)};
constexpr Schema kVrm0Schema{kVrm0, true};

// Version 1.
constexpr Property kBone[] = {index_of("node", "nodes", true)};
constexpr Schema kBoneSchema{kBone, true};
constexpr Property kHumanoid[] = {map("humanBones", kBoneSchema)};
constexpr Schema kHumanoidSchema{kHumanoid, true};
constexpr Property kAnnotation[] = {index_of("node", "nodes", true), text("type", true)};
constexpr Schema kAnnotationSchema{kAnnotation, true};
constexpr Property kFirstPerson[] = {list("meshAnnotations", kAnnotationSchema)};
constexpr Schema kFirstPersonSchema{kFirstPerson, true};
constexpr Property kRangeMap[] = {number("inputMaxValue"), number("outputScale")};
constexpr Schema kRangeMapSchema{kRangeMap, true};
constexpr Property kLookAt[] = {numbers("offsetFromHeadBone", 3, 3),
                                text("type"),
                                object("rangeMapHorizontalInner", kRangeMapSchema),
                                object("rangeMapHorizontalOuter", kRangeMapSchema),
                                object("rangeMapVerticalDown", kRangeMapSchema),
                                object("rangeMapVerticalUp", kRangeMapSchema)};
constexpr Schema kLookAtSchema{kLookAt, true};
constexpr Property kBind[] = {index_of("node", "nodes", true),
                              count_of("index", 0, true),
                              {.name = "weight", .kind = Kind::number, .required = true}};
constexpr Schema kBindSchema{kBind, true};
constexpr Property kExpression[] = {flag("isBinary"),
                                    text("overrideBlink"),
                                    text("overrideLookAt"),
                                    text("overrideMouth"),
                                    list("morphTargetBinds", kBindSchema),
                                    list("materialColorBinds", kOpen),
                                    list("textureTransformBinds", kOpen)};
constexpr Schema kExpressionSchema{kExpression, true};
constexpr Property kExpressions[] = {map("preset", kExpressionSchema), map("custom", kExpressionSchema)};
constexpr Schema kExpressionsSchema{kExpressions, true};
constexpr Property kVrm[] = {text("specVersion"),
                             object("meta", kOpen),
                             object("humanoid", kHumanoidSchema),
                             object("firstPerson", kFirstPersonSchema),
                             object("lookAt", kLookAtSchema),
                             object("expressions", kExpressionsSchema)};
constexpr Schema kVrmSchema{kVrm, true};

constexpr Property kSphere[] = {numbers("offset", 3, 3), number("radius")};
constexpr Schema kSphereSchema{kSphere, true};
constexpr Property kCapsule[] = {numbers("offset", 3, 3), numbers("tail", 3, 3), number("radius")};
constexpr Schema kCapsuleSchema{kCapsule, true};
constexpr Property kShape[] = {object("sphere", kSphereSchema), object("capsule", kCapsuleSchema)};
constexpr Schema kShapeSchema{kShape, true};
constexpr Property kCollider[] = {index_of("node", "nodes", true), object("shape", kShapeSchema)};
constexpr Schema kColliderSchema{kCollider, true};
constexpr Property kColliderGroup[] = {references("colliders")};
constexpr Schema kColliderGroupSchema{kColliderGroup, true};
constexpr Property kJoint[] = {index_of("node", "nodes", true), number("hitRadius"),         number("stiffness"),
                               number("gravityPower"),          numbers("gravityDir", 3, 3), number("dragForce")};
constexpr Schema kJointSchema{kJoint, true};
constexpr Property kSpring[] = {list("joints", kJointSchema), references("colliderGroups"),
                                index_of("center", "nodes")};
constexpr Schema kSpringSchema{kSpring, true};
constexpr Property kSpringBone[] = {list("colliders", kColliderSchema), list("colliderGroups", kColliderGroupSchema),
                                    list("springs", kSpringSchema)};
constexpr Schema kSpringBoneSchema{kSpringBone, true};

constexpr Property kRootExtensions[] = {object("VRM", kVrm0Schema), object("VRMC_vrm", kVrmSchema),
                                        object("VRMC_springBone", kSpringBoneSchema)};

}  // namespace

const Schema kRootExtensionsSchema{kRootExtensions, true};

}  // namespace marrow::cook::gltf
