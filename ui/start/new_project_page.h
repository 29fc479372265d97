// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/new_project.h"
#include "ui/jobs/job_queue.h"
#include "ui/jobs/latest_job.h"
#include "ui/start/camera_table.h"

#include <QWidget>

#include <functional>
#include <memory>
#include <string>
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

/// Puts a project together: cameras with their sources, and a calibration file. What is chosen is
/// read at once, beside the window, so that the page says what will not work before it is made.
class NewProjectPage : public QWidget {
  Q_OBJECT
public:
  explicit NewProjectPage(QWidget* parent = nullptr);

  /// Starts from scratch, with these files (videos, image folders, a calibration) already in it.
  void begin(const QStringList& files);
  /// Adds files to those it has, once it is known what they are; one that ends as calibrations do
  /// is the calibration.
  void addFiles(const QStringList& files);
  /// Asks for videos, and adds them.
  void chooseVideos();
  /// Adds the cameras that are connected to this computer.
  void addConnectedCameras();

Q_SIGNALS:
  /// It is made; the note says what the user should know of it, or is empty.
  void made(const dewpoint::project::Project& project, const QString& note);
  void failed(const QString& sentence);
  void cancelled();

private:
  static std::vector<FootagePlace> placesOf(const std::vector<std::string>& locations);

  QPushButton* addButton(const char* name, const std::function<void()>& act);
  void makeButtons();
  void arrange();
  void retranslateUi();
  /// Finds out in a thread what there is at locations; requests are answered in their order.
  void search(std::function<std::vector<FootagePlace>()> look,
              std::function<void(const std::vector<FootagePlace>&)> found);
  /// Drops what is being searched for or made.
  void forgetWork();
  void addFootage(const std::vector<FootagePlace>& places);
  void chooseFolder();
  void refresh();
  NewProject wanted() const;
  void createProject();
  void finish(const Result<MadeProject>& result);

  QLabel* title_;
  QLabel* lead_;
  QLineEdit* name_;
  QLabel* nameLabel_;
  QStackedWidget* list_; ///< the table, or where to drop videos as long as it is empty
  CameraTable* cameras_;
  DropZone* dropZone_;
  QLabel* note_; ///< what the user should know of recordings that differ
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
  std::unique_ptr<JobQueue> searches_; ///< of this project; one that is given up is not heard
  int underWay_ = 0;                   ///< searches whose rows are still to come
  LatestJob making_{LatestJob::Overtaken::Dropped}; ///< the first image of a video may take long
};

} // namespace dewpoint::ui
