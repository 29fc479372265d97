// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/video_installer.h"

#include "core/project/project.h"
#include "core/session/session.h"
#include "ui/cameraview/camera_view.h"
#include "ui/document/document.h"
#include "ui/document/method_presentation.h"
#include "ui/export/export_destination.h"
#include "ui/export/video_dialog.h"
#include "ui/selection/selection.h"
#include "ui/text/camera_names.h"
#include "ui/timeline/timeline.h"
#include "ui/view3d/birds_eye_view.h"
#include "ui/widgets/message_bar.h"
#include "ui/workbench/workbench.h"

#include <QMainWindow>

#include <algorithm>
#include <utility>

namespace dewpoint::ui {

namespace {

constexpr int kHeightIfUnknown = 480;          ///< pixels
constexpr double kAspectIfUnknown = 4.0 / 3.0; ///< of an image whose size is not known yet

/// Name of the folder of a take, or of the project.
QString recordingOf(const Project& project) {
  const std::string stem = project.file.stem().string();
  return QString::fromStdString(stem == "project" ? project.file.parent_path().filename().string()
                                                  : stem);
}

std::vector<VideoView> cameraViewsOf(const Workbench& bench) {
  const auto& cameras = bench.document.project().cameras;
  std::vector<VideoView> views;
  for (const CameraView* shown : bench.window.findChildren<CameraView*>()) {
    const auto index = static_cast<std::size_t>(shown->camera());
    const bool isListed = std::ranges::any_of(
        views, [&](const VideoView& one) { return one.camera == shown->camera(); });
    if (index >= cameras.size() || isListed) {
      continue;
    }
    const Intrinsics& size = cameras[index].camera.intrinsics;
    const bool isKnown = size.width > 0 && size.height > 0;
    views.push_back(
        {.camera = shown->camera(),
         .title = cameraName(cameras[index].camera.name, index),
         .options = shown->options(),
         .aspect = isKnown ? static_cast<double>(size.width) / size.height : kAspectIfUnknown,
         .height = isKnown ? size.height : kHeightIfUnknown});
  }
  std::ranges::sort(views, {}, [](const VideoView& view) { return view.camera; });
  return views;
}

void addSceneTo(VideoSources& offer, const Workbench& bench) {
  const auto* scene = bench.window.findChild<BirdsEyeView*>();
  if (scene == nullptr || !scene->hasImage() ||
      !bench.document.methodPresentation().hasBirdsEyeView) {
    return;
  }
  const double aspect = static_cast<double>(scene->width()) / std::max(1, scene->height());
  VideoView view{.camera = std::nullopt,
                 .title = BirdsEyeView::tr("Bird's-eye view"),
                 .options = {},
                 .aspect = std::clamp(aspect, 1.0, 16.0 / 9.0),
                 .height = kHeightIfUnknown};
  if (!offer.views.empty()) {
    view.options.volume = offer.views.front().options.volume;
    view.height = std::ranges::max(offer.views, {}, &VideoView::height).height;
  }
  offer.views.push_back(std::move(view));
  offer.birdsEyeView = scene;
}

VideoSources offerOf(const Workbench& bench, const TimelineModel& time) {
  VideoSources offer;
  offer.session = bench.session.session();
  if (offer.session == nullptr) {
    return offer;
  }
  offer.views = cameraViewsOf(bench);
  addSceneTo(offer, bench);
  offer.recordingName = recordingOf(bench.document.project());
  offer.frames = [&time] {
    std::vector<FrameTime> frames;
    for (std::int64_t frame = time.history.firstFrame; frame <= time.history.lastFrame; ++frame) {
      frames.push_back({frame, time.secondsOf(frame)});
    }
    return frames;
  };
  offer.lastTrackedFrame = time.history.newestTrackedFrame;
  offer.framesPerSecond = time.framesPerSecond;
  return offer;
}

QString videoFile(const ExportDestination& destination) {
  return destination.proposedFile(QStringLiteral("video"));
}

VideoDialog* makeVideoDialog(const Workbench& bench, const TimelineModel& time) {
  auto* dialog = new VideoDialog([bench, &time] { return offerOf(bench, time); }, &bench.window);
  MessageBar* messages = &bench.messages;
  QObject::connect(dialog, &VideoDialog::exportEnded, messages,
                   [dialog, messages](const QString& text) {
                     if (!dialog->isVisible()) {
                       messages->showNotice(text);
                     }
                   });
  QObject::connect(dialog, &VideoDialog::failed, messages, [dialog, messages](const QString& text) {
    if (!dialog->isVisible()) {
      messages->showError(text);
    }
  });
  ExportDestination* destination = ExportDestination::forWorkbench(bench);
  const auto resetChoices = [dialog, destination] {
    dialog->resetChoices(videoFile(*destination));
  };
  QObject::connect(&bench.document, &Document::projectReplaced, dialog, resetChoices);
  QObject::connect(dialog, &VideoDialog::fileWritten, destination,
                   &ExportDestination::rememberFolder);
  resetChoices();
  QObject::connect(&bench.session, &SessionController::runEnded, dialog, [dialog] {
    dialog->stop(VideoDialog::tr("The export was stopped because the run has ended."));
  });
  QObject::connect(&bench.session, &SessionController::runAboutToRestart, dialog, [dialog] {
    dialog->stop(VideoDialog::tr("The export was stopped because the run was restarted."));
  });
  const auto refresh = [dialog] {
    if (dialog->isVisible()) {
      dialog->refresh();
    }
  };
  QObject::connect(&bench.session, &SessionController::opened, dialog, refresh);
  QObject::connect(&bench.session, &SessionController::closed, dialog, refresh);
  return dialog;
}

} // namespace

void installVideoExport(const Workbench& bench, const Timeline& timeline) {
  bench.onTriggered("actionExportVideo", &bench.window, [bench, &timeline] {
    auto* dialog = bench.window.findChild<VideoDialog*>();
    const TimelineModel& time = timeline.model();
    if (dialog == nullptr) {
      dialog = makeVideoDialog(bench, time);
    }
    dialog->proposeFile(videoFile(*ExportDestination::forWorkbench(bench)));
    const auto& range = bench.selection.selectedRange();
    dialog->setSelectedRange(
        range ? std::optional(std::pair(time.secondsOf(range->first), time.secondsOf(range->last)))
              : std::nullopt);
    Workbench::presentDialog(dialog);
  });
  bench.requireRun({"actionExportVideo"});
}

} // namespace dewpoint::ui
