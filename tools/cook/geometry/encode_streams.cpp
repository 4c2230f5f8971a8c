#include "cook/geometry/encode_streams.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>
#include <unordered_map>

#include <draco/compression/config/compression_shared.h>
#include <draco/compression/expert_encode.h>
#include <draco/mesh/mesh.h>
#include <meshoptimizer.h>

#include "common/failure.h"
#include "cook/geometry/record.h"
#include "draco/decode_skin.h"
#include "draco/skin_codec.h"
#include "marrow/draco.h"
#include "marrow/meshopt.h"
#include "unpack/arrange.h"
#include "unpack/octahedron.h"

namespace marrow::cook {
namespace {

OwnedStreams without_skin(const OwnedStreams& streams) {
  OwnedStreams out = streams;
  out.drop([](const Stream& stream, const auto&) { return is_skin(stream.kind); });
  return out;
}

// How one attempt encodes.
struct Settings {
  bool edgebreaker = true;  // else triangles one by one, which keeps any
  int speed = 0;
  struct OfStream {
    int prediction;  // kOwnChoice: Draco decides
    bool as_normal;  // of directions: Draco knows that they are unit vectors
  };
  std::vector<OfStream> streams;
};
constexpr int kOwnChoice = -100;
// At this speed each number is predicted by one triangle. Below, by several or along better ways, which takes twice as
// long to decode.
constexpr int kOneParallelogram = 2;
// What a slower prediction must save, of all bytes.
constexpr double kWorthwhile = 0.04;

draco::GeometryAttribute::Type attribute_type(StreamKind kind) {
  switch (kind) {
    case StreamKind::position:
      return draco::GeometryAttribute::POSITION;
    case StreamKind::normal:
    case StreamKind::tangent:
      return draco::GeometryAttribute::NORMAL;
    case StreamKind::uv:
      return draco::GeometryAttribute::TEX_COORD;
    case StreamKind::colour:
      return draco::GeometryAttribute::COLOR;
    default:
      return draco::GeometryAttribute::GENERIC;
  }
}

bool is_direction(StreamKind kind) {
  return kind == StreamKind::normal || kind == StreamKind::tangent;
}

// Directions may go in as unit vectors, which Draco predicts on the sphere; rounding them again gives the same points.
// Else they are two numbers like others.
void add_attribute(const Stream& s, const std::vector<std::int32_t>& values, bool as_normal, draco::Mesh& mesh) {
  const std::uint32_t count = mesh.num_points();
  draco::GeometryAttribute description;
  const bool floats = is_direction(s.kind) && as_normal;
  const std::uint32_t components = floats ? 3 : s.components;
  description.Init(is_direction(s.kind) && !as_normal ? draco::GeometryAttribute::GENERIC : attribute_type(s.kind),
                   nullptr, static_cast<std::uint8_t>(components), floats ? draco::DT_FLOAT32 : draco::DT_INT32, false,
                   4 * std::int64_t{components}, 0);
  draco::PointAttribute& attribute = *mesh.attribute(mesh.AddAttribute(description, true, count));
  for (std::uint32_t v = 0; v < count; ++v) {
    const std::int32_t* const from = &values[std::size_t{v} * s.components];
    float unit[3];
    if (floats) from_octahedron(from[0], from[1], s.bits, unit);
    attribute.SetAttributeValue(draco::AttributeValueIndex(v),
                                floats ? static_cast<const void*>(unit) : static_cast<const void*>(from));
  }
}

void fill_mesh(const OwnedStreams& s, const Settings& settings, bool merge_positions, draco::Mesh& mesh) {
  mesh.set_num_points(s.mesh.vertex_count);
  mesh.SetNumFaces(s.indices.size() / 3);
  for (std::uint32_t f = 0; f < s.indices.size() / 3; ++f) {
    const std::uint32_t* const t = &s.indices[std::size_t{f} * 3];
    mesh.SetFace(draco::FaceIndex(f), {draco::PointIndex(t[0]), draco::PointIndex(t[1]), draco::PointIndex(t[2])});
  }
  for (std::size_t i = 0; i < s.streams.size(); ++i)
    add_attribute(s.streams[i], s.values[i], settings.streams[i].as_normal, mesh);
  for (int i = 0; i < mesh.num_attributes(); ++i)
    if (merge_positions || i > 0) mesh.attribute(i)->DeduplicateValues(*mesh.attribute(i));
}

// What an attempt has come to. Points may be more than vertices where the surface is no manifold.
struct Encoded {
  std::vector<std::byte> bytes;  // empty: it failed
  std::uint32_t points = 0;
  std::uint32_t faces = 0;
};

Encoded encode(const OwnedStreams& s, bool merge_positions, const Settings& settings) {
  draco::Mesh mesh;
  fill_mesh(s, settings, merge_positions, mesh);
  draco::ExpertEncoder encoder(mesh);
  encoder.SetEncodingMethod(settings.edgebreaker ? draco::MESH_EDGEBREAKER_ENCODING : draco::MESH_SEQUENTIAL_ENCODING);
  encoder.SetSpeedOptions(settings.speed, settings.speed);
  encoder.SetTrackEncodedProperties(true);
  for (std::size_t i = 0; i < s.streams.size(); ++i) {
    const int id = static_cast<int>(i);
    const auto [prediction, as_normal] = settings.streams[i];
    if (is_direction(s.streams[i].kind) && as_normal) encoder.SetAttributeQuantization(id, s.streams[i].bits);
    if (prediction != kOwnChoice) static_cast<void>(encoder.SetAttributePredictionScheme(id, prediction));
  }
  draco::EncoderBuffer buffer;
  if (!encoder.EncodeToBuffer(&buffer).ok()) return {};
  const auto* const first = reinterpret_cast<const std::byte*>(buffer.data());
  return {{first, first + buffer.size()},
          static_cast<std::uint32_t>(encoder.num_encoded_points()),
          static_cast<std::uint32_t>(encoder.num_encoded_faces())};
}

// Another way to code a stream.
struct Alternative {
  Settings::OfStream settings;
  bool is_slow = false;  // to decode
};

// Ways that may beat others.
std::vector<Alternative> alternatives(StreamKind kind) {
  constexpr Settings::OfStream kDifference = {draco::PREDICTION_DIFFERENCE, false},
                               kParallelogram = {draco::MESH_PREDICTION_PARALLELOGRAM, false},
                               kOnSphere = {draco::PREDICTION_DIFFERENCE, true};
  switch (kind) {
    case StreamKind::normal:
      return {{kDifference}, {kOnSphere}, {{draco::MESH_PREDICTION_GEOMETRIC_NORMAL, true}, true}};
    case StreamKind::tangent:
      return {{kDifference}, {kOnSphere}};
    case StreamKind::uv:
      return {{kParallelogram}, {{draco::MESH_PREDICTION_TEX_COORDS_PORTABLE, false}, true}};
    case StreamKind::joints:  // unless they are apart
    case StreamKind::weights:
    case StreamKind::colour:
    case StreamKind::tangent_sign:
      return {{kDifference}, {kParallelogram}};
    case StreamKind::residual:
      return {{kDifference}, {kParallelogram}, {{draco::PREDICTION_NONE, false}}};
    default:
      return {};
  }
}

// What is tried first: quick to decode, or what Draco takes for the smallest.
Settings first_settings(const OwnedStreams& s, DracoAim aim) {
  Settings out;
  out.speed = aim == DracoAim::smallest ? 0 : kOneParallelogram;
  for (const Stream& stream : s.streams) {
    const bool differs = stream.kind == StreamKind::tangent || (aim == DracoAim::quick && is_direction(stream.kind));
    const bool parallelogram = aim == DracoAim::quick && stream.kind == StreamKind::uv;
    out.streams.push_back({differs         ? draco::PREDICTION_DIFFERENCE
                           : parallelogram ? draco::MESH_PREDICTION_PARALLELOGRAM
                                           : kOwnChoice,
                           aim == DracoAim::smallest});
  }
  return out;
}

// Streams are coded apart, so the best way for each can be looked for one at a time.
Encoded best(const OwnedStreams& s, DracoAim aim, bool merge_positions) {
  Settings best = first_settings(s, aim);
  Encoded encoded = encode(s, merge_positions, best);
  const auto attempt = [&](const Settings& settings, double saves) {
    Encoded other = encode(s, merge_positions, settings);
    const double most = (1 - saves) * static_cast<double>(encoded.bytes.size());
    if (other.bytes.empty() || (!encoded.bytes.empty() && static_cast<double>(other.bytes.size()) >= most)) return;
    encoded = std::move(other);
    best = settings;
  };
  if (aim == DracoAim::smallest)
    for (const int speed : {1, kOneParallelogram}) {
      Settings settings = best;
      settings.speed = speed;
      attempt(settings, 0);
    }
  for (std::size_t i = 0; i < s.streams.size(); ++i) {
    for (const Alternative& alternative : alternatives(s.streams[i].kind)) {
      Settings settings = best;
      settings.streams[i] = alternative.settings;
      attempt(settings, aim == DracoAim::quick && alternative.is_slow ? kWorthwhile : 0);
    }
  }
  return encoded;
}

// The search for the smallest begins elsewhere and may end in a larger one than the other.
Encoded edgebreaker(const OwnedStreams& s, DracoAim aim, bool merge_positions) {
  Encoded out = best(s, DracoAim::quick, merge_positions);
  if (aim == DracoAim::quick) return out;
  Encoded other = best(s, aim, merge_positions);
  const bool is_smaller = out.bytes.empty() || other.bytes.size() < out.bytes.size();
  return !other.bytes.empty() && is_smaller ? other : out;
}

Encoded one_by_one(const OwnedStreams& s) {
  Settings settings = first_settings(s, DracoAim::smallest);
  settings.edgebreaker = false;
  for (Settings::OfStream& stream : settings.streams) stream.prediction = kOwnChoice;
  return encode(s, false, settings);
}

// A triangle by what its corners hold, beginning at the least: a hash of all of a vertex's numbers each.
using Triangle = std::array<std::uint64_t, 3>;

std::uint64_t corner(const OwnedStreams& s, std::uint32_t vertex) {
  std::uint64_t hash = 0xcbf29ce484222325;  // FNV-1a, by words
  for (std::size_t i = 0; i < s.streams.size(); ++i) {
    const std::size_t components = s.streams[i].components;
    for (std::size_t c = 0; c < components; ++c) {
      hash = (hash ^ static_cast<std::uint32_t>(s.values[i][vertex * components + c])) * 0x100000001b3;
      hash ^= hash >> 29;
    }
  }
  return hash;
}

std::vector<Triangle> surface(const OwnedStreams& s) {
  std::vector<Triangle> out;
  for (std::size_t i = 0; i + 2 < s.indices.size(); i += 3) {
    Triangle t{corner(s, s.indices[i]), corner(s, s.indices[i + 1]), corner(s, s.indices[i + 2])};
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    out.push_back(t);
  }
  std::sort(out.begin(), out.end());
  return out;
}

// What the runtime will decode, and whether that is the same surface.
bool decodes_to_the_same(const Encoded& encoded, const OwnedStreams& s, OwnedStreams& decoded) {
  if (encoded.faces != s.indices.size() / 3) return false;
  decoded = s;
  decoded.mesh.vertex_count = encoded.points;
  for (std::size_t i = 0; i < s.streams.size(); ++i)
    decoded.values[i].resize(std::size_t{encoded.points} * s.streams[i].components);
  std::vector<std::byte> bytes = {std::byte{0}};  // of a skin apart
  bytes.insert(bytes.end(), encoded.bytes.begin(), encoded.bytes.end());
  return draco_decoder().decode({bytes.data(), bytes.size()}, decoded.view()) == Status::ok &&
         surface(decoded) == surface(s);
}

// For each vertex of `s` one of `decoded` that holds the same.
void follow(const OwnedStreams& s, OwnedStreams& decoded) {
  std::unordered_map<std::uint64_t, std::uint32_t> place;
  for (std::uint32_t v = 0; v < decoded.mesh.vertex_count; ++v) place.emplace(corner(decoded, v), v);
  for (std::uint32_t& vertex : decoded.source_map)
    if (vertex != kNoSlot) vertex = place.at(corner(s, vertex));
}

std::vector<std::byte> encode_surface(OwnedStreams& streams, DracoAim aim) {
  // Triangles between vertices at one place that move apart are lost where places are merged, and those that never have
  // an area in either case.
  for (int attempt = 0; attempt < 3; ++attempt) {
    const Encoded encoded = attempt < 2 ? edgebreaker(streams, aim, attempt == 0) : one_by_one(streams);
    OwnedStreams decoded;
    if (encoded.bytes.empty() || !decodes_to_the_same(encoded, streams, decoded)) continue;
    follow(streams, decoded);
    streams = std::move(decoded);
    return encoded.bytes;
  }
  throw tools::Failure(tools::Exit::internal, "", "", "draco-mesh-differs",
                       "the encoded mesh does not decode to the same surface; use --mesh-codec meshopt");
}

// Vertices in the order in which the runtime will store them: those with the same joints follow each other.
void arrange_vertices(OwnedStreams& s) {
  const MeshStreams view = s.view();
  std::vector<std::byte> memory(arrange_scratch_bytes(view.vertex_count));
  Memory scratch{memory.data(), 0, memory.size()};
  Arrangement a;
  if (!arrange(view, scratch, a)) throw tools::Failure(tools::Exit::internal, "", "", "arrange", "not enough memory");
  std::vector<std::uint32_t> place(view.vertex_count);
  for (std::uint32_t i = 0; i < view.vertex_count; ++i) place[a.order[i]] = i;
  for (std::size_t i = 0; i < s.streams.size(); ++i)
    s.values[i] = numbers_of(s.streams[i], s.values[i], view.vertex_count, [&](std::size_t v) { return a.order[v]; });
  for (std::uint32_t& index : s.indices) index = place[index];
  for (std::uint32_t& vertex : s.source_map)
    if (vertex != kNoSlot) vertex = place[vertex];
}

template <class Number>
std::vector<unsigned char> narrowed(const Stream& s, const std::vector<std::int32_t>& values, std::size_t stride) {
  std::vector<unsigned char> out(values.size() / s.components * stride);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Number number = static_cast<Number>(values[i]);
    std::memcpy(&out[i / s.components * stride + i % s.components * sizeof number], &number, sizeof number);
  }
  return out;
}

void add_part(const std::vector<unsigned char>& part, std::vector<std::byte>& out) {
  add_varint(static_cast<std::uint32_t>(part.size()), out);
  for (const unsigned char byte : part) out.push_back(std::byte{byte});
}

}  // namespace

