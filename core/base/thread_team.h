// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <cstdint>
#include <functional>
#include <memory>

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

  int threadCount() const { return threadCount_; }

  /// Calls `body(begin, end)` on contiguous pieces that cover [0, count), and returns when all are
  /// done. Not re-entrant; `body` must not throw.
  void forEachRange(std::int64_t count,
                    const std::function<void(std::int64_t, std::int64_t)>& body);

  /// The same in pieces of `blockSize` elements (the last one may be shorter), which begin at
  /// multiples of it for any number of threads: what is summed up within a block is the same sum.
  void forEachBlock(std::int64_t count, std::int64_t blockSize,
                    const std::function<void(std::int64_t, std::int64_t)>& body);

private:
  /// The further threads and what they wait for; in the source, because half the tree includes this
  /// header and few need the standard library's threads.
  class Workers;

  int threadCount_ = 1;
  std::unique_ptr<Workers> workers_; ///< null where there are none
};

} // namespace dewpoint::base
