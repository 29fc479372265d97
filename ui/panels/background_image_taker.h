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

/// Writes an image as the background image of a camera and returns the file: keepBackgroundImage().
using BackgroundImageKeeper = std::function<Result<std::filesystem::path>(
    const Project& project, std::size_t camera, const cv::Mat& image,
    const std::filesystem::path& folder)>;

/// Makes the image that a camera shows its background image: asks when a target is in it, writes it
/// without waiting for the disk, and enters the file into the project, as a step.
class BackgroundImageTaker : public QObject {
  Q_OBJECT
public:
  BackgroundImageTaker(Document& document, Selection& selection, const CameraListModel& cameras,
                       QObject* parent = nullptr);
  ~BackgroundImageTaker() override; ///< what is being written is written to its end, and unheard

  /// The images that may be taken: those shown.
  void setSnapshot(const TrackSnapshotPtr& snapshot) { snapshot_ = snapshot; }
  /// Who writes them, in a thread of its own: it may take long.
  void setKeeper(BackgroundImageKeeper keep) { keep_ = std::move(keep); }
  /// Whether a camera shows an image, and none is being written.
  bool canTake(int camera) const;
  void take(int camera);

Q_SIGNALS:
  /// An image is being written from now on, or no more.
  void busyChanged();
  void failed(const QString& sentence);
  /// Something was done, and this is what.
  void messageRequested(const QString& sentence);
  /// Something is done only after this question was answered with yes.
  void confirmationRequested(const QString& question, const QString& yes,
                             const std::function<void()>& act);

private:
  /// The image that a camera shows; empty when there is none.
  cv::Mat shownImage(int camera) const;
  /// The target that is tracked in the image of a camera that is shown; empty: none.
  QString targetSeenBy(int camera) const;
  /// Writes the image without waiting for it; useKept() follows unless another project is opened.
  void keep(int camera, const cv::Mat& image);
  /// What became of the image; `then`: the project as it was when the image was taken.
  void useKept(const Project& then, int camera, const Result<std::filesystem::path>& kept);
  void forgetKept();

  Document& document_;
  Selection& selection_;
  const CameraListModel& cameras_;
  TrackSnapshotPtr snapshot_;
  BackgroundImageKeeper keep_;
  std::unique_ptr<JobQueue> keeping_; ///< of this project; one that is given up is not heard
  bool isKeeping_ = false;
};

} // namespace dewpoint::ui
