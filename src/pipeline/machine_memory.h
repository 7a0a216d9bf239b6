#pragma once

#include <cstdint>
#include <string>

namespace fluidymation {

/// Bytes of memory that this process may use at most: those of the machine, or of its control
/// groups (cgroup v2 and v1, Linux) where that is less.
[[nodiscard]] std::int64_t machineMemoryBytes();

/// The least limit of the control groups that a process is in and of those above them.
/// @param processGroups  as /proc/self/cgroup has it: lines "ID:CONTROLLERS:PATH".
/// @param root  where the groups' files lie, /sys/fs/cgroup.
/// @return  the largest number there is where no group has a limit or none can be read.
[[nodiscard]] std::int64_t groupMemoryBytes(const std::string& processGroups,
                                            const std::string& root);

}  // namespace fluidymation
