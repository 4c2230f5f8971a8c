// A small avatar as glTF, and what VRM 1 and VRM 0 say of it: the same, but for what only one of them can say.
#pragma once

#include "unit/cook/gltf/document.h"

namespace marrow::cook {

// Its nodes. It is 1 m tall, of two bones with a skin; hair of two bones below the head, and a lock beside it.
enum AvatarNode { kBody, kHips, kHead, kLeftEye, kRightEye, kHair, kHairLower, kHairEnd, kFace, kLock };

inline Builder avatar() {
  Builder b;
  b.root["nodes"] = {
      {{"name", "body"}, {"mesh", 0}, {"skin", 0}},
      {{"name", "Hips"}, {"children", {kHead}}},
      {{"name", "Head"}, {"translation", {0, 1, 0}}, {"children", {kLeftEye, kRightEye, kHair, kFace}}},
      {{"name", "Eye.L"}, {"translation", {0.03125, 0.0625, 0.0625}}},
      {{"name", "Eye.R"}, {"translation", {-0.03125, 0.0625, 0.0625}}},
      {{"name", "Hair"}, {"translation", {0, 0.125, -0.125}}, {"children", {kHairLower, kLock}}},
      {{"name", "Hair lower"}, {"translation", {0, -0.125, 0}}, {"children", {kHairEnd}}},
      {{"name", "Hair end"}, {"translation", {0, -0.0625, 0}}},
      {{"name", "face"}, {"mesh", 1}},
      {{"name", "Lock"}, {"translation", {0.125, 0, 0}}},
  };
  b.root["scenes"][0]["nodes"] = {kBody, kHips};
  const int positions = b.curve(4);
  const int joints = b.numbers<std::uint8_t>(kU8, "VEC4", 4, {0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0});
  const int weights = b.numbers<float>(kF32, "VEC4", 4, {1, 0, 0, 0, 1, 0, 0, 0, 0.25F, 0.75F, 0, 0, 1, 0, 0, 0});
  const int indices = b.numbers<std::uint16_t>(kU16, "SCALAR", 1, {0, 1, 2, 1, 3, 2});
  Json targets = Json::array();
  for (const float x : {1.0F, 2.0F, 3.0F}) {
    const int moved = b.positions({x, 0, 0, 0, x, 0, 0, 0, x, x, x, 0});
    targets.push_back({{"POSITION", moved}});
  }
  b.root["meshes"] = {
      {{"primitives",
        {{{"attributes", {{"POSITION", positions}, {"JOINTS_0", joints}, {"WEIGHTS_0", weights}}},
          {"indices", indices}}}}},
      {{"name", "face"},
       {"extras", {{"targetNames", {"smile", "eyes shut", "brow"}}}},
       {"weights", {0, 0, 0.25}},
       {"primitives", {{{"attributes", {{"POSITION", positions}}}, {"indices", indices}, {"targets", targets}}}}}};
  const int inverse_bind = b.numbers<float>(kF32, "MAT4", 16, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0,  0, 1,
                                                               1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1, 0, 1});
  b.root["skins"] = {{{"joints", {kHips, kHead}}, {"inverseBindMatrices", inverse_bind}, {"skeleton", kHips}}};
  return b;
}

