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

/// Runs `work` in a detached thread. It must hold everything it uses, because the window and the
/// object that started it may be deleted before it ends. Must not throw.
void runDetached(std::function<void()> work);

/// Deleter that deletes an object in a thread of `runDetached()`. For objects whose destructor
/// waits for a thread or a device: whichever thread releases the last reference does not block.
struct DetachedDelete {
  template <class Object> void operator()(Object* object) const {
    runDetached([object] { delete object; });
  }
};

/// Waits at most `patience` until all threads of `runDetached()` have ended; returns false if some
/// are still running. For the end of the program, when no window is open: a job that hangs in a
/// dead stream is abandoned then.
bool waitForDetached(std::chrono::milliseconds patience);

/// Delivers functions from other threads to the thread of the window. A mutex guards the queue of
/// functions; the wake-up event carries no data.
class JobMailbox : public QObject {
  Q_OBJECT
public:
  explicit JobMailbox(QObject* parent = nullptr);
  ~JobMailbox() override; ///< drops everything posted from now on

  /// Sending end of a mailbox, for other threads; it may outlive the mailbox.
  class Sender {
  public:
    /// Posts a function that runs in the thread of the mailbox, unless the mailbox was deleted
    /// meanwhile.
    void post(std::function<void()> letter) const;

  private:
    friend class JobMailbox;
    struct State {
      std::mutex mutex;
      std::deque<std::function<void()>> letters;
      JobMailbox* receiver = nullptr; ///< null after the mailbox was deleted
    };
    std::shared_ptr<State> state_ = std::make_shared<State>();
  };
  const Sender& sender() const { return sender_; }

private:
  void deliver();

  Sender sender_;
};

} // namespace dewpoint::ui
