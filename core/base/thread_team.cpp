// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/thread_team.h"

#include <algorithm>

namespace dewpoint::base {
namespace {
// Below this many elements waking the others costs more than the work.
constexpr std::int64_t kSmallestShared = 2048;
} // namespace

ThreadTeam::ThreadTeam(int threadCount) {
  for (int worker = 1; worker < threadCount; ++worker) {
    workers_.emplace_back([this, worker](const std::stop_token& stop) { work(stop, worker); });
  }
}

ThreadTeam::~ThreadTeam() {
  for (auto& worker : workers_) {
    worker.request_stop();
  }
}

void ThreadTeam::forEachRange(std::int64_t count,
                              const std::function<void(std::int64_t, std::int64_t)>& body) {
  if (workers_.empty() || count < kSmallestShared) {
    if (count > 0) {
      body(0, count);
    }
    return;
  }
  share(count, body);
}

void ThreadTeam::forEachBlock(std::int64_t count, std::int64_t blockSize,
                              const std::function<void(std::int64_t, std::int64_t)>& body) {
  const std::function<void(std::int64_t, std::int64_t)> blocks = [&](std::int64_t first,
                                                                     std::int64_t last) {
    for (std::int64_t block = first; block < last; ++block) {
      body(block * blockSize, std::min(count, (block + 1) * blockSize));
    }
  };
  const std::int64_t blockCount = (count + blockSize - 1) / blockSize;
  if (workers_.empty() || count < kSmallestShared || blockCount < 2) {
    blocks(0, blockCount);
  } else {
    share(blockCount, blocks);
  }
}

void ThreadTeam::share(std::int64_t count,
                       const std::function<void(std::int64_t, std::int64_t)>& body) {
  {
    const std::lock_guard lock(mutex_);
    count_ = count;
    body_ = &body;
    pending_ = static_cast<int>(workers_.size());
    ++generation_;
  }
  wake_.notify_all();
  runPiece(0);
  std::unique_lock lock(mutex_);
  done_.wait(lock, [this] { return pending_ == 0; });
  body_ = nullptr;
}

void ThreadTeam::runPiece(int piece) const {
  const std::int64_t pieces = threadCount();
  const std::int64_t begin = count_ * piece / pieces;
  const std::int64_t end = count_ * (piece + 1) / pieces;
  if (begin < end) {
    (*body_)(begin, end);
  }
}

void ThreadTeam::work(const std::stop_token& stop, int worker) {
  std::uint64_t seen = 0;
  while (true) {
    {
      std::unique_lock lock(mutex_);
      if (!wake_.wait(lock, stop, [&] { return generation_ != seen; })) {
        return;
      }
      seen = generation_;
    }
    runPiece(worker);
    {
      const std::lock_guard lock(mutex_);
      --pending_;
    }
    done_.notify_one();
  }
}

} // namespace dewpoint::base
