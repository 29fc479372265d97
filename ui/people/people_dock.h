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

/// Methods for people in the window: who is there, who stands where, and what is exported of them.
/// While such a method is chosen, its panel replaces those of the other methods.
class PeopleDock : public QObject {
  Q_OBJECT
public:
  /// `others`: docks that mean nothing to people, nor theirs to other methods.
  PeopleDock(const Workbench& bench, const CameraDocks& cameras, BirdsEyeView& birdsEye,
             std::vector<ViewDock*> others);

  /// A click into the image of a camera, pixels: selects the person who is seen there.
  void selectSeenAt(int camera, const QPointF& pixel);

private:
  void connectActions();
  void connectPlacer(const CameraDocks& cameras);
  /// The docks and actions that the method has a use for.
  void updateForMethod();
  void placePeople(bool placing);
  void askExport();
  /// Writes the tables of this run, of those counted by run_; an error if it is over.
  void write(const QString& folder, int run);
  bool isOfPeople() const;
  /// An undoable step of the document, about the frame that is shown.
  void correct(const QString& step, PersonCorrection correction);

  Workbench bench_;
  PeoplePanel* panel_;
  AddPersonTool* placer_;
  LatestJob* check_;   ///< whether there are tables already
  LatestJob* writing_; ///< writes tables; while it does, the next ones wait
  int run_ = 0;        ///< grows with every end of a run
  ViewDock* dock_;
  std::vector<ViewDock*> others_;
};

} // namespace dewpoint::ui
