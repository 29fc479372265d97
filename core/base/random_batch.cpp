// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/box_muller.h"
#include "core/base/instruction_set.h"
#include "core/base/philox.h"
#include "core/base/random.h"
#include "core/base/vector_kernel.h"

#include <algorithm>

namespace dewpoint::base {

/// Random numbers in blocks: first the words of a block, then what is made of them.
struct RandomBatch {
  static constexpr int kBlock = 256;

  struct Words {
    std::uint32_t word[4][kBlock];
  };

  /// `Word` is what vector units mix fastest: see Philox.
  template <class Word>
  DEWPOINT_KERNEL void draw(const RandomStream& stream, std::uint32_t firstIndex, int count,
                            Words& words, std::uint32_t block = 0) {
    const std::uint32_t iteration = stream.iteration_;
    const std::uint32_t frame = stream.frame_;
    const std::uint32_t purpose = (stream.purpose_ << 24U) | block;
    const std::uint32_t key0 = stream.key_[0];
    const std::uint32_t key1 = stream.key_[1];
    for (int i = 0; i < count; ++i) {
      Word c0 = firstIndex + static_cast<std::uint32_t>(i);
      Word c1 = iteration;
      Word c2 = frame;
      Word c3 = purpose;
      Philox::mix(c0, c1, c2, c3, key0, key1);
      words.word[0][i] = static_cast<std::uint32_t>(c0);
      words.word[1][i] = static_cast<std::uint32_t>(c1);
      words.word[2][i] = static_cast<std::uint32_t>(c2);
      words.word[3][i] = static_cast<std::uint32_t>(c3);
    }
  }

  template <class Word> struct Normals {
    DEWPOINT_KERNEL void run(const RandomStream* stream, std::uint32_t firstIndex,
                             std::int64_t total, double* __restrict first,
                             double* __restrict second, double* __restrict third) {
      alignas(64) Words words;
      for (std::int64_t begin = 0; begin < total; begin += kBlock) {
        const int count = static_cast<int>(std::min<std::int64_t>(kBlock, total - begin));
        draw<Word>(*stream, firstIndex + static_cast<std::uint32_t>(begin), count, words);
        for (int i = 0; i < count; ++i) {
          const NormalPairSingle pair = boxMullerSingle(words.word[0][i], words.word[1][i]);
          first[begin + i] = pair.first;
          second[begin + i] = pair.second;
        }
        for (int i = 0; i < count; ++i) {
          third[begin + i] = boxMullerSingle(words.word[2][i], words.word[3][i]).first;
        }
      }
    }
  };

  template <class Word> struct NormalsInDouble {
    DEWPOINT_KERNEL void run(const RandomStream* stream, std::uint32_t firstIndex,
                             std::uint32_t block, std::int64_t total,
                             const std::array<double*, 4>* columns) {
      alignas(64) Words words;
      for (std::int64_t begin = 0; begin < total; begin += kBlock) {
        const int count = static_cast<int>(std::min<std::int64_t>(kBlock, total - begin));
        draw<Word>(*stream, firstIndex + static_cast<std::uint32_t>(begin), count, words, block);
        for (std::size_t pair = 0; pair < 4; pair += 2) {
          double* __restrict first = (*columns)[pair] + begin;
          double* __restrict second = (*columns)[pair + 1] + begin;
          for (int i = 0; i < count; ++i) {
            const NormalPair normal = boxMuller(words.word[pair][i], words.word[pair + 1][i]);
            first[i] = normal.first;
            second[i] = normal.second;
          }
        }
      }
    }
  };

  template <class Word> struct Exponentials {
    DEWPOINT_KERNEL void run(const RandomStream* stream, std::uint32_t firstIndex,
                             std::int64_t total, const std::array<float*, 4>* columns) {
      alignas(64) Words words;
      for (std::int64_t begin = 0; begin < total; begin += kBlock) {
        const int count = static_cast<int>(std::min<std::int64_t>(kBlock, total - begin));
        draw<Word>(*stream, firstIndex + static_cast<std::uint32_t>(begin), count, words);
        for (std::size_t w = 0; w < 4; ++w) {
          float* __restrict out = (*columns)[w] + begin;
          for (int i = 0; i < count; ++i) {
            out[i] = exponentialVariate(words.word[w][i]);
          }
        }
      }
    }
  };

  /// The same numbers either way. AVX-512 multiplies lanes of 64 bits; narrower sets do not.
  template <template <class> class Kernel, class... Arguments>
  static void run(Arguments... arguments) {
    if (instructionSet() == InstructionSet::Avx512) {
      runKernel<Kernel<std::uint64_t>>(arguments...);
    } else {
      runKernel<Kernel<std::uint32_t>>(arguments...);
    }
  }
};

void RandomStream::normals(std::uint32_t firstIndex, std::int64_t count,
                           const std::array<double*, 3>& columns) const {
  RandomBatch::run<RandomBatch::Normals>(this, firstIndex, count, columns[0], columns[1],
                                         columns[2]);
}

void RandomStream::normals4(std::uint32_t firstIndex, std::uint32_t block, std::int64_t count,
                            const std::array<double*, 4>& columns) const {
  RandomBatch::run<RandomBatch::NormalsInDouble>(this, firstIndex, block, count, &columns);
}

void RandomStream::exponentials(std::uint32_t firstIndex, std::int64_t count,
                                const std::array<float*, 4>& columns) const {
  RandomBatch::run<RandomBatch::Exponentials>(this, firstIndex, count, &columns);
}

} // namespace dewpoint::base
