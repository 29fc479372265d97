// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/thread_team.h"

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <vector>

namespace dewpoint::base {
namespace {
// Below this many elements waking the others costs more than the work.
constexpr std::int64_t kSmallestShared = 2048;
} // namespace

class ThreadTeam::Workers {
public:
  explicit Workers(int count) {
    for (int worker = 1; worker <= count; ++worker) {
      threads_.emplace_back([this, worker](const std::stop_token& stop) { work(stop, worker); });
    }
  }
  ~Workers() {
    for (auto& thread : threads_) {
      thread.request_stop();
    }
  }
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  /// Cuts [0, count) into one piece per thread, the calling one included, and waits for all.
  void share(std::int64_t count, const std::function<void(std::int64_t, std::int64_t)>& body) {
    {
      const std::lock_guard lock(mutex_);
      count_ = count;
      body_ = &body;
      pending_ = static_cast<int>(threads_.size());
      ++generation_;
    }
    wake_.notify_all();
    runPiece(0);
    std::unique_lock lock(mutex_);
    done_.wait(lock, [this] { return pending_ == 0; });
    body_ = nullptr;
  }

private:
  void runPiece(int piece) const {
    const auto pieces = static_cast<std::int64_t>(threads_.size()) + 1;
    const std::int64_t begin = count_ * piece / pieces;
    const std::int64_t end = count_ * (piece + 1) / pieces;
    if (begin < end) {
      (*body_)(begin, end);
    }
  }

  void work(const std::stop_token& stop, int worker) {
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

  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::condition_variable done_;
  std::uint64_t generation_ = 0;
  int pending_ = 0;
  std::int64_t count_ = 0;
  const std::function<void(std::int64_t, std::int64_t)>* body_ = nullptr;
  std::vector<std::jthread> threads_;
};

ThreadTeam::ThreadTeam(int threadCount) : threadCount_(std::max(1, threadCount)) {
  if (threadCount_ > 1) {
    workers_ = std::make_unique<Workers>(threadCount_ - 1);
  }
}

ThreadTeam::~ThreadTeam() = default;

void ThreadTeam::forEachRange(std::int64_t count,
                              const std::function<void(std::int64_t, std::int64_t)>& body) {
  if (!workers_ || count < kSmallestShared) {
    if (count > 0) {
      body(0, count);
    }
    return;
  }
  workers_->share(count, body);
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
  if (!workers_ || count < kSmallestShared || blockCount < 2) {
    blocks(0, blockCount);
  } else {
    workers_->share(blockCount, blocks);
  }
}

} // namespace dewpoint::base
