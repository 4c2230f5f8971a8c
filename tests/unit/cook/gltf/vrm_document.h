// A small avatar as glTF, and what VRM 1 and VRM 0 say of it: the same, but for
// what only one of them can say.
#pragma once

#include "unit/cook/gltf/gltf_text.h"

namespace marrow::cook {

// It is 1 m tall, of two bones with a skin; hair of two bones below the head,
// and a lock beside it. Nodes are 0 body, 1 hips, 2 head, 3 and 4 eyes, 5 hair,
// 6 its lower bone, 7 its end, 8 face, 9 lock.
inline const char* const kAvatar = R"("nodes": [
    {"name": "body", "mesh": 0, "skin": 0}, {"name": "Hips", "children": [2]},
    {"name": "Head", "translation": [0, 1, 0], "children": [3, 4, 5, 8]},
    {"name": "Eye.L", "translation": [0.03125, 0.0625, 0.0625]}, {"name": "Eye.R", "translation": [-0.03125, 0.0625, 0.0625]},
    {"name": "Hair", "translation": [0, 0.125, -0.125], "children": [6, 9]},
    {"name": "Hair lower", "translation": [0, -0.125, 0], "children": [7]}, {"name": "Hair end", "translation": [0, -0.0625, 0]},
    {"name": "face", "mesh": 1}, {"name": "Lock", "translation": [0.125, 0, 0]}],
  "scenes": [{"nodes": [0, 1]}],
  "meshes": [
    {"primitives": [{"indices": "=u16x1 0 1 2 1 3 2", "attributes": {"POSITION": "=f32x3 0 0 0 1 1 0 2 4 0 3 9 0",
      "JOINTS_0": "=u8x4 0 0 0 0 1 0 0 0 0 1 0 0 1 0 0 0", "WEIGHTS_0": "=f32x4 1 0 0 0 1 0 0 0 0.25 0.75 0 0 1 0 0 0"}}]},
    {"name": "face", "extras": {"targetNames": ["smile", "eyes shut", "brow"]}, "weights": [0, 0, 0.25],
     "primitives": [{"indices": "=u16x1 0 1 2 1 3 2", "attributes": {"POSITION": "=f32x3 0 0 0 1 1 0 2 4 0 3 9 0"},
       "targets": [{"POSITION": "=f32x3 1 0 0 0 1 0 0 0 1 1 1 0"}, {"POSITION": "=f32x3 2 0 0 0 2 0 0 0 2 2 2 0"},
                   {"POSITION": "=f32x3 3 0 0 0 3 0 0 0 3 3 3 0"}]}]}],
  "skins": [{"joints": [1, 2], "skeleton": 1,
             "inverseBindMatrices": "=f32x16 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1  1 0 0 0 0 1 0 0 0 0 1 0 0 -1 0 1"}])";