std::optional<SkinApart> SkinApart::take(OwnedStreams& streams) {
  if (!has_skin_for_bits(streams.view())) return {};
  OwnedStreams bare = without_skin(streams);
  if (places_of(Rows(bare), Rows(streams), streams.mesh.vertex_count).empty()) return {};
  SkinApart out;
  out.before_ = std::move(streams);
  streams = std::move(bare);
  return out;
}

std::vector<std::byte> SkinApart::give_back(OwnedStreams& streams) const {
  const Rows old_rows(without_skin(before_)), rows(streams);
  const RowPlaces places = places_of(old_rows, old_rows, before_.mesh.vertex_count);
  for (std::size_t i = 0; i < before_.streams.size(); ++i) {
    const Stream& stream = before_.streams[i];
    if (!is_skin(stream.kind)) continue;
    const auto at = static_cast<std::ptrdiff_t>(i);
    streams.streams.insert(streams.streams.begin() + at, stream);
    streams.values.insert(streams.values.begin() + at,
                          numbers_of(stream, before_.values[i], streams.mesh.vertex_count,
                                     [&](std::size_t v) { return places.at(rows.of(v)); }));
  }
  const MeshStreams mesh = streams.view();
  const SkinBefore before(mesh);
  const auto models = std::make_unique<SkinModels>();
  models->begin();
  SymbolEncoder encoder;
  SkinCodec<SymbolEncoder> codec(mesh, before, *models, encoder);
  for (std::uint32_t v = 0; v < mesh.vertex_count; ++v)
    if (!codec.code(v)) throw tools::Failure(tools::Exit::internal, "", "", "packed-geometry", "a skin that is none");
  return encoder.finish();
}

