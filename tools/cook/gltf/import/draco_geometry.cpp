// Decodes KHR_draco_mesh_compression.
#include "cook/gltf/import/import_vertices.h"

#include <cstring>
#include <functional>
#include <stdexcept>

#include <draco/attributes/attribute_octahedron_transform.h>
#include <draco/attributes/attribute_quantization_transform.h>
#include <draco/compression/attributes/normal_compression_utils.h>
#include <draco/compression/decode.h>
#include <draco/core/quantization_utils.h>
#include <draco/mesh/mesh.h>

#include "common/retold.h"
#include "draco/counts.h"

namespace marrow::cook::gltf {
namespace {

template <class T>
double load(const std::uint8_t* from) {
  T value;
  std::memcpy(&value, from, sizeof value);
  return static_cast<double>(value);
}

double load_component(const std::uint8_t* from, draco::DataType type) {
  switch (type) {
    case draco::DT_INT8:
      return load<std::int8_t>(from);
    case draco::DT_UINT8:
      return load<std::uint8_t>(from);
    case draco::DT_INT16:
      return load<std::int16_t>(from);
    case draco::DT_UINT16:
      return load<std::uint16_t>(from);
    case draco::DT_INT32:
      return load<std::int32_t>(from);
    case draco::DT_UINT32:
      return load<std::uint32_t>(from);
    case draco::DT_FLOAT32:
      return load<float>(from);
    default:
      break;
  }
  return 0;
}

bool is_readable(draco::DataType type) {
  switch (type) {
    case draco::DT_INT8:
    case draco::DT_UINT8:
    case draco::DT_INT16:
    case draco::DT_UINT16:
    case draco::DT_INT32:
    case draco::DT_UINT32:
    case draco::DT_FLOAT32:
      return true;
    default:
      return false;
  }
}

void refuse_bombs(std::span<const std::byte> bytes, const DracoGeometry::Promise& promise, const std::string& where,
                  const Report& report) {
  DracoCounts claimed;
  const Status status = draco_counts({bytes.data(), bytes.size()}, claimed);
  if (status == Status::unsupported)
    report.unsupported(where, "Draco bitstream", "only version 2.2, which glTF names, is read; export again");
  if (status != Status::ok)
    report.invalid(where, "damaged Draco data", std::string(to_string(status)) + "; export again");
  if (claimed.points <= promise.points && claimed.faces <= promise.most_faces) return;
  report.invalid(where, "differs from the accessors in count",
                 "Draco data claims " + std::to_string(claimed.points) + " points and " +
                     std::to_string(claimed.faces) + " triangles; export again");
}

std::unique_ptr<draco::Mesh> decode(std::span<const std::byte> bytes, const std::string& where, const Report& report) {
  const auto refuse = [&](const std::string& why) {
    report.invalid(where, "damaged Draco data", why + "; export again");
  };
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const auto type = draco::Decoder::GetEncodedGeometryType(&buffer);
  if (!type.ok()) refuse(type.status().error_msg());
  if (type.value() != draco::TRIANGULAR_MESH) refuse("it is not a triangle mesh");
  const auto decode_mesh = [&]() -> std::unique_ptr<draco::Mesh> {
    draco::Decoder decoder;
    for (const auto kind :
         {draco::GeometryAttribute::POSITION, draco::GeometryAttribute::NORMAL, draco::GeometryAttribute::COLOR,
          draco::GeometryAttribute::TEX_COORD, draco::GeometryAttribute::GENERIC})
      decoder.SetSkipAttributeTransform(kind);  // restore() does it
    auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
    if (!decoded.ok()) refuse(decoded.status().error_msg());
    return std::move(decoded).value();
  };
  std::unique_ptr<draco::Mesh> mesh =
      tools::retold<std::length_error>(decode_mesh, [&](const std::length_error&) -> tools::Failure {
        report.invalid(where, "damaged Draco data", "it claims more than memory holds; export again");
      });
  if (!mesh) refuse("nothing in it");
  return mesh;
}

// Turns a point's numbers, as they are stored, into floats and appends them.
using Restore = std::function<void(const std::vector<double>& stored, std::vector<float>& to)>;

// Integers are of the accessor's type, whatever Draco has made of it on its way.
Restore restore_plain(draco::DataType type, const Accessor& accessor) {
  const bool normalised = accessor.normalised && type != draco::DT_FLOAT32;
  return [normalised, component = accessor.component](const std::vector<double>& stored, std::vector<float>& to) {
    for (const double number : stored)
      to.push_back(static_cast<float>(normalised ? normalise(number, component) : number));
  };
}

// Evenly spaced from the least value on.
Restore restore_quantised(const draco::PointAttribute& attribute) {
  draco::AttributeQuantizationTransform transform;
  if (!transform.InitFromAttribute(attribute)) return nullptr;
  const int bits = transform.quantization_bits();
  draco::Dequantizer steps;
  if (bits < 1 || bits > 30 || !steps.Init(transform.range(), (1 << bits) - 1)) return nullptr;
  return [steps, least = transform.min_values()](const std::vector<double>& stored, std::vector<float>& to) {
    for (std::size_t c = 0; c < stored.size(); ++c)
      to.push_back(steps.DequantizeFloat(static_cast<std::int32_t>(stored[c])) + least[c]);
  };
}

// Unit vectors as places on an unfolded octahedron.
Restore restore_directions(const draco::PointAttribute& attribute) {
  draco::AttributeOctahedronTransform transform;
  draco::OctahedronToolBox octahedron;
  if (!transform.InitFromAttribute(attribute) || attribute.num_components() != 2 ||
      !octahedron.SetQuantizationBits(transform.quantization_bits()))
    return nullptr;
  return [octahedron](const std::vector<double>& stored, std::vector<float>& to) {
    float direction[3];
    octahedron.QuantizedOctahedralCoordsToUnitVector(static_cast<std::int32_t>(stored[0]),
                                                     static_cast<std::int32_t>(stored[1]), direction);
    to.insert(to.end(), direction, direction + 3);
  };
}

// Draco's library would restore floats as well, but compiled with contracted products for some processors, whose last
// bits differ. Its headers' functions are compiled with ours, without. None if the quantisation cannot be.
Restore restore_of(const draco::PointAttribute& attribute, const Accessor& accessor) {
  const draco::AttributeTransformData* transform = attribute.GetAttributeTransformData();
  const draco::AttributeTransformType type =
      transform == nullptr ? draco::ATTRIBUTE_NO_TRANSFORM : transform->transform_type();
  if (type == draco::ATTRIBUTE_NO_TRANSFORM) return restore_plain(attribute.data_type(), accessor);
  if (attribute.data_type() != draco::DT_INT32) return nullptr;
  if (type == draco::ATTRIBUTE_QUANTIZATION_TRANSFORM) return restore_quantised(attribute);
  if (type == draco::ATTRIBUTE_OCTAHEDRON_TRANSFORM) return restore_directions(attribute);
  return nullptr;
}

}  // namespace

DracoGeometry::DracoGeometry(std::span<const std::byte> bytes, const Promise& promise, const std::string& where,
                             const Report& report)
    : report_(report) {
  refuse_bombs(bytes, promise, where, report);
  mesh_ = decode(bytes, where, report);
  if (mesh_->num_points() != promise.points) {
    report.invalid(where, "differs from the accessors in count",
                   std::to_string(mesh_->num_points()) + " points where " + std::to_string(promise.points) +
                       " are promised; export again");
  }
  for (draco::FaceIndex face(0); face < mesh_->num_faces(); ++face) {
    for (const draco::PointIndex& point : mesh_->face(face)) {
      if (point.value() >= mesh_->num_points())
        report.invalid(where, "damaged Draco data", "a triangle has no such point");
    }
  }
}

DracoGeometry::~DracoGeometry() = default;

std::vector<std::uint32_t> DracoGeometry::indices() const {
  std::vector<std::uint32_t> indices;
  indices.reserve(std::size_t{mesh_->num_faces()} * 3);
  for (draco::FaceIndex face(0); face < mesh_->num_faces(); ++face) {
    for (const draco::PointIndex& point : mesh_->face(face)) indices.push_back(point.value());
  }
  return indices;
}

std::vector<float> DracoGeometry::attribute(std::uint32_t unique_id, const Accessor& accessor,
                                            const std::string& where) const {
  const draco::PointAttribute* attribute = mesh_->GetAttributeByUniqueId(unique_id);
  const auto refuse = [&](const char* why) {
    report_.invalid(where, "wrong Draco attribute", std::string(why) + "; export again");
  };
  if (attribute == nullptr) refuse("the data has no attribute of this id");
  const draco::DataType type = attribute->data_type();
  if (!is_readable(type)) refuse("its data type is not glTF's");
  const auto stored = static_cast<std::size_t>(attribute->num_components());
  const auto size = static_cast<std::size_t>(draco::DataTypeLength(type));
  const std::uint32_t points = mesh_->num_points();
  if (!attribute->is_mapping_identity() && attribute->indices_map_size() < points) refuse("points are without a value");
  const Restore restore = restore_of(*attribute, accessor);
  if (!restore) refuse("its quantisation is none");
  const std::size_t components = accessor.components();
  std::vector<float> values;
  values.reserve(points * components);
  std::vector<double> numbers(stored);
  for (draco::PointIndex point(0); point < points; ++point) {
    const draco::AttributeValueIndex entry = attribute->mapped_index(point);
    if (entry.value() >= attribute->size() ||
        !attribute->IsAddressValid(attribute->GetAddress(entry) + size * stored - 1)) {
      refuse("a point refers to a value that is not there");
    }
    const std::uint8_t* from = attribute->GetAddress(entry);
    for (std::size_t c = 0; c < stored; ++c) numbers[c] = load_component(from + c * size, type);
    restore(numbers, values);
    if (values.size() != (point.value() + std::size_t{1}) * components) refuse("the number of components differs");
  }
  return values;
}

}  // namespace marrow::cook::gltf
