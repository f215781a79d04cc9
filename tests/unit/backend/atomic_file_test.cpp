#include "backend/atomic_file.h"

#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

namespace arelem::backend {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class AtomicFileTest : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "arelem-atomic-XXXXXX").string();
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  static std::string content(const std::string& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
  }
  static void put(const std::string& file, const std::string& text) { std::ofstream(file) << text; }
  std::vector<std::string> entries() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_)) {
      names.push_back(entry.path().filename());
    }
    std::sort(names.begin(), names.end());
    return names;
  }
  static std::string refusal(const std::string& file) {
    auto created = AtomicFile::create(file);
    return created ? "created" : created.failure().message;
  }

  fs::path folder_;
};

TEST_F(AtomicFileTest, TheFileAppearsWithTheCommit) {
  auto file = AtomicFile::create(path("a.cls"));
  ASSERT_TRUE(file.ok());
  file->stream() << std::string(200000, 'x') << "end";
  EXPECT_FALSE(fs::exists(path("a.cls")));
  EXPECT_EQ(file->commit(), std::nullopt);
  EXPECT_EQ(content(path("a.cls")), std::string(200000, 'x') + "end");
  EXPECT_THAT(entries(), ::testing::ElementsAre("a.cls"));
}

TEST_F(AtomicFileTest, WithoutACommitNothingChanges) {
  put(path("a.cls"), "old");
  {
    auto file = AtomicFile::create(path("a.cls"));
    ASSERT_TRUE(file.ok());
    file->stream() << "new" << std::flush;
    EXPECT_EQ(entries().size(), 2U);
  }
  EXPECT_EQ(content(path("a.cls")), "old");
  EXPECT_THAT(entries(), ::testing::ElementsAre("a.cls"));
}