std::vector<std::byte> encode_draco(OwnedStreams& streams, DracoAim aim) {
  const std::optional<SkinApart> skin = SkinApart::take(streams);
  const std::vector<std::byte> surface = encode_surface(streams, aim);
  const std::vector<std::byte> bits = skin ? skin->give_back(streams) : std::vector<std::byte>();
  std::vector<std::byte> out;
  add_varint(static_cast<std::uint32_t>(bits.size()), out);
  out.insert(out.end(), bits.begin(), bits.end());
  out.insert(out.end(), surface.begin(), surface.end());
  return out;
}

std::vector<std::byte> encode_meshopt(OwnedStreams& s) {
  arrange_vertices(s);
  const std::uint32_t vertices = s.mesh.vertex_count;
  meshopt_encodeIndexVersion(1);
  meshopt_encodeVertexVersion(0);
  std::vector<std::byte> out;
  std::vector<unsigned char> part(meshopt_encodeIndexBufferBound(s.indices.size(), vertices));
  part.resize(meshopt_encodeIndexBuffer(part.data(), part.size(), s.indices.data(), s.indices.size()));
  add_part(part, out);
  // The index codec may turn triangles round; what the runtime decodes is what counts.
  meshopt_decodeIndexBuffer(s.indices.data(), s.indices.size(), sizeof(std::uint32_t), part.data(), part.size());
  for (std::size_t i = 0; i < s.streams.size(); ++i) {
    const Stream& stream = s.streams[i];
    const std::size_t number_bytes = stream.bits <= 8 ? 1 : stream.bits <= 16 ? 2 : 4;
    const std::size_t stride = (stream.components * number_bytes + 3) / 4 * 4;
    const std::vector<unsigned char> numbers = number_bytes == 1 ? narrowed<std::uint8_t>(stream, s.values[i], stride)
                                               : number_bytes == 2
                                                   ? narrowed<std::uint16_t>(stream, s.values[i], stride)
                                                   : narrowed<std::int32_t>(stream, s.values[i], stride);
    part.resize(meshopt_encodeVertexBufferBound(vertices, stride));
    part.resize(meshopt_encodeVertexBuffer(part.data(), part.size(), numbers.data(), vertices, stride));
    add_part(part, out);
  }
  OwnedStreams decoded = s;
  for (auto& values : decoded.values) std::fill(values.begin(), values.end(), 0);
  if (meshopt_decoder().decode({out.data(), out.size()}, decoded.view()) != Status::ok || s.values != decoded.values)
    throw tools::Failure(tools::Exit::internal, "", "", "meshopt-mesh-differs",
                         "the encoded mesh does not decode to itself");
  return out;
}
}  // namespace marrow::cook
