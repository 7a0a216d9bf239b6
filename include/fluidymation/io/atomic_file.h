#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace fluidymation {

/// Accepts bytes of the file being written; throws Error when the disk does not.
using ByteSink = std::function<void(const void* data, std::size_t byteCount)>;

/// Creates or replaces `path` as one step: `write` fills a temporary file in the same folder, which
/// is flushed to disk and renamed. When anything fails the temporary file is removed and an
/// older `path` stays as it was. A process that is killed meanwhile leaves the temporary file
/// behind, as .NAME.tmp.LETTERS: hidden, and nobody else's, because the letters are random. Any
/// number of writers may write `path` at a time: the last one to finish wins.
/// @throws Error naming `path` and the system's reason; whatever `write` throws.
void writeAtomically(const std::string& path, const std::function<void(const ByteSink&)>& write);

/// The same for a file that is in memory already.
void writeAtomically(const std::string& path, const std::vector<std::uint8_t>& file);

/// Makes sure that `path` is free or an ordinary file, and a name that the file system takes,
/// before any work is done. @throws Error naming `path` and the reason.
void checkReplaceable(const std::string& path);

/// Makes sure, as far as that can be told without trying, that `folder` can be created and written:
/// that the nearest folder on the way that exists is one, and may be written by this user.
/// @throws Error naming the folder and the reason, as the two functions below would.
void checkFolderCreatable(const std::string& folder);

/// Creates `folder` and its parents where missing. @throws Error naming the folder.
void createFolder(const std::string& folder);

/// Makes sure that files can be created in `folder`, before any work is done.
/// @throws Error naming the folder and the system's reason.
void checkFolderWritable(const std::string& folder);

}  // namespace fluidymation
