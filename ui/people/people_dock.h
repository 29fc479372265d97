// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/workbench/workbench.h"

#include <Eigen/Core>

#include <vector>

class QPointF;

namespace dewpoint::project {
struct PersonCorrection;
} // namespace dewpoint::project

namespace dewpoint::ui {

class BirdsEyeView;
class CameraDocks;
class LatestJob;
class PeoplePanel;
class AddPersonTool;
class ViewDock;

/// Adds everything for methods that track people to the window: a dock that shows who is present
/// and where, corrections, and the export of tables. While such a method is selected, this dock
/// replaces docks that are only for other methods.
class PeopleDock : public QObject {
  Q_OBJECT
public:
  /// Creates the dock. `others` are docks that methods for people do not use; they are hidden while
  /// the people dock is shown.
  PeopleDock(const Workbench& bench, const CameraDocks& cameras, BirdsEyeView& birdsEye,
             std::vector<ViewDock*> others);

  /// Selects the person seen at a pixel of a camera image.
  void selectPersonAt(int camera, const QPointF& pixel);

private:
  void connectActions();
  void connectPlacer(const CameraDocks& cameras);
  /// Shows or hides docks and actions depending on the method.
  void updateForMethod();
  void placePeople(bool placing);
  void requestExport();
  /// Writes the tables of the run with number `run` (see `run_`). Reports an error if that run is
  /// over.
  void writeTables(const QString& folder, int run);
  bool tracksPeople() const;
  /// Applies a correction to the frame shown, in an undoable step of the document.
  void correct(const QString& step, PersonCorrection correction);

  Workbench bench_;
  PeoplePanel* panel_;
  AddPersonTool* addPersonTool_;
  LatestJob* check_;   ///< checks whether the tables already exist
  LatestJob* writing_; ///< writes tables; the next request waits until this is done
  int run_ = 0;        ///< incremented at the end of each run
  ViewDock* dock_;
  std::vector<ViewDock*> others_;
};

} // namespace dewpoint::ui
