// Holds platform/godot/4/gdextension.h against Godot's own gdextension_interface.h, of 4.1 or later. Compiles, or not.
#include <gdextension_interface.h>

#include <type_traits>

#include "../../../../platform/godot/4/gdextension.h"

using gdextension::Api;

template <typename A, typename B>
constexpr bool is_alike() {
  return std::is_void_v<A> == std::is_void_v<B> && std::is_pointer_v<A> == std::is_pointer_v<B> &&
         sizeof(std::conditional_t<std::is_void_v<A>, char, A>) ==
             sizeof(std::conditional_t<std::is_void_v<B>, char, B>);
}

// Whether two functions are called in the same way.
template <typename R, typename... A, typename S, typename... B>
constexpr bool are_alike(R (*)(A...), S (*)(B...)) {
  if constexpr (sizeof...(A) != sizeof...(B))
    return false;
  else
    return is_alike<R, S>() && (is_alike<A, B>() && ...);
}

#define SAME(ours, theirs) static_assert(are_alike(static_cast<ours>(nullptr), static_cast<theirs>(nullptr)), #ours)
#define FUNCTION(name, theirs) SAME(decltype(Api::name), GDExtensionInterface##theirs)
FUNCTION(variant_get_type, VariantGetType);
FUNCTION(get_variant_from_type_constructor, GetVariantFromTypeConstructor);
FUNCTION(get_variant_to_type_constructor, GetVariantToTypeConstructor);
FUNCTION(variant_get_ptr_constructor, VariantGetPtrConstructor);
FUNCTION(variant_get_ptr_destructor, VariantGetPtrDestructor);
FUNCTION(variant_get_ptr_builtin_method, VariantGetPtrBuiltinMethod);
FUNCTION(string_new_with_utf8_chars, StringNewWithUtf8Chars);
FUNCTION(string_to_utf8_chars, StringToUtf8Chars);
FUNCTION(packed_byte_array_operator_index, PackedByteArrayOperatorIndex);
FUNCTION(packed_byte_array_operator_index_const, PackedByteArrayOperatorIndexConst);
FUNCTION(packed_int32_array_operator_index, PackedInt32ArrayOperatorIndex);
FUNCTION(packed_float32_array_operator_index, PackedFloat32ArrayOperatorIndex);
FUNCTION(packed_string_array_operator_index, PackedStringArrayOperatorIndex);
FUNCTION(classdb_get_class_tag, ClassdbGetClassTag);
FUNCTION(classdb_get_method_bind, ClassdbGetMethodBind);
FUNCTION(classdb_construct_object, ClassdbConstructObject);
FUNCTION(classdb_register_extension_class, ClassdbRegisterExtensionClass);
FUNCTION(classdb_register_extension_class_method, ClassdbRegisterExtensionClassMethod);
FUNCTION(classdb_register_extension_class_property, ClassdbRegisterExtensionClassProperty);
FUNCTION(classdb_unregister_extension_class, ClassdbUnregisterExtensionClass);
FUNCTION(object_set_instance, ObjectSetInstance);
FUNCTION(object_cast_to, ObjectCastTo);
FUNCTION(object_method_bind_ptrcall, ObjectMethodBindPtrcall);
FUNCTION(print_error, PrintError);
SAME(gdextension::Constructor, GDExtensionPtrConstructor);
SAME(gdextension::Destructor, GDExtensionPtrDestructor);
SAME(gdextension::BuiltIn, GDExtensionPtrBuiltInMethod);
SAME(gdextension::FromValue, GDExtensionVariantFromTypeConstructorFunc);
SAME(gdextension::ToValue, GDExtensionTypeFromVariantConstructorFunc);
SAME(gdextension::GetFunction, GDExtensionInterfaceGetProcAddress);
SAME(decltype(gdextension::Class::create), GDExtensionClassCreateInstance);
SAME(decltype(gdextension::Class::free), GDExtensionClassFreeInstance);
SAME(decltype(gdextension::ClassMethod::call), GDExtensionClassMethodCall);
SAME(decltype(gdextension::ClassMethod::pointer_call), GDExtensionClassMethodPtrCall);

