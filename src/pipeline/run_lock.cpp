#include "pipeline/run_lock.h"

#include <unistd.h>

#include <filesystem>
#include <system_error>

#include "fluidymation/io/atomic_file.h"

namespace fluidymation {

RunLock::~RunLock() {
  const bool wasTaken = lock_.has_value();
  lock_.reset();
  if (wasTaken) rmdir(files_.hiddenFolder().c_str());  // fails where something is in it
}

void RunLock::takeIfUsed() {
  std::error_code ignored;
  if (std::filesystem::is_directory(files_.hiddenFolder(), ignored)) lock();
}

std::string RunLock::take() {
  createFolder(files_.hiddenFolder());
  if (!lock_) lock();
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

void RunLock::lock() { lock_.emplace(files_.lock(), "painting " + files_.pattern()); }

}  // namespace fluidymation
