// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <array>
#include <cstddef>
#include <string_view>

namespace dewpoint::ui {

/// Names of all actions of the window. Each name is the object name of a QAction, and the key under
/// which the preferences store the action's shortcut, so an existing name must not change.
inline constexpr auto kActionNames = std::to_array<std::string_view>({
    "actionNew",
    "actionOpen",
    "actionOpenDemo",
    "actionSave",
    "actionSaveAs",
    "actionExportTrajectory",
    "actionExportPeople",
    "actionExportVideo",
    "actionSavePicture",
    "actionCloseProject",
    "actionQuit",
    "actionUndo",
    "actionRedo",
    "actionLearnColor",
    "actionAddTarget",
    "actionRemoveTarget",
    "actionHideTarget",
    "actionCameras",
    "actionLockColors",
    "actionPlacePerson",
    "actionRemovePerson",
    "actionCorrectPosition",
    "actionRemoveCorrection",
    "actionShortcuts",
    "actionCalibrate",
    "actionCalibrateByHand",
    "actionCalibrateBoard",
    "actionPrintBoard",
    "actionCalibrateWand",
    "actionCalibrateWorld",
    "actionImportCalibration",
    "actionExportCalibration",
    "actionPlanRig",
    "actionShowMap",
    "actionPlanCamera",
    "actionResolveCamera",
    "actionFindPlace",
    "actionPlay",
    "actionNextFrame",
    "actionNextIteration",
    "actionPreviousFrame",
    "actionNow",
    "actionRerun",
    "actionTrackAgain",
    "actionSlower",
    "actionFaster",
    "actionNormalSpeed",
    "actionSlowStart",
    "actionAddMark",
    "actionRemoveMark",
    "actionPreviousMark",
    "actionNextMark",
    "actionGoToFrame",
    "actionPreviousTrouble",
    "actionNextTrouble",
    "actionZoomToSpan",
    "actionRecord",
    "actionTakeNotes",
    "actionSendResults",
    "actionOutputs",
    "actionRestart",
    "actionRestartNewSeed",
    "actionFilterThreads",
    "actionExperiments",
    "actionShowMask",
    "actionShowEvidence",
    "actionShowBest",
    "actionShowMagnifier",
    "actionShowRays",
    "actionShowImagesInScene",
    "actionShowVolumeOfInterest",
    "actionShowVolumes",
    "actionZoomIn",
    "actionZoomOut",
    "actionFitImage",
    "actionLookFromAbove",
    "actionLookFromFront",
    "actionLookFromSide",
    "actionLookFree",
    "actionFitScene",
    "actionPalette",
    "actionResetLayout",
    "actionFullScreen",
    "actionThemeSystem",
    "actionThemeLight",
    "actionThemeDark",
    "actionPlotPosition",
    "actionPlotSpread",
    "actionPlotSampleSize",
    "actionPlotLikelihood",
    "actionPlotExistence",
    "actionPlotError",
    "actionPlotDuration",
    "actionPlotOverTime",
    "actionPlotAll",
    "actionPlotCopy",
    "actionPlotSave",
    "actionTrajectoryCopy",
    "actionManual",
    "actionQuickStart",
    "actionLegend",
    "actionMethods",
    "actionMessages",
    "actionCheckProject",
    "actionReportProblem",
    "actionAbout",
});

/// Identifies an action by its name. A name that is not in `kActionNames` does not compile.
class ActionId {
public:
  // NOLINTNEXTLINE(google-explicit-constructor): a name converts to its id
  consteval ActionId(const char* name) : index_(indexOf(name)) {}
  /// Creates a separator for a list of actions, for example in a menu.
  // NOLINTNEXTLINE(google-explicit-constructor)
  consteval ActionId(std::nullptr_t) : index_(kActionNames.size()) {}

  constexpr bool isSeparator() const { return index_ == kActionNames.size(); }
  /// Returns the index in `kActionNames`. Not valid for a separator.
  constexpr std::size_t index() const { return index_; }
  constexpr std::string_view name() const { return kActionNames[index_]; }

private:
  static consteval std::size_t indexOf(std::string_view name) {
    for (std::size_t k = 0; k < kActionNames.size(); ++k) {
      if (kActionNames[k] == name) {
        return k;
      }
    }
    throw "there is no action with this name"; // stops the compilation
  }

  std::size_t index_;
};

} // namespace dewpoint::ui
