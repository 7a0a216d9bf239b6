#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "fluidymation/io/unnamed_file.h"

namespace fluidymation {

/// Where records are kept that wait for their turn.
struct RecordStorage {
  /// Bytes of memory; what is more goes to a temporary file.
  std::size_t memoryBytes = std::numeric_limits<std::size_t>::max();
  std::string folder;  ///< on whose disk that file is, see `UnnamedFile`
};

/// Records of bytes, in memory as long as there is room, else in a temporary file that nobody sees
/// and that the system removes. What is read is what was added, wherever it was. For one thread at
/// a time.
class RecordStore {
 public:
  using Record = std::size_t;

  explicit RecordStore(RecordStorage storage) : storage_(std::move(storage)) {}

  /// @throws Error naming the folder of the temporary file when that cannot be written.
  template <typename Value>
  [[nodiscard]] Record add(const std::vector<Value>& values) {
    static_assert(std::is_trivially_copyable_v<Value>);
    return addBytes(values.data(), values.size() * sizeof(Value));
  }

  /// @throws Error likewise, when it cannot be read.
  template <typename Value>
  [[nodiscard]] std::vector<Value> get(Record record) const {
    static_assert(std::is_trivially_copyable_v<Value>);
    assert(!entries_[record].isDropped);
    const std::size_t bytes = byteCount(record);
    assert(bytes % sizeof(Value) == 0);
    std::vector<Value> values(bytes / sizeof(Value));
    getBytes(record, values.data());
    return values;
  }

  /// Forgets a record that is not asked for again; its memory is free for others, its place on the
  /// disk is not.
  void drop(Record record);

  [[nodiscard]] std::size_t bytesInMemory() const { return bytesInMemory_; }
  [[nodiscard]] std::uint64_t bytesOnDisk() const { return file_ ? file_->size() : 0; }

 private:
  struct Entry {
    std::size_t byteCount = 0;
    std::vector<std::uint8_t> inMemory;
    std::optional<std::uint64_t> onDisk;  ///< where it begins, unless it is in memory
    bool isDropped = false;
  };

  Record addBytes(const void* data, std::size_t byteCount);
  [[nodiscard]] std::size_t byteCount(Record record) const { return entries_[record].byteCount; }
  void getBytes(Record record, void* data) const;

  RecordStorage storage_;
  std::vector<Entry> entries_;
  std::size_t bytesInMemory_ = 0;
  std::unique_ptr<UnnamedFile> file_;
};

}  // namespace fluidymation
