// docs/format.md has the tables of sections that their descriptions (asset/sections) make.
#include <fstream>
#include <iterator>
#include <string>
#include <type_traits>

#include <gtest/gtest.h>

#include "asset/format.h"
#include "asset/sections/examples_section.h"
#include "graph/graph_section.h"
#include "support/places.h"

namespace marrow {
namespace {

using format::Field;

template <class T>
std::string type_of() {
  if constexpr (std::is_array_v<T>) {
    return type_of<std::remove_all_extents_t<T>>() + " × " +
           std::to_string(sizeof(T) / sizeof(std::remove_all_extents_t<T>));
  } else if constexpr (std::is_class_v<T>) {
    return std::to_string(sizeof(T)) + " B";
  } else {
    const bool has_sign = std::is_signed_v<T>;
    return (std::is_floating_point_v<T> ? "f" : has_sign ? "i" : "u") + std::to_string(8 * sizeof(T));
  }
}

// A row for each member of a header or a record, and for each array behind a header.
class Table : public format::Unheard {
 public:
  // start: of the header or record. bytes: of a header, behind which arrays stand.
  explicit Table(const void* start, std::size_t bytes = 0) : start_(start), bytes_(bytes) {}
  const std::string& rows() const { return rows_; }

  template <class T, class... A>
  void any(const Field& f, const T& value, const A&...) {
    if (f.name == nullptr) return;  // a second rule of the member before it
    const auto at = reinterpret_cast<const char*>(&value) - static_cast<const char*>(start_);
    row(std::to_string(at), type_of<T>(), f);
  }
  template <class T>
  void reserved(const T& value) {
    any({"reserved", "0"}, value);
  }
#define MARROW_WORD(word)                                  \
  template <class T, class... A>                           \
  void word(const Field& f, const T& value, const A&...) { \
    any(f, value);                                         \
  }
  MARROW_WORD(range)
  MARROW_WORD(flags)
  MARROW_WORD(name)
  MARROW_WORD(text)
  MARROW_WORD(finite)
  MARROW_WORD(bounded)
  MARROW_WORD(not_negative)
  MARROW_WORD(within)
  MARROW_WORD(inside)
  MARROW_WORD(near)
  MARROW_WORD(skeleton)
  MARROW_WORD(skeleton_or_reference)
  MARROW_WORD(only_of_skeleton)
  MARROW_WORD(below)
  MARROW_WORD(section)
  MARROW_WORD(joint)
#undef MARROW_WORD
  template <class T, class... A>
  void array(const Field& f, const format::Array<T>&, const A&...) {
    const std::string times = f.times;
    row(is_first_array_ ? std::to_string(bytes_) : "",
        std::is_same_v<T, std::byte> ? times : type_of<T>() + " × " + times, f);
    is_first_array_ = false;
  }
  template <class T, class... A>
  void records(const Field& f, const format::Array<T>& a, const A&...) {
    array(f, a);
  }

 private:
  void row(const std::string& at, const std::string& type, const Field& f) {
    rows_ += at.empty() ? "| " : "| " + at + " ";
    rows_ += "| " + type + " | " + f.name + " | ";
    rows_ += f.rule[0] != 0 ? std::string(f.rule) + " |\n" : "|\n";
  }

