// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/random.h"

#include "core/base/box_muller.h"
#include "core/base/instruction_set.h"
#include "core/base/philox.h"
#include "core/base/vector_kernel.h"

#include <algorithm>

namespace dewpoint::base {
namespace {

constexpr double kTwoPowMinus32 = 1.0 / 4294967296.0;

} // namespace

std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> counter,
                                    std::array<std::uint32_t, 2> key) {
  auto& [c0, c1, c2, c3] = counter;
  Philox::mix(c0, c1, c2, c3, key[0], key[1]);
  return counter;
}

RandomStream::RandomStream(std::uint64_t seed, std::uint32_t frame, std::uint32_t iteration,
                           RandomPurpose purpose)
    : key_{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)}, frame_(frame),
      iteration_(iteration), purpose_(static_cast<std::uint32_t>(purpose)) {}

std::array<std::uint32_t, 4> RandomStream::randomWords(std::uint32_t index,
                                                       std::uint32_t block) const {
  return philox({index, iteration_, frame_, (purpose_ << 24U) | block}, key_);
}

double RandomStream::uniform(std::uint32_t index, std::uint32_t block) const {
  const auto word = randomWords(index, block);
  const std::uint64_t bits = (std::uint64_t{word[0]} << 21U) ^ (word[1] >> 11U);
  return static_cast<double>(bits) * 0x1.0p-53;
}

std::array<double, 3> RandomStream::uniform3(std::uint32_t index, std::uint32_t block) const {
  const auto word = randomWords(index, block);
  return {word[0] * kTwoPowMinus32, word[1] * kTwoPowMinus32, word[2] * kTwoPowMinus32};
}

std::array<double, 4> RandomStream::normal4(std::uint32_t index, std::uint32_t block) const {
  const auto word = randomWords(index, block);
  const auto [first, second] = boxMuller(word[0], word[1]);
  const auto [third, fourth] = boxMuller(word[2], word[3]);
  return {first, second, third, fourth};
}

std::array<float, 3> RandomStream::normal3(std::uint32_t index) const {
  const auto word = randomWords(index);
  const auto [first, second] = boxMullerSingle(word[0], word[1]);
  return {first, second, boxMullerSingle(word[2], word[3]).first};
}

std::array<float, 4> RandomStream::exponential4(std::uint32_t index) const {
  const auto word = randomWords(index);
  return {exponentialVariate(word[0]), exponentialVariate(word[1]), exponentialVariate(word[2]),
          exponentialVariate(word[3])};
}

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

void RandomStream::fillNormal3(std::uint32_t firstIndex, std::int64_t count,
                               const std::array<double*, 3>& columns) const {
  RandomBatch::run<RandomBatch::Normals>(this, firstIndex, count, columns[0], columns[1],
                                         columns[2]);
}

void RandomStream::fillNormal4(std::uint32_t firstIndex, std::uint32_t block, std::int64_t count,
                               const std::array<double*, 4>& columns) const {
  RandomBatch::run<RandomBatch::NormalsInDouble>(this, firstIndex, block, count, &columns);
}

void RandomStream::fillExponential4(std::uint32_t firstIndex, std::int64_t count,
                                    const std::array<float*, 4>& columns) const {
  RandomBatch::run<RandomBatch::Exponentials>(this, firstIndex, count, &columns);
}

std::uint64_t derivedSeed(std::uint64_t seed, std::uint32_t index) {
  if (index == 0) {
    return seed;
  }
  const auto word = philox({index, 0, 0, 0xDE77}, {static_cast<std::uint32_t>(seed),
                                                   static_cast<std::uint32_t>(seed >> 32)});
  return (std::uint64_t{word[0]} << 32U) | word[1];
}

} // namespace dewpoint::base
