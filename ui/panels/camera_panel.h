// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/session/run/snapshot.h"

#include <QWidget>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <utility>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QListView;
class QPushButton;

namespace dewpoint::project {
struct Project;
struct ProjectCamera;
} // namespace dewpoint::project

namespace dewpoint::ui {

class CameraListModel;
class Document;
class JobQueue;
class Selection;

/// Writes an image as a picture of a camera's empty room and returns the file: keepEmptyRoom().
using EmptyRoomKeeper = std::function<Result<std::filesystem::path>(
    const Project& project, std::size_t camera, const cv::Mat& image,
    const std::filesystem::path& folder)>;

/// The cameras: name, where the images come from, how they are turned, and what is known of their
/// calibration.
class CameraPanel : public QWidget {
  Q_OBJECT
public:
  CameraPanel(Document& document, Selection& selection, CameraListModel& cameras,
              QWidget* parent = nullptr);
  ~CameraPanel() override; ///< what is being written is written to its end, and unheard

  /// The images that a picture of the empty room may be taken from: those shown.
  void setSnapshot(const TrackSnapshotPtr& snapshot);
  /// Who writes pictures of empty rooms, in a thread of its own: it may take long.
  void setKeeper(EmptyRoomKeeper keep) { keep_ = std::move(keep); }

Q_SIGNALS:
  /// A calibration file is to be read for all cameras.
  void calibrationWanted(const QString& file);
  void failed(const QString& sentence);
  /// Something was done, and this is what.
  void messageRequested(const QString& sentence);
  /// Something is done only after this question was answered with yes.
  void confirmationRequested(const QString& question, const QString& yes,
                             const std::function<void()>& act);

private:
  void retranslateUi();
  void refresh();
  /// Row of the selected camera; -1 without cameras.
  int chosen() const;
  void showChosen();
  void showCalibration(const ProjectCamera& camera);
  void edit(const QString& step, const std::function<void(ProjectCamera&)>& change);
  void relocate();
  void chooseEmptyRoom();
  void takeEmptyRoom();
  void setEmptyRoom(const QString& file);
  /// Writes the image without waiting for it; useKept() follows unless another project is opened.
  void keepAsEmptyRoom(int camera, const cv::Mat& image);
  /// What became of the image; `then`: the project as it was when the image was taken.
  void useKept(const Project& then, int camera, const Result<std::filesystem::path>& kept);
  void forgetKept();
  void enableTake();
  /// The target that is tracked in the image of a camera that is shown; empty: none.
  QString targetSeenBy(int camera) const;
  void makeFields();
  void connectFields();
  /// The image that the chosen camera shows; empty when there is none.
  cv::Mat shownImage() const;

  Document& document_;
  Selection& selection_;
  CameraListModel& cameras_;
  QListView* list_;
  QLabel* nameLabel_;
  QLineEdit* name_;
  QLabel* sourceLabel_;
  QLineEdit* source_;
  QPushButton* browse_;
  QLabel* emptyRoomLabel_;
  QLineEdit* emptyRoom_;
  QPushButton* emptyRoomBrowse_;
  QPushButton* emptyRoomTake_;
  QLabel* turnLabel_;
  QComboBox* turn_;
  QCheckBox* mirror_;
  QLabel* lateLabel_;
  QDoubleSpinBox* late_;
  QLabel* calibration_;
  QPushButton* load_;
  TrackSnapshotPtr snapshot_;
  EmptyRoomKeeper keep_;
  std::unique_ptr<JobQueue> keeping_; ///< of this project; one that is given up is not heard
  bool isKeeping_ = false;
};

} // namespace dewpoint::ui
