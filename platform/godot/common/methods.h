// What scripts may call, as one table of plain values: each Godot's glue registers it, and turns its own values to
// these.
#pragma once
#include "cooked.h"

namespace marrow_godot {

enum class Kind { nothing, truth, whole, real, text, bytes, ints, reals, texts, object };

struct Value {
  std::int64_t whole = 0;  // of truth, too
  double real = 0;
  void* object = nullptr;
  const std::uint8_t* bytes = nullptr;  // as long as the call
  std::size_t byte_count = 0;
  std::string text;
  std::vector<std::int32_t> ints;
  std::vector<float> reals;
  std::vector<std::string> texts;
};

// What an engine does with a pose: kReals a bone, as rests has them. False: `skeleton` is none, or has other bones.
struct Engine {
  bool (*set_bones)(void* skeleton, const float* pose, const float* rests, std::size_t bone_count);
};

constexpr int kMostArguments = 6;

struct Argument {
  const char* name;
  Kind kind;
};

struct Method {
  const char* name;
  Kind result;
  int argument_count;
  Argument arguments[kMostArguments];
  void (*call)(Cooked& cooked, const Engine& engine, const Value* arguments, Value& result);
};

struct Methods {
  const Method* all;
  int count;
};
Methods methods();

}  // namespace marrow_godot
