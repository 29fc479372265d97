// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <cstdint>
#include <functional>
#include <memory>

namespace dewpoint::base {

/// A fixed number of threads that share loops over independent elements. Results must not depend on
/// how the range is split; then they do not depend on the number of threads either.
class ThreadTeam {
public:
  /// Starts the threads. `threadCount` includes the calling thread; 1 starts none.
  explicit ThreadTeam(int threadCount = 1);
  ~ThreadTeam();
  ThreadTeam(const ThreadTeam&) = delete;
  ThreadTeam& operator=(const ThreadTeam&) = delete;

  int threadCount() const { return threadCount_; }

  /// Calls `body(begin, end)` on contiguous pieces that cover [0, count), and returns when all
  /// calls are done. Not reentrant; `body` must not throw.
  void forEachRange(std::int64_t count,
                    const std::function<void(std::int64_t, std::int64_t)>& body);

  /// Calls `body(begin, end)` on blocks of `blockSize` elements; the last block may be shorter.
  /// Blocks begin at multiples of `blockSize` for any number of threads, so a sum within a block is
  /// always the same.
  void forEachBlock(std::int64_t count, std::int64_t blockSize,
                    const std::function<void(std::int64_t, std::int64_t)>& body);

private:
  /// The additional threads and their synchronization. Defined in the source file, because half the
  /// tree includes this header and few files need the standard library's threads.
  class Workers;

  int threadCount_ = 1;
  std::unique_ptr<Workers> workers_; ///< null without additional threads
};

} // namespace dewpoint::base
