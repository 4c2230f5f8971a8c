// The engine's side of Godot 4's C interface, as far as a library asks for it: values, a registry of classes, objects,
// and a Skeleton3D that keeps what it is told. Written from the interface's description, to run a library without
// Godot.
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "../../../platform/godot/4/gdextension.h"

namespace mock {

// A Variant: its type and 16 bytes.
struct Variant {
  std::int32_t type = 0;
  std::int32_t padding = 0;
  alignas(8) std::uint8_t inside[16] = {};

  Variant() = default;
  Variant(bool value);
  Variant(std::int64_t value);
  Variant(int value) : Variant(std::int64_t(value)) {}
  Variant(double value);
  Variant(const char* value);
  Variant(const std::vector<std::uint8_t>& value);
  Variant(struct Object* value);
  Variant(Variant&& other);
  Variant& operator=(Variant&& other);
  ~Variant();

  bool truth() const { return inside[0] != 0; }
  std::int64_t whole() const;
  double real() const;
  std::string text() const;
  std::vector<std::string> texts() const;
  std::vector<std::uint8_t> bytes() const;
  std::vector<float> reals() const;
  std::vector<std::int32_t> ints() const;
};
static_assert(sizeof(Variant) == 24);

struct Object {
  std::string type;
  void* instance = nullptr;
  std::vector<float> pose;  // of a Skeleton3D: ten a bone
};

struct Method {
  gdextension::ClassMethod info;
  std::vector<int> arguments;
  int result;
};

struct Property {
  int type;
  std::string setter, getter;
};

struct Class {
  std::string parent;
  gdextension::Class info;
  std::map<std::string, Method> methods;
  std::map<std::string, Property> properties;
};

struct Engine {
  std::map<std::string, Class> classes;
  std::vector<std::string> errors;  // printed
  std::string without;              // a function that this Godot lacks
  bool other_skeleton = false;      // its methods have other arguments
  std::int64_t live = 0;            // values that are not destroyed

  // As a script calls: false and an error if the library refuses the arguments.
  bool call(Object& object, const std::string& method, const std::vector<const Variant*>& arguments, Variant& result,
            gdextension::CallError& error);
  // As compiled scripts call, with arguments of the right types.
  Variant call_typed(Object& object, const std::string& method, const std::vector<const Variant*>& arguments);
  Object* make(const std::string& type);
  void free(Object* object);
};

Engine& engine();
gdextension::Function get_function(const char* name);

}  // namespace mock
