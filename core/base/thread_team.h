// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <cstdint>
#include <functional>
#include <memory>

namespace dewpoint::base {

/// Fixed number of threads that share loops over independent elements. If a result does not depend
/// on how a range is split, it does not depend on the number of threads either.
class ThreadTeam {
public:
  /// Starts the additional threads. `threadCount` includes the calling thread, so no thread is
  /// started if it is 1.
  explicit ThreadTeam(int threadCount = 1);
  ~ThreadTeam();
  ThreadTeam(const ThreadTeam&) = delete;
  ThreadTeam& operator=(const ThreadTeam&) = delete;

  int threadCount() const { return threadCount_; }

  /// Calls `body(begin, end)` for contiguous pieces that cover [0, count), and returns when all
  /// calls are done. `body` must not use this ThreadTeam, and must not throw.
  void forEachRange(std::int64_t count,
                    const std::function<void(std::int64_t, std::int64_t)>& body);

  /// Calls `body(begin, end)` for blocks of `blockSize` elements; the last block may be shorter.
  /// Blocks start at multiples of `blockSize`, regardless of the number of threads. Each block
  /// always contains the same elements, so the rounded sum over a block is always the same.
  void forEachBlock(std::int64_t count, std::int64_t blockSize,
                    const std::function<void(std::int64_t, std::int64_t)>& body);

private:
  /// Additional threads and their synchronization. Defined in the source file because this widely
  /// included header should not include the standard library's thread headers.
  class Workers;

  int threadCount_ = 1;
  std::unique_ptr<Workers> workers_; ///< null if there are no additional threads
};

} // namespace dewpoint::base