  const void* start_;
  std::size_t bytes_;
  bool is_first_array_ = true;
  std::string rows_;
};

// Of what one header or record, empty as it is here, is described as.
template <class Header>
std::string section_table() {
  const Header h{};
  typename format::LayoutOf<Header>::Type l{};
  Table table(&h, sizeof h);
  fields(table, h, l);
  return table.rows();
}
template <class Header, class Layout, class... Context>
std::string part_table(const Context&... context) {
  const Header h{};
  Layout l{};
  Table table(&h, sizeof h);
  fields(table, h, l, context...);
  return table.rows();
}
template <class Record>
std::string record_table() {
  const Record r{};
  Table table(&r);
  format::fields(table, r);
  return table.rows();
}

class FormatPage : public ::testing::Test {
 protected:
  void expect(const std::string& rows, const char* of) {
    EXPECT_NE(page_.find("| offset | type | field | rule |\n|---|---|---|---|\n" + rows + "\n"), std::string::npos)
        << "docs/format.md should have of " << of << ":\n"
        << rows;
  }
  std::string page_ = [] {
    std::ifstream in(test::in_source("docs/format.md"));
    return std::string(std::istreambuf_iterator<char>(in), {});
  }();
};

TEST_F(FormatPage, HasTheTablesOfSections) {
  expect(section_table<format::SkeletonHeader>(), "SKEL");
  expect(section_table<format::ReferenceHeader>(), "SREF");
  expect(section_table<format::ClipHeader>(), "CLIP");
  expect(section_table<format::GeometryHeader>(), "GEOM");
  expect(section_table<format::MeshHeader>(), "MESH");
  expect(section_table<format::MaterialHeader>(), "MATL");
  expect(section_table<format::ImageHeader>(), "IMAG");
  expect(section_table<format::NodeHeader>(), "NODE");
  expect(section_table<format::LimitHeader>(), "LIMI");
  expect(section_table<format::SpringHeader>(), "SPRI");
  expect(section_table<format::RoleHeader>(), "ROLE");
  expect(section_table<format::MotionHeader>(), "MOTN");
  expect(section_table<format::PoseMapHeader>(), "PMAP");
  expect(section_table<format::BoundsHeader>(), "BNDS");
  expect(section_table<format::ExampleHeader>(), "SHAP");
  expect(section_table<format::GraphHeader>(), "GRPH");
  expect(part_table<format::CodedHeader, format::CodedLayout>(0u), "coded segments");
  expect(part_table<format::MorphHeader, format::MorphLayout>(format::GeometryLayout{}), "morph targets");
  expect(part_table<format::PoseSpaceHeader, format::PoseSpaceLayout>(format::GeometryHeader{}), "pose space");
}

TEST_F(FormatPage, HasTheTablesOfRecords) {
  expect(record_table<Track>(), "a track");
  expect(record_table<Channel>(), "a channel");
  expect(record_table<MorphTarget>(), "a morph target");
  expect(record_table<Texture>(), "a texture");
  expect(record_table<Property>(), "a property");
  expect(record_table<JointLimit>(), "a limit");
  expect(record_table<format::SpringRecord>(), "a chain");
  expect(record_table<SpringJoint>(), "a chain's joint");
  expect(record_table<SpringCollider>(), "a collider");
  expect(record_table<JointRole>(), "a role of a joint");
  expect(record_table<JointPair>(), "a pair");
  expect(record_table<JointSole>(), "a sole");
  expect(record_table<RootKey>(), "a key of a root");
  expect(record_table<ClipEvent>(), "an event");
  expect(record_table<MappedGroup>(), "a group");
  expect(record_table<MappedTurn>(), "a turn");
  expect(record_table<MappedPlace>(), "a place");
  expect(record_table<RigStep>(), "a step");
  expect(record_table<GraphParameter>(), "a parameter");
  expect(record_table<GraphNode>(), "a node of a graph");
  expect(record_table<GraphClip>(), "a clip of a graph");
  expect(record_table<GraphSpace>(), "a space");
  expect(record_table<GraphPoint>(), "a point");
  expect(record_table<PlaneTriangle>(), "a triangle");
  expect(record_table<GraphMachine>(), "a machine");
  expect(record_table<GraphState>(), "a state");
  expect(record_table<GraphTransition>(), "a transition");
  expect(record_table<GraphCondition>(), "a condition");
  expect(record_table<GraphLayer>(), "a layer");
  expect(record_table<GraphMask>(), "a mask");
  expect(record_table<GraphMaskPart>(), "a part of a mask");
  expect(record_table<format::BoundsCodes>(), "bounds");
}

}  // namespace
}  // namespace marrow
