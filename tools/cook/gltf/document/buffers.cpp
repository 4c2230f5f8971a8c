// Gathers the bytes behind a document's buffers and cuts them into buffer views.
#include "cook/gltf/document/buffers.h"

#include <map>

#include "cook/gltf/document/meshopt.h"
#include "cook/gltf/document/scene_files.h"

namespace marrow::cook::gltf {
namespace {

constexpr std::uint64_t kMostExternalBytes = kMostBytes;
// What compressed views may unfold to: so many bytes, and so many times the file's.
constexpr std::uint64_t kFreeUnfolding = std::uint64_t{1} << 25;
constexpr std::uint64_t kMostUnfolding = 16;
constexpr std::int64_t kVertexTarget = 34962;
constexpr std::int64_t kIndexTarget = 34963;

class Loader {
 public:
  Loader(const Container& container, Files* files, Report& report)
      : container_(container), files_(files), report_(report) {}

  void add_buffer(const Json& buffer, std::size_t index) {
    const std::string where = pointer("buffers", index);
    const std::uint64_t length = buffer.at("byteLength").get<std::uint64_t>();
    const auto uri = buffer.find("uri");
    if (uri != buffer.end()) {
      const auto& text = uri->get_ref<const std::string&>();
      const std::string uri_where = under(where, "uri");
      add_bytes(is_data_uri(text) ? data_bytes(text, uri_where) : file_bytes(text, length, uri_where), length, where);
    } else if (index == 0 && container_.binary) {
      add_chunk(length, where);
    } else {
      if (!is_placeholder(buffer, where))
        report_.warn(where, "buffer-without-data",
                     "no bytes are given for this buffer; what refers to it reads as zero");
      result.buffers.emplace_back(std::nullopt);
    }
  }

  void add_view(const Json& view, std::size_t index) {
    const std::string where = pointer("bufferViews", index);
    const auto buffer_index = view.at("buffer").get<std::size_t>();
    const std::uint64_t offset = count_or(view, "byteOffset", 0);
    View added;
    added.offset = offset;
    added.length = view.at("byteLength").get<std::uint64_t>();
    if (added.length == 0) report_.mend(under(where, "byteLength"), "empty-buffer-view", "glTF 2.0 demands a byte");
    added.stride = static_cast<std::uint32_t>(count_or(view, "byteStride", 0));
    added.target = static_cast<std::int64_t>(count_or(view, "target", 0));
    check_stride(added, where);
    const auto& buffer = result.buffers[buffer_index];
    const std::uint64_t capacity = buffer ? buffer->size() : declared_length_[buffer_index];
    if (offset > capacity || added.length > capacity - offset) {
      report_.invalid(under(where, "byteLength"), "beyond the buffer's end",
                      "the buffer has " + std::to_string(capacity) + " bytes; export again");
    }
    std::string meshopt_where = where;
    if (const Json* meshopt = find_meshopt(view, meshopt_where)) {
      added.present = true;
      added.bytes = decoded_bytes(*meshopt, added, meshopt_where);
    } else if (buffer) {
      added.present = true;
      added.bytes = buffer->subspan(offset, added.length);
    }
    result.views.push_back(added);
  }

  void declare_length(const Json& buffer) { declared_length_.push_back(buffer.at("byteLength").get<std::uint64_t>()); }

  Buffers result;

 private:
  void check_stride(const View& view, const std::string& where) {
    if (view.target != 0 && view.target != kVertexTarget && view.target != kIndexTarget) {
      report_.warn(under(where, "target"), "unknown-buffer-target", "neither vertices nor indices; ignored");
    }
    if (view.stride == 0) return;
    const std::string here = under(where, "byteStride");
    if (view.stride % 4 != 0) report_.invalid(here, "not a multiple of 4", "export again");
    if (view.stride > view.length) report_.invalid(here, "longer than the view", "export again");
    if (view.target == kIndexTarget) report_.invalid(here, "only vertex data may have a stride", "export again");
  }

  // Its views are compressed, and their bytes stand elsewhere.
  static bool is_placeholder(const Json& buffer, std::string where) {
    const Json* meshopt = find_meshopt(buffer, where);
    return meshopt != nullptr && meshopt->value("fallback", false);
  }

