#pragma once

#include <optional>
#include <string>
#include <utility>

#include "checkpoint/run_files.h"
#include "fluidymation/io/file_lock.h"

namespace fluidymation {

/// Holds what only one run may: the frames of a pattern and what is kept beside them.
class RunLock {
 public:
  explicit RunLock(RunFiles files) : files_(std::move(files)) {}
  RunLock(const RunLock&) = delete;
  RunLock& operator=(const RunLock&) = delete;
  /// Frees the lock. A hidden folder with nothing in it goes where this run has made it or has
  /// painted all it wanted; one that was found stays as a run before has left it.
  ~RunLock();

  /// Takes the lock where another run may have been before, and creates nothing elsewhere.
  /// @throws Error naming process and host of the run that holds it.
  void takeIfUsed();

  /// Takes the lock unless it is held, creates the hidden folder, and removes what runs that were
  /// killed have left half written. @throws Error likewise.
  /// Also where the lock was free before and another run has left states meanwhile: nobody has
  /// decided what becomes of them.
  /// @return  one sentence for the user where such a run was found; else empty.
  [[nodiscard]] std::string take();

  /// Whether frames are at work. A run that ends while they are leaves the hidden folder even where
  /// it could not save anything in it: the next one sees from it that these frames are no pictures
  /// of somebody else's.
  void setUnfinished(bool unfinished) { removesFolder_ = !unfinished; }

 private:
  /// @return  whether the folder is there: the run that made it may just have removed it.
  bool lockIfThere();

  RunFiles files_;
  std::optional<FileLock> lock_;
  bool removesFolder_ = false;
};

}  // namespace fluidymation
