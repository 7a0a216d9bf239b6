#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace fluidymation {

/// Accepts bytes of the file being written; throws Error when the disk does not.
using ByteSink = std::function<void(const void* data, std::size_t byteCount)>;

/// Creates or replaces `path` as one step: `write` fills a temporary file in the same folder, which
/// is flushed to disk and renamed, and then the folder is flushed. When anything fails the
/// temporary file is removed and an older `path` stays as it was. A process that is killed
/// meanwhile leaves the temporary file behind, as .NAME.tmp.LETTERS: hidden, and nobody else's,
/// because the letters are random. Any number of writers may write `path` at a time: the last one
/// to finish wins.
/// @throws Error naming `path` and the system's reason; whatever `write` throws.
void writeAtomically(const std::string& path, const std::function<void(const ByteSink&)>& write);

/// The same for a file that is in memory already.
void writeAtomically(const std::string& path, const std::vector<std::uint8_t>& file);

/// The same where another program writes: `write` gets the name of the temporary file, which exists
/// and is empty, and has it filled.
void replaceAtomically(const std::string& path,
                       const std::function<void(const std::string& temporary)>& write);

/// Appends a line to a file of lines that is there, and flushes it to disk. A process that is
/// killed meanwhile may leave a part of the line: readers must not count one without its end.
/// @throws Error naming `path` and the system's reason.
void appendLine(const std::string& path, const std::string& line);

/// The file that a temporary one of `writeAtomically` would have become: "a.png" for
/// ".a.png.tmp.LETTERS"; nothing for any other name. Both are names without a folder. Of names that
/// are longer than 200 bytes only these 200.
[[nodiscard]] std::optional<std::string> temporaryFileOf(const std::string& name);

/// Removes temporary files that a killed process has left in `folder`: those of files of which
/// `isOurs(name)` holds, and those of `checkFolderWritable`. Nobody else may be writing such files.
/// What cannot be listed or removed stays.
/// @return  how many were removed.
int removeLeftovers(const std::string& folder,
                    const std::function<bool(const std::string& name)>& isOurs);

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
