// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace dewpoint::base {

/// A fixed number of threads that share loops over independent elements. Results must not depend
/// on how the range is cut: then they do not depend on the number of threads either.
class ThreadTeam {
public:
  /// `threadCount` includes the calling thread; 1 means no further thread at all.
  explicit ThreadTeam(int threadCount = 1);
  ~ThreadTeam();
  ThreadTeam(const ThreadTeam&) = delete;
  ThreadTeam& operator=(const ThreadTeam&) = delete;

  int threadCount() const { return static_cast<int>(workers_.size()) + 1; }

  /// Calls `body(begin, end)` on contiguous pieces that cover [0, count), and returns when all are
  /// done. Not re-entrant; `body` must not throw.
  void forEachRange(std::int64_t count,
                    const std::function<void(std::int64_t, std::int64_t)>& body);

  /// The same in pieces of `blockSize` elements (the last one may be shorter), which begin at
  /// multiples of it for any number of threads: what is summed up within a block is the same sum.
  void forEachBlock(std::int64_t count, std::int64_t blockSize,
                    const std::function<void(std::int64_t, std::int64_t)>& body);

private:
  void share(std::int64_t count, const std::function<void(std::int64_t, std::int64_t)>& body);
  void work(const std::stop_token& stop, int worker);
  void runPiece(int piece) const;

  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::condition_variable done_;
  std::uint64_t generation_ = 0;
  int pending_ = 0;
  std::int64_t count_ = 0;
  const std::function<void(std::int64_t, std::int64_t)>* body_ = nullptr;
  std::vector<std::jthread> workers_;
};

} // namespace dewpoint::base
