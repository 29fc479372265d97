// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/view/video_plan.h"
#include "ui/export/video_drawer.h"

#include <QObject>
#include <QString>

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

namespace dewpoint::ui {

/// Description of a video to export.
struct VideoRequest {
  std::shared_ptr<const VideoLayout> layout;
  std::vector<std::int64_t> frames; ///< frame that each image shows (chooseVideoFrames())
  VideoEncoding encoding;
  double framesPerSecond = 30.0;
  std::filesystem::path file;
  bool replacesFile = false; ///< true to overwrite an existing file
};

/// Writes a run as a video in the background. A canceled or failed export leaves no file.
class VideoExporter : public QObject {
  Q_OBJECT
public:
  explicit VideoExporter(QObject* parent = nullptr);
  ~VideoExporter() override; ///< cancels an export in progress

  /// Starts an export. Must not be called while an export is running. `scene` is the bird's-eye
  /// view whose appearance is copied, or null.
  void start(VideoRequest request, Session* session, const BirdsEyeView* scene);
  void cancel();
  /// Ends an export immediately because the session ends, and emits `failed()` with this sentence.
  void abandon(const QString& sentence);
  bool isRunning() const { return state_ != nullptr; }
  /// Returns the drawer, which can draw single images while no export is running.
  VideoDrawer& drawer() { return *drawer_; }

Q_SIGNALS:
  void progressChanged(int percent);
  void finished(const QString& file);
  void canceled();
  /// Emitted if the file exists and VideoRequest::replacesFile is false. Nothing was written.
  void fileExists(const QString& file);
  void failed(const QString& sentence);

private:
  /// Data shared with the other threads.
  struct State {
    VideoRequest request;
    std::atomic<bool> isCanceled = false;
    std::optional<VideoEncoder> encoder; ///< only used by the thread that writes
    std::optional<Error> error;          ///< as `encoder`
  };
  using StatePtr = std::shared_ptr<State>;
  void open();
  void requestNext();
  /// Adds `images` to the number of written images, and ends the export after the last one.
  void count(const StatePtr& state, std::size_t images);
  void close();
  void end(const StatePtr& state, const Status& closed);

  VideoDrawer* drawer_;
  StatePtr state_;          ///< null while no export is running
  std::size_t next_ = 0;    ///< index of the first image that has not been requested
  std::size_t written_ = 0; ///< number of images written so far
  int waiting_ = 0;         ///< number of requested frames that have not been written yet
  bool closing_ = false;
};

} // namespace dewpoint::ui
