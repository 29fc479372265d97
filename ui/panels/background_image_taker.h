// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/session/snapshot/snapshot.h"

#include <QObject>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <utility>

namespace dewpoint::project {
struct Project;
} // namespace dewpoint::project

namespace dewpoint::ui {

class CameraListModel;
class Document;
class JobQueue;
class Selection;

/// Writes an image as a camera's background image and returns the file, as saveBackgroundImage()
/// does.
using BackgroundImageWriter = std::function<Result<std::filesystem::path>(
    const Project& project, std::size_t camera, const cv::Mat& image,
    const std::filesystem::path& folder)>;

/// Makes the image that a camera currently shows the background image of this camera. Asks for
/// confirmation if a target is in the image, writes the image in another thread, and adds the file
/// to the project in one undoable step.
class BackgroundImageTaker : public QObject {
  Q_OBJECT
public:
  BackgroundImageTaker(Document& document, Selection& selection, const CameraListModel& cameras,
                       QObject* parent = nullptr);
  ~BackgroundImageTaker() override; ///< a write in progress completes, but its result is ignored

  /// Sets the snapshot shown, from whose images a background image is taken.
  void setSnapshot(const TrackSnapshotPtr& snapshot) { snapshot_ = snapshot; }
  /// Sets the function that writes the images. The function is called from another thread, because
  /// writing may take long.
  void setWriter(BackgroundImageWriter keep) { write_ = std::move(keep); }
  /// Returns whether a background image can be taken: the camera shows an image, and no other
  /// background image is being written.
  bool canCapture(int camera) const;
  void capture(int camera);

Q_SIGNALS:
  /// Emitted when a write starts or ends.
  void busyChanged();
  void failed(const QString& sentence);
  /// Emitted with a sentence that describes what was done.
  void messageRequested(const QString& sentence);
  /// Emitted with a question for the user. The receiver must call `act` only if the user chooses
  /// the answer `yes`.
  void confirmationRequested(const QString& question, const QString& yes,
                             const std::function<void()>& act);

private:
  /// Returns the image that a camera shows, or an empty image if there is none.
  cv::Mat shownImage(int camera) const;
  /// Returns the name of a target that is tracked in the image shown by a camera, or an empty
  /// string if there is none.
  QString targetSeenBy(int camera) const;
  /// Writes the image in another thread. `applyWritten()` is called afterwards unless another
  /// project is opened.
  void write(int camera, const cv::Mat& image);
  /// Handles the result of the write. `then` is the project at the time the image was taken.
  void applyWritten(const Project& then, int camera, const Result<std::filesystem::path>& kept);
  void discardWrites();

  Document& document_;
  Selection& selection_;
  const CameraListModel& cameras_;
  TrackSnapshotPtr snapshot_;
  BackgroundImageWriter write_;
  std::unique_ptr<JobQueue> writeQueue_; ///< for this project; replaced to drop its results
  bool isWriting_ = false;
};

} // namespace dewpoint::ui
