#include "pipeline/fault_list.h"

#include <algorithm>

#include "fluidymation/core/error.h"

namespace fluidymation {

bool FaultList::gather(const std::function<void()>& step) {
  try {
    step();
    return true;
  } catch (const Error&) {
    addCurrent();
    return false;
  }
}

bool FaultList::gatherUnlessMisused(const std::function<void()>& step) {
  try {
    step();
    return true;
  } catch (const UsageError&) {
    throw;
  } catch (const Error&) {
    addCurrent();
    return false;
  }
}

std::vector<std::string> FaultList::lines() const {
  std::vector<std::string> lines = messages_;
  if (unlisted_ > 0) lines.push_back("... and " + std::to_string(unlisted_) + " more");
  return lines;
}

void FaultList::throwIfAny() const {
  if (!empty()) throw Faults(lines());
}

void FaultList::addCurrent() {
  try {
    throw;
  } catch (const Faults& faults) {
    for (const std::string& line : faults.lines()) add(line);
  } catch (const Error& error) {
    add(error.what());
  }
}

void FaultList::add(const std::string& message) {
  if (std::find(messages_.begin(), messages_.end(), message) != messages_.end()) return;
  if (messages_.size() < most_) {
    messages_.push_back(message);
  } else {
    ++unlisted_;
  }
}

}  // namespace fluidymation