#define FIELD(ours, field, theirs, its)                                                                           \
  static_assert(                                                                                                  \
      offsetof(gdextension::ours, field) == offsetof(theirs, its) && sizeof(gdextension::ours) == sizeof(theirs), \
      #ours "::" #field)
FIELD(Initialization, minimum_level, GDExtensionInitialization, minimum_initialization_level);
FIELD(Initialization, userdata, GDExtensionInitialization, userdata);
FIELD(Initialization, initialize, GDExtensionInitialization, initialize);
FIELD(Initialization, deinitialize, GDExtensionInitialization, deinitialize);
FIELD(Property, type, GDExtensionPropertyInfo, type);
FIELD(Property, name, GDExtensionPropertyInfo, name);
FIELD(Property, class_name, GDExtensionPropertyInfo, class_name);
FIELD(Property, hint, GDExtensionPropertyInfo, hint);
FIELD(Property, hint_string, GDExtensionPropertyInfo, hint_string);
FIELD(Property, usage, GDExtensionPropertyInfo, usage);
FIELD(CallError, error, GDExtensionCallError, error);
FIELD(CallError, argument, GDExtensionCallError, argument);
FIELD(CallError, expected, GDExtensionCallError, expected);
FIELD(Class, is_virtual, GDExtensionClassCreationInfo, is_virtual);
FIELD(Class, is_abstract, GDExtensionClassCreationInfo, is_abstract);
FIELD(Class, set, GDExtensionClassCreationInfo, set_func);
FIELD(Class, notification, GDExtensionClassCreationInfo, notification_func);
FIELD(Class, create, GDExtensionClassCreationInfo, create_instance_func);
FIELD(Class, free, GDExtensionClassCreationInfo, free_instance_func);
FIELD(Class, userdata, GDExtensionClassCreationInfo, class_userdata);
FIELD(ClassMethod, name, GDExtensionClassMethodInfo, name);
FIELD(ClassMethod, userdata, GDExtensionClassMethodInfo, method_userdata);
FIELD(ClassMethod, call, GDExtensionClassMethodInfo, call_func);
FIELD(ClassMethod, pointer_call, GDExtensionClassMethodInfo, ptrcall_func);
FIELD(ClassMethod, flags, GDExtensionClassMethodInfo, method_flags);
FIELD(ClassMethod, has_result, GDExtensionClassMethodInfo, has_return_value);
FIELD(ClassMethod, result, GDExtensionClassMethodInfo, return_value_info);
FIELD(ClassMethod, result_metadata, GDExtensionClassMethodInfo, return_value_metadata);
FIELD(ClassMethod, argument_count, GDExtensionClassMethodInfo, argument_count);
FIELD(ClassMethod, arguments, GDExtensionClassMethodInfo, arguments_info);
FIELD(ClassMethod, argument_metadata, GDExtensionClassMethodInfo, arguments_metadata);
FIELD(ClassMethod, default_count, GDExtensionClassMethodInfo, default_argument_count);
FIELD(ClassMethod, defaults, GDExtensionClassMethodInfo, default_arguments);

#define VALUE(ours, theirs) static_assert(int(gdextension::ours) == int(GDEXTENSION_##theirs), #ours)
VALUE(kNil, VARIANT_TYPE_NIL);
VALUE(kBool, VARIANT_TYPE_BOOL);
VALUE(kInt, VARIANT_TYPE_INT);
VALUE(kFloat, VARIANT_TYPE_FLOAT);
VALUE(kString, VARIANT_TYPE_STRING);
VALUE(kStringName, VARIANT_TYPE_STRING_NAME);
VALUE(kObject, VARIANT_TYPE_OBJECT);
VALUE(kPackedBytes, VARIANT_TYPE_PACKED_BYTE_ARRAY);
VALUE(kPackedInts, VARIANT_TYPE_PACKED_INT32_ARRAY);
VALUE(kPackedFloats, VARIANT_TYPE_PACKED_FLOAT32_ARRAY);
VALUE(kPackedStrings, VARIANT_TYPE_PACKED_STRING_ARRAY);
VALUE(kInvalidArgument, CALL_ERROR_INVALID_ARGUMENT);
VALUE(kTooMany, CALL_ERROR_TOO_MANY_ARGUMENTS);
VALUE(kTooFew, CALL_ERROR_TOO_FEW_ARGUMENTS);
static_assert(GDEXTENSION_INITIALIZATION_SCENE == 2 && GDEXTENSION_METHOD_FLAG_NORMAL == 1 &&
              GDEXTENSION_METHOD_ARGUMENT_METADATA_NONE == 0);
