#include "preview/video.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "fluidymation/core/error.h"
#include "fluidymation/core/text.h"
#include "fluidymation/io/atomic_file.h"

extern char** environ;  // NOLINT(readability-redundant-declaration): POSIX leaves it to us

namespace fluidymation {
namespace {

constexpr const char* kProgram = "ffmpeg";

[[noreturn]] void failToRun(const std::string& path, int code) {
  throw Error(path + ": " + kProgram + " cannot be run (" + std::generic_category().message(code) +
              ")");
}

/// How often is asked, while ffmpeg is waited for, whether to stop.
constexpr int kPatienceMs = 50;

/// ffmpeg, reading raw pictures from a pipe. Ended and waited for by its destructor at the latest.
class Encoder {
 public:
  /// @param stopIfWanted  called while ffmpeg is waited for; may throw.
  Encoder(std::string path, const std::vector<std::string>& arguments,
          const std::function<void()>& stopIfWanted)
      : path_(std::move(path)),
        stopIfWanted_(stopIfWanted),
        messages_(std::tmpfile(), std::fclose) {
    std::array<int, 2> ends{};
    if (!messages_ || pipe2(ends.data(), O_CLOEXEC) != 0) failToRun(path_, errno);
    input_ = ends[1];
    const int failure = start(arguments, ends[0]);
    close(ends[0]);
    // A program that reads nothing must not hold us
    if (failure == 0 && fcntl(input_, F_SETFL, O_NONBLOCK) == 0) return;
    const int reason = failure != 0 ? failure : errno;
    close(input_);
    endNow();
    failToRun(path_, reason);
  }
  Encoder(const Encoder&) = delete;
  Encoder& operator=(const Encoder&) = delete;
  ~Encoder() {
    if (input_ >= 0) close(input_);
    endNow();
  }

  /// @return  false where it reads no more: its end says why.
  [[nodiscard]] bool feed(const std::vector<std::uint8_t>& bytes) const {
    std::size_t written = 0;
    while (written < bytes.size()) {
      pollfd room{input_, POLLOUT, 0};
      stopIfWanted_();
      if (poll(&room, 1, kPatienceMs) <= 0) continue;
      const ssize_t count = write(input_, bytes.data() + written, bytes.size() - written);
      if (count < 0 && (errno == EINTR || errno == EAGAIN)) continue;
      if (count <= 0) return false;
      written += static_cast<std::size_t>(count);
    }
    return true;
  }

  /// Lets it finish. @throws Error with its last words unless it did so well.
  void finish() {
    close(input_);
    input_ = -1;
    int status = 0;
    while (waitpid(process_, &status, WNOHANG) == 0) {
      stopIfWanted_();
      std::this_thread::sleep_for(std::chrono::milliseconds(kPatienceMs));
    }
    process_ = -1;
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return;
    throw Error(path_ + ": " + kProgram + " failed (" + lastWords() + ")");
  }

 private:
  /// @return  0, or the system's reason.
  int start(const std::vector<std::string>& arguments, int input) {
    posix_spawn_file_actions_t files;
    posix_spawnattr_t attributes;
    posix_spawn_file_actions_init(&files);
    posix_spawnattr_init(&attributes);
    posix_spawn_file_actions_adddup2(&files, input, STDIN_FILENO);
    posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&files, fileno(messages_.get()), STDERR_FILENO);
    // Ctrl-C is for us; and it starts with the signals that any program starts with.
    sigset_t defaults;
    sigemptyset(&defaults);
    for (const int signal : {SIGPIPE, SIGXFSZ, SIGHUP, SIGINT, SIGTERM}) {
      sigaddset(&defaults, signal);
    }
    posix_spawnattr_setsigdefault(&attributes, &defaults);
    posix_spawnattr_setpgroup(&attributes, 0);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
    std::vector<std::string> words = arguments;
    std::vector<char*> pointers;
    pointers.reserve(words.size() + 1);
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    const int failure =
        posix_spawnp(&process_, kProgram, &files, &attributes, pointers.data(), environ);
    if (failure != 0) process_ = -1;
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&files);
    return failure;
  }

