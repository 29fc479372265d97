// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/multinomial_resampling.h"

#include "core/filter/cumulative.h"
#include "core/filter/sorted_lookup.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <memory>

namespace dewpoint {
namespace {

constexpr std::int64_t kBlock = MultinomialResampling::kBlock;
constexpr std::int64_t kChunk = 16384; ///< draws that are sorted into blocks together
constexpr std::int64_t kRun = 512;     ///< draws that are looked up together

std::int64_t pieces(std::int64_t count, std::int64_t size) {
  return (count + size - 1) / size;
}

/// What a call needs, kept for the next one of the same thread: fresh memory costs more than the
/// work on it.
struct Workspace {
  CumulativeWeights cumulative;
  std::vector<double> blockEnds;
  SortedLookup blocks;
  std::vector<double> draws;        ///< chunk by chunk, within a chunk block by block
  std::vector<std::int32_t> begins; ///< chunk by chunk, where each block begins within it, and end
};

/// What each thread needs.
struct Scratch {
  std::array<double, kChunk> draws;
  std::array<std::int32_t, kChunk> blockOfDraw;
  std::vector<std::int32_t> next;
  std::array<double, kBlock> cumulative;
  std::array<std::int32_t, kRun> found;
  SortedLookup lookup;
};

Scratch& scratch() {
  thread_local const auto ofThisThread = std::make_unique<Scratch>();
  return *ofThisThread;
}

/// One resampling of `count` particles.
class Resampling {
public:
  Resampling(Workspace& workspace, std::int64_t particles, std::int64_t count,
             const RandomStream& stream, ThreadTeam& team, std::vector<Eigen::Index>& picked)
      : w_(workspace), particles_(particles), count_(count), stream_(stream), team_(team),
        picked_(picked), blockCount_(pieces(particles, kBlock)),
        chunkCount_(pieces(count, kChunk)) {
    assert(w_.cumulative.total() > 0.0);
  }

  void run() {
    w_.draws.resize(static_cast<std::size_t>(count_));
    w_.begins.resize(static_cast<std::size_t>(chunkCount_ * (blockCount_ + 1)));
    w_.blockEnds.resize(static_cast<std::size_t>(blockCount_));
    for (std::int64_t block = 0; block < blockCount_; ++block) {
      w_.blockEnds[std::size_t(block)] =
          w_.cumulative.before(std::min(particles_, (block + 1) * kBlock));
    }
    constexpr std::int32_t kCellsPerBlock = 16;
    w_.blocks.build(w_.blockEnds.data(), static_cast<std::int32_t>(blockCount_), 0.0,
                    kCellsPerBlock);
    team_.forEachBlock(count_, kChunk,
                       [&](std::int64_t begin, std::int64_t end) { drawChunk(begin, end); });
    const std::vector<std::int64_t> outputs = layOut();
    team_.forEachBlock(particles_, kBlock, [&](std::int64_t begin, std::int64_t end) {
      pickBlock(begin, end, picked_.data() + outputs[std::size_t(begin / kBlock)]);
    });
  }

private:
  std::int32_t* beginsOf(std::int64_t chunk) const {
    return w_.begins.data() + chunk * (blockCount_ + 1);
  }

  /// Draws begin to end - 1, sorted by the block they fall into; the order within a block stays.
  void drawChunk(std::int64_t begin, std::int64_t end) const {
    const std::int64_t length = end - begin;
    Scratch& s = scratch();
    stream_.uniforms(static_cast<std::uint32_t>(begin), length, s.draws.data());
    const double total = w_.cumulative.total();
    for (std::int64_t i = 0; i < length; ++i) {
      s.draws[std::size_t(i)] *= total;
    }
    std::int32_t* begins = beginsOf(begin / kChunk);
    if (blockCount_ == 1) {
      begins[0] = 0;
      begins[1] = static_cast<std::int32_t>(length);
      std::copy_n(s.draws.begin(), length, w_.draws.begin() + begin);
      return;
    }
    w_.blocks.find(s.draws.data(), length, s.blockOfDraw.data());
    std::fill_n(begins, blockCount_ + 1, 0);
    for (std::int64_t i = 0; i < length; ++i) {
      ++begins[s.blockOfDraw[std::size_t(i)] + 1];
    }
    for (std::int64_t block = 0; block < blockCount_; ++block) {
      begins[block + 1] += begins[block];
    }
    s.next.assign(begins, begins + blockCount_);
    double* sorted = w_.draws.data() + begin;
    for (std::int64_t i = 0; i < length; ++i) {
      sorted[s.next[std::size_t(s.blockOfDraw[std::size_t(i)])]++] = s.draws[std::size_t(i)];
    }
  }

  /// Where the ancestors of each block are listed.
  std::vector<std::int64_t> layOut() const {
    std::vector<std::int64_t> outputs(static_cast<std::size_t>(blockCount_) + 1, 0);
    for (std::int64_t chunk = 0; chunk < chunkCount_; ++chunk) {
      const std::int32_t* begins = beginsOf(chunk);
      for (std::int64_t block = 0; block < blockCount_; ++block) {
        outputs[std::size_t(block + 1)] += begins[block + 1] - begins[block];
      }
    }
    for (std::size_t block = 1; block < outputs.size(); ++block) {
      outputs[block] += outputs[block - 1];
    }
    return outputs;
  }

  /// The ancestors among particles begin to end - 1, one block.
  void pickBlock(std::int64_t begin, std::int64_t end, Eigen::Index* out) const {
    Scratch& s = scratch();
    const std::int64_t block = begin / kBlock;
    bool built = false;
    for (std::int64_t chunk = 0; chunk < chunkCount_; ++chunk) {
      const std::int32_t* begins = beginsOf(chunk);
      const double* draws = w_.draws.data() + chunk * kChunk;
      for (std::int64_t first = begins[block]; first < begins[block + 1]; first += kRun) {
        if (!built) {
          w_.cumulative.write(begin, end, s.cumulative.data());
          s.lookup.build(s.cumulative.data(), static_cast<std::int32_t>(end - begin),
                         w_.cumulative.before(begin), 2);
          built = true;
        }
        const std::int64_t length = std::min<std::int64_t>(kRun, begins[block + 1] - first);
        s.lookup.find(draws + first, length, s.found.data());
        for (std::int64_t i = 0; i < length; ++i) {
          *out++ = begin + s.found[std::size_t(i)];
        }
      }
    }
  }

  Workspace& w_;
  std::int64_t particles_;
  std::int64_t count_;
  const RandomStream& stream_;
  ThreadTeam& team_;
  std::vector<Eigen::Index>& picked_;
  std::int64_t blockCount_;
  std::int64_t chunkCount_;
};

} // namespace

void MultinomialResampling::ancestors(const Eigen::ArrayXd& weights, Eigen::Index count,
                                      const RandomStream& stream, ThreadTeam& team,
                                      std::vector<Eigen::Index>& picked) const {
  thread_local Workspace workspace;
  workspace.cumulative.build(weights, team);
  picked.resize(static_cast<std::size_t>(count));
  Resampling(workspace, weights.size(), count, stream, team, picked).run();
}

void MultinomialResampling::ancestors(const Eigen::ArrayXd& weights, Eigen::Index count,
                                      const RandomStream& stream,
                                      std::vector<Eigen::Index>& picked) const {
  ThreadTeam alone(1);
  ancestors(weights, count, stream, alone, picked);
}

} // namespace dewpoint
