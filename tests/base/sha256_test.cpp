// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/sha256.h"
#include "core/base/text_file.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

TEST(Sha256, HasTheValuesOfTheStandard) {
  // FIPS 180-2, appendix B, and the empty message.
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256(std::string(1000000, 'a')),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, PiecesMakeNoDifference) {
  std::string text;
  for (int k = 0; k < 300; ++k) {
    text += static_cast<char>(k);
  }
  for (const std::size_t piece : {1U, 7U, 55U, 56U, 63U, 64U, 65U, 128U}) {
    Sha256 sum;
    for (std::size_t at = 0; at < text.size(); at += piece) {
      sum.add(std::string_view(text).substr(at, piece));
    }
    EXPECT_EQ(sum.hexDigest(), sha256(text)) << piece;
  }
}

TEST(Sha256, OfAFileIsThatOfItsContent) {
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "sha256.txt";
  ASSERT_TRUE(writeTextFile(file, "abc"));
  EXPECT_EQ(sha256OfFile(file), sha256("abc"));
  std::filesystem::remove(file);
  const auto missing = sha256OfFile(file);
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, ErrorCode::FileMissing);
}

} // namespace
} // namespace dewpoint::tests
