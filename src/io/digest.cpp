#include "fluidymation/io/digest.h"

#include <fcntl.h>
#include <unistd.h>
#include <xxhash.h>

#include <algorithm>
#include <cerrno>
#include <iterator>
#include <memory>
#include <new>
#include <string_view>
#include <system_error>
#include <vector>

#include "fluidymation/core/error.h"

namespace fluidymation {
namespace {

constexpr std::string_view kDigits = "0123456789abcdef";

[[nodiscard]] Digest canonical(const XXH128_hash_t& hash) {
  XXH128_canonical_t canonical;
  XXH128_canonicalFromHash(&canonical, hash);
  Digest digest;
  std::copy(std::begin(canonical.digest), std::end(canonical.digest), digest.bytes.begin());
  return digest;
}

[[noreturn]] void failToRead(const std::string& path, int code) {
  throw Error(path + ": cannot be read (" + std::generic_category().message(code) + ")");
}

/// An open descriptor, closed at the end.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { close(number_); }
  [[nodiscard]] int number() const { return number_; }

 private:
  int number_;
};

}  // namespace

std::string Digest::text() const {
  std::string text;
  for (const std::uint8_t byte : bytes) {
    text += kDigits[byte >> 4U];
    text += kDigits[byte & 15U];
  }
  return text;
}

std::optional<Digest> Digest::parse(const std::string& text) {
  Digest digest;
  if (text.size() != 2 * digest.bytes.size()) return std::nullopt;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::size_t value = kDigits.find(text[i]);
    if (value == std::string_view::npos) return std::nullopt;
    std::uint8_t& byte = digest.bytes[i / 2];
    byte = static_cast<std::uint8_t>(std::size_t{byte} << 4U | value);
  }
  return digest;
}

Digest digestOf(const void* data, std::size_t byteCount) {
  return canonical(XXH3_128bits(data, byteCount));
}

Digest digestOfFile(const std::string& path) {
  constexpr std::size_t kChunkBytes = 1 << 18;
  // Without O_NONBLOCK a named pipe of that name would wait for a writer for ever.
  const int number = open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  if (number < 0) failToRead(path, errno);
  const Descriptor file(number);
  const std::unique_ptr<XXH3_state_t, XXH_errorcode (*)(XXH3_state_t*)> state(XXH3_createState(),
                                                                              XXH3_freeState);
  if (!state) throw std::bad_alloc();
  XXH3_128bits_reset(state.get());
  std::vector<unsigned char> chunk(kChunkBytes);
  for (;;) {
    const ssize_t count = read(file.number(), chunk.data(), chunk.size());
    if (count == 0) break;
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) failToRead(path, errno);
    XXH3_128bits_update(state.get(), chunk.data(), static_cast<std::size_t>(count));
  }
  return canonical(XXH3_128bits_digest(state.get()));
}

}  // namespace fluidymation
