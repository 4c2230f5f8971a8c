#include "mock_engine.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string_view>

namespace mock {
namespace {

using namespace gdextension;

void stop(const std::string& what) {
  std::fprintf(stderr, "mock_host: %s\n", what.c_str());
  std::exit(1);
}

// ---- Values: a String or StringName is a pointer, null if empty; a packed array is a pointer behind another.

std::string*& string_in(void* value) {
  return *static_cast<std::string**>(value);
}
std::string text_in(const void* value) {
  const std::string* const text = *static_cast<std::string* const*>(value);
  return text == nullptr ? "" : *text;
}

using Array = std::vector<std::uint8_t>;
struct Packed {
  void* unused;
  Array* array;
};
Packed& packed(void* value) {
  return *static_cast<Packed*>(value);
}
const Array& array_in(const void* value) {
  static const Array kNone;
  const Array* const array = static_cast<const Packed*>(value)->array;
  return array == nullptr ? kNone : *array;
}

std::size_t width(int type) {
  if (type == kPackedBytes) return 1;
  return type == kPackedStrings ? sizeof(void*) : 4;
}

bool is_text(int type) {
  return type == kString || type == kStringName;
}
bool is_packed(int type) {
  return type >= kPackedBytes;
}

void make_text(void* to, const std::string& text) {
  string_in(to) = text.empty() ? nullptr : new std::string(text);
  engine().live += !text.empty();
}

template <int type>
void destroy(void* value) {
  if (is_text(type)) {
    engine().live -= string_in(value) != nullptr;
    delete string_in(value);
    string_in(value) = reinterpret_cast<std::string*>(8);  // not to be used again
    return;
  }
  Array*& array = packed(value).array;
  if (type == kPackedStrings && array != nullptr)
    for (std::size_t i = 0; i < array->size(); i += sizeof(void*)) destroy<kString>(array->data() + i);
  engine().live -= array != nullptr;
  delete array;
  array = reinterpret_cast<Array*>(8);
}

Destructor destructor(int type) {
  switch (type) {
    case kString:
      return destroy<kString>;
    case kStringName:
      return destroy<kStringName>;
    case kPackedBytes:
      return destroy<kPackedBytes>;
    case kPackedInts:
      return destroy<kPackedInts>;
    case kPackedFloats:
      return destroy<kPackedFloats>;
    case kPackedStrings:
      return destroy<kPackedStrings>;
    default:
      stop("there is no destructor of type " + std::to_string(type));
      return nullptr;
  }
}

void copy(int type, void* to, const void* from) {
  if (is_text(type)) return make_text(to, text_in(from));
  if (!is_packed(type)) {
    std::memcpy(to, from, type == kBool ? 1 : 8);
    return;
  }
  packed(to) = {nullptr, array_in(from).empty() ? nullptr : new Array(array_in(from))};
  engine().live += !array_in(from).empty();
  if (type == kPackedStrings)
    for (std::size_t i = 0; i < array_in(from).size(); i += sizeof(void*))
      make_text(packed(to).array->data() + i, text_in(array_in(from).data() + i));
}

template <int type>
void to_variant(void* variant, void* value) {
  Variant& out = *static_cast<Variant*>(variant);
  out.type = type;
  copy(type, out.inside, value);
}

template <int type>
void from_variant(void* value, void* variant) {
  const Variant& in = *static_cast<Variant*>(variant);
  if (in.type != type) stop("a variant is taken for what it is not");
  copy(type, value, in.inside);
}

FromValue variant_maker(int type) {
  switch (type) {
    case kBool:
      return to_variant<kBool>;
    case kInt:
      return to_variant<kInt>;
    case kFloat:
      return to_variant<kFloat>;
    case kString:
      return to_variant<kString>;
    case kPackedBytes:
      return to_variant<kPackedBytes>;
    case kPackedInts:
      return to_variant<kPackedInts>;
    case kPackedFloats:
      return to_variant<kPackedFloats>;
    case kPackedStrings:
      return to_variant<kPackedStrings>;
    default:
      stop("no variant is made of type " + std::to_string(type));
      return nullptr;
  }
}

ToValue variant_reader(int type) {
  switch (type) {
    case kInt:
      return from_variant<kInt>;
    case kFloat:
      return from_variant<kFloat>;
    case kString:
      return from_variant<kString>;
    case kObject:
      return from_variant<kObject>;
    case kPackedBytes:
      return from_variant<kPackedBytes>;
    default:
      stop("no variant is read as type " + std::to_string(type));
      return nullptr;
  }
}

Constructor constructor(int type, std::int32_t index) {
  if (type != kStringName || index != 2) stop("that constructor is not there");
  return [](void* to, const void* const* from) { make_text(to, text_in(from[0])); };
}

template <int type>
void resize(void* self, const void* const* arguments, void* result, int count) {
  const std::int64_t size = *static_cast<const std::int64_t*>(arguments[0]);
  if (count != 1 || size < 0) stop("resize is called in another way");
  if (packed(self).array == nullptr) packed(self).array = new Array, ++engine().live;
  packed(self).array->resize(std::size_t(size) * width(type));
  *static_cast<std::int64_t*>(result) = 0;
}

void size_of_bytes(void* self, const void* const*, void* result, int count) {
  if (count != 0) stop("size is called with arguments");
  *static_cast<std::int64_t*>(result) = std::int64_t(array_in(self).size());
}

BuiltIn built_in(int type, const void* name, std::int64_t hash) {
  if (text_in(name) == "size" && hash == 3173160232 && type == kPackedBytes) return size_of_bytes;
  if (text_in(name) != "resize" || hash != 848867239) stop("there is no method " + text_in(name));
  if (type == kPackedBytes) return resize<kPackedBytes>;
  if (type == kPackedInts) return resize<kPackedInts>;
  if (type == kPackedFloats) return resize<kPackedFloats>;
  return resize<kPackedStrings>;
}

template <typename Element>
Element* element(void* self, std::int64_t index) {
  if (index < 0 || std::size_t(index) * sizeof(Element) >= array_in(self).size()) stop("an index is out of range");
  return reinterpret_cast<Element*>(packed(self).array->data()) + index;
}

std::int64_t to_utf8(const void* string, char* to, std::int64_t most) {
  const std::string text = text_in(string);
  if (to != nullptr) std::memcpy(to, text.data(), std::min(std::size_t(most), text.size()));
  return std::int64_t(text.size());
}

// ---- Classes and objects.

struct Bind {
  const char* name;
  std::int64_t hash;
  std::size_t at, count;  // in a bone's ten numbers
};
constexpr Bind kBinds[] = {{"get_bone_count", 3905245786, 0, 0},
                           {"set_bone_pose_position", 1530502735, 0, 3},
                           {"set_bone_pose_rotation", 2823819782, 3, 4},
                           {"set_bone_pose_scale", 1530502735, 7, 3}};

const void* find_bind(const void* type, const void* name, std::int64_t hash) {
  for (const Bind& each : kBinds)
    if (text_in(type) == "Skeleton3D" && text_in(name) == each.name && hash == each.hash && !engine().other_skeleton)
      return &each;
  return nullptr;
}

void call_bind(const void* bind, void* object, const void* const* arguments, void* result) {
  const Bind& method = *static_cast<const Bind*>(bind);
  std::vector<float>& pose = static_cast<Object*>(object)->pose;
  if (static_cast<Object*>(object)->type != "Skeleton3D") stop("what is posed is no skeleton");
  if (method.count == 0) {
    *static_cast<std::int64_t*>(result) = std::int64_t(pose.size() / 10);
    return;
  }
  const std::int64_t bone = *static_cast<const std::int64_t*>(arguments[0]);
  if (bone < 0 || 10 * std::size_t(bone) >= pose.size()) stop("there is no such bone");
  std::memcpy(&pose[10 * std::size_t(bone) + method.at], arguments[1], method.count * sizeof(float));
}

void check_property(const gdextension::Property& property) {
  if (property.name == nullptr || property.class_name == nullptr || property.hint_string == nullptr)
    stop("a property lacks a name: Godot would read a null pointer");
}

void register_class(void*, const void* name, const void* parent, const gdextension::Class* info) {
  if (info->create == nullptr || info->free == nullptr) stop("a class cannot be made");
  engine().classes[text_in(name)] = {text_in(parent), *info, {}, {}};
}

void register_method(void*, const void* type, const ClassMethod* info) {
  Method method{*info, {}, info->has_result != 0 ? info->result->type : kNil};
  if (info->has_result != 0) check_property(*info->result);
  for (std::uint32_t i = 0; i < info->argument_count; ++i) {
    check_property(info->arguments[i]);
    if (text_in(info->arguments[i].name).empty() || info->argument_metadata[i] != 0) stop("an argument has no name");
    method.arguments.push_back(info->arguments[i].type);
  }
  engine().classes.at(text_in(type)).methods[text_in(info->name)] = method;
}

void register_property(void*, const void* type, const gdextension::Property* info, const void* setter,
                       const void* getter) {
  check_property(*info);
  engine().classes.at(text_in(type)).properties[text_in(info->name)] = {info->type, text_in(setter), text_in(getter)};
}

void unregister_class(void*, const void* name) {
  engine().classes.erase(text_in(name));
}

void* construct(const void* name) {
  return engine().make(text_in(name));
}

void set_instance(void* object, const void* type, void* instance) {
  static_cast<Object*>(object)->type = text_in(type);
  static_cast<Object*>(object)->instance = instance;
}

void* class_tag(const void* name) {
  static std::map<std::string, char> tags;
  return &tags[text_in(name)];
}

void* cast(const void* object, void* tag) {
  std::string* name = new std::string(static_cast<const Object*>(object)->type);
  const bool is = class_tag(&name) == tag;
  delete name;
  return is ? const_cast<void*>(object) : nullptr;
}

void print_error(const char* text, const char*, const char*, std::int32_t, std::uint8_t) {
  engine().errors.push_back(text);
}

template <typename Signature>
Function erase(Signature* function) {
  return reinterpret_cast<Function>(function);
}

}  // namespace

Engine& engine() {
  static Engine the_engine;
  return the_engine;
}

gdextension::Function get_function(const char* name) {
  static const std::map<std::string_view, Function> kFunctions = {
      {"variant_get_type", erase(+[](const void* variant) { return int(static_cast<const Variant*>(variant)->type); })},
      {"get_variant_from_type_constructor", erase(variant_maker)},
      {"get_variant_to_type_constructor", erase(variant_reader)},
      {"variant_get_ptr_constructor", erase(constructor)},
      {"variant_get_ptr_destructor", erase(destructor)},
      {"variant_get_ptr_builtin_method", erase(built_in)},
      {"string_new_with_utf8_chars", erase(+[](void* to, const char* text) { make_text(to, text); })},
      {"string_to_utf8_chars", erase(to_utf8)},
      {"packed_byte_array_operator_index_const",
       erase(+[](const void* self, std::int64_t index) -> const std::uint8_t* {
         return element<std::uint8_t>(const_cast<void*>(self), index);
       })},
      {"packed_byte_array_operator_index", erase(element<std::uint8_t>)},
      {"packed_int32_array_operator_index", erase(element<std::int32_t>)},
      {"packed_float32_array_operator_index", erase(element<float>)},
      {"packed_string_array_operator_index",
       erase(+[](void* self, std::int64_t index) -> void* { return element<void*>(self, index); })},
      {"classdb_get_class_tag", erase(class_tag)},
      {"classdb_get_method_bind", erase(find_bind)},
      {"classdb_construct_object", erase(construct)},
      {"classdb_register_extension_class", erase(register_class)},
      {"classdb_register_extension_class_method", erase(register_method)},
      {"classdb_register_extension_class_property", erase(register_property)},
      {"classdb_unregister_extension_class", erase(unregister_class)},
      {"object_set_instance", erase(set_instance)},
      {"object_cast_to", erase(cast)},
      {"object_method_bind_ptrcall", erase(call_bind)},
      {"print_error", erase(print_error)},
  };
  const auto found = kFunctions.find(name);
  return found == kFunctions.end() || engine().without == name ? nullptr : found->second;
}

Object* Engine::make(const std::string& type) {
  const auto found = classes.find(type);
  if (found != classes.end()) return static_cast<Object*>(found->second.info.create(found->second.info.userdata));
  return new Object{type, nullptr, {}};
}

void Engine::free(Object* object) {
  const auto found = classes.find(object->type);
  if (found != classes.end()) found->second.info.free(found->second.info.userdata, object->instance);
  delete object;
}

bool Engine::call(Object& object, const std::string& method, const std::vector<const Variant*>& arguments,
                  Variant& result, CallError& error) {
  const ClassMethod& info = classes.at(object.type).methods.at(method).info;
  error = {};
  info.call(info.userdata, object.instance, reinterpret_cast<const void* const*>(arguments.data()),
            std::int64_t(arguments.size()), &result, &error);
  return error.error == 0;
}

Variant Engine::call_typed(Object& object, const std::string& method, const std::vector<const Variant*>& arguments) {
  const Method& found = classes.at(object.type).methods.at(method);
  if (arguments.size() != found.arguments.size()) stop(method + " has another count of arguments");
  std::vector<const void*> values;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (arguments[i]->type != found.arguments[i]) stop(method + " has arguments of other types");
    values.push_back(arguments[i]->inside);
  }
  Variant result;  // as an engine has it: of the result's type, and empty
  result.type = found.result;
  found.info.pointer_call(found.info.userdata, object.instance, values.data(), result.inside);
  return result;
}

