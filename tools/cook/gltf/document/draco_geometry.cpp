// Decodes KHR_draco_mesh_compression.
#include "cook/gltf/document/draco_geometry.h"

#include <cstring>
#include <exception>

#include <draco/compression/decode.h>
#include <draco/mesh/mesh.h>

#include "cook/gltf/document/accessor.h"
#include "draco/counts.h"

namespace marrow::cook::gltf {
namespace {

// Draco's integer types as glTF's, for normalising.
Component component_of(draco::DataType type) {
  switch (type) {
    case draco::DT_INT8:
      return Component::i8;
    case draco::DT_UINT8:
      return Component::u8;
    case draco::DT_INT16:
      return Component::i16;
    case draco::DT_UINT16:
      return Component::u16;
    case draco::DT_UINT32:
      return Component::u32;
    default:
      break;
  }
  return Component::f32;
}

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
  std::unique_ptr<draco::Mesh> mesh;
  try {
    draco::Decoder decoder;
    auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
    if (!decoded.ok()) refuse(decoded.status().error_msg());
    mesh = std::move(decoded).value();
  } catch (const std::length_error&) {
    refuse("it claims more than memory holds");
  }
  if (!mesh) refuse("nothing in it");
  return mesh;
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

std::vector<float> DracoGeometry::attribute(std::uint32_t unique_id, std::size_t components, bool normalised,
                                            const std::string& where) const {
  const draco::PointAttribute* attribute = mesh_->GetAttributeByUniqueId(unique_id);
  const auto refuse = [&](const char* why) {
    report_.invalid(where, "wrong Draco attribute", std::string(why) + "; export again");
  };
  if (attribute == nullptr) refuse("the data has no attribute of this id");
  if (static_cast<std::size_t>(attribute->num_components()) != components) refuse("the number of components differs");
  const draco::DataType type = attribute->data_type();
  if (!is_readable(type)) refuse("its data type is not glTF's");
  const auto size = static_cast<std::size_t>(draco::DataTypeLength(type));
  const bool mapped_one_to_one = attribute->is_mapping_identity();
  const std::uint32_t points = mesh_->num_points();
  if (!mapped_one_to_one && attribute->indices_map_size() < points) refuse("points are without a value");
  std::vector<float> values;
  values.reserve(points * components);
  for (draco::PointIndex point(0); point < points; ++point) {
    const draco::AttributeValueIndex entry = attribute->mapped_index(point);
    if (entry.value() >= attribute->size() ||
        !attribute->IsAddressValid(attribute->GetAddress(entry) + size * components - 1)) {
      refuse("a point refers to a value that is not there");
    }
    const std::uint8_t* from = attribute->GetAddress(entry);
    for (std::size_t c = 0; c < components; ++c) {
      const double raw = load_component(from + c * size, type);
      values.push_back(static_cast<float>(normalised ? normalise(raw, component_of(type)) : raw));
    }
  }
  return values;
}

}  // namespace marrow::cook::gltf
