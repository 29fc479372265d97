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

/// What the user sees while no project is open: a gallery of scenes to try, the ways to begin with
/// videos and cameras of one's own, and what was open last.
class StartPage : public QWidget {
  Q_OBJECT
public:
  explicit StartPage(RecentProjects& recent, QWidget* parent = nullptr);

  /// Reads the list of recent projects again, and finds out which of them are still there.
  void refresh();
  /// Whether something is being opened: the card that was pressed says so.
  void setOpening(bool opening);

Q_SIGNALS:
  /// The built-in scene with this name (empty: the demo); `calibrate`: with its calibration by hand
  /// open.
  void sceneWanted(const QString& name, bool calibrate);
  void videosWanted();
  void camerasWanted();
  void projectWanted(const QString& file); ///< empty: to be chosen

private:
  void makeScenes();
  void makeOwn();
  void arrange();
  void retranslateUi();
  void showRecentTitle();

  RecentProjects& projects_;
  QWidget* page_; ///< what is scrolled
  QLabel* title_;
  QLabel* lead_;
  GalleryCard* demo_;
  CardGrid* gallery_;
  std::vector<GalleryCard*> scenes_; ///< of the gallery, in the order of kGallery
  QLabel* ownTitle_;
  GalleryCard* videos_;
  GalleryCard* cameras_;
  GalleryCard* open_;
  QLabel* recentTitle_;
  RecentList* recent_;
  QLabel* hint_;
  GalleryCard* pressed_ = nullptr; ///< the card that was pressed last
};

} // namespace dewpoint::ui
