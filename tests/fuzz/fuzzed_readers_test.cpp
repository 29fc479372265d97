// SPDX-License-Identifier: GPL-3.0-or-later
// The short run of the fuzzers: every input of the corpus, and changed ones. A reader that does not
// return ends this program; its input is last-<reader> in /dev/shm/dewpoint-fuzz-<process> then.
// The long runs are script/fuzz.
#include "tests/fuzz/fuzzed_readers.h"
#include "tests/fuzz/input_file.h"
#include "tests/fuzz/mutation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace dewpoint::tests {
namespace {

namespace fs = std::filesystem;

/// Changed inputs of each reader: some seconds for all. The environment variable
/// DEWPOINT_FUZZ_INPUTS asks for others, where there is no Clang.
constexpr std::size_t kUsualInputs = 500;
constexpr std::uint64_t kSeed = 22;

std::size_t inputsWanted() {
  const char* wanted = std::getenv("DEWPOINT_FUZZ_INPUTS");
  return wanted != nullptr ? std::strtoull(wanted, nullptr, 10) : kUsualInputs;
}

fs::path corpusOf(const std::string& reader) {
  return fs::path(DEWPOINT_SOURCE_DIR) / "tests" / "fuzz" / "corpus" / reader;
}

std::string bytesOf(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

class FuzzedReaders : public testing::TestWithParam<FuzzedReader> {};

TEST_P(FuzzedReaders, ReturnWhateverTheBytesAre) {
  const FuzzedReader reader = GetParam();
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(corpusOf(reader.name))) {
    files.push_back(entry.path());
  }
  std::ranges::sort(files);
  ASSERT_FALSE(files.empty());
  std::vector<std::string> corpus;
  for (const fs::path& file : files) {
    SCOPED_TRACE(file.string());
    corpus.push_back(bytesOf(file));
    reader.read(corpus.back());
  }
  const InputFile last(std::string("last-") + reader.name); // stays when the process ends early
  Mutation mutation(corpus, kSeed);
  for (std::size_t input = inputsWanted(); input > 0; --input) {
    const std::string bytes = mutation.next();
    (void)last.hold(bytes);
    reader.read(bytes);
  }
}

INSTANTIATE_TEST_SUITE_P(All, FuzzedReaders,
                         testing::ValuesIn(fuzzedReaders().begin(), fuzzedReaders().end()),
                         [](const auto& tested) {
                           std::string name = tested.param.name;
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

TEST(Mutation, IsTheSameForTheSameSeed) {
  const std::vector<std::string> corpus{"a = 1\n", "", "b = [2.5, 3]\n"};
  Mutation one(corpus, 7);
  Mutation same(corpus, 7);
  Mutation other(corpus, 8);
  bool differs = false;
  for (int k = 0; k < 100; ++k) {
    const std::string input = one.next();
    EXPECT_EQ(input, same.next());
    differs = differs || input != other.next();
  }
  EXPECT_TRUE(differs);
}

} // namespace
} // namespace dewpoint::tests
