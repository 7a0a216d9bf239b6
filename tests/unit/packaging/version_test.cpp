// The version is told in two places that CMake does not write.

#include <gtest/gtest.h>

#include <string>

#include "fluidymation/core/version.h"
#include "support/temporary_folder.h"

namespace fluidymation {
namespace {

std::string textOf(const char* path) {
  const test::Bytes bytes = test::readBytes(path);
  return {bytes.begin(), bytes.end()};
}

TEST(Version, TheNewestChangesAreThoseOfThisVersion) {
  const std::string changes = textOf(FLUIDYMATION_CHANGELOG);
  const std::size_t heading = changes.find("\n## ");
  ASSERT_NE(heading, std::string::npos);
  EXPECT_EQ(changes.compare(heading, version().size() + 4, "\n## " + version()), 0)
      << changes.substr(heading, 40);
}

TEST(Version, ACitationNamesThisVersion) {
  EXPECT_NE(textOf(FLUIDYMATION_CITATION).find("\nversion: " + version() + "\n"),
            std::string::npos);
}

}  // namespace
}  // namespace fluidymation