  /// Ends it, and what it may have started, however it is.
  void endNow() {
    if (process_ <= 0) return;
    kill(-process_, SIGKILL);
    while (waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
    }
    process_ = -1;
  }

  /// The last line of its messages that is not empty.
  [[nodiscard]] std::string lastWords() const {
    constexpr std::size_t kLongest = 4096;
    std::array<char, kLongest> buffer{};
    std::FILE* const file = messages_.get();
    std::fseek(file, 0, SEEK_END);
    const long size = std::ftell(file);
    std::fseek(file, std::max(0L, size - static_cast<long>(kLongest)), SEEK_SET);
    std::string text(buffer.data(), std::fread(buffer.data(), 1, kLongest, file));
    text.erase(text.find_last_not_of("\r\n ") + 1);
    const std::size_t line = text.rfind('\n');
    if (line != std::string::npos) text.erase(0, line + 1);
    return text.empty() ? "it says nothing" : text;
  }

  std::string path_;
  const std::function<void()>& stopIfWanted_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> messages_;
  int input_ = -1;
  pid_t process_ = -1;
};

[[nodiscard]] std::vector<std::string> argumentsFor(VideoFormat format, Size size,
                                                    int framesPerSecond, const std::string& file) {
  std::vector<std::string> words = {
      kProgram,   "-v",    "error", "-y",           "-f", "rawvideo",
      "-pix_fmt", "rgb24", "-s",    sizeText(size), "-r", std::to_string(framesPerSecond),
      "-i",       "pipe:0"};
  // A palette made of all frames: one for each would flicker
  const std::vector<std::string> gif = {
      "-vf", "split[a][b];[a]palettegen[p];[b][p]paletteuse=dither=bayer:bayer_scale=4", "-f",
      "gif"};
  const std::vector<std::string> mp4 = {"-pix_fmt",   "yuv420p", "-movflags",
                                        "+faststart", "-f",      "mp4"};
  const std::vector<std::string>& rest = format == VideoFormat::kGif ? gif : mp4;
  words.insert(words.end(), rest.begin(), rest.end());
  words.push_back("file:" + file);
  return words;
}

[[nodiscard]] std::vector<std::uint8_t> rawBytes(const Image<Rgba8>& picture) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(3 * picture.pixelCount());
  for (const Rgba8 pixel : picture) bytes.insert(bytes.end(), {pixel.r, pixel.g, pixel.b});
  return bytes;
}

}  // namespace

bool hasFfmpeg() {
  // NOLINTNEXTLINE(concurrency-mt-unsafe): nothing here changes the environment
  const char* const path = std::getenv("PATH");
  std::string folders = path != nullptr ? path : "";
  while (!folders.empty()) {
    const std::size_t colon = folders.find(':');
    const std::string folder = folders.substr(0, colon);
    const std::string file = (folder.empty() ? "." : folder) + "/" + kProgram;
    std::error_code ignored;
    if (std::filesystem::is_regular_file(file, ignored) && access(file.c_str(), X_OK) == 0) {
      return true;
    }
    folders.erase(0, colon == std::string::npos ? colon : colon + 1);
  }
  return false;
}

void writeVideo(const std::string& path, VideoFormat format, int frameCount, int framesPerSecond,
                const std::function<Image<Rgba8>(int frame)>& frame,
                const std::function<void()>& stopIfWanted) {
  replaceAtomically(path, [&](const std::string& temporary) {
    std::optional<Encoder> encoder;
    bool readsAll = true;
    for (int i = 0; i < frameCount && readsAll; ++i) {
      const Image<Rgba8> picture = frame(i);
      assert(picture.width() % 2 == 0 && picture.height() % 2 == 0);
      if (!encoder) {
        encoder.emplace(path, argumentsFor(format, picture.size(), framesPerSecond, temporary),
                        stopIfWanted);
      }
      readsAll = encoder->feed(rawBytes(picture));
    }
    if (encoder) encoder->finish();
    if (!readsAll) {
      throw Error(path + ": " + kProgram + " ended before it had read all pictures");
    }
  });
}

}  // namespace fluidymation