  // The compressed bytes count, whether or not there are plain ones beside them.
  std::span<const std::byte> decoded_bytes(const Json& extension, const View& view, const std::string& where) {
    const MeshoptView meshopt = read_meshopt_view(extension, view.length, view.stride, where, report_);
    const auto& source = result.buffers[meshopt.buffer];
    if (!source) report_.invalid(under(where, "buffer"), "no data", "the buffer has no bytes; export again");
    if (meshopt.offset > source->size() || meshopt.coded_length > source->size() - meshopt.offset) {
      report_.invalid(under(where, "byteLength"), "beyond the buffer's end",
                      "the buffer has " + std::to_string(source->size()) + " bytes; export again");
    }
    coded_bytes_ += meshopt.coded_length;
    unfolded_bytes_ += view.length;
    if (unfolded_bytes_ > kFreeUnfolding + kMostUnfolding * coded_bytes_)
      report_.unsupported(where, "unfolds too far", "split the scene, or export it without compression");
    return result.owned.emplace_back(
        decode_meshopt(meshopt, source->subspan(meshopt.offset, meshopt.coded_length), where, report_));
  }

  void add_bytes(std::span<const std::byte> bytes, std::uint64_t length, const std::string& where) {
    if (bytes.size() < length) {
      report_.invalid(under(where, "byteLength"), "longer than the data",
                      "there are " + std::to_string(bytes.size()) + " bytes; export again");
    }
    result.buffers.emplace_back(bytes.first(length));
  }

  void add_chunk(std::uint64_t length, const std::string& where) {
    if (!container_.has_bin) report_.invalid(where, "no BIN chunk", "the buffer has no uri either; export again");
    add_bytes(container_.bin, length, where);
    if (container_.bin.size() - length > 3) {
      report_.warn(where, "bin-chunk-too-long", "the BIN chunk goes on after the buffer's end; the rest is dropped");
    }
  }

  std::span<const std::byte> data_bytes(const std::string& uri, const std::string& where) {
    DataUri data = decode_data_uri(uri, where, report_);
    if (data.mime_type != "application/octet-stream" && data.mime_type != "application/gltf-buffer") {
      report_.mend(where, "data-uri-mime-type", "must be application/octet-stream or application/gltf-buffer");
    }
    return result.owned.emplace_back(std::move(data.bytes));
  }

  std::span<const std::byte> file_bytes(const std::string& uri, std::uint64_t length, const std::string& where) {
    const std::string path = name_beside(files_, report_.file(), uri, "buffer", where, report_);
    const auto known = owned_of_path_.find(path);
    if (known != owned_of_path_.end() && result.owned[known->second].size() >= length) {
      return result.owned[known->second];
    }
    std::vector<std::byte> bytes = read_scene_file(*files_, path, length, where, report_);
    result.external_bytes += bytes.size();
    if (result.external_bytes > kMostExternalBytes) {
      report_.unsupported(where, "buffers too large", "split the scene; 2 GiB is the limit");
    }
    owned_of_path_[path] = result.owned.size();
    return result.owned.emplace_back(std::move(bytes));
  }

  const Container& container_;
  Files* files_;
  Report& report_;
  std::map<std::string, std::size_t> owned_of_path_;
  std::vector<std::uint64_t> declared_length_;
  std::uint64_t coded_bytes_ = 0, unfolded_bytes_ = 0;  // of compressed views
};

}  // namespace

Buffers load_buffers(const Json& root, const Container& container, Files* files, Report& report) {
  Loader loader(container, files, report);
  const Json none = Json::array();
  const Json& buffers = root.contains("buffers") ? root.at("buffers") : none;
  const Json& views = root.contains("bufferViews") ? root.at("bufferViews") : none;
  for (std::size_t i = 0; i < buffers.size(); ++i) {
    loader.declare_length(buffers[i]);
    loader.add_buffer(buffers[i], i);
  }
  for (std::size_t i = 0; i < views.size(); ++i) loader.add_view(views[i], i);
  return std::move(loader.result);
}

}  // namespace marrow::cook::gltf
