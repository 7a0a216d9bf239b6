#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace fluidymation {

/// Gathers what is wrong with several things, so that the user sees it all at once; each message
/// once, in the order of their coming.
class FaultList {
 public:
  /// @param most  of messages that are kept; those beyond are counted only.
  explicit FaultList(std::size_t most = std::numeric_limits<std::size_t>::max()) : most_(most) {}

  /// Does a step; its Error or Faults are gathered, UsageErrors too.
  /// @return  whether it had none.
  bool gather(const std::function<void()>& step);

  /// The same for a step where what is wrong with the options ends everything.
  /// @throws UsageError of the step.
  bool gatherUnlessMisused(const std::function<void()>& step);

  [[nodiscard]] bool empty() const { return messages_.empty(); }

  /// The messages; "... and 7 more" is the last one where some were counted only.
  [[nodiscard]] std::vector<std::string> lines() const;

  /// @throws Faults where there are some.
  void throwIfAny() const;

 private:
  /// The exception that is being handled.
  void addCurrent();
  void add(const std::string& message);

  std::size_t most_;
  std::vector<std::string> messages_;
  std::size_t unlisted_ = 0;
};

}  // namespace fluidymation