inline Builder avatar_1() {
  Builder b = avatar();
  b.root["extensionsUsed"] = {"VRMC_vrm", "VRMC_springBone"};
  const auto map = [](double degrees) { return Json{{"inputMaxValue", 90}, {"outputScale", degrees}}; };
  b.root["extensions"]["VRMC_vrm"] = {
      {"specVersion", "1.0"},
      {"meta",
       {{"name", "Testa"},
        {"authors", {"Ada", "Eve"}},
        {"licenseUrl", "https://vrm.dev/licenses/1.0/"},
        {"thumbnailImage", 0},
        {"allowRedistribution", true},
        {"avatarPermission", "everyone"}}},
      {"humanoid",
       {{"humanBones",
         {{"hips", {{"node", kHips}}},
          {"head", {{"node", kHead}}},
          {"leftEye", {{"node", kLeftEye}}},
          {"rightEye", {{"node", kRightEye}}}}}}},
      {"firstPerson", {{"meshAnnotations", {{{"node", kFace}, {"type", "thirdPersonOnly"}}}}}},
      {"lookAt",
       {{"type", "bone"},
        {"offsetFromHeadBone", {0, 0.0625, 0}},
        {"rangeMapHorizontalInner", map(10)},
        {"rangeMapHorizontalOuter", map(20)},
        {"rangeMapVerticalDown", map(8)},
        {"rangeMapVerticalUp", map(12)}}},
      {"expressions",
       {{"preset",
         {{"happy",
           {{"isBinary", true},
            {"overrideBlink", "block"},
            {"morphTargetBinds",
             {{{"node", kFace}, {"index", 0}, {"weight", 1}}, {{"node", kFace}, {"index", 2}, {"weight", 0.5}}}}}},
          {"blink", {{"morphTargetBinds", {{{"node", kFace}, {"index", 1}, {"weight", 1}}}}}}}},
        {"custom", {{"glow", {{"materialColorBinds", {Json::object()}}}}}}}}};
  b.root["extensions"]["VRMC_springBone"] = {
      {"specVersion", "1.0"},
      {"colliders",
       {{{"node", kHead}, {"shape", {{"sphere", {{"offset", {0, 0.125, 0.25}}, {"radius", 0.125}}}}}},
        {{"node", kHips}, {"shape", {{"capsule", {{"tail", {0, 1, 0}}, {"radius", 0.0625}}}}}}}},
      {"colliderGroups", {{{"colliders", {0}}}, {{"colliders", {0, 1}}}}},
      {"springs",
       {{{"colliderGroups", {0}},
         {"joints",
          {{{"node", kHair}, {"stiffness", 1}, {"dragForce", 0.4}, {"hitRadius", 0.03125}},
           {{"node", kHairLower}, {"stiffness", 0.5}, {"dragForce", 0.4}, {"gravityPower", 0.25}},
           {{"node", kHairEnd}}}}}}}};
  return b;
}

// Faces -z, so its left is where version 1's right is; the eyes are called after what they are.
inline Builder avatar_0() {
  Builder b = avatar();
  b.root["extensionsUsed"] = {"VRM"};
  const auto map = [](double degrees) {
    return Json{{"curve", {0, 0, 0, 1, 1, 1, 1, 0}}, {"xRange", 90}, {"yRange", degrees}};
  };
  const auto point = [](double x, double y, double z) { return Json{{"x", x}, {"y", y}, {"z", z}}; };
  b.root["extensions"]["VRM"] = {
      {"exporterVersion", "test"},
      {"meta",
       {{"title", "Testa"}, {"author", "Ada"}, {"licenseName", "CC0"}, {"texture", -1}, {"reference", nullptr}}},
      {"humanoid",
       {{"humanBones",
         {{{"bone", "hips"}, {"node", kHips}},
          {{"bone", "head"}, {"node", kHead}},
          {{"bone", "leftEye"}, {"node", kLeftEye}},
          {{"bone", "rightEye"}, {"node", kRightEye}},
          {{"bone", "jaw"}, {"node", -1}}}}}},
      {"firstPerson",
       {{"firstPersonBone", -1},
        {"firstPersonBoneOffset", point(0, 0.0625, 0.5)},
        {"meshAnnotations", {{{"mesh", 1}, {"firstPersonFlag", "ThirdPersonOnly"}}}},
        {"lookAtTypeName", "Bone"},
        {"lookAtHorizontalInner", map(10)},
        {"lookAtHorizontalOuter", map(20)},
        {"lookAtVerticalDown", map(8)},
        {"lookAtVerticalUp", map(12)}}},
      {"blendShapeMaster",
       {{"blendShapeGroups",
         {{{"name", "Joy"},
           {"presetName", "joy"},
           {"isBinary", true},
           {"binds", {{{"mesh", 1}, {"index", 0}, {"weight", 100}}, {{"mesh", 1}, {"index", 2}, {"weight", 50}}}}},
          {{"name", "Blink"}, {"presetName", "blink"}, {"binds", {{{"mesh", 1}, {"index", 1}, {"weight", 100}}}}},
          {{"name", "glow"},
           {"presetName", "unknown"},
           {"binds", Json::array()},
           {"materialValues", {Json::object()}}}}}}},
      {"secondaryAnimation",
       {{"boneGroups",
         {{{"comment", ""},
           {"stiffiness", 1},
           {"gravityPower", 0.25},
           {"gravityDir", point(0, -1, 0)},
           {"dragForce", 0.4},
           {"center", -1},
           {"hitRadius", 0.03125},
           {"bones", {kHair}},
           {"colliderGroups", {0}}}}},
        {"colliderGroups",
         {{{"node", kHead}, {"colliders", {{{"offset", point(0, 0.125, -0.25)}, {"radius", 0.125}}}}}}}}}};
  return b;
}

}  // namespace marrow::cook
