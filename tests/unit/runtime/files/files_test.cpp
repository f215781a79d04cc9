// Data files never lead out of their folders.
#include "runtime/files/files.h"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

namespace arelem::files {
namespace {

namespace fs = std::filesystem;

class FilesTest : public testing::Test {
 protected:
  void SetUp() override {
    root_ = fs::path(testing::TempDir()) /
            testing::UnitTest::GetInstance()->current_test_info()->name();
    fs::remove_all(root_);
    fs::create_directories(root_ / "job" / "sub");
    std::ofstream(root_ / "job" / "a.txt") << "first";
    std::ofstream(root_ / "job" / "sub" / "b.txt") << "second";
    std::ofstream(root_ / "secret.txt") << "secret";
    fs::create_symlink(root_ / "secret.txt", root_ / "job" / "link.txt");
    files_.folders = {(root_ / "job").string()};
  }
  void TearDown() override { fs::remove_all(root_); }

  std::string codeOf(std::string_view name) {
    const Result<std::string> text = read(files_, name);
    return text ? "" : std::string(text.failure().row->code);
  }

  fs::path root_;
  Files files_;
};

TEST_F(FilesTest, ReadsBesideTheProgramAndBelow) {
  EXPECT_EQ(*read(files_, "a.txt"), "first");
  EXPECT_EQ(*read(files_, "sub/b.txt"), "second");
  EXPECT_EQ(*read(files_, "sub/../a.txt"), "first");
}

TEST_F(FilesTest, LooksInTheFoldersInOrder) {
  files_.folders = {(root_ / "job" / "sub").string(), (root_ / "job").string()};
  EXPECT_EQ(*read(files_, "a.txt"), "first");
}

TEST_F(FilesTest, RefusesNamesThatLeadOut) {
  EXPECT_EQ(codeOf("../secret.txt"), "E0730");
  EXPECT_EQ(codeOf("link.txt"), "E0730");
  EXPECT_EQ(codeOf((root_ / "job" / "a.txt").string()), "E0730");
  EXPECT_EQ(codeOf(""), "E0730");
}

TEST_F(FilesTest, TellsWhatIsMissingOrTooLarge) {
  EXPECT_EQ(codeOf("none.txt"), "E0731");
  EXPECT_EQ(codeOf("sub"), "E0731");
  files_.largest = 4;
  EXPECT_EQ(codeOf("a.txt"), "E0732");
}

}  // namespace
}  // namespace arelem::files
