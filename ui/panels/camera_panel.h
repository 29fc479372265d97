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

/// Writes an image as a picture of a camera's empty room and returns the file:
/// keepBackgroundImage().
using EmptyRoomKeeper = std::function<Result<std::filesystem::path>(
    const Project& project, std::size_t camera, const cv::Mat& image,
    const std::filesystem::path& folder)>;

/// Panel of the cameras: name, image source, rotation and mirroring of the images, delay, and the
/// state of the calibration.
class CameraPanel : public QWidget {
  Q_OBJECT
public:
  CameraPanel(Document& document, Selection& selection, CameraListModel& cameras,
              QWidget* parent = nullptr);
  /// A background image that is being written is completed, but its result is dropped.
  ~CameraPanel() override;

  /// Sets the images shown, from which a background image can be taken.
  void setSnapshot(const TrackSnapshotPtr& snapshot);
  /// Sets the function that writes background images. It is called in another thread, because it
  /// may take long.
  void setKeeper(EmptyRoomKeeper keep) { keep_ = std::move(keep); }

Q_SIGNALS:
  /// A calibration file is to be read for all cameras.
  void calibrationWanted(const QString& file);
  void failed(const QString& sentence);
  /// A sentence about what was done.
  void messageRequested(const QString& sentence);
  /// Asks the user to confirm an action; `act` runs only after the answer `yes`.
  void confirmationRequested(const QString& question, const QString& yes,
                             const std::function<void()>& act);

private:
  void retranslateUi();
  void refresh();
  /// Index of the selected camera; -1 without cameras.
  int chosen() const;
  void showChosen();
  void showCalibration(const ProjectCamera& camera);
  void edit(const QString& step, const std::function<void(ProjectCamera&)>& change);
  void relocate();
  void chooseEmptyRoom();
  void takeEmptyRoom();
  void setEmptyRoom(const QString& file);
  /// Writes the image in another thread. `useKept()` follows unless another project is opened
  /// meanwhile.
  void keepAsEmptyRoom(int camera, const cv::Mat& image);
  /// Uses the written background image, or reports an error. `then`: the project when the image was
  /// taken.
  void useKept(const Project& then, int camera, const Result<std::filesystem::path>& kept);
  void forgetKept();
  void enableTake();
  /// Name of a target that is tracked in the shown image of a camera; empty: none.
  QString targetSeenBy(int camera) const;
  void makeFields();
  void connectFields();
  /// Image of the selected camera that is shown; empty if there is none.
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
  /// Jobs of this project; results for an earlier project are dropped.
  std::unique_ptr<JobQueue> keeping_;
  bool isKeeping_ = false;
};

} // namespace dewpoint::ui
