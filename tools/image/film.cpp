#include "image/film.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "common/failure.h"
#include "common/formats.h"
#include "disk/files.h"
#include "text/printable.h"

extern char** environ;

namespace marrow::tools {
namespace {

constexpr int kFilmDescriptor = 3;  // of ffmpeg's process
constexpr std::size_t kMostSaid = 4096;

struct Kind {
  const char* extension;
  std::vector<std::string> arguments;
};

// The screens' primaries and matrix are named, else players guess them by the picture's height.
std::vector<std::string> video(std::vector<std::string> codec) {
  codec.insert(codec.end(), {"-vf", "scale=out_color_matrix=bt709:out_range=tv:flags=accurate_rnd+full_chroma_int",
                             "-pix_fmt", "yuv420p", "-color_range", "tv", "-colorspace", "bt709", "-color_primaries",
                             "bt709", "-color_trc", "bt709"});
  return codec;
}

// One palette of all frames, so that colours do not jump; noise only where something moves.
const std::vector<Kind>& kinds() {
  static const std::vector<Kind> all = {
      {".gif",
       {"-filter_complex",
        "split[a][b];[a]palettegen=stats_mode=full[p];[b][p]paletteuse=dither=sierra2_4a:diff_mode=rectangle", "-loop",
        "0", "-f", "gif"}},
      {".mp4", video({"-c:v", "libx264", "-crf", "18", "-movflags", "+faststart", "-f", "mp4"})},
      // Each frame whole: the encoder of animations leaves blocks of the frame before that are nearly alike, and shows
      // it.
      {".webp", {"-c:v", "libwebp", "-quality", "60", "-compression_level", "5", "-loop", "0", "-f", "webp"}},
      {".webm",
       video({"-c:v", "libvpx-vp9", "-crf", "24", "-b:v", "0", "-row-mt", "1", "-cpu-used", "3", "-f", "webm"})},
  };
  return all;
}

const Kind* kind_of(const std::string& output) {
  const auto found = std::ranges::find_if(kinds(), [&](const Kind& k) { return has_extension(output, k.extension); });
  return found == kinds().end() ? nullptr : &*found;
}

// As a shell looks for it, but not in the working directory unless that is named.
std::optional<std::string> find_program(const std::string& name) {
  const char* const path = std::getenv("PATH");
  std::string_view left = path == nullptr ? "" : path;
  while (!left.empty()) {
    const std::size_t end = std::min(left.find(':'), left.size());
    const std::string program = std::string(left.substr(0, end)) + "/" + name;
    struct stat info {};
    if (end > 0 && ::stat(program.c_str(), &info) == 0 && S_ISREG(info.st_mode) && ::access(program.c_str(), X_OK) == 0)
      return program;
    left.remove_prefix(std::min(end + 1, left.size()));
  }
  return std::nullopt;
}

std::string find_ffmpeg(const std::string& output) {
  if (std::optional<std::string> found = find_program("ffmpeg")) return *found;
  throw Failure(Exit::unsupported, output, "",
                "there is no program ffmpeg on the PATH, which writes GIF, MP4, WebM and WebP",
                "install it (apt-get install ffmpeg), or name a .png: an animated PNG");
}

std::vector<std::string> arguments_of(const std::string& program, const std::string& output, const Film::Shape& shape) {
  std::vector<std::string> out = {program, "-nostdin", "-hide_banner",  "-loglevel", "error",      "-y",
                                  "-f",    "rawvideo", "-pixel_format", "rgb24",     "-video_size"};
  out.push_back(fmt::format("{}x{}", shape.width, shape.height));
  out.insert(out.end(), {"-framerate", fmt::format("{}/{:.9f}", shape.frames, shape.duration_s), "-i", "pipe:0"});
  const std::vector<std::string>& own = kind_of(output)->arguments;
  out.insert(out.end(), own.begin(), own.end());
  // Nothing of the program's version or of the time.
  out.insert(out.end(), {"-map_metadata", "-1", "-fflags", "+bitexact", "-flags:v", "+bitexact",
                         fmt::format("file:/dev/fd/{}", kFilmDescriptor)});
  return out;
}

std::string last_line(std::FILE* file) {
  std::fseek(file, 0, SEEK_END);
  const long size = std::ftell(file);
  std::fseek(file, std::max(0L, size - static_cast<long>(kMostSaid)), SEEK_SET);
  std::string text(kMostSaid, '\0');
  text.resize(std::fread(text.data(), 1, text.size(), file));
  text.erase(text.find_last_not_of(" \r\n") + 1);
  return printable(text.substr(text.find_last_of("\r\n") + 1));
}

// The bytes of an open file, in memory only as far as they are looked at.
class MappedFile {
 public:
  explicit MappedFile(int fd) {
    struct stat info {};
    if (::fstat(fd, &info) != 0 || info.st_size <= 0) return;
    size_ = static_cast<std::size_t>(info.st_size);
    address_ = ::mmap(nullptr, size_, PROT_READ, MAP_PRIVATE, fd, 0);
  }
  ~MappedFile() {
    if (address_ != MAP_FAILED) ::munmap(address_, size_);
  }
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;
  std::span<const std::byte> bytes() const {
    if (address_ == MAP_FAILED) return {};
    return {static_cast<const std::byte*>(address_), size_};
  }

