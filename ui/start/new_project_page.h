// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/new_project.h"
#include "ui/jobs/latest_job.h"

#include <QWidget>

#include <functional>

class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;

namespace dewpoint::ui {

/// Puts a project together: cameras with their sources, and a calibration file.
class NewProjectPage : public QWidget {
  Q_OBJECT
public:
  explicit NewProjectPage(QWidget* parent = nullptr);

  /// Starts from scratch, with these files (videos, image folders, a calibration) already in it.
  void begin(const QStringList& files);
  /// Adds files to those it has; a .toml file is the calibration.
  void addFiles(const QStringList& files);
  /// Asks for videos, and adds them.
  void chooseVideos();
  /// Adds the cameras that are connected to this computer.
  void addConnectedCameras();

Q_SIGNALS:
  /// It is made; the note says what the person should know of it, or is empty.
  void made(const dewpoint::project::Project& project, const QString& note);
  void failed(const QString& sentence);
  void cancelled();

private:
  QPushButton* addButton(const char* name, const std::function<void()>& act);
  void makeTable();
  void makeRows();
  void retranslateUi();
  bool isListed(const QString& location) const;
  void add(const QString& location);
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
  QPushButton* create_ = nullptr;
  QPushButton* cancel_ = nullptr;
  QString calibrationFile_;
  LatestJob making_{LatestJob::Overtaken::Dropped}; ///< the first image of a video may take long
};

} // namespace dewpoint::ui
