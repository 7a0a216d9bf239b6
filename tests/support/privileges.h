#pragma once

#include <string>

namespace fluidymation::test {

/// Whether this process may read and write what its permissions forbid.
[[nodiscard]] bool mayDoEverything();

/// Gives `folder` and all it holds to the user that `dropPrivileges` becomes; nothing where this
/// process is not root.
void giveAway(const std::string& folder);

/// Becomes an ordinary user where this process is root; only in a process of the test's own, since
/// there is no way back. Ends the process when that is refused.
void dropPrivileges();

}  // namespace fluidymation::test
