// Where a cache keeps its entries: bytes by name, whole or not at all.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace marrow::tools {

// What the user says about caches.
struct CacheArguments {
  std::vector<std::string> places;  // folders and http:// or https:// addresses; the first that has an entry gives it;
                                    // empty ones do not count
  std::uint64_t folder_bytes = 1u << 30;
  bool read_only = false;  // of what is asked by HTTP
  std::string token_file;  // whose first line says who asks
  unsigned timeout_s = 10;
};

// All calls from any thread. None throws: what cannot be had or kept is cooked again.
class Store {
 public:
  virtual ~Store() = default;
  virtual std::optional<std::string> get(const std::string& name) = 0;
  virtual void put(const std::string& name, std::string_view bytes) = 0;
  // Has said something else than what was put there.
  virtual void reject(const std::string& name) = 0;
  // After the last call; keeps within bounds.
  virtual void end() {}
  // The last thing that went wrong, with what it means: a warning about the place. Empty: nothing did.
  std::string trouble() const;
  const std::string& place() const { return place_; }

 protected:
  explicit Store(std::string place) : place_(std::move(place)) {}
  void note(const std::string& trouble);

 private:
  std::string place_;
  mutable std::mutex mutex_;
  std::string trouble_;
};

// A folder, which processes may share: files are replaced whole and never changed. Once it has grown, end() removes
// those that were not used for longest until the rest has at most so many bytes. Only what a cache has written is
// removed.
std::unique_ptr<Store> folder_store(const std::string& folder, std::uint64_t most_bytes);

// A server that knows GET and PUT, as caches of Bazel and ccache do: ADDRESS/ac/ and 64 hexadecimal digits. Throws
// Failure: usage for an address or where this program was built without HTTP, io for the file with the token.
std::unique_ptr<Store> http_store(const std::string& address, const CacheArguments& arguments);

bool is_http(const std::string& place);

}  // namespace marrow::tools
