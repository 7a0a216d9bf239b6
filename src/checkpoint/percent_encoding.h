#pragma once

#include <optional>
#include <string>

namespace fluidymation {

/// Any bytes as ASCII: letters, digits and ".-_/" as they are, all others as "%FF".
[[nodiscard]] std::string percentEncoded(const std::string& bytes);

/// The reverse; nothing for what `percentEncoded` does not write.
[[nodiscard]] std::optional<std::string> percentDecoded(const std::string& text);

}  // namespace fluidymation
