#include "pipeline/run_lock.h"

#include <unistd.h>

#include <filesystem>
#include <system_error>

#include "fluidymation/core/error.h"
#include "fluidymation/io/atomic_file.h"

namespace fluidymation {

RunLock::~RunLock() {
  const bool wasTaken = lock_.has_value();
  lock_.reset();
  if (wasTaken && removesFolder_) {
    rmdir(files_.hiddenFolder().c_str());  // fails where something is in it
  }
}

void RunLock::takeIfUsed() {
  std::error_code ignored;
  if (std::filesystem::is_directory(files_.hiddenFolder(), ignored)) lockIfThere();
}

std::string RunLock::take() {
  const bool isFresh = !lock_;
  if (isFresh) removesFolder_ = true;
  do createFolder(files_.hiddenFolder());
  while (!lock_ && !lockIfThere());
  if (isFresh && !files_.states().empty()) {
    throw Error(files_.hiddenFolder() +
                ": another run has left a state while this one began; wanted another try");
  }
  if (!lock_->isHeld()) {
    return files_.lock() +
           ": this file system has no locks; see to it that no other run paints "
           "these frames";
  }
  removeLeftovers(files_.folder(),
                  [&](const std::string& name) { return files_.isFrameOrManifest(name); });
  removeLeftovers(files_.hiddenFolder(),
                  [&](const std::string& name) { return files_.isHidden(name); });
  if (lock_->abandonedBy().empty()) return "";
  return files_.lock() + ": taken over from " + lock_->abandonedBy() + ", which is gone";
}

bool RunLock::lockIfThere() {
  try {
    lock_.emplace(files_.lock(), "painting " + files_.pattern());
  } catch (const Error&) {
    std::error_code ignored;
    if (std::filesystem::exists(files_.hiddenFolder(), ignored)) throw;
    return false;
  }
  return true;
}

}  // namespace fluidymation