Variant::Variant(bool value) : type(kBool) {
  inside[0] = value;
}
Variant::Variant(std::int64_t value) : type(kInt) {
  std::memcpy(inside, &value, sizeof value);
}
Variant::Variant(double value) : type(kFloat) {
  std::memcpy(inside, &value, sizeof value);
}
Variant::Variant(const char* value) : type(kString) {
  make_text(inside, value);
}
Variant::Variant(Object* value) : type(kObject) {
  std::memcpy(inside, &value, sizeof value);
}
Variant::Variant(const std::vector<std::uint8_t>& value) : type(kPackedBytes) {
  Packed from{nullptr, const_cast<Array*>(&value)};
  copy(kPackedBytes, inside, &from);
}
Variant::Variant(Variant&& other) : type(other.type) {
  std::memcpy(inside, other.inside, sizeof inside);
  other.type = kNil;
}
Variant& Variant::operator=(Variant&& other) {
  std::swap(type, other.type);
  std::swap(inside, other.inside);
  return *this;
}
Variant::~Variant() {
  if (is_text(type) || is_packed(type)) destructor(type)(inside);
}

std::int64_t Variant::whole() const {
  std::int64_t out;
  std::memcpy(&out, inside, sizeof out);
  return out;
}
double Variant::real() const {
  double out;
  std::memcpy(&out, inside, sizeof out);
  return out;
}
std::string Variant::text() const {
  return text_in(inside);
}
std::vector<std::string> Variant::texts() const {
  std::vector<std::string> out;
  const Array& array = array_in(inside);
  for (std::size_t i = 0; i < array.size(); i += sizeof(void*)) out.push_back(text_in(array.data() + i));
  return out;
}
std::vector<std::uint8_t> Variant::bytes() const {
  return array_in(inside);
}
std::vector<float> Variant::reals() const {
  std::vector<float> out(array_in(inside).size() / 4);
  if (!out.empty()) std::memcpy(out.data(), array_in(inside).data(), array_in(inside).size());
  return out;
}
std::vector<std::int32_t> Variant::ints() const {
  std::vector<std::int32_t> out(array_in(inside).size() / 4);
  if (!out.empty()) std::memcpy(out.data(), array_in(inside).data(), array_in(inside).size());
  return out;
}

}  // namespace mock
