#include <algorithm>
#include <atomic>
#include <cctype>

#include <fmt/format.h>

#include "common/failure.h"
#include "common/hash.h"
#include "disk/files.h"
#include "jobs/store.h"

#ifdef MARROW_CURL
#include <curl/curl.h>
#include <dlfcn.h>
// The header checks types by macros, which are of calls by name.
#undef curl_easy_setopt
#undef curl_easy_getinfo
#endif

namespace marrow::tools {

#ifdef MARROW_CURL
namespace {

constexpr std::size_t kMostBytes = 256u << 20;
constexpr long kConnect_ms = 3000;
constexpr int kMostFailures = 3;  // in a row: then the server is left alone

// libcurl, loaded when the first server is asked: with what it needs it makes a start of the program take twice as
// long.
class Curl {
 public:
  Curl() {
    void* const library = ::dlopen("libcurl.so.4", RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr) throw Failure(Exit::usage, "--cache", "", "no HTTP", std::string(::dlerror()));
    load(library, "curl_easy_init", easy_init);
    load(library, "curl_easy_cleanup", easy_cleanup);
    load(library, "curl_easy_reset", easy_reset);
    load(library, "curl_easy_setopt", easy_setopt);
    load(library, "curl_easy_perform", easy_perform);
    load(library, "curl_easy_getinfo", easy_getinfo);
    load(library, "curl_easy_strerror", easy_strerror);
    load(library, "curl_slist_append", slist_append);
    load(library, "curl_slist_free_all", slist_free_all);
    decltype(&curl_global_init) global_init = nullptr;
    load(library, "curl_global_init", global_init);
    const CURLcode ready = global_init(CURL_GLOBAL_DEFAULT);
    if (ready != CURLE_OK) throw Failure(Exit::internal, "--cache", "", "no HTTP", easy_strerror(ready));
  }
  decltype(&curl_easy_init) easy_init = nullptr;
  decltype(&curl_easy_cleanup) easy_cleanup = nullptr;
  decltype(&curl_easy_reset) easy_reset = nullptr;
  decltype(&::curl_easy_setopt) easy_setopt = nullptr;
  decltype(&curl_easy_perform) easy_perform = nullptr;
  decltype(&::curl_easy_getinfo) easy_getinfo = nullptr;
  decltype(&curl_easy_strerror) easy_strerror = nullptr;
  decltype(&curl_slist_append) slist_append = nullptr;
  decltype(&curl_slist_free_all) slist_free_all = nullptr;

 private:
  template <typename Function>
  static void load(void* library, const char* name, Function& out) {
    out = reinterpret_cast<Function>(::dlsym(library, name));
    if (out == nullptr) throw Failure(Exit::usage, "--cache", "", "no HTTP", std::string("libcurl has no ") + name);
  }
};

const Curl& curl() {
  static const Curl one;
  return one;
}

// Without name and password.
std::string shown(const std::string& address) {
  const std::size_t host = address.find("://") + 3, end = address.find('/', host), at = address.rfind('@', end);
  return at == std::string::npos || at < host ? address : address.substr(0, host) + address.substr(at + 1);
}

std::string read_token(const std::string& file) {
  const AlignedBytes bytes = read_file(file);
  std::string_view text(reinterpret_cast<const char*>(bytes.data()), std::min<std::size_t>(bytes.size(), 1u << 16));
  text = text.substr(0, text.find_first_of("\r\n"));
  const bool plain = std::ranges::all_of(text, [](unsigned char c) { return c > ' ' && c < 127; });
  if (text.empty() || !plain)
    throw Failure(Exit::invalid, file, "1", "no token", "the first line must be one word of ASCII");
  return std::string(text);
}

struct Upload {
  std::string_view rest;
};

std::size_t send(char* to, std::size_t size, std::size_t count, void* user) {
  std::string_view& rest = static_cast<Upload*>(user)->rest;
  const std::size_t n = std::min(size * count, rest.size());
  std::copy_n(rest.data(), n, to);
  rest.remove_prefix(n);
  return n;
}

std::size_t receive(char* from, std::size_t size, std::size_t count, void* user) {
  std::string& body = *static_cast<std::string*>(user);
  if (body.size() + size * count > kMostBytes) return 0;
  body.append(from, size * count);
  return size * count;
}

class HttpStore final : public Store {
 public:
  HttpStore(const std::string& address, const CacheArguments& arguments)
      : Store(shown(address)), address_(address), read_only_(arguments.read_only), timeout_s_(arguments.timeout_s) {
    while (address_.ends_with('/')) address_.pop_back();
    std::string header = "Authorization: Bearer ";
    if (!arguments.token_file.empty())
      headers_.reset(curl().slist_append(nullptr, (header + read_token(arguments.token_file)).c_str()));
    headers_.reset(curl().slist_append(headers_.release(), "Content-Type: application/octet-stream"));
    headers_.reset(curl().slist_append(headers_.release(), "Expect:"));
  }