 private:
  void* address_ = MAP_FAILED;
  std::size_t size_ = 0;
};

// A descriptor above those that ffmpeg's process gives a meaning; closed in that process.
int out_of_the_way(int fd) {
  return ::fcntl(fd, F_DUPFD_CLOEXEC, kFilmDescriptor + 1);
}

}  // namespace

bool is_film(const std::string& output) {
  return kind_of(output) != nullptr;
}

void expect_ffmpeg(const std::string& output) {
  find_ffmpeg(output);
}

Film::Film(std::string output, const Shape& shape)
    : output_(std::move(output)), made_(std::tmpfile()), said_(std::tmpfile()) {
  const std::string program = find_ffmpeg(output_);
  if (!made_ || !said_) throw Failure(Exit::io, output_, "", "cannot make a temporary file", std::strerror(errno));
  start(program, shape);
}

Film::~Film() {
  if (child_ >= 0) ::kill(child_, SIGKILL);
  end();
}

void Film::start(const std::string& program, const Shape& shape) {
  std::vector<std::string> texts = arguments_of(program, output_, shape);
  std::vector<char*> argv;
  for (std::string& text : texts) argv.push_back(text.data());
  argv.push_back(nullptr);

  int ends[2];
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    throw Failure(Exit::io, output_, "", "cannot start ffmpeg", std::strerror(errno));
  frames_ = ends[0];
  ::shutdown(frames_, SHUT_RD);
  const int given[] = {out_of_the_way(ends[1]), out_of_the_way(::fileno(said_.get())),
                       out_of_the_way(::fileno(made_.get()))};
  ::close(ends[1]);

  posix_spawn_file_actions_t actions;
  posix_spawnattr_t attributes;
  posix_spawn_file_actions_init(&actions);
  posix_spawnattr_init(&attributes);
  posix_spawn_file_actions_adddup2(&actions, given[0], 0);
  posix_spawn_file_actions_adddup2(&actions, given[1], 1);
  posix_spawn_file_actions_adddup2(&actions, given[1], 2);
  posix_spawn_file_actions_adddup2(&actions, given[2], kFilmDescriptor);
  sigset_t none;  // Ctrl-C ends it as well
  ::sigemptyset(&none);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
  const int error = ::posix_spawn(&child_, program.c_str(), &actions, &attributes, argv.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  for (const int fd : given)
    if (fd >= 0) ::close(fd);
  if (error == 0) return;
  child_ = -1;
  ::close(std::exchange(frames_, -1));
  throw Failure(Exit::io, output_, "", "cannot start " + program, std::strerror(error));
}

void Film::add(const Image& frame) {
  for (std::size_t done = 0; done < frame.rgb.size();) {
    const ssize_t n = ::send(frames_, frame.rgb.data() + done, frame.rgb.size() - done, MSG_NOSIGNAL);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) {
      end();
      complain();
    }
    done += static_cast<std::size_t>(n);
  }
}

bool Film::end() {
  if (frames_ >= 0) ::close(std::exchange(frames_, -1));
  int status = -1;
  if (child_ < 0) return false;
  while (::waitpid(child_, &status, 0) < 0 && errno == EINTR) {
  }
  child_ = -1;
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

void Film::finish() {
  if (!end()) complain();
  const MappedFile made(::fileno(made_.get()));
  if (made.bytes().empty()) complain();
  write_file_atomically(output_, made.bytes());
}

void Film::complain() const {
  const std::string said = last_line(said_.get());
  throw Failure(Exit::io, output_, "", "ffmpeg failed: " + (said.empty() ? "it said nothing" : said),
                "install an ffmpeg with this codec, make room in the folder of temporary files, or name a .png");
}

}  // namespace marrow::tools
