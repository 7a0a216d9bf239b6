#include "fluidymation/io/record_store.h"

#include <cstring>
#include <utility>

namespace fluidymation {

RecordStore::Record RecordStore::addBytes(const void* data, std::size_t byteCount) {
  Entry entry;
  entry.byteCount = byteCount;
  if (byteCount <= storage_.memoryBytes - bytesInMemory_) {
    const auto* bytes = static_cast<const std::uint8_t*>(data);
    entry.inMemory.assign(bytes, bytes + byteCount);
    bytesInMemory_ += byteCount;
  } else {
    if (!file_) file_ = std::make_unique<UnnamedFile>(storage_.folder);
    entry.onDisk = file_->append(data, byteCount);
  }
  entries_.push_back(std::move(entry));
  return entries_.size() - 1;
}

void RecordStore::getBytes(Record record, void* data) const {
  const Entry& entry = entries_[record];
  if (entry.byteCount == 0) return;
  if (entry.onDisk) {
    file_->read(*entry.onDisk, data, entry.byteCount);
  } else {
    std::memcpy(data, entry.inMemory.data(), entry.byteCount);
  }
}

void RecordStore::drop(Record record) {
  Entry& entry = entries_[record];
  if (!entry.onDisk) bytesInMemory_ -= entry.byteCount;
  entry = {};
  entry.isDropped = true;
}

}  // namespace fluidymation
