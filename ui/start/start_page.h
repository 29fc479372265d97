// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QWidget>

#include <vector>

class QLabel;

namespace dewpoint::ui {

class CardGrid;
class GalleryCard;
class RecentList;
class RecentProjects;

/// Page shown while no project is open: a gallery of scenes to try, ways to start with your own
/// videos and cameras, and recent projects.
class StartPage : public QWidget {
  Q_OBJECT
public:
  explicit StartPage(RecentProjects& recent, QWidget* parent = nullptr);

  /// Rereads the list of recent projects, and checks which of them still exist.
  void refresh();
  /// Sets whether a project is being opened. If so, the card that was pressed shows a text about
  /// it.
  void setOpening(bool opening);

Q_SIGNALS:
  /// Emitted when the user selects the built-in scene with this name (empty for the demo). If
  /// `calibrate` is true, the page for calibration by hand must also be opened.
  void builtInSceneRequested(const QString& name, bool calibrate);
  void startWithVideosRequested();
  void startWithCamerasRequested();
  void calibrationRequested(); ///< the user wants to calibrate videos with the calibration guide
  /// Emitted when the user wants to open this project; empty if the user should select a file.
  void projectRequested(const QString& file);

private:
  void makeScenes();
  void makeOwnRecordingCards();
  void arrange();
  void retranslateUi();
  void showRecentTitle();

  RecentProjects& projects_;
  QWidget* page_; ///< scrolled content
  QLabel* title_;
  QLabel* intro_;
  GalleryCard* demo_;
  CardGrid* gallery_;
  std::vector<GalleryCard*> scenes_; ///< gallery cards, in the order of kGallery
  QLabel* ownTitle_;
  GalleryCard* videos_;
  GalleryCard* cameras_;
  GalleryCard* calibrate_;
  GalleryCard* open_;
  QLabel* recentTitle_;
  RecentList* recent_;
  QLabel* hint_;
  GalleryCard* pressed_ = nullptr; ///< last card that was pressed
};

} // namespace dewpoint::ui
