// The tables of glTF 2.0's objects and of VRM's, which check_schema() walks by.
//
// What the runtime does not carry (cameras, lights) is checked for being an object at all and no further.
#include "cook/gltf/rules/schema.h"

namespace marrow::cook::gltf {
namespace {

// Rows of the tables.
constexpr Property index_of(std::string_view name, std::string_view collection, bool required = false) {
  return {.name = name, .kind = Kind::index, .required = required, .of = collection};
}

constexpr Property count_of(std::string_view name, double min, bool required = false) {
  return {.name = name, .kind = Kind::integer, .required = required, .min = min, .max = kLargestInteger};
}

constexpr Property text(std::string_view name, bool required = false, std::string_view words = {}) {
  return {.name = name, .kind = Kind::text, .required = required, .of = words};
}

constexpr Property object(std::string_view name, const Schema& schema, bool required = false) {
  return {.name = name, .kind = Kind::object, .required = required, .schema = &schema};
}

constexpr Property objects(std::string_view name, const Schema& schema, bool required = false) {
  return {.name = name, .kind = Kind::objects, .required = required, .schema = &schema};
}

constexpr Property numbers(std::string_view name, std::size_t shortest, std::size_t longest) {
  return {.name = name, .kind = Kind::numbers, .shortest = shortest, .longest = longest};
}

constexpr Property flag(std::string_view name) {
  return {.name = name, .kind = Kind::boolean};
}

constexpr Schema kOpen{{}, true};

// VRM, versions 0 and 1 (github.com/vrm-c/vrm-specification). Only what is read is looked at, and lists may be empty,
// as exporters write them so. Numbers of version 0 that name something may be -1: nothing.
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

constexpr Schema kRootExtensionsSchema{kRootExtensions, true};

// glTF 2.0, in the order of the specification's property reference.
constexpr double kLargestEnum = 65535;

constexpr Property code(std::string_view name, bool required) {
  return {.name = name, .kind = Kind::integer, .required = required, .min = 0, .max = kLargestEnum};
}

constexpr Property kAsset[] = {text("version", true), text("minVersion"), text("generator"), text("copyright")};
constexpr Schema kAssetSchema{kAsset};

constexpr Property kSparseIndices[] = {index_of("bufferView", "bufferViews", true), count_of("byteOffset", 0),
                                       code("componentType", true)};
constexpr Schema kSparseIndicesSchema{kSparseIndices};
constexpr Property kSparseValues[] = {index_of("bufferView", "bufferViews", true), count_of("byteOffset", 0)};
constexpr Schema kSparseValuesSchema{kSparseValues};
constexpr Property kSparse[] = {count_of("count", 1, true), object("indices", kSparseIndicesSchema, true),
                                object("values", kSparseValuesSchema, true)};
constexpr Schema kSparseSchema{kSparse};
constexpr Property kAccessor[] = {index_of("bufferView", "bufferViews"),
                                  count_of("byteOffset", 0),
                                  code("componentType", true),
                                  flag("normalized"),
                                  count_of("count", 0, true),  // 1, but exporters write keys of nothing
                                  text("type", true),
                                  numbers("max", 1, 16),
                                  numbers("min", 1, 16),
                                  object("sparse", kSparseSchema)};
constexpr Schema kAccessorSchema{kAccessor};

constexpr Property kAnimationPointer[] = {text("pointer", true)};
constexpr Schema kAnimationPointerSchema{kAnimationPointer};
constexpr Property kTargetExtensions[] = {object("KHR_animation_pointer", kAnimationPointerSchema)};
constexpr Schema kTargetExtensionsSchema{kTargetExtensions, true};
constexpr Property kTarget[] = {index_of("node", "nodes"), text("path", true),
                                object("extensions", kTargetExtensionsSchema)};
constexpr Schema kTargetSchema{kTarget};
constexpr Property kChannel[] = {count_of("sampler", 0, true), object("target", kTargetSchema, true)};
constexpr Schema kChannelSchema{kChannel};
constexpr Property kAnimationSampler[] = {index_of("input", "accessors", true), index_of("output", "accessors", true),
                                          text("interpolation", false, "LINEAR STEP CUBICSPLINE")};
constexpr Schema kAnimationSamplerSchema{kAnimationSampler};
constexpr Property kAnimation[] = {objects("channels", kChannelSchema, true),
                                   objects("samplers", kAnimationSamplerSchema, true)};
constexpr Schema kAnimationSchema{kAnimation};

constexpr Property kMeshoptBuffer[] = {flag("fallback")};
constexpr Schema kMeshoptBufferSchema{kMeshoptBuffer};
constexpr Property kBufferExtensions[] = {object("EXT_meshopt_compression", kMeshoptBufferSchema),
                                          object("KHR_meshopt_compression", kMeshoptBufferSchema)};
constexpr Schema kBufferExtensionsSchema{kBufferExtensions, true};
constexpr Property kBuffer[] = {text("uri"), count_of("byteLength", 1, true),
                                object("extensions", kBufferExtensionsSchema)};
constexpr Schema kBufferSchema{kBuffer};
constexpr Property kMeshopt[] = {index_of("buffer", "buffers", true),
                                 count_of("byteOffset", 0),
                                 count_of("byteLength", 1, true),
                                 {.name = "byteStride", .kind = Kind::integer, .required = true, .min = 2, .max = 256},
                                 count_of("count", 1, true),
                                 text("mode", true, "ATTRIBUTES TRIANGLES INDICES"),
                                 text("filter", false, "NONE OCTAHEDRAL QUATERNION EXPONENTIAL COLOR")};
constexpr Schema kMeshoptSchema{kMeshopt};
constexpr Property kBufferViewExtensions[] = {object("EXT_meshopt_compression", kMeshoptSchema),
                                              object("KHR_meshopt_compression", kMeshoptSchema)};
constexpr Schema kBufferViewExtensionsSchema{kBufferViewExtensions, true};
constexpr Property kBufferView[] = {index_of("buffer", "buffers", true),
                                    count_of("byteOffset", 0),
                                    count_of("byteLength", 0, true),
                                    {.name = "byteStride", .kind = Kind::integer, .min = 4, .max = 252},
                                    code("target", false),
                                    object("extensions", kBufferViewExtensionsSchema)};
constexpr Schema kBufferViewSchema{kBufferView};

constexpr Property kImage[] = {text("uri"), text("mimeType"), index_of("bufferView", "bufferViews")};
constexpr Schema kImageSchema{kImage};
constexpr Property kOtherImage[] = {index_of("source", "images")};
constexpr Schema kOtherImageSchema{kOtherImage};
constexpr Property kTextureExtensions[] = {object("KHR_texture_basisu", kOtherImageSchema),
                                           object("MSFT_texture_dds", kOtherImageSchema),
                                           object("EXT_texture_webp", kOtherImageSchema)};
constexpr Schema kTextureExtensionsSchema{kTextureExtensions, true};
constexpr Property kTexture[] = {index_of("sampler", "samplers"), index_of("source", "images"),
                                 object("extensions", kTextureExtensionsSchema)};
constexpr Schema kTextureSchema{kTexture};

constexpr Property kSampler[] = {code("magFilter", false), code("minFilter", false), code("wrapS", false),
                                 code("wrapT", false)};
constexpr Schema kSamplerSchema{kSampler};

constexpr Property kTextureTransform[] = {numbers("offset", 2, 2),
                                          {.name = "rotation", .kind = Kind::number},
                                          numbers("scale", 2, 2),
                                          count_of("texCoord", 0)};
constexpr Schema kTextureTransformSchema{kTextureTransform};
constexpr Property kTextureInfoExtensions[] = {object("KHR_texture_transform", kTextureTransformSchema)};
constexpr Schema kTextureInfoExtensionsSchema{kTextureInfoExtensions, true};
constexpr Property kTextureInfo[] = {index_of("index", "textures", true), count_of("texCoord", 0),
                                     object("extensions", kTextureInfoExtensionsSchema)};
constexpr Schema kTextureInfoSchema{kTextureInfo, true};  // normal and occlusion textures add a number each
constexpr Property kPbr[] = {numbers("baseColorFactor", 4, 4),
                             object("baseColorTexture", kTextureInfoSchema),
                             {.name = "metallicFactor", .kind = Kind::number},
                             {.name = "roughnessFactor", .kind = Kind::number},
                             object("metallicRoughnessTexture", kTextureInfoSchema)};
constexpr Schema kPbrSchema{kPbr};
constexpr Property kSpecularGlossiness[] = {numbers("diffuseFactor", 4, 4),
                                            object("diffuseTexture", kTextureInfoSchema),
                                            object("specularGlossinessTexture", kTextureInfoSchema)};
constexpr Schema kSpecularGlossinessSchema{kSpecularGlossiness, true};  // and two factors
constexpr Property kEmissiveStrength[] = {{.name = "emissiveStrength", .kind = Kind::number, .min = 0}};
constexpr Schema kEmissiveStrengthSchema{kEmissiveStrength};
constexpr Property kMaterialExtensions[] = {object("KHR_materials_pbrSpecularGlossiness", kSpecularGlossinessSchema),
                                            object("KHR_materials_emissive_strength", kEmissiveStrengthSchema),
                                            object("KHR_materials_unlit", kOpen)};
constexpr Schema kMaterialExtensionsSchema{kMaterialExtensions, true};
constexpr Property kMaterial[] = {object("pbrMetallicRoughness", kPbrSchema),
                                  object("normalTexture", kTextureInfoSchema),
                                  object("occlusionTexture", kTextureInfoSchema),
                                  object("emissiveTexture", kTextureInfoSchema),
                                  numbers("emissiveFactor", 3, 3),
                                  text("alphaMode"),
                                  {.name = "alphaCutoff", .kind = Kind::number},
                                  flag("doubleSided"),
                                  object("extensions", kMaterialExtensionsSchema)};
constexpr Schema kMaterialSchema{kMaterial};

constexpr Property kDraco[] = {index_of("bufferView", "bufferViews", true),
                               {.name = "attributes", .kind = Kind::index_map, .required = true}};
constexpr Schema kDracoSchema{kDraco};
constexpr Property kPrimitiveExtensions[] = {object("KHR_draco_mesh_compression", kDracoSchema)};
constexpr Schema kPrimitiveExtensionsSchema{kPrimitiveExtensions, true};
constexpr Property kPrimitive[] = {{.name = "attributes", .kind = Kind::index_map, .required = true, .of = "accessors"},
                                   index_of("indices", "accessors"),
                                   index_of("material", "materials"),
                                   {.name = "mode", .kind = Kind::integer, .min = 0, .max = 6},
                                   {.name = "targets", .kind = Kind::index_maps, .of = "accessors"},
                                   object("extensions", kPrimitiveExtensionsSchema)};
constexpr Schema kPrimitiveSchema{kPrimitive};
constexpr Property kMesh[] = {objects("primitives", kPrimitiveSchema, true), numbers("weights", 1, kAnyLength)};
constexpr Schema kMeshSchema{kMesh};

constexpr Property kVisibility[] = {flag("visible")};
constexpr Schema kVisibilitySchema{kVisibility};
constexpr Property kLevels[] = {{.name = "ids", .kind = Kind::indices, .of = "nodes"}};
constexpr Schema kLevelsSchema{kLevels, true};
constexpr Property kNodeExtensions[] = {object("KHR_node_visibility", kVisibilitySchema),
                                        object("MSFT_lod", kLevelsSchema)};
constexpr Schema kNodeExtensionsSchema{kNodeExtensions, true};
constexpr Property kNode[] = {index_of("camera", "cameras"),
                              {.name = "children", .kind = Kind::indices, .of = "nodes"},
                              index_of("skin", "skins"),
                              numbers("matrix", 16, 16),
                              index_of("mesh", "meshes"),
                              numbers("rotation", 4, 4),
                              numbers("scale", 3, 3),
                              numbers("translation", 3, 3),
                              numbers("weights", 1, kAnyLength),
                              object("extensions", kNodeExtensionsSchema)};
constexpr Schema kNodeSchema{kNode};
constexpr Property kScene[] = {{.name = "nodes", .kind = Kind::indices, .of = "nodes"}};
constexpr Schema kSceneSchema{kScene};
constexpr Property kSkin[] = {index_of("inverseBindMatrices", "accessors"),
                              index_of("skeleton", "nodes"),
                              {.name = "joints", .kind = Kind::indices, .required = true, .of = "nodes"}};
constexpr Schema kSkinSchema{kSkin};

constexpr Property kRoot[] = {{.name = "extensionsUsed", .kind = Kind::texts},
                              {.name = "extensionsRequired", .kind = Kind::texts},
                              objects("accessors", kAccessorSchema),
                              objects("animations", kAnimationSchema),
                              object("asset", kAssetSchema, true),
                              objects("buffers", kBufferSchema),
                              objects("bufferViews", kBufferViewSchema),
                              objects("cameras", kOpen),
                              object("extensions", kRootExtensionsSchema),
                              objects("images", kImageSchema),
                              objects("materials", kMaterialSchema),
                              objects("meshes", kMeshSchema),
                              objects("nodes", kNodeSchema),
                              objects("samplers", kSamplerSchema),
                              index_of("scene", "scenes"),
                              objects("scenes", kSceneSchema),
                              objects("skins", kSkinSchema),
                              objects("textures", kTextureSchema)};

}  // namespace

const Schema kRootSchema{kRoot};

}  // namespace marrow::cook::gltf
