// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/sha256.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <fstream>
#include <vector>

namespace dewpoint::base {
namespace {

/// Fractional parts of the cube roots of the first 64 primes (FIPS 180-4, section 4.2.2).
constexpr std::array<std::uint32_t, 64> kSha256Rounds{
    0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5,
    0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174,
    0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da,
    0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967,
    0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85,
    0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070,
    0x19a4c116, 0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
    0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2};

} // namespace

void Sha256::add(std::string_view bytes) {
  allBytes_ += bytes.size();
  while (!bytes.empty()) {
    const std::size_t taken = std::min(kBlock - waitingBytes_, bytes.size());
    std::memcpy(waiting_.data() + waitingBytes_, bytes.data(), taken);
    waitingBytes_ += taken;
    bytes.remove_prefix(taken);
    if (waitingBytes_ == kBlock) {
      processBlock(waiting_.data());
      waitingBytes_ = 0;
    }
  }
}

std::string Sha256::hexDigest() {
  const std::uint64_t bits = 8 * allBytes_;
  // A one, zeros up to the last eight bytes of a block, and there the length in bits.
  std::string end(1 + (kBlock + kBlock - 9 - waitingBytes_) % kBlock, '\0');
  end.front() = static_cast<char>(0x80);
  for (int shift = 56; shift >= 0; shift -= 8) {
    end += static_cast<char>((bits >> shift) & 0xffU);
  }
  add(end);
  std::string text;
  for (const std::uint32_t word : state_) {
    text += fmt::format("{:08x}", word);
  }
  return text;
}

void Sha256::processBlock(const unsigned char* bytes) {
  std::array<std::uint32_t, 64> w{};
  for (std::size_t k = 0; k < 16; ++k) {
    for (std::size_t byte = 0; byte < 4; ++byte) {
      w[k] = (w[k] << 8U) | bytes[4 * k + byte];
    }
  }
  for (std::size_t k = 16; k < w.size(); ++k) {
    const std::uint32_t s0 = std::rotr(w[k - 15], 7) ^ std::rotr(w[k - 15], 18) ^ (w[k - 15] >> 3U);
    const std::uint32_t s1 = std::rotr(w[k - 2], 17) ^ std::rotr(w[k - 2], 19) ^ (w[k - 2] >> 10U);
    w[k] = w[k - 16] + s0 + w[k - 7] + s1;
  }
  auto [a, b, c, d, e, f, g, h] = state_;
  for (std::size_t k = 0; k < w.size(); ++k) {
    const std::uint32_t s1 = std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25);
    const std::uint32_t one = h + s1 + ((e & f) ^ (~e & g)) + kSha256Rounds[k] + w[k];
    const std::uint32_t s0 = std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22);
    const std::uint32_t two = s0 + ((a & b) ^ (a & c) ^ (b & c));
    h = g;
    g = f;
    f = e;
    e = d + one;
    d = c;
    c = b;
    b = a;
    a = one + two;
  }
  const std::array<std::uint32_t, 8> added{a, b, c, d, e, f, g, h};
  for (std::size_t k = 0; k < state_.size(); ++k) {
    state_[k] += added[k];
  }
}

std::string sha256(std::string_view text) {
  Sha256 sum;
  sum.add(text);
  return sum.hexDigest();
}

Result<std::string> sha256OfFile(const std::filesystem::path& file) {
  std::error_code problem;
  if (!std::filesystem::exists(file, problem)) {
    return failure(ErrorCode::FileMissing, file.string(), "", "");
  }
  std::ifstream stream(file, std::ios::binary);
  Sha256 sum;
  std::vector<char> piece(1U << 20U);
  while (stream) {
    stream.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    sum.add({piece.data(), static_cast<std::size_t>(stream.gcount())});
  }
  if (!stream.eof()) {
    return failure(ErrorCode::FileUnreadable, file.string(), "", "");
  }
  return sum.hexDigest();
}

} // namespace dewpoint::base
