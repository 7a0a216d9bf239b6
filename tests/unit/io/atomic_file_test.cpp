#include "fluidymation/io/atomic_file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <thread>

#include "fluidymation/core/error.h"
#include "support/privileges.h"
#include "support/temporary_folder.h"

namespace fluidymation {
namespace {

using test::bytesOf;
using test::messageOf;
using test::readBytes;
using test::TemporaryFolder;
using Names = std::vector<std::string>;

void writeText(const std::string& path, const std::string& text) {
  writeAtomically(path, [&](const ByteSink& sink) { sink(text.data(), text.size()); });
}

/// Files of this process may grow to `bytes` and no further: a disk that becomes full.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    getrlimit(RLIMIT_FSIZE, &before_);
    rlimit limit = before_;
    limit.rlim_cur = bytes;
    setrlimit(RLIMIT_FSIZE, &limit);
    handler_ = std::signal(SIGXFSZ, SIG_IGN);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;
  ~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  rlimit before_{};
  void (*handler_)(int) = SIG_DFL;
};

TEST(AtomicFile, WritesAndReplaces) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.txt");
  writeText(path, "one");
  writeText(path, "two");
  EXPECT_EQ(readBytes(path), bytesOf("two"));
  EXPECT_EQ(folder.names(), Names{"a.txt"});
}

// An empty list has no bytes to point at: undefined behaviour is reported here by its sanitizer.
TEST(AtomicFile, WritesEmptyFiles) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.txt");
  writeText(path, "one");
  writeAtomically(path, std::vector<std::uint8_t>{});
  EXPECT_TRUE(std::filesystem::exists(path));
  EXPECT_EQ(std::filesystem::file_size(path), 0U);
}

TEST(AtomicFile, ShowsNothingUnderItsNameBeforeTheEnd) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.txt");
  writeAtomically(path, [&](const ByteSink& sink) {
    sink("half", 4);
    EXPECT_FALSE(std::filesystem::exists(path));
    ASSERT_EQ(folder.names().size(), 1U);
    EXPECT_EQ(folder.names()[0][0], '.');
  });
  EXPECT_EQ(readBytes(path), bytesOf("half"));
}

TEST(AtomicFile, LeavesTheOlderFileWhenTheWriterThrows) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.txt");
  writeText(path, "old");
  EXPECT_THROW(writeAtomically(path,
                               [](const ByteSink& sink) {
                                 sink("new", 3);
                                 throw std::runtime_error("enough");
                               }),
               std::runtime_error);
  EXPECT_EQ(readBytes(path), bytesOf("old"));
  EXPECT_EQ(folder.names(), Names{"a.txt"});
}

TEST(AtomicFile, LeavesTheOlderFileWhenTheDiskIsFull) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.txt");
  writeText(path, "old");
  // Few bytes fail only when the buffer is flushed, many at once.
  for (const std::size_t size : {std::size_t{2000}, std::size_t{1000000}}) {
    std::string message;
    {
      const FileSizeLimit limit(1000);
      message = messageOf<Error>([&] { writeText(path, std::string(size, 'x')); });
    }
    EXPECT_EQ(message, path + ": cannot be written (File too large)");
    EXPECT_EQ(readBytes(path), bytesOf("old"));
    EXPECT_EQ(folder.names(), Names{"a.txt"});
  }
}

TEST(AtomicFile, NamesFileAndReasonWhenTheFolderIsMissingOrNoFolder) {
  const TemporaryFolder folder;
  writeText(folder.file("plain"), "x");
  EXPECT_EQ(messageOf<Error>([&] { writeText(folder.file("none/a.txt"), "x"); }),
            folder.file("none/a.txt") + ": cannot be written (No such file or directory)");
  EXPECT_EQ(messageOf<Error>([&] { writeText(folder.file("plain/a.txt"), "x"); }),
            folder.file("plain/a.txt") + ": cannot be written (Not a directory)");
  EXPECT_EQ(folder.names(), Names{"plain"});
}

