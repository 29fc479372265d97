// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "ui/export/video_picture.h"
#include "ui/export/video_scene.h"
#include "ui/jobs/job_queue.h"

#include <QObject>

#include <cstdint>
#include <functional>
#include <memory>

namespace dewpoint::session {
class Session;
} // namespace dewpoint::session

namespace dewpoint::ui {

class BirdsEyeView;

/// Draws images of an exported video: requests snapshots of frames from a session, draws the
/// bird's-eye view in the GUI thread, and everything else in another thread. What the window shows
/// does not change.
class VideoDrawer : public QObject {
  Q_OBJECT
public:
  explicit VideoDrawer(QObject* parent = nullptr);

  /// Sets the session and the composition (`look`) of the next images. `scene` is the bird's-eye
  /// view whose appearance is copied; null if the composition contains no bird's-eye view.
  void beginVideo(Session* session, std::shared_ptr<const VideoLayout> look,
                  const BirdsEyeView* scene);
  /// Drops requests that have not been answered. The session may end after this call.
  void stop();

  /// Function that processes an image. It is called in another thread, in the order of the
  /// requests, and must not throw. The function that it returns (may be empty) is then called in
  /// the GUI thread.
  using Consume = std::function<std::function<void()>(Result<QImage> image)>;
  /// Requests the image of a frame, which is passed to `consume`. `isWanted` returns whether the
  /// image is still needed, and may be called from any thread. Make one request at a time: wait for
  /// `ready()` before the next.
  void draw(std::int64_t frame, Consume consume, std::function<bool()> isWanted);
  bool isReady() const { return !fetching_; }
  /// Returns whether the bird's-eye view is drawn in a smaller size because this computer draws it
  /// slowly.
  bool isSceneResolutionReduced() const { return sceneArea_ >= 0 && scene_.isSizeReduced(); }
  /// Runs other work in the thread in which images are processed, after all images requested so
  /// far.
  void enqueue(JobQueue::Work work) { jobs_.add(std::move(work)); }

Q_SIGNALS:
  /// Emitted when the next image can be requested.
  void ready();

private:
  void take(Result<TrackSnapshotPtr> snapshot, const Consume& consume);

  Session* session_ = nullptr;
  std::shared_ptr<const VideoLayout> look_;
  VideoScene scene_;
  int sceneArea_ = -1; ///< index of the bird's-eye view among the views; -1: none
  bool fetching_ = false;
  std::uint64_t generation_ = 0; ///< answers to earlier requests are dropped
  JobMailbox mailbox_;
  JobQueue jobs_;
};

} // namespace dewpoint::ui
