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

/// The SHA-256 checksum of bytes that come in pieces (FIPS 180-4): tells whether contents are the
/// same.
class Sha256 {
public:
  void add(std::string_view bytes);
  /// 64 hexadecimal digits of all that was added. Nothing may be added after it.
  std::string text();

private:
  static constexpr std::size_t kBlock = 64; ///< bytes

  void takeBlock(const unsigned char* bytes);

  std::array<std::uint32_t, 8> state_{0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                      0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
  std::array<unsigned char, kBlock> waiting_{};
  std::size_t waitingBytes_ = 0;
  std::uint64_t allBytes_ = 0;
};

/// Of a text.
std::string sha256(std::string_view text);
/// Of a file's content, read in pieces: FileMissing or FileUnreadable.
Result<std::string> sha256OfFile(const std::filesystem::path& file);

} // namespace dewpoint::base
