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

  /// Reads the list of recent projects again, and checks which of them still exist.
  void refresh();
  /// Sets whether a project is being opened; the card that was pressed shows it.
  void setOpening(bool opening);

Q_SIGNALS:
  /// The user chose the built-in scene with this name (empty: the demo). `calibrate`: opens its
  /// calibration by hand.
  void sceneWanted(const QString& name, bool calibrate);
  void videosWanted();
  void camerasWanted();
  void projectWanted(const QString& file); ///< empty: the user selects a file

private:
  void makeScenes();
  void makeOwn();
  void arrange();
  void retranslateUi();
  void showRecentTitle();

  RecentProjects& projects_;
  QWidget* page_; ///< scrolled content
  QLabel* title_;
  QLabel* lead_;
  GalleryCard* demo_;
  CardGrid* gallery_;
  std::vector<GalleryCard*> scenes_; ///< cards of the gallery, in the order of kGallery
  QLabel* ownTitle_;
  GalleryCard* videos_;
  GalleryCard* cameras_;
  GalleryCard* open_;
  QLabel* recentTitle_;
  RecentList* recent_;
  QLabel* hint_;
  GalleryCard* pressed_ = nullptr; ///< card that was pressed last
};

} // namespace dewpoint::ui
