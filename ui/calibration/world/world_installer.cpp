// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/world/world_installer.h"

#include "ui/calibration/calibration_mode.h"
#include "ui/calibration/world/board_floor.h"
#include "ui/calibration/world/world_mark_tool.h"
#include "ui/calibration/world/world_marks.h"
#include "ui/calibration/world/world_page.h"
#include "ui/cameraview/camera_docks.h"
#include "ui/cameraview/camera_view.h"

#include <QAction>

namespace dewpoint::ui {
namespace {

constexpr QLatin1String kWorldPage("worldPage");

} // namespace

void installWorldPage(const Workbench& bench, CalibrationMode& mode, const CameraDocks& cameras) {
  auto* marks = new WorldMarks(bench.document, &mode);
  auto* boardFloor = new BoardFloor(bench.document, &mode);
  bench.connectView(boardFloor);
  mode.addPage(new WorldPage(*marks, *boardFloor, bench.cameras),
               [] { return WorldPage::tr("Floor"); });
  auto* tool = new WorldMarkTool(bench, *marks, &mode);
  bench.connectImageView(tool);
  QObject::connect(&cameras, &CameraDocks::viewCreated, tool, &WorldMarkTool::attach);
  // The images are free for the grid while another page is in front.
  QObject::connect(&mode, &CalibrationMode::pageShown, marks, [marks](const QString& page) {
    marks->setClicksPlacePoint(page == kWorldPage);
  });
  QObject::connect(&mode, &CalibrationMode::imageClicksTakenOver, marks,
                   [marks] { marks->setClicksPlacePoint(false); });
  QObject::connect(marks, &WorldMarks::changed, &mode, [bench, marks] {
    if (marks->clicksPlacePoint()) {
      bench.action("actionLearnColor")->setChecked(false);
    }
  });
  bench.onTriggered("actionCalibrateWorld", marks, [&mode] { mode.open(kWorldPage); });
  bench.requireRun({"actionCalibrateWorld"});
}

} // namespace dewpoint::ui
