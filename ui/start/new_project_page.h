// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/connected_cameras.h"
#include "core/setup/new_project/new_project.h"
#include "ui/jobs/job_queue.h"
#include "ui/jobs/latest_job.h"
#include "ui/start/camera_table.h"

#include <QWidget>

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

class QDialogButtonBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QStackedWidget;

namespace dewpoint::ui {

class CalibrationChoice;
class DropZone;

/// Page that creates a project from cameras with their sources and a calibration file. Files are
/// read in another thread as soon as they are selected, so that the page shows problems before the
/// project is created.
class NewProjectPage : public QWidget {
  Q_OBJECT
public:
  explicit NewProjectPage(QWidget* parent = nullptr);

  /// Starts a new project with these files (videos, image folders, a calibration). If
  /// `findsCalibration` is true, a calibration file found beside the recordings is proposed.
  void startNewProject(const QStringList& files, bool findsCalibration = true);
  /// Adds files to the new project, once their kind has been determined. A file with a calibration
  /// suffix becomes the calibration.
  void addFiles(const QStringList& files);
  /// Asks the user for videos and adds them.
  void chooseVideos();
  /// Adds the cameras connected to this computer.
  void addConnectedCameras();
  /// Replaces the access to the camera devices of this computer, for example by simulated devices.
  void setDeviceAccess(capture::DeviceAccessPtr devices) { devices_ = std::move(devices); }

Q_SIGNALS:
  /// Emitted when the project was created. `note` is a hint for the user; may be empty.
  void created(const dewpoint::project::Project& project, const QString& note);
  void failed(const QString& sentence);
  void canceled();

private:
  static std::vector<FootageLocation> locationsOf(const std::vector<std::string>& locations);

  QPushButton* addButton(const char* name, const std::function<void()>& act);
  void makeButtons();
  void arrange();
  void retranslateUi();
  /// Examines locations in another thread. Requests are answered in order.
  void search(std::function<std::vector<FootageLocation>()> look,
              std::function<void(const std::vector<FootageLocation>&)> found);
  /// Cancels searches and project creation in progress.
  void cancelWork();
  void addFootage(const std::vector<FootageLocation>& places);
  /// Searches for the calibration of the recordings beside them, unless the user has chosen one.
  void findCalibration();
  void chooseFolder();
  void refresh();
  NewProject newProject() const;
  void createProject();
  void finish(const Result<CreatedProject>& result);

  QLabel* title_;
  QLabel* intro_;
  QLineEdit* name_;
  QLabel* nameLabel_;
  QStackedWidget* list_; ///< the table, or the drop zone while the table is empty
  CameraTable* cameras_;
  DropZone* dropZone_;
  QLabel* note_; ///< hint about recordings that differ from each other
  QPushButton* addVideos_ = nullptr;
  QPushButton* addFolder_ = nullptr;
  QPushButton* addDevices_ = nullptr;
  QPushButton* addAddress_ = nullptr;
  QPushButton* remove_ = nullptr;
  CalibrationChoice* calibration_;
  QLabel* rateLabel_;
  QDoubleSpinBox* rate_;
  QDialogButtonBox* buttons_;
  QPushButton* create_ = nullptr;
  QPushButton* cancel_ = nullptr;
  capture::DeviceAccessPtr devices_ = capture::systemDevices();
  /// Jobs for this project. Results for an earlier project are ignored.
  std::unique_ptr<JobQueue> searches_;
  int pendingSearches_ = 0; ///< number of searches whose rows have not been added yet
  /// Creates the project, which may take long, because the first image of each video is read.
  LatestJob making_{LatestJob::SupersededJob::Dropped};
};

} // namespace dewpoint::ui
