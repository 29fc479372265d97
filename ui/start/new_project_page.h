// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/new_project.h"
#include "ui/jobs/job_queue.h"
#include "ui/jobs/latest_job.h"

#include <QSet>
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
class QTableWidget;
class QTableWidgetItem;

namespace dewpoint::ui {

/// Puts a project together: cameras with their sources, and a calibration file.
class NewProjectPage : public QWidget {
  Q_OBJECT
public:
  explicit NewProjectPage(QWidget* parent = nullptr);

  /// Starts from scratch, with these files (videos, image folders, a calibration) already in it.
  void begin(const QStringList& files);
  /// Adds files to those it has, once it is known what they are; a .toml file is the calibration.
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
  /// What there is at a location, found out in a thread: its disk may be slow.
  struct Place {
    std::string location;
    bool showsImages = false; ///< it can be a camera
    bool isFile = false;      ///< or a folder: there, and no device
    bool isImages = false;    ///< a folder of images
  };
  static std::vector<Place> placesOf(const std::vector<std::string>& locations);

  QPushButton* addButton(const char* name, const std::function<void()>& act);
  void makeTable();
  void makeRows();
  void retranslateUi();
  bool isListed(const QString& location) const;
  /// Finds out in a thread what there is at locations; requests are answered in their order.
  void search(std::function<std::vector<Place>()> look,
              std::function<void(const std::vector<Place>&)> found);
  /// Drops what is being searched for or made.
  void forgetWork();
  void addFootage(const std::vector<Place>& places);
  void add(const Place& place);
  void lookAtTyped(const QTableWidgetItem& item);
  void removeRow();
  void chooseFolder();
  void addAddress();
  void chooseCalibration();
  void setCalibration(const QString& file);
  void refresh();
  NewProject wanted() const;
  void createProject();
  void finish(const Result<MadeProject>& result);

  QLabel* title_;
  QLabel* lead_;
  QLineEdit* name_;
  QLabel* nameLabel_;
  QTableWidget* cameras_;
  QPushButton* addVideos_ = nullptr;
  QPushButton* addFolder_ = nullptr;
  QPushButton* addDevices_ = nullptr;
  QPushButton* addAddress_ = nullptr;
  QPushButton* remove_ = nullptr;
  QLabel* calibrationLabel_;
  QLabel* calibration_;
  QPushButton* chooseCalibration_ = nullptr;
  QPushButton* dropCalibration_ = nullptr;
  QLabel* rateLabel_;
  QDoubleSpinBox* rate_;
  QDialogButtonBox* buttons_;
  QPushButton* create_ = nullptr;
  QPushButton* cancel_ = nullptr;
  QString calibrationFile_;
  QSet<QString> imageFolders_;         ///< of the sources; known to be some
  std::unique_ptr<JobQueue> searches_; ///< of this project; one that is given up is not heard
  int underWay_ = 0;                   ///< searches whose rows are still to come
  LatestJob making_{LatestJob::Overtaken::Dropped}; ///< the first image of a video may take long
};

} // namespace dewpoint::ui
