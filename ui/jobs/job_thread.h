// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QObject>

#include <chrono>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>

namespace dewpoint::ui {

/// Runs `work` in a detached thread. The work must own everything it uses, because the window and
/// the object that started it may be deleted before it ends. Must not throw.
void runDetached(std::function<void()> work);

/// Deleter that deletes an object in a thread started by `runDetached()`. For objects whose
/// destructor waits for a thread or a device: releasing the last reference never blocks the calling
/// thread.
struct DetachedDeleter {
  template <class Object> void operator()(Object* object) const {
    runDetached([object] { delete object; });
  }
};

/// Waits until all threads of `runDetached()` have ended, but at most for `patience`. Returns false
/// if some are still running. Call it at the end of the program, when no window is open. A job that
/// still hangs, for example in a dead stream, is abandoned.
bool waitForDetachedJobs(std::chrono::milliseconds patience);

/// Delivers functions from other threads to the GUI thread. A mutex guards the queue of functions;
/// the wake-up event carries no data.
class JobMailbox : public QObject {
  Q_OBJECT
public:
  explicit JobMailbox(QObject* parent = nullptr);
  ~JobMailbox() override; ///< discards everything posted from now on

  /// Object with which other threads post functions to a mailbox. It may outlive the mailbox.
  class Sender {
  public:
    /// Posts a function that will run in the mailbox's thread, unless the mailbox is deleted first.
    void post(std::function<void()> task) const;

  private:
    friend class JobMailbox;
    struct State {
      std::mutex mutex;
      std::deque<std::function<void()>> tasks;
      JobMailbox* receiver = nullptr; ///< null after the mailbox is deleted
    };
    std::shared_ptr<State> state_ = std::make_shared<State>();
  };
  const Sender& sender() const { return sender_; }

private:
  void deliver();

  Sender sender_;
};

} // namespace dewpoint::ui
