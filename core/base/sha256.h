// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace dewpoint::base {

/// SHA-256 checksum (FIPS 180-4) of bytes that are added in pieces. Used to detect whether two
/// contents are the same.
class Sha256 {
public:
  /// Adds bytes to the checksum.
  void add(std::string_view bytes);
  /// Returns the checksum of all bytes added so far, as 64 hexadecimal digits. Nothing may be added
  /// afterwards.
  std::string hexDigest();

private:
  static constexpr std::size_t kBlock = 64; ///< bytes

  void processBlock(const unsigned char* bytes);

  std::array<std::uint32_t, 8> state_{0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                      0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
  std::array<unsigned char, kBlock> waiting_{};
  std::size_t waitingBytes_ = 0;
  std::uint64_t allBytes_ = 0;
};

/// Returns the SHA-256 checksum of a string, as 64 hexadecimal digits.
std::string sha256(std::string_view text);
/// Returns the SHA-256 checksum of a file's content, which is read in pieces. Errors: FileMissing,
/// FileUnreadable.
Result<std::string> sha256OfFile(const std::filesystem::path& file);

} // namespace dewpoint::base
