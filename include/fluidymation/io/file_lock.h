#pragma once

#include <string>

namespace fluidymation {

/// Holds a lock file, so that no second run works where this one does. The system frees the lock
/// when the process ends, however it ends; the file then stays and tells of who held it.
class FileLock {
 public:
  /// Takes the lock; the file is created where it is missing, in a folder that exists.
  /// @param work  what only one run may do at a time, for the message: "painting out/%05d.png".
  /// @throws Error naming the file, and the process and host that hold it, when another run has it.
  FileLock(std::string path, const std::string& work);
  FileLock(FileLock&& other) noexcept;
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;
  FileLock& operator=(FileLock&&) = delete;

  /// Removes the file and frees the lock.
  ~FileLock();

  /// Whether it is held; not on a file system that knows no locks.
  [[nodiscard]] bool isHeld() const { return held_; }

  /// "process 4711 on host render7": who held it last and did not free it. Empty where everybody
  /// did.
  [[nodiscard]] const std::string& abandonedBy() const { return abandonedBy_; }

 private:
  std::string path_;
  int descriptor_ = -1;
  bool held_ = false;
  std::string abandonedBy_;
};

}  // namespace fluidymation
