// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/calibration/board_guide_thread.h"

#include "core/base/thread_count.h"

#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace dewpoint::setup {

class BoardGuideThread::Impl {
public:
  /// What a guidance is begun with.
  struct Beginning {
    Project project;
    BoardGuideRequest request;
  };

  /// What is to be done.
  struct Orders {
    std::optional<Beginning> beginning; ///< another guidance takes over
    FrameSetPtr frames;                 ///< not looked at yet
    bool capture = false;
    bool floor = false;
    bool skipToPoses = false;

    bool any() const { return beginning || frames || capture || floor || skipToPoses; }
  };

  explicit Impl(std::function<void()> wake)
      : wake_(std::move(wake)), newest_(std::make_shared<const BoardGuideState>()),
        thread_([this](const std::stop_token& stop) { work(stop); }) {}

  template <class Change> void order(Change apply) {
    {
      const std::lock_guard lock(mutex_);
      apply(orders_);
    }
    changed_.notify_one();
  }

  void start(const Project& project, const BoardGuideRequest& request) {
    // The guidance itself, which has threads to join, is made and goes in the thread.
    auto state = std::make_shared<const BoardGuideState>(BoardGuide(project, request).state());
    order([&](Orders& orders) {
      orders = Orders();
      orders.beginning.emplace(Beginning{project, request});
      newest_ = std::move(state);
    });
  }

  BoardGuideStatePtr newestState() const {
    const std::lock_guard lock(mutex_);
    return newest_;
  }

private:
  void work(const std::stop_token& stop) {
    std::unique_ptr<BoardGuide> guide;
    while (true) {
      Orders orders;
      {
        std::unique_lock lock(mutex_);
        if (!changed_.wait(lock, stop, [&] { return orders_.any(); })) {
          return;
        }
        orders = std::exchange(orders_, Orders());
      }
      if (orders.beginning) {
        const auto& [project, request] = *orders.beginning;
        guide = std::make_unique<BoardGuide>(project, request,
                                             threadCountForTasks(project.cameras.size()));
      }
      if (guide) {
        execute(*guide, orders);
        publish(*guide);
      }
    }
  }

  static void execute(BoardGuide& guide, const Orders& orders) {
    if (orders.floor) {
      guide.captureFloor();
    } else if (orders.capture) {
      guide.captureNow();
    }
    if (orders.skipToPoses) {
      guide.skipToPoses();
    }
    if (orders.frames) {
      guide.processFrame(*orders.frames);
    }
  }

  void publish(const BoardGuide& guide) {
    auto state = std::make_shared<const BoardGuideState>(guide.state());
    {
      const std::lock_guard lock(mutex_);
      if (orders_.beginning) {
        return; // another one was begun meanwhile
      }
      newest_ = std::move(state);
    }
    if (wake_) {
      wake_();
    }
  }

  std::function<void()> wake_;
  mutable std::mutex mutex_;
  std::condition_variable_any changed_;
  Orders orders_;
  BoardGuideStatePtr newest_;
  std::jthread thread_; // last: it uses the rest
};

BoardGuideThread::BoardGuideThread(std::function<void()> wake)
    : impl_(std::make_unique<Impl>(std::move(wake))) {}
BoardGuideThread::~BoardGuideThread() = default;
void BoardGuideThread::start(const Project& project, const BoardGuideRequest& request) {
  impl_->start(project, request);
}
void BoardGuideThread::offer(FrameSetPtr frames) {
  impl_->order([&](auto& orders) { orders.frames = std::move(frames); });
}
void BoardGuideThread::captureNow() {
  impl_->order([](auto& orders) { orders.capture = true; });
}
void BoardGuideThread::captureFloor() {
  impl_->order([](auto& orders) { orders.floor = true; });
}
void BoardGuideThread::skipToPoses() {
  impl_->order([](auto& orders) { orders.skipToPoses = true; });
}
BoardGuideStatePtr BoardGuideThread::newestState() const {
  return impl_->newestState();
}

} // namespace dewpoint::setup