TEST_F(AtomicFileTest, ModeOfTheOlderFileIsKept) {
  put(path("a.cls"), "old");
  ASSERT_EQ(::chmod(path("a.cls").c_str(), 0640), 0);
  auto file = AtomicFile::create(path("a.cls"));
  ASSERT_TRUE(file.ok());
  EXPECT_EQ(file->commit(), std::nullopt);
  struct stat status {};
  ASSERT_EQ(::stat(path("a.cls").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777U, 0640U);
}

TEST_F(AtomicFileTest, AFullDiskLeavesTheOldFile) {
  put(path("a.cls"), "old");
  struct rlimit before {};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const struct rlimit small { 100000, before.rlim_max };
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  std::optional<Failure> failure;
  {
    auto file = AtomicFile::create(path("a.cls"));
    ASSERT_TRUE(file.ok());
    file->stream() << std::string(300000, 'x');
    EXPECT_FALSE(file->stream().good());
    failure = file->commit();
  }
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
  std::signal(SIGXFSZ, handler);
  ASSERT_TRUE(failure.has_value());
  EXPECT_THAT(failure->message, HasSubstr("failed after 100000 bytes: File too large"));
  EXPECT_EQ(content(path("a.cls")), "old");
  EXPECT_THAT(entries(), ::testing::ElementsAre("a.cls"));
}

TEST_F(AtomicFileTest, WhatIsNoFileIsRefused) {
  EXPECT_THAT(refusal(folder_.string()), HasSubstr("it is a folder"));
  EXPECT_THAT(refusal("/dev/zero"), HasSubstr("it is a device"));
  EXPECT_THAT(refusal(path("missing/a.cls")), HasSubstr("No such file or directory"));
  put(path("file"), "");
  EXPECT_THAT(refusal(path("file/a.cls")), HasSubstr("Not a directory"));
  fs::create_symlink("nowhere", path("dangling"));
  EXPECT_THAT(refusal(path("dangling")), HasSubstr("a symbolic link to nothing"));
  fs::create_symlink("loop", path("loop"));
  EXPECT_THAT(refusal(path("loop")), HasSubstr("symbolic links"));
  EXPECT_THAT(entries(), ::testing::ElementsAre("dangling", "file", "loop"));
}

TEST_F(AtomicFileTest, ProtectedFilesAndFoldersAreRefused) {
  if (::geteuid() == 0) {
    GTEST_SKIP() << "the superuser may write everywhere";
  }
  put(path("a.cls"), "old");
  ASSERT_EQ(::chmod(path("a.cls").c_str(), 0444), 0);
  EXPECT_THAT(refusal(path("a.cls")), HasSubstr("Permission denied"));
  ASSERT_EQ(::chmod(folder_.c_str(), 0555), 0);
  EXPECT_THAT(refusal(path("b.cls")), HasSubstr("Permission denied"));
  ASSERT_EQ(::chmod(folder_.c_str(), 0755), 0);
}

TEST_F(AtomicFileTest, ALinkKeepsPointing) {
  put(path("real.cls"), "old");
  fs::create_symlink("real.cls", path("link.cls"));
  auto file = AtomicFile::create(path("link.cls"));
  ASSERT_TRUE(file.ok());
  file->stream() << "new";
  EXPECT_EQ(file->commit(), std::nullopt);
  EXPECT_TRUE(fs::is_symlink(path("link.cls")));
  EXPECT_EQ(content(path("real.cls")), "new");
}

TEST_F(AtomicFileTest, DirectOutputs) {
  auto null = AtomicFile::create("/dev/null");
  ASSERT_TRUE(null.ok());
  null->stream() << "gone";
  EXPECT_EQ(null->commit(), std::nullopt);

  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  std::string received;
  std::thread reader([&] { received = content(path("pipe")); });
  auto fifo = AtomicFile::create(path("pipe"));
  ASSERT_TRUE(fifo.ok());
  fifo->stream() << "through the pipe";
  EXPECT_EQ(fifo->commit(), std::nullopt);
  reader.join();
  EXPECT_EQ(received, "through the pipe");
  EXPECT_THAT(entries(), ::testing::ElementsAre("pipe"));
}

TEST_F(AtomicFileTest, ALostReaderIsAFailure) {
  const auto handler = std::signal(SIGPIPE, SIG_IGN);
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  const int reader = ::open(path("pipe").c_str(), O_RDONLY | O_NONBLOCK);
  auto fifo = AtomicFile::create(path("pipe"));
  ASSERT_TRUE(fifo.ok());
  ::close(reader);
  fifo->stream() << "to nobody";
  const auto failure = fifo->commit();
  std::signal(SIGPIPE, handler);
  ASSERT_TRUE(failure.has_value());
  EXPECT_THAT(failure->message, HasSubstr("Broken pipe"));
}

TEST_F(AtomicFileTest, ManyWritersOfOneName) {
  std::vector<std::thread> writers;
  for (char letter = 'a'; letter < 'i'; ++letter) {
    writers.emplace_back([this, letter] {
      for (int i = 0; i < 20; ++i) {
        auto file = AtomicFile::create(path("same"));
        ASSERT_TRUE(file.ok());
        file->stream() << std::string(70000, letter);
        EXPECT_EQ(file->commit(), std::nullopt);
      }
    });
  }
  for (std::thread& writer : writers) {
    writer.join();
  }
  const std::string last = content(path("same"));
  EXPECT_EQ(last, std::string(70000, last.at(0)));
  EXPECT_THAT(entries(), ::testing::ElementsAre("same"));
}

TEST_F(AtomicFileTest, CompleteKeepsTheOldFileAndSuffixKeepsTheName) {
  put(path("a"), "old");
  auto file = AtomicFile::create(path("a"));
  ASSERT_TRUE(file.ok());
  file->stream() << "half";
  const auto bytes = file->complete();
  ASSERT_TRUE(bytes.ok());
  EXPECT_EQ(*bytes, 4U);
  EXPECT_EQ(content(path("a")), "old");
  EXPECT_EQ(file->commit(".partial"), std::nullopt);
  EXPECT_EQ(content(path("a")), "old");
  EXPECT_EQ(content(path("a.partial")), "half");
  EXPECT_THAT(entries(), ::testing::UnorderedElementsAre("a", "a.partial"));
}

TEST_F(AtomicFileTest, TemporariesCanBeRemovedFromOutside) {
  auto file = AtomicFile::create(path("a"));
  ASSERT_TRUE(file.ok());
  file->stream() << "half" << std::flush;
  EXPECT_EQ(entries().size(), 1U);
  AtomicFile::removeTemporaries();
  EXPECT_THAT(entries(), ::testing::IsEmpty());
  EXPECT_TRUE(file->commit().has_value());
}

TEST_F(AtomicFileTest, VeryLongNames) {
  const std::string name(255, 'n');
  auto file = AtomicFile::create(path(name));
  ASSERT_TRUE(file.ok());
  EXPECT_EQ(file->commit(), std::nullopt);
  EXPECT_THAT(entries(), ::testing::ElementsAre(name));
}

}  // namespace
}  // namespace arelem::backend
