#include "cook/options/option_lists.h"

#include <charconv>

#include "marrow/file.h"
#include "text/number.h"

namespace marrow::cook {
namespace {

constexpr Named<MeshCodec> kMeshCodecs[] = {{"draco", MeshCodec::draco},
                                            {"draco-smallest", MeshCodec::draco_smallest},
                                            {"meshopt", MeshCodec::meshopt},
                                            {"none", MeshCodec::none}};
constexpr Named<int> kSubdivisions[] = {{"0", 0}, {"1", 1}, {"2", 2}, {"3", 3}};

void set_position_error(CookOptions& options, const Value& given) {
  Amount amount;
  if (!read_amount(given.text, amount))
    refuse(given, "\"" + given.text + "\" is not an error",
           "give a length or a share of the mesh's longest side, as in 0.1mm, 0.0001m or 0.01%");
  options.mesh.position_error = amount.value;
  options.mesh.position_error_is_share = amount.is_share;
}

// "RATIO[:INFLUENCES]", ever coarser, between commas.
void set_lod(CookOptions& options, const Value& given) {
  options.mesh.lod.clear();
  const char* at = given.text.data();
  const char* const end = at + given.text.size();
  for (bool good = true; good;) {
    LodRule rule;
    auto read = tools::read_double(at, end, rule.ratio);
    good = read.ec == std::errc() && rule.ratio > 0 &&
           rule.ratio < (options.mesh.lod.empty() ? 1 : options.mesh.lod.back().ratio);
    if (good && read.ptr != end && *read.ptr == ':') {
      read = std::from_chars(read.ptr + 1, end, rule.influences);
      good = read.ec == std::errc() && rule.influences >= 1 && rule.influences <= kMaxInfluences;
    }
    good = good && options.mesh.lod.size() < kMostLods;
    if (good) options.mesh.lod.push_back(rule);
    if (good && read.ptr == end) return;
    good = good && *read.ptr == ',';
    at = read.ptr + 1;
  }
  refuse(
      given, "\"" + given.text + "\" are no levels of detail",
      "give up to 15 shares of the triangles below 1, descending, each with an influence count from 1 to 8 or without, "
      "as in 0.5,0.25:2");
}

// At least what a triangle can follow.
void set_palette(CookOptions& options, const Value& given) {
  options.mesh.most_entries = static_cast<std::size_t>(whole_number(given, 3 * kMaxInfluences, kMaxJoints));
}

constexpr Option kPrecisionOptions[] = {
    {"mesh-codec", OptionKind::text, "TEXT",
     "draco: small, and as fast to unpack as Draco can be; draco-smallest: some 2 to 7 % smaller, a third slower; "
     "either "
     "is meshopt for a mesh with a hundred morph targets or so, which are too many for Draco; meshopt: the fastest to "
     "unpack; none: the file is not packed, floats and clips are as they will be in memory",
     names_in<kMeshCodecs>, [](CookOptions& o, const Value& v) { o.mesh.codec = *value_of(kMeshCodecs, v.text); }},
    {"position-error",
     OptionKind::text,
     "E",
     "how far quantisation may move vertices, in the scene at rest: 0.1mm, 0.0001m or 0.01% of the mesh's longest "
     "side; the default is 14 "
     "bits on the longest side, 0.0053%",
     {},
     set_position_error},
    {"normal-error",
     OptionKind::text,
     "DEGREES",
     "how far it may turn normals and tangents; the default is 0.2",
     {},
     [](CookOptions& o, const Value& v) { o.mesh.precision.normal_error_deg = number_between(v, 0.002, 45); }},
    {"uv-error",
     OptionKind::text,
     "SHARE",
     "how far it may move UVs, in widths of the texture; the default is 0.000122",
     {},
     [](CookOptions& o, const Value& v) { o.mesh.precision.uv_error = number_between(v, 1e-7, 1); }},
    {"weight-error",
     OptionKind::text,
     "SHARE",
     "how far it may change weights; the default is 0.00025",
     {},
     [](CookOptions& o, const Value& v) { o.mesh.precision.weight_error = number_between(v, 2e-5, 0.5); }},
};

constexpr Option kMeshOptions[] = {
    {"subdivide", OptionKind::text, "N",
     "four times the triangles, N times, by Loop's scheme, which rounds the mesh off; what `skin_as` deforms by is "
     "exactly the posed mesh subdivided where --as learns it (docs/deformers.md); 0: none",
     names_in<kSubdivisions>,
     [](CookOptions& o, const Value& v) { o.mesh.subdivide = *value_of(kSubdivisions, v.text); }},
    {"lod",
     OptionKind::text,
     "R[:N][,R[:N]...]",
     "levels of detail with these shares of the triangles, descending, as 0.5,0.25; with :N at most so many "
     "influences a vertex",
     {},
     set_lod},
    {"palette",
     OptionKind::text,
     "ENTRIES",
     "joints and helpers that a mesh may have, 24 to 32767; what has more is split into several meshes; the "
     "default, 341, is what the GPU paths take",
     {},
     set_palette},
};

}  // namespace

std::span<const Option> precision_options() {
  return kPrecisionOptions;
}

std::span<const Option> mesh_options() {
  return kMeshOptions;
}

}  // namespace marrow::cook
