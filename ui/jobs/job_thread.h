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

/// Runs `work` in a thread that nobody joins. It must hold everything it uses: the window, and
/// the object that started it, may be gone before it ends. Must not throw.
void runDetached(std::function<void()> work);

/// Deletes an object in a thread of runDetached(): for one whose destructor waits, for a thread of
/// its own or for a device. Whoever lets go of it last, in whatever thread, waits for nothing.
struct DetachedDelete {
  template <class Object> void operator()(Object* object) const {
    runDetached([object] { delete object; });
  }
};

/// Waits until no thread of runDetached() is left, at most so long; false when some still run. For
/// the end of the program, when no window is open any more: a job that hangs in a dead stream is
/// left behind then.
bool waitForDetached(std::chrono::milliseconds patience);

/// Brings functions from threads into the thread of the window. The functions wait in a slot that a
/// mutex guards; the wake-up carries nothing.
class JobMailbox : public QObject {
  Q_OBJECT
public:
  explicit JobMailbox(QObject* parent = nullptr);
  ~JobMailbox() override; ///< from now on, whatever is posted is dropped

  /// The threads' end of a mailbox; it may outlive the mailbox.
  class Sender {
  public:
    /// `letter` runs in the mailbox's thread, unless the mailbox is gone by then.
    void post(std::function<void()> letter) const;

  private:
    friend class JobMailbox;
    struct State {
      std::mutex mutex;
      std::deque<std::function<void()>> letters;
      JobMailbox* receiver = nullptr; ///< null once it is gone
    };
    std::shared_ptr<State> state_ = std::make_shared<State>();
  };
  const Sender& sender() const { return sender_; }

private:
  void deliver();

  Sender sender_;
};

} // namespace dewpoint::ui
