// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/guide/guide_installer.h"

#include "core/setup/new_project/new_project.h"
#include "ui/calibration/calibration_mode.h"
#include "ui/calibration/guide/calibration_guide.h"
#include "ui/calibration/guide/guide_page.h"
#include "ui/calibration/guide/step_strip.h"
#include "ui/document/document.h"
#include "ui/widgets/message_bar.h"

#include <QAction>

#include <memory>
#include <utility>

namespace dewpoint::ui {
namespace {

constexpr QLatin1String kGuidePage("guidePage");

void openStep(const Workbench& bench, CalibrationMode& mode, GuideStep step) {
  switch (step) {
  case GuideStep::ImportFile:
    bench.action("actionImportCalibration")->trigger();
    return;
  case GuideStep::LearnBall:
    bench.action("actionLearnColor")->trigger();
    return;
  case GuideStep::PrintBoard:
  case GuideStep::LensesByBoard:
  case GuideStep::BoardInVolume:
    mode.open(QStringLiteral("boardPage"));
    return;
  case GuideStep::WaveWand:
    mode.open(QStringLiteral("wandPage"));
    return;
  case GuideStep::Floor:
  case GuideStep::MeasuredLength:
    mode.open(QStringLiteral("worldPage"));
    return;
  case GuideStep::FieldOfView:
  case GuideStep::GridOnFloor:
  case GuideStep::MeasurePoints:
  case GuideStep::ComputeCameras:
  case GuideStep::RoughPositions:
    break;
  }
  mode.open(QStringLiteral("handPage"));
}

bool lacksCalibration(const Document& document) {
  return document.methodFamily().needsCalibration && hasGuessedPose(document.project());
}

QString question() {
  return GuidePage::tr(
      "The camera positions are only guesses. Calibrate the cameras to get correct 3D positions.");
}

/// The question stays until it is answered: it is the next step.
void askForCalibration(const Workbench& bench) {
  QAction* guide = bench.action("actionCalibrate");
  bench.messages.showLastingQuestion(
      question(), {{GuidePage::tr("Calibrate…"), [guide] { guide->trigger(); }}});
}

/// Asks while the calibration is lacking. The user may close the question: then it is asked again
/// only if the calibration was there meanwhile (Undo), or if a method is chosen that needs it.
void followCalibration(const Workbench& bench, QObject* context) {
  const auto lacked = std::make_shared<bool>(false);
  const auto follow = [bench, lacked](bool asksAgain) {
    const bool lacks = lacksCalibration(bench.document);
    const bool isNew = !std::exchange(*lacked, lacks);
    if (!lacks) {
      bench.messages.withdrawQuestion(question());
    } else if (isNew || asksAgain) {
      askForCalibration(bench);
    }
  };
  QObject::connect(&bench.document, &Document::methodChanged, context, [follow] { follow(true); });
  QObject::connect(&bench.session, &SessionController::opened, context, [follow] { follow(true); });
  QObject::connect(&bench.document, &Document::calibrationChanged, context,
                   [follow] { follow(false); });
  QObject::connect(&bench.document, &Document::projectReplaced, context, [bench, lacked] {
    *lacked = lacksCalibration(bench.document); // asked when its run begins
    bench.messages.withdrawQuestion(question());
  });
}

} // namespace

void installCalibrationGuide(const Workbench& bench, CalibrationMode& mode) {
  auto* guide = new CalibrationGuide(bench.document, &mode);
  mode.addPage(new GuidePage(*guide, bench.cameras), [] { return GuidePage::tr("Guide"); });
  mode.setHeader(new StepStrip(*guide));
  QObject::connect(guide, &CalibrationGuide::openRequested, &mode,
                   [bench, &mode](GuideStep step) { openStep(bench, mode, step); });
  QObject::connect(&mode, &CalibrationMode::pageShown, guide, [guide](const QString& page) {
    if (page == kGuidePage) {
      guide->markOpened();
    }
  });
  bench.onTriggered("actionCalibrate", guide, [&mode] { mode.open(kGuidePage); });
  bench.requireRun({"actionCalibrate"});
  followCalibration(bench, guide);
}

} // namespace dewpoint::ui
