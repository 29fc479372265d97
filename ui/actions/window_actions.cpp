// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/window_actions.h"

#include "ui/actions/action_registry.h"
#include "ui/actions/camera_actions.h"
#include "ui/actions/edit_actions.h"
#include "ui/actions/help_actions.h"

#include <QAction>
#include <QActionGroup>
#include <QCoreApplication>

namespace dewpoint::ui {
namespace {

std::vector<ActionDeclaration> projectActions() {
  const char* group = QT_TRANSLATE_NOOP("Actions", "File");
  return {
      {"actionNew", group, QT_TRANSLATE_NOOP("Actions", "New project…"),
       QT_TRANSLATE_NOOP("Actions", "Create a project from videos or connected cameras"), "new",
       QKeySequence::New},
      {"actionOpen", group, QT_TRANSLATE_NOOP("Actions", "Open project…"),
       QT_TRANSLATE_NOOP("Actions", "Open a project file"), "open", QKeySequence::Open},
      {"actionOpenDemo", group, QT_TRANSLATE_NOOP("Actions", "Open the demo"),
       QT_TRANSLATE_NOOP("Actions", "Open the simulated demo scene")},
      {"actionSave", group, QT_TRANSLATE_NOOP("Actions", "Save"),
       QT_TRANSLATE_NOOP("Actions", "Save the changes to the project file"), "save",
       QKeySequence::Save},
      {"actionSaveAs", group, QT_TRANSLATE_NOOP("Actions", "Save as…"),
       QT_TRANSLATE_NOOP("Actions", "Save the project under another name"), nullptr,
       Qt::CTRL | Qt::SHIFT | Qt::Key_S},
      {"actionExportTrajectory", group, QT_TRANSLATE_NOOP("Actions", "Export trajectory…"),
       QT_TRANSLATE_NOOP("Actions", "Export the trajectory so far for use in another program"),
       "export", Qt::CTRL | Qt::Key_E},
      {"actionExportPeople", group, QT_TRANSLATE_NOOP("Actions", "Export 3D shapes of people…"),
       QT_TRANSLATE_NOOP(
           "Actions",
           "Save tables of each person's position, volume, hull and density on the floor"),
       nullptr, Qt::CTRL | Qt::ALT | Qt::Key_P},
      {"actionExportVideo", group, QT_TRANSLATE_NOOP("Actions", "Export video…"),
       QT_TRANSLATE_NOOP("Actions", "Save the camera views and the bird's-eye view as a video"),
       nullptr, Qt::CTRL | Qt::ALT | Qt::Key_E},
      {"actionSavePicture", group, QT_TRANSLATE_NOOP("Actions", "Save a picture of a view…"),
       QT_TRANSLATE_NOOP("Actions", "Save a camera image, the bird's-eye view or a plot as PNG"),
       nullptr, Qt::CTRL | Qt::SHIFT | Qt::Key_P},
      {"actionCloseProject", group, QT_TRANSLATE_NOOP("Actions", "Close project"),
       QT_TRANSLATE_NOOP("Actions", "Go back to the start page"), nullptr, QKeySequence::Close},
      {"actionQuit", group, QT_TRANSLATE_NOOP("Actions", "Quit"),
       QT_TRANSLATE_NOOP("Actions", "Quit Dewpoint"), nullptr, QKeySequence::Quit},
  };
}

std::vector<ActionDeclaration> calibrationActions() {
  const char* group = QT_TRANSLATE_NOOP("Actions", "Calibration");
  return {
      {"actionCalibrate", group, QT_TRANSLATE_NOOP("Actions", "Calibrate…"),
       QT_TRANSLATE_NOOP("Actions", "See what is known about the cameras, and calibrate them step "
                                    "by step in the way that you choose"),
       nullptr, Qt::CTRL | Qt::ALT | Qt::Key_G},
      {"actionCalibrateByHand", group, QT_TRANSLATE_NOOP("Actions", "Calibrate by hand…"),
       QT_TRANSLATE_NOOP("Actions", "Adjust the calibration of the cameras until a grid drawn over "
                                    "their images matches the real scene"),
       "camera", Qt::Key_C, true},
      {"actionCalibrateBoard", group, QT_TRANSLATE_NOOP("Actions", "Calibrate with a board…"),
       QT_TRANSLATE_NOOP("Actions",
                         "Find the intrinsics and positions of the cameras with a printed board"),
       nullptr, Qt::SHIFT | Qt::Key_C},
      {"actionPrintBoard", group, QT_TRANSLATE_NOOP("Actions", "Print a calibration board…"),
       QT_TRANSLATE_NOOP("Actions", "Save the calibration board as a PDF at its true size")},
      {"actionCalibrateWand", group, QT_TRANSLATE_NOOP("Actions", "Calibrate with a wand…"),
       QT_TRANSLATE_NOOP("Actions",
                         "Refine the calibration by waving a ball, or a wand with two balls"),
       nullptr, Qt::SHIFT | Qt::Key_V},
      {"actionCalibrateWorld", group, QT_TRANSLATE_NOOP("Actions", "Set floor and origin…"),
       QT_TRANSLATE_NOOP("Actions", "Set the floor, the origin, the axes and the scale of the room "
                                    "with points that you mark in the images"),
       nullptr, Qt::SHIFT | Qt::Key_O},
      {"actionImportCalibration", group, QT_TRANSLATE_NOOP("Actions", "Import calibration…"),
       QT_TRANSLATE_NOOP(
           "Actions", "Load the calibration of the cameras from a file that another program wrote"),
       nullptr, Qt::CTRL | Qt::SHIFT | Qt::Key_I},
      {"actionExportCalibration", group, QT_TRANSLATE_NOOP("Actions", "Export calibration…"),
       QT_TRANSLATE_NOOP("Actions", "Save the calibration of the cameras for another program"),
       nullptr, Qt::CTRL | Qt::SHIFT | Qt::Key_E},
      {"actionPlanRig", group, QT_TRANSLATE_NOOP("Actions", "Plan the rig…"),
       QT_TRANSLATE_NOOP(
           "Actions",
           "See how accurately the cameras will measure, and where another camera would help"),
       nullptr, Qt::SHIFT | Qt::Key_G},
      {"actionShowMap", group, QT_TRANSLATE_NOOP("Actions", "Show error map"),
       QT_TRANSLATE_NOOP(
           "Actions",
           "In the bird's-eye view, show the position error to expect for a target at each point"),
       nullptr, Qt::SHIFT | Qt::Key_M, true},
      {"actionPlanCamera", group, QT_TRANSLATE_NOOP("Actions", "Add planned camera"),
       QT_TRANSLATE_NOOP("Actions", "Add a planned camera; you can then drag it in the bird's-eye "
                                    "view to try out where to place it"),
       nullptr, Qt::SHIFT | Qt::Key_P},
      {"actionResolveCamera", group, QT_TRANSLATE_NOOP("Actions", "Recompute pose of moved camera"),
       QT_TRANSLATE_NOOP("Actions", "Recompute the pose of the camera that was moved during the "
                                    "run; all other cameras stay unchanged"),
       nullptr, Qt::CTRL | Qt::SHIFT | Qt::Key_B},
      {"actionFindPlace", group, QT_TRANSLATE_NOOP("Actions", "Find best camera position"),
       QT_TRANSLATE_NOOP("Actions", "Search the walls and the ceiling for the position where "
                                    "another camera would help most"),
       nullptr, Qt::SHIFT | Qt::Key_F},
  };
}

std::vector<ActionDeclaration> runActions() {
  const char* group = QT_TRANSLATE_NOOP("Actions", "Run");
  return {
      {"actionPlay", group, QT_TRANSLATE_NOOP("Actions", "Play"),
       QT_TRANSLATE_NOOP("Actions", "Play or pause"), "play", Qt::Key_Space},
      {"actionNextFrame", group, QT_TRANSLATE_NOOP("Actions", "Next frame"),
       QT_TRANSLATE_NOOP("Actions", "Track one frame and pause"), "next-frame", Qt::Key_Period},
      {"actionNextIteration", group, QT_TRANSLATE_NOOP("Actions", "One iteration"),
       QT_TRANSLATE_NOOP("Actions", "Run one filter iteration on the current frame and pause"),
       "iteration", Qt::Key_I},
      {"actionPreviousFrame", group, QT_TRANSLATE_NOOP("Actions", "Previous frame"),
       QT_TRANSLATE_NOOP("Actions", "Step back one frame and show its tracking result"),
       "previous-frame", Qt::Key_Comma},
      {"actionNow", group, QT_TRANSLATE_NOOP("Actions", "Go to latest frame"),
       QT_TRANSLATE_NOOP("Actions", "Stop looking back and show the latest tracked frame"), "now",
       Qt::Key_N},
      {"actionRerun", group, QT_TRANSLATE_NOOP("Actions", "Track again from here"),
       QT_TRANSLATE_NOOP("Actions", "Track again from the frame shown, with the current method, "
                                    "parameters and colors. To stop, press Pause"),
       "rerun", Qt::CTRL | Qt::Key_R},
      {"actionTrackAgain", group, QT_TRANSLATE_NOOP("Actions", "Track again"),
       QT_TRANSLATE_NOOP("Actions",
                         "Track again every frame that was last tracked with earlier settings"),
       nullptr, Qt::CTRL | Qt::SHIFT | Qt::Key_R},
      {"actionSlower", group, QT_TRANSLATE_NOOP("Actions", "Slower"),
       QT_TRANSLATE_NOOP("Actions",
                         "Play the recording more slowly, down to 1/30 of the normal speed"),
       nullptr, Qt::Key_BracketLeft},
      {"actionFaster", group, QT_TRANSLATE_NOOP("Actions", "Faster"),
       QT_TRANSLATE_NOOP("Actions",
                         "Play the recording faster, up to eight times the normal speed"),
       nullptr, Qt::Key_BracketRight},
      {"actionNormalSpeed", group, QT_TRANSLATE_NOOP("Actions", "Normal speed"),
       QT_TRANSLATE_NOOP("Actions", "Play the recording as fast as it was filmed"), nullptr,
       Qt::Key_Backslash},
      {"actionSlowStart", group, QT_TRANSLATE_NOOP("Actions", "Play slowly until converged"),
       QT_TRANSLATE_NOOP("Actions", "Play the first iterations of a run one by one, until every "
                                    "target is being tracked (five seconds at most)"),
       nullptr, Qt::SHIFT | Qt::Key_Space, true},
      {"actionAddMark", group, QT_TRANSLATE_NOOP("Actions", "Add marker"),
       QT_TRANSLATE_NOOP("Actions", "Add a named marker at the frame shown"), "mark", Qt::Key_K},
      {"actionRemoveMark", group, QT_TRANSLATE_NOOP("Actions", "Remove marker"),
       QT_TRANSLATE_NOOP("Actions", "Remove the marker at the frame shown"), nullptr,
       Qt::SHIFT | Qt::Key_K},
      {"actionPreviousMark", group, QT_TRANSLATE_NOOP("Actions", "Previous marker"),
       QT_TRANSLATE_NOOP("Actions", "Go to the previous marker"), nullptr,
       Qt::CTRL | Qt::Key_PageUp},
      {"actionNextMark", group, QT_TRANSLATE_NOOP("Actions", "Next marker"),
       QT_TRANSLATE_NOOP("Actions", "Go to the next marker"), nullptr, Qt::CTRL | Qt::Key_PageDown},
      {"actionGoToFrame", group, QT_TRANSLATE_NOOP("Actions", "Go to frame…"),
       QT_TRANSLATE_NOOP("Actions", "Enter a frame number, or a time such as 2.5 s, and go there"),
       nullptr, Qt::CTRL | Qt::Key_G},
      {"actionPreviousTrouble", group, QT_TRANSLATE_NOOP("Actions", "Previous trouble"),
       QT_TRANSLATE_NOOP("Actions",
                         "Go back to the frame where tracking of the selected target was "
                         "lost or became uncertain, or where a camera had a problem. If "
                         "no target is selected, all targets count"),
       nullptr, Qt::CTRL | Qt::SHIFT | Qt::Key_PageUp},
      {"actionNextTrouble", group, QT_TRANSLATE_NOOP("Actions", "Next trouble"),
       QT_TRANSLATE_NOOP("Actions", "Go to the next frame where tracking of the selected target is "
                                    "lost or becomes uncertain, or where a camera has a problem. "
                                    "If no target is selected, all targets count"),
       nullptr, Qt::CTRL | Qt::SHIFT | Qt::Key_PageDown},
      {"actionZoomToSpan", group, QT_TRANSLATE_NOOP("Actions", "Zoom to the selected time span"),
       QT_TRANSLATE_NOOP("Actions", "Fill the timeline with the selected span of the recording"),
       nullptr, Qt::Key_Z},
      {"actionRestart", group, QT_TRANSLATE_NOOP("Actions", "Restart"),
       QT_TRANSLATE_NOOP("Actions", "Start the run again with the same random numbers"), "restart",
       Qt::Key_R},
      {"actionRestartNewSeed", group, QT_TRANSLATE_NOOP("Actions", "Restart with a new seed"),
       QT_TRANSLATE_NOOP("Actions", "Start the run again with other random numbers"), "restart-new",
       Qt::SHIFT | Qt::Key_R},
      {"actionRecord", group, QT_TRANSLATE_NOOP("Actions", "Record"),
       QT_TRANSLATE_NOOP("Actions",
                         "Record the live cameras into a folder that opens as a project, "
                         "or stop recording"),
       "record", Qt::Key_F9, true},
      {"actionTakeNotes", group, QT_TRANSLATE_NOOP("Actions", "Set take number and notes…"),
       QT_TRANSLATE_NOOP(
           "Actions",
           "Set the number and notes of the next take, or the notes of the current take")},
      {"actionSendResults", group, QT_TRANSLATE_NOOP("Actions", "Send results"),
       QT_TRANSLATE_NOOP("Actions", "Start or stop sending positions to other programs during the "
                                    "run. Until you start sending, nothing is sent"),
       nullptr, Qt::SHIFT | Qt::Key_F9, true},
      {"actionOutputs", group, QT_TRANSLATE_NOOP("Actions", "Outputs…"),
       QT_TRANSLATE_NOOP("Actions",
                         "Choose where results are sent: TCP, WebSocket, OSC, TUIO, CSV")},
      {"actionFilterThreads", group, QT_TRANSLATE_NOOP("Actions", "Filter threads…"),
       QT_TRANSLATE_NOOP("Actions", "Choose how many processor threads compute the filter"),
       nullptr, Qt::CTRL | Qt::ALT | Qt::Key_F},
      {"actionExperiments", group, QT_TRANSLATE_NOOP("Actions", "Experiments…"),
       QT_TRANSLATE_NOOP(
           "Actions",
           "Reproduce figures from the papers that describe the methods, and write a report"),
       nullptr, Qt::CTRL | Qt::SHIFT | Qt::Key_X},
  };
}

std::vector<ActionDeclaration> viewActions() {
  const char* group = QT_TRANSLATE_NOOP("Actions", "View");
  return {
      {"actionShowMask", group, QT_TRANSLATE_NOOP("Actions", "Show mask"),
       QT_TRANSLATE_NOOP("Actions", "Show which pixels have the color of a target"), "mask",
       Qt::Key_M, true},
      {"actionShowEvidence", group, QT_TRANSLATE_NOOP("Actions", "Show likelihood map"),
       QT_TRANSLATE_NOOP("Actions", "Show how likely each position around the target is. Circles "
                                    "mark positions at which the method suspects the target"),
       "evidence", Qt::Key_E, true},
      {"actionShowBest", group, QT_TRANSLATE_NOOP("Actions", "Show best particle"),
       QT_TRANSLATE_NOOP("Actions", "In all views, draw a triangle at the particle of each target "
                                    "that has the highest weight"),
       nullptr, Qt::SHIFT | Qt::Key_E, true},
      {"actionShowMagnifier", group, QT_TRANSLATE_NOOP("Actions", "Show magnifier"),
       QT_TRANSLATE_NOOP(
           "Actions",
           "When a target's particles are too close together to tell apart, show them enlarged"),
       nullptr, Qt::SHIFT | Qt::Key_I, true},
      {"actionShowRays", group, QT_TRANSLATE_NOOP("Actions", "Show lines of sight"),
       QT_TRANSLATE_NOOP("Actions",
                         "In the bird's-eye view, draw a line from each camera to the target. The "
                         "line is dashed if the camera cannot see the target"),
       nullptr, Qt::SHIFT | Qt::Key_Y, true},
      {"actionShowImagesInScene", group,
       QT_TRANSLATE_NOOP("Actions", "Show images in the bird's-eye view"),
       QT_TRANSLATE_NOOP(
           "Actions", "Show each camera's image inside its viewing pyramid in the bird's-eye view"),
       nullptr, Qt::SHIFT | Qt::Key_U, true},
      {"actionShowVolumeOfInterest", group,
       QT_TRANSLATE_NOOP("Actions", "Show the volume of interest"),
       QT_TRANSLATE_NOOP("Actions",
                         "Draw the volume of interest in the images and in the bird's-eye view: "
                         "targets are searched for only inside this box"),
       nullptr, Qt::SHIFT | Qt::Key_H, true},
      {"actionShowVolumes", group, QT_TRANSLATE_NOOP("Actions", "Show 3D shapes of people"),
       QT_TRANSLATE_NOOP(
           "Actions", "Show the hull that encloses 95 % of each person's volume, and lines on the "
                      "floor around the areas that contain 25, 50, 75 and 95 % of each person"),
       nullptr, Qt::Key_H, true},
      {"actionZoomIn", group, QT_TRANSLATE_NOOP("Actions", "Zoom in"),
       QT_TRANSLATE_NOOP("Actions", "Zoom in on the camera image under the pointer, or on the "
                                    "image of the selected camera (or use the mouse wheel)"),
       nullptr, Qt::CTRL | Qt::Key_Plus},
      {"actionZoomOut", group, QT_TRANSLATE_NOOP("Actions", "Zoom out"),
       QT_TRANSLATE_NOOP("Actions", "Zoom out of the camera image under the pointer, or of the "
                                    "image of the selected camera"),
       nullptr, Qt::CTRL | Qt::Key_Minus},
      {"actionFitImage", group, QT_TRANSLATE_NOOP("Actions", "Fit image"),
       QT_TRANSLATE_NOOP("Actions", "Show the whole camera image (or double-click)"), nullptr,
       Qt::CTRL | Qt::Key_0},
      {"actionLookFromAbove", group, QT_TRANSLATE_NOOP("Actions", "Top view"),
       QT_TRANSLATE_NOOP("Actions", "Show the room from above in the bird's-eye view (XY plane)"),
       "above", Qt::Key_A},
      {"actionLookFromFront", group, QT_TRANSLATE_NOOP("Actions", "Front view"),
       QT_TRANSLATE_NOOP("Actions",
                         "Show the room from the front in the bird's-eye view (XZ plane)"),
       "front", Qt::Key_F},
      {"actionLookFromSide", group, QT_TRANSLATE_NOOP("Actions", "Side view"),
       QT_TRANSLATE_NOOP("Actions",
                         "Show the room from the side in the bird's-eye view (YZ plane)"),
       "side", Qt::Key_Y},
      {"actionLookFree", group, QT_TRANSLATE_NOOP("Actions", "3D view"),
       QT_TRANSLATE_NOOP("Actions", "Bird's-eye view in perspective; drag to rotate it"), "free",
       Qt::Key_V},
      {"actionFitScene", group, QT_TRANSLATE_NOOP("Actions", "Fit everything in view"),
       QT_TRANSLATE_NOOP("Actions", "Show the whole room in the bird's-eye view (or double-click)"),
       nullptr, Qt::SHIFT | Qt::Key_A},
      {"actionPalette", group, QT_TRANSLATE_NOOP("Actions", "Search actions…"),
       QT_TRANSLATE_NOOP("Actions", "Find any action by its name"), "search", Qt::CTRL | Qt::Key_K},
      {"actionResetLayout", group, QT_TRANSLATE_NOOP("Actions", "Reset layout"),
       QT_TRANSLATE_NOOP("Actions", "Restore the default arrangement of the views"), nullptr,
       Qt::CTRL | Qt::SHIFT | Qt::Key_L},
      {"actionFullScreen", group, QT_TRANSLATE_NOOP("Actions", "Full screen"),
       QT_TRANSLATE_NOOP("Actions", "Switch between full screen and a normal window"), nullptr,
       Qt::Key_F11, true},
      {"actionThemeSystem", group, QT_TRANSLATE_NOOP("Actions", "Follow system"),
       QT_TRANSLATE_NOOP("Actions", "Use the system's light or dark colors"), nullptr,
       Qt::CTRL | Qt::ALT | Qt::Key_7, true},
      {"actionThemeLight", group, QT_TRANSLATE_NOOP("Actions", "Light"),
       QT_TRANSLATE_NOOP("Actions", "Light colors"), nullptr, Qt::CTRL | Qt::ALT | Qt::Key_8, true},
      {"actionThemeDark", group, QT_TRANSLATE_NOOP("Actions", "Dark"),
       QT_TRANSLATE_NOOP("Actions", "Dark colors"), nullptr, Qt::CTRL | Qt::ALT | Qt::Key_9, true},
  };
}

std::vector<ActionDeclaration> plotActions() {
  const char* group = QT_TRANSLATE_NOOP("Actions", "Plots");
  return {
      {"actionPlotPosition", group, QT_TRANSLATE_NOOP("Actions", "Plot position"),
       QT_TRANSLATE_NOOP("Actions", "Position along x, y and z, with a band of plus and minus two "
                                    "standard deviations, and the true position if it is known"),
       nullptr, Qt::CTRL | Qt::Key_1, true},
      {"actionPlotSpread", group, QT_TRANSLATE_NOOP("Actions", "Plot spread"),
       QT_TRANSLATE_NOOP("Actions", "Standard deviation of the particles along x, y and z"),
       nullptr, Qt::CTRL | Qt::Key_2, true},
      {"actionPlotSampleSize", group, QT_TRANSLATE_NOOP("Actions", "Plot effective sample size"),
       QT_TRANSLATE_NOOP("Actions", "Effective sample size, and number of particles"), nullptr,
       Qt::CTRL | Qt::Key_3, true},
      {"actionPlotLikelihood", group, QT_TRANSLATE_NOOP("Actions", "Plot likelihood"),
       QT_TRANSLATE_NOOP("Actions", "How well the estimate fits each camera's image"), nullptr,
       Qt::CTRL | Qt::Key_4, true},
      {"actionPlotExistence", group, QT_TRANSLATE_NOOP("Actions", "Plot existence"),
       QT_TRANSLATE_NOOP(
           "Actions",
           "Existence probability: from all cameras together, and from each camera alone"),
       nullptr, Qt::CTRL | Qt::Key_5, true},
      {"actionPlotError", group, QT_TRANSLATE_NOOP("Actions", "Plot error"),
       QT_TRANSLATE_NOOP("Actions",
                         "Distance between estimate and ground truth, if the truth is known"),
       nullptr, Qt::CTRL | Qt::Key_6, true},
      {"actionPlotDuration", group, QT_TRANSLATE_NOOP("Actions", "Plot time per step"),
       QT_TRANSLATE_NOOP("Actions",
                         "Time that one filter iteration takes for one target, in microseconds"),
       nullptr, Qt::CTRL | Qt::Key_7, true},
      {"actionPlotOverTime", group, QT_TRANSLATE_NOOP("Actions", "Plot over time"),
       QT_TRANSLATE_NOOP("Actions", "Plot against time in seconds instead of filter iterations"),
       nullptr, Qt::SHIFT | Qt::Key_T, true},
      {"actionPlotAll", group, QT_TRANSLATE_NOOP("Actions", "Show whole run"),
       QT_TRANSLATE_NOOP("Actions", "Show the whole run in the plots again (or double-click)"),
       nullptr, Qt::CTRL | Qt::SHIFT | Qt::Key_0},
      {"actionPlotCopy", group, QT_TRANSLATE_NOOP("Actions", "Copy plots as CSV"),
       QT_TRANSLATE_NOOP("Actions", "Copy the numbers of all plots shown, as a table"), nullptr,
       Qt::CTRL | Qt::ALT | Qt::Key_C},
      {"actionPlotSave", group, QT_TRANSLATE_NOOP("Actions", "Save plots as picture…"),
       QT_TRANSLATE_NOOP("Actions", "Save a picture of the plots as they look now, as SVG or PNG"),
       nullptr, Qt::CTRL | Qt::ALT | Qt::Key_S},
      {"actionTrajectoryCopy", group, QT_TRANSLATE_NOOP("Actions", "Copy trajectory as CSV"),
       QT_TRANSLATE_NOOP(
           "Actions", "Copy the selected rows of the trajectory, or all rows if none is selected"),
       nullptr, Qt::CTRL | Qt::ALT | Qt::Key_T},
  };
}

} // namespace

void declareWindowActions(ActionRegistry& registry) {
  for (const auto& group : {projectActions(), editActions(), cameraActions(), calibrationActions(),
                            runActions(), viewActions(), plotActions(), helpActions()}) {
    for (const ActionDeclaration& declaration : group) {
      registry.add(declaration);
    }
  }
  registry.action("actionShowRays")->setChecked(true);
  registry.action("actionShowVolumes")->setChecked(true);
  registry.action("actionShowVolumeOfInterest")->setChecked(true);
  registry.action("actionShowMagnifier")->setChecked(true);
  registry.addAlternativeShortcut("actionRedo", Qt::CTRL | Qt::Key_Y);
  registry.addAlternativeShortcut("actionRedo", Qt::CTRL | Qt::SHIFT | Qt::Key_Z);
  auto* themes = new QActionGroup(&registry);
  themes->addAction(registry.action("actionThemeSystem"));
  themes->addAction(registry.action("actionThemeLight"));
  themes->addAction(registry.action("actionThemeDark"));
}

} // namespace dewpoint::ui
