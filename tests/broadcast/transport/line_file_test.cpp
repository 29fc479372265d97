// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text_file.h"
#include "core/broadcast/transport/line_file.h"
#include "tests/broadcast/test_socket.h"

#include <gtest/gtest.h>

#include <array>
#include <fcntl.h>
#include <filesystem>
#include <string>
#include <sys/stat.h>

namespace dewpoint::tests {
namespace {

using broadcast::FileDescriptor;
using broadcast::LineFile;

std::filesystem::path lineFileNamed(const std::string& name) {
  const auto file = std::filesystem::path(testing::TempDir()) / ("line_file_" + name);
  std::filesystem::remove(file);
  return file;
}

std::string textIn(const FileDescriptor& pipe) {
  std::array<char, 65536> bytes;
  const auto count = ::read(pipe.number(), bytes.data(), bytes.size());
  return std::string(bytes.data(), count > 0 ? static_cast<std::size_t>(count) : 0);
}

TEST(LineFile, WritesAFileFromItsBeginning) {
  const auto path = lineFileNamed("plain.csv");
  ASSERT_TRUE(writeTextFile(path, "of an earlier run\n"));
  auto file = LineFile::open(path);
  ASSERT_TRUE(file);
  (*file)->setPreamble("header\n");
  (*file)->send({"a\n", "b\n"});
  (*file)->send({"c\n"});
  EXPECT_EQ(readTextFile(path).value_or(""), "header\na\nb\nc\n");
  EXPECT_EQ((*file)->report().sentPieceCount, 4);
}

TEST(LineFile, AFileThatCannotBeWrittenIsReported) {
  const auto file = LineFile::open("/nowhere/at/all.csv");
  ASSERT_FALSE(file);
  EXPECT_EQ(file.error().code, ErrorCode::FileUnwritable);
}

TEST(LineFile, APipeWaitsForNobodyAndGreetsEachReader) {
  const auto path = lineFileNamed("pipe");
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  auto file = LineFile::open(path);
  ASSERT_TRUE(file);
  (*file)->setPreamble("header\n");
  (*file)->send({"lost\n"}); // nobody reads it
  EXPECT_EQ((*file)->report().clientCount, 0);
  EXPECT_TRUE((*file)->report().hasNoReader);
  for (int reader = 0; reader < 2; ++reader) {
    FileDescriptor pipe(::open(path.c_str(), O_RDONLY | O_NONBLOCK));
    (*file)->send({"a\n"});
    EXPECT_EQ(textIn(pipe), "header\na\n");
    EXPECT_EQ((*file)->report().clientCount, 1);
    EXPECT_FALSE((*file)->report().hasNoReader);
    pipe.close();
    (*file)->send({"b\n"}); // the reader has gone: no signal ends the program
    EXPECT_EQ((*file)->report().clientCount, 0);
    EXPECT_TRUE((*file)->report().hasNoReader);
    EXPECT_EQ((*file)->report().problem, "");
  }
}

TEST(LineFile, AFullPipeLosesWholeLines) {
  const auto path = lineFileNamed("full");
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  auto file = LineFile::open(path);
  ASSERT_TRUE(file);
  const FileDescriptor pipe(::open(path.c_str(), O_RDONLY | O_NONBLOCK));
  const std::string line = std::string(999, 'x') + "\n";
  for (int k = 0; k < 500; ++k) {
    (*file)->send({line});
  }
  EXPECT_GT((*file)->report().droppedPieceCount, 300);
  std::string all;
  for (std::string more = textIn(pipe); !more.empty(); more = textIn(pipe)) {
    all += more;
  }
  EXPECT_EQ(all.size() % line.size(), 0U);
  EXPECT_EQ(all.size() / line.size(), static_cast<std::size_t>((*file)->report().sentPieceCount));
}

} // namespace
} // namespace dewpoint::tests