TEST(AtomicFile, NamesFileAndReasonWhenTheFolderIsReadOnly) {
  const TemporaryFolder folder;
  std::filesystem::permissions(folder.path(), std::filesystem::perms::owner_write,
                               std::filesystem::perm_options::remove);
  test::giveAway(folder.path());
  // In a process of its own, which can stop being root.
  EXPECT_EXIT(
      {
        test::dropPrivileges();
        std::cerr << messageOf<Error>([&] { writeText(folder.file("a.txt"), "x"); }) << "\n"
                  << messageOf<Error>([&] { checkFolderCreatable(folder.path()); }) << "\n"
                  << messageOf<Error>([&] { checkFolderCreatable(folder.file("b/c")); }) << "\n";
        _exit(0);
      },
      ::testing::ExitedWithCode(0),
      "/a.txt: cannot be written \\(Permission denied\\)\n.*"
      ": files cannot be created in this folder \\(Permission denied\\)\n.*"
      "/b/c: the folder cannot be created \\(Permission denied\\)\n");
  std::filesystem::permissions(folder.path(), std::filesystem::perms::owner_all);
}

TEST(AtomicFile, ReplacesNeitherFoldersNorDevices) {
  const TemporaryFolder folder;
  EXPECT_EQ(messageOf<Error>([&] { writeText(folder.path(), "x"); }),
            folder.path() + ": cannot be written (it is a folder)");
  EXPECT_EQ(messageOf<Error>([&] { writeText("/dev/null", "x"); }),
            "/dev/null: cannot be written (it exists and is no regular file)");
}

TEST(AtomicFile, WritesTheLongestNames) {
  const TemporaryFolder folder;
  const std::string longest(255, 'n');
  writeText(folder.file(longest), "x");
  EXPECT_EQ(folder.names(), Names{longest});
}

TEST(AtomicFile, NewFilesHaveTheUsersPermissions) {
  const TemporaryFolder folder;
  const mode_t before = umask(027);
  writeText(folder.file("a"), "x");
  umask(before);
  EXPECT_EQ(std::filesystem::status(folder.file("a")).permissions(), std::filesystem::perms{0640});
}

TEST(AtomicFile, TemporaryFilesOfOthersStay) {
  // Of a run in another container, where the process numbers are the same.
  const TemporaryFolder folder;
  const std::string number = std::to_string(getpid());
  const Names others = {".a.tmp." + number, ".write-test.tmp." + number};
  for (const std::string& name : others) test::writeBytes(folder.file(name), bytesOf("theirs"));
  writeText(folder.file("a"), "x");
  checkFolderWritable(folder.path());
  EXPECT_EQ(folder.names(), (Names{others[0], others[1], "a"}));
  for (const std::string& name : others) EXPECT_EQ(readBytes(folder.file(name)), bytesOf("theirs"));
}

TEST(AtomicFile, WritersOfOneNameDoNotMeet) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a");
  writeAtomically(path, [&](const ByteSink& sink) {
    sink("first ", 6);
    writeText(path, "other");
    EXPECT_EQ(readBytes(path), bytesOf("other"));
    sink("second", 6);
  });
  EXPECT_EQ(readBytes(path), bytesOf("first second"));
  EXPECT_EQ(folder.names(), Names{"a"});
}

/// Writes `path` over and over, each time with `size` bytes of one letter.
void writeRepeatedly(const std::string& path, char letter, std::size_t size) {
  constexpr int kTimes = 40;
  for (int i = 0; i < kTimes; ++i) writeText(path, std::string(size, letter));
}

