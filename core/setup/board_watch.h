// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/board_guide.h"

#include <functional>
#include <memory>

namespace dewpoint::setup {

/// A BoardGuide in a thread of its own, fed with the images of live cameras: it uses the newest
/// ones only. Every call returns at once.
class BoardWatch {
public:
  /// `wake` is called from the thread after a state was published; it must only post.
  explicit BoardWatch(std::function<void()> wake);
  ~BoardWatch(); ///< stops the thread, and waits for images that were shown: not in a window's
                 ///< thread
  BoardWatch(const BoardWatch&) = delete;
  BoardWatch& operator=(const BoardWatch&) = delete;

  /// Begins, or starts over.
  void begin(const Project& project, const BoardGuideRequest& request);
  /// Replaces images that are still waiting.
  void show(FrameSetPtr frames);
  void captureNow();
  /// As captureNow(); there the board lies on the floor.
  void captureFloor();
  void goOn();
  /// The newest state since begin(); never null.
  BoardGuideStatePtr newest() const;

private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

} // namespace dewpoint::setup