  std::optional<std::string> get(const std::string& name) override {
    std::string body;
    const long status = ask(name, nullptr, body);
    if (status != 200) return std::nullopt;
    return body;
  }

  void put(const std::string& name, std::string_view bytes) override {
    if (read_only_ || full_) return;
    Upload upload{bytes};
    std::string ignored;
    const long status = ask(name, &upload, ignored);
    if (status / 100 == 4 || status == 507) {
      full_ = true;
      note(fmt::format("nothing is kept there: it answers {} to PUT", status));
    }
  }

  void reject(const std::string& name) override {
    note("it gave other bytes for " + name + " than were kept; they are cooked");
  }

 private:
  using Handle = std::unique_ptr<CURL, decltype(&curl_easy_cleanup)>;
  using Headers = std::unique_ptr<curl_slist, decltype(&curl_slist_free_all)>;

  // With its connection, which the next call uses again.
  Handle take() {
    const std::lock_guard lock(idle_mutex_);
    if (idle_.empty()) return {curl().easy_init(), curl().easy_cleanup};
    Handle out = std::move(idle_.back());
    idle_.pop_back();
    return out;
  }
  void give_back(Handle handle) {
    const std::lock_guard lock(idle_mutex_);
    idle_.push_back(std::move(handle));
  }

  // Servers of Bazel's protocol take 64 digits; ours have 32 and what they are of.
  std::string address_of(const std::string& name) const {
    return address_ + "/ac/" + name.substr(0, 32) + hash_of(std::as_bytes(std::span(name.data(), name.size())));
  }

  // The status, 0: there was no answer, or one that counts as none. upload: null of GET.
  long ask(const std::string& name, Upload* upload, std::string& body) {
    if (given_up_) return 0;
    Handle handle = take();
    CURL* const c = handle.get();
    if (c == nullptr) return 0;
    const curl_off_t size = upload != nullptr ? static_cast<curl_off_t>(upload->rest.size()) : 0;
    curl().easy_reset(c);
    curl().easy_setopt(c, CURLOPT_URL, address_of(name).c_str());
    curl().easy_setopt(c, CURLOPT_PROTOCOLS_STR, "http,https");
    curl().easy_setopt(c, CURLOPT_FOLLOWLOCATION, 0L);
    curl().easy_setopt(c, CURLOPT_NOSIGNAL, 1L);
    curl().easy_setopt(c, CURLOPT_CONNECTTIMEOUT_MS, kConnect_ms);
    curl().easy_setopt(c, CURLOPT_TIMEOUT, static_cast<long>(timeout_s_));
    curl().easy_setopt(c, CURLOPT_HTTPHEADER, headers_.get());
    curl().easy_setopt(c, CURLOPT_WRITEFUNCTION, &receive);
    curl().easy_setopt(c, CURLOPT_WRITEDATA, &body);
    if (upload != nullptr) {
      curl().easy_setopt(c, CURLOPT_UPLOAD, 1L);
      curl().easy_setopt(c, CURLOPT_READFUNCTION, &send);
      curl().easy_setopt(c, CURLOPT_READDATA, upload);
      curl().easy_setopt(c, CURLOPT_INFILESIZE_LARGE, size);
    }
    const CURLcode done = curl().easy_perform(c);
    long status = 0;
    curl().easy_getinfo(c, CURLINFO_RESPONSE_CODE, &status);
    give_back(std::move(handle));
    return judged(done, status, upload != nullptr);
  }

  long judged(CURLcode done, long status, bool puts) {
    constexpr long kFull = 507;
    const bool refuses = status == 401 || status == 403;
    std::atomic<int>& failures = puts ? put_failures_ : get_failures_;
    if (done == CURLE_OK && (status == kFull || (status < 500 && (puts || !refuses)))) {
      failures = 0;
      return status;
    }
    const std::string why = done == CURLE_WRITE_ERROR ? "it sends an entry of more than 256 MiB"
                            : done != CURLE_OK        ? curl().easy_strerror(done)
                                                      : fmt::format("it answers {}", status);
    if (refuses || ++failures >= kMostFailures) given_up_ = true;
    note(why + (given_up_ ? "; it is not asked any more" : ""));
    return 0;
  }

  std::string address_;
  bool read_only_;
  unsigned timeout_s_;
  Headers headers_{nullptr, curl().slist_free_all};
  std::mutex idle_mutex_;
  std::vector<Handle> idle_;
  std::atomic<int> get_failures_{0}, put_failures_{0};
  std::atomic<bool> given_up_{false};
  std::atomic<bool> full_{false};
};

}  // namespace

std::unique_ptr<Store> http_store(const std::string& address, const CacheArguments& arguments) {
  return std::make_unique<HttpStore>(address, arguments);
}
#else
std::unique_ptr<Store> http_store(const std::string& address, const CacheArguments&) {
  throw Failure(Exit::usage, address, "", "no HTTP", "this program was built without libcurl; name a folder");
}
#endif

}  // namespace marrow::tools