TEST(AtomicFile, ConcurrentWritersLeaveWholeFilesOnly) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a");
  const auto sizeOf = [](char letter) {
    return std::size_t{50000} + 10000U * static_cast<unsigned>(letter - 'a');
  };
  writeText(path, std::string(sizeOf('a'), 'a'));
  const pid_t child = fork();
  if (child == 0) {
    writeRepeatedly(path, 'a', sizeOf('a'));
    _exit(0);
  }
  std::atomic<int> running{2};
  std::vector<std::thread> writers;
  for (const char letter : {'b', 'c'}) {
    writers.emplace_back([&, letter] {
      writeRepeatedly(path, letter, sizeOf(letter));
      --running;
    });
  }
  while (running > 0) {
    const test::Bytes found = readBytes(path);
    ASSERT_FALSE(found.empty());
    const char letter = static_cast<char>(found.front());
    EXPECT_EQ(found, bytesOf(std::string(sizeOf(letter), letter)));
  }
  for (std::thread& writer : writers) writer.join();
  int status = -1;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0);
  EXPECT_EQ(folder.names(), Names{"a"});
}

TEST(CreateFolder, CreatesParentsAndAcceptsWhatExists) {
  const TemporaryFolder folder;
  for (const char* name : {"a/b/c", "a/b/c", "a/b/d/", "."}) {
    createFolder(folder.file(name));
    EXPECT_TRUE(std::filesystem::is_directory(folder.file(name)));
  }
}

TEST(CheckFolderCreatable, SaysTheSameAsCreatingWouldAndCreatesNothing) {
  const TemporaryFolder folder;
  writeText(folder.file("plain"), "x");
  for (const char* name : {"", "a", "a/b/", "a/../b"}) checkFolderCreatable(folder.file(name));
  EXPECT_EQ(messageOf<Error>([&] { checkFolderCreatable(folder.file("plain")); }),
            folder.file("plain") + ": the folder cannot be created (it exists and is no folder)");
  EXPECT_EQ(messageOf<Error>([&] { checkFolderCreatable(folder.file("plain/a")); }),
            folder.file("plain/a") + ": the folder cannot be created (Not a directory)");
  checkFolderCreatable("relative");
  EXPECT_EQ(folder.names(), Names{"plain"});
}

TEST(CreateFolder, NamesTheFolderThatCannotBe) {
  const TemporaryFolder folder;
  writeText(folder.file("plain"), "x");
  EXPECT_EQ(messageOf<Error>([&] {
              createFolder(folder.file("plain"));
            }).find(folder.file("plain") + ": the folder cannot be created ("),
            0U);
  EXPECT_EQ(messageOf<Error>([&] { createFolder(folder.file("plain/a")); }),
            folder.file("plain/a") + ": the folder cannot be created (Not a directory)");
}

TEST(AtomicFileLeftovers, AreKnownByTheirNames) {
  const std::string letters = "abcdefghijklmnop";
  EXPECT_EQ(temporaryFileOf(".a.png.tmp." + letters), "a.png");
  EXPECT_EQ(temporaryFileOf(".a.tmp.b.tmp." + letters), "a.tmp.b");
  for (const std::string& other :
       {std::string(), "a.png.tmp." + letters, ".a.png.tmp." + letters.substr(1),
        ".a.png.tmp.q" + letters.substr(1), "..tmp." + letters.substr(1), ".tmp." + letters,
        std::string(".a.png")}) {
    EXPECT_FALSE(temporaryFileOf(other).has_value()) << other;
  }
}

TEST(AtomicFileLeftovers, AreRemovedWhereTheyAreOurs) {
  const TemporaryFolder folder;
  const std::string letters = "aaaabbbbccccdddd";
  for (const std::string& name : {".a.png.tmp." + letters, ".b.png.tmp." + letters,
                                  ".write-test.tmp." + letters, std::string("a.png")}) {
    test::writeBytes(folder.file(name), bytesOf("half"));
  }
  EXPECT_EQ(removeLeftovers(folder.path(), [](const std::string& name) { return name == "a.png"; }),
            2);
  EXPECT_EQ(folder.names(), (Names{".b.png.tmp." + letters, "a.png"}));
  EXPECT_EQ(removeLeftovers(folder.file("none"), [](const std::string&) { return true; }), 0);
}

}  // namespace
}  // namespace fluidymation
