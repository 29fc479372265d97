// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/box_muller.h"
#include "core/base/philox.h"
#include "core/base/random.h"
#include "core/base/vector_kernel.h"

#include <algorithm>

namespace dewpoint {

/// Random numbers in blocks: first the words of a block, then what is made of them.
struct RandomBatch {
  static constexpr int kBlock = 256;

  struct Words {
    std::uint32_t word[4][kBlock];
  };

  DEWPOINT_KERNEL void draw(const RandomStream& stream, std::uint32_t firstIndex, int count,
                            Words& words) {
    const std::uint32_t iteration = stream.iteration_;
    const std::uint32_t frame = stream.frame_;
    const std::uint32_t purpose = stream.purpose_ << 24U;
    const std::uint32_t key0 = stream.key_[0];
    const std::uint32_t key1 = stream.key_[1];
    for (int i = 0; i < count; ++i) {
      std::uint32_t c0 = firstIndex + static_cast<std::uint32_t>(i);
      std::uint32_t c1 = iteration;
      std::uint32_t c2 = frame;
      std::uint32_t c3 = purpose;
      Philox::mix(c0, c1, c2, c3, key0, key1);
      words.word[0][i] = c0;
      words.word[1][i] = c1;
      words.word[2][i] = c2;
      words.word[3][i] = c3;
    }
  }

  struct Uniforms {
    DEWPOINT_KERNEL void run(const RandomStream* stream, std::uint32_t firstIndex,
                             std::int64_t total, double* __restrict out) {
      alignas(64) Words words;
      for (std::int64_t begin = 0; begin < total; begin += kBlock) {
        const int count = static_cast<int>(std::min<std::int64_t>(kBlock, total - begin));
        draw(*stream, firstIndex + static_cast<std::uint32_t>(begin), count, words);
        for (int i = 0; i < count; ++i) {
          // 53 bits in two exact parts.
          const double high = words.word[0][i];
          const double low = words.word[1][i] >> 11U;
          out[begin + i] = high * 0x1.0p-32 + low * 0x1.0p-53;
        }
      }
    }
  };

  struct Normals {
    DEWPOINT_KERNEL void run(const RandomStream* stream, std::uint32_t firstIndex,
                             std::int64_t total, double* __restrict first,
                             double* __restrict second, double* __restrict third) {
      alignas(64) Words words;
      for (std::int64_t begin = 0; begin < total; begin += kBlock) {
        const int count = static_cast<int>(std::min<std::int64_t>(kBlock, total - begin));
        draw(*stream, firstIndex + static_cast<std::uint32_t>(begin), count, words);
        for (int i = 0; i < count; ++i) {
          const NormalPair pair = boxMuller(words.word[0][i], words.word[1][i]);
          first[begin + i] = pair.first;
          second[begin + i] = pair.second;
        }
        for (int i = 0; i < count; ++i) {
          third[begin + i] = boxMuller(words.word[2][i], words.word[3][i]).first;
        }
      }
    }
  };
};

void RandomStream::uniforms(std::uint32_t firstIndex, std::int64_t count, double* out) const {
  runKernel<RandomBatch::Uniforms>(this, firstIndex, count, out);
}

void RandomStream::normals(std::uint32_t firstIndex, std::int64_t count,
                           const std::array<double*, 3>& columns) const {
  runKernel<RandomBatch::Normals>(this, firstIndex, count, columns[0], columns[1], columns[2]);
}

} // namespace dewpoint