inline Builder avatar_1() {
  return document_of(std::string(kAvatar) +
                     R"(, "extensionsUsed": ["VRMC_vrm", "VRMC_springBone"], "extensions": {
    "VRMC_vrm": {"specVersion": "1.0",
      "meta": {"name": "Testa", "authors": ["Ada", "Eve"], "licenseUrl": "https://vrm.dev/licenses/1.0/",
               "thumbnailImage": 0, "allowRedistribution": true, "avatarPermission": "everyone"},
      "humanoid": {"humanBones": {"hips": {"node": 1}, "head": {"node": 2}, "leftEye": {"node": 3}, "rightEye": {"node": 4}}},
      "firstPerson": {"meshAnnotations": [{"node": 8, "type": "thirdPersonOnly"}]},
      "lookAt": {"type": "bone", "offsetFromHeadBone": [0, 0.0625, 0],
                 "rangeMapHorizontalInner": {"inputMaxValue": 90, "outputScale": 10},
                 "rangeMapHorizontalOuter": {"inputMaxValue": 90, "outputScale": 20},
                 "rangeMapVerticalDown": {"inputMaxValue": 90, "outputScale": 8},
                 "rangeMapVerticalUp": {"inputMaxValue": 90, "outputScale": 12}},
      "expressions": {"preset": {
          "happy": {"isBinary": true, "overrideBlink": "block",
                    "morphTargetBinds": [{"node": 8, "index": 0, "weight": 1}, {"node": 8, "index": 2, "weight": 0.5}]},
          "blink": {"morphTargetBinds": [{"node": 8, "index": 1, "weight": 1}]}},
        "custom": {"glow": {"materialColorBinds": [{}]}}}},
    "VRMC_springBone": {"specVersion": "1.0",
      "colliders": [{"node": 2, "shape": {"sphere": {"offset": [0, 0.125, 0.25], "radius": 0.125}}},
                    {"node": 1, "shape": {"capsule": {"tail": [0, 1, 0], "radius": 0.0625}}}],
      "colliderGroups": [{"colliders": [0]}, {"colliders": [0, 1]}],
      "springs": [{"colliderGroups": [0],
                   "joints": [{"node": 5, "stiffness": 1, "dragForce": 0.4, "hitRadius": 0.03125},
                              {"node": 6, "stiffness": 0.5, "dragForce": 0.4, "gravityPower": 0.25}, {"node": 7}]}]}})");
}

// Faces -z, so its left is where version 1's right is; the eyes are called
// after what they are.
inline Builder avatar_0() {
  return document_of(std::string(kAvatar) +
                     R"(, "extensionsUsed": ["VRM"], "extensions": {"VRM": {"exporterVersion": "test",
    "meta": {"title": "Testa", "author": "Ada", "licenseName": "CC0", "texture": -1, "reference": null},
    "humanoid": {"humanBones": [{"bone": "hips", "node": 1}, {"bone": "head", "node": 2}, {"bone": "leftEye", "node": 3},
                                {"bone": "rightEye", "node": 4}, {"bone": "jaw", "node": -1}]},
    "firstPerson": {"firstPersonBone": -1, "firstPersonBoneOffset": {"x": 0, "y": 0.0625, "z": 0.5},
      "meshAnnotations": [{"mesh": 1, "firstPersonFlag": "ThirdPersonOnly"}], "lookAtTypeName": "Bone",
      "lookAtHorizontalInner": {"curve": [0, 0, 0, 1, 1, 1, 1, 0], "xRange": 90, "yRange": 10},
      "lookAtHorizontalOuter": {"curve": [0, 0, 0, 1, 1, 1, 1, 0], "xRange": 90, "yRange": 20},
      "lookAtVerticalDown": {"curve": [0, 0, 0, 1, 1, 1, 1, 0], "xRange": 90, "yRange": 8},
      "lookAtVerticalUp": {"curve": [0, 0, 0, 1, 1, 1, 1, 0], "xRange": 90, "yRange": 12}},
    "blendShapeMaster": {"blendShapeGroups": [
      {"name": "Joy", "presetName": "joy", "isBinary": true,
       "binds": [{"mesh": 1, "index": 0, "weight": 100}, {"mesh": 1, "index": 2, "weight": 50}]},
      {"name": "Blink", "presetName": "blink", "binds": [{"mesh": 1, "index": 1, "weight": 100}]},
      {"name": "glow", "presetName": "unknown", "binds": [], "materialValues": [{}]}]},
    "secondaryAnimation": {
      "boneGroups": [{"comment": "", "stiffiness": 1, "gravityPower": 0.25, "gravityDir": {"x": 0, "y": -1, "z": 0},
                      "dragForce": 0.4, "center": -1, "hitRadius": 0.03125, "bones": [5], "colliderGroups": [0]}],
      "colliderGroups": [{"node": 2, "colliders": [{"offset": {"x": 0, "y": 0.125, "z": -0.25}, "radius": 0.125}]}]}}})");
}

}  // namespace marrow::cook
