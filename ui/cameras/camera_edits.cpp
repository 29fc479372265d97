// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cameras/camera_edits.h"

#include "core/project/project.h"
#include "core/setup/calibration/calibrated_project.h"
#include "ui/document/document.h"
#include "ui/text/error_sentence.h"

#include <memory>
#include <optional>
#include <utility>

namespace dewpoint::ui {

namespace {

/// What was found at some locations, in their order, or the first problem.
Result<std::vector<CameraSource>> examinedSources(const QStringList& locations) {
  std::vector<CameraSource> sources;
  for (const QString& location : locations) {
    auto source = sourceAt(location.toStdString());
    if (!source) {
      return tl::make_unexpected(source.error());
    }
    sources.push_back(std::move(*source));
  }
  return sources;
}

} // namespace

CameraEdits::CameraEdits(Document& document, QObject* parent)
    : QObject(parent), document_(document) {
  connect(&document_, &Document::projectReplaced, this, [this] { ++projects_; });
}

void CameraEdits::setPending(int pending) {
  const bool before = isBusy();
  pending_ = pending;
  if (isBusy() != before) {
    Q_EMIT busyChanged(isBusy());
  }
}

void CameraEdits::examine(const QStringList& locations, std::function<void(Sources)> use) {
  setPending(pending_ + 1);
  jobs_.add([this, locations, use = std::move(use), project = projects_] {
    const auto sources = std::make_shared<Result<Sources>>(examinedSources(locations));
    return [this, use, project, sources] {
      setPending(pending_ - 1);
      if (project != projects_) {
        return;
      }
      if (*sources) {
        use(**sources);
      } else {
        Q_EMIT failed(errorText(sources->error()));
      }
    };
  });
}

void CameraEdits::edit(const QString& step, const std::function<Status(Project&)>& change) {
  Status changed;
  const auto edited = document_.editSources(step, [&](Project& project) {
    Project next = project;
    changed = change(next);
    if (changed) {
      project = std::move(next);
    }
  });
  const Status& result = changed ? edited : changed;
  if (!result) {
    Q_EMIT failed(errorText(result.error()));
  }
}

void CameraEdits::addLocations(const QStringList& locations, const QSize& size) {
  if (locations.isEmpty()) {
    return;
  }
  examine(locations, [this, size](Sources sources) {
    for (CameraSource& source : sources) {
      if (source.size.empty() && !size.isEmpty()) {
        source.size = {size.width(), size.height()};
      }
    }
    add(sources);
  });
}

void CameraEdits::add(const std::vector<CameraSource>& sources) {
  edit(tr("Add %n camera(s)", nullptr, static_cast<int>(sources.size())),
       [&](Project& project) { return addCameras(project, sources); });
}

void CameraEdits::remove(int camera) {
  edit(tr("Remove camera"), [&](Project& project) {
    return removeProjectCamera(project, static_cast<std::size_t>(camera));
  });
}

void CameraEdits::replace(int camera, const CameraSource& source) {
  edit(tr("Replace camera"), [&](Project& project) {
    return replaceSource(project, static_cast<std::size_t>(camera), source);
  });
}

void CameraEdits::replaceByLocation(int camera, const QString& location) {
  examine({location}, [this, camera](const Sources& sources) {
    if (camera < static_cast<int>(document_.project().cameras.size())) {
      replace(camera, sources.front());
    }
  });
}

void CameraEdits::swapSources(int camera, int other) {
  edit(tr("Exchange cameras"), [&](Project& project) {
    setup::swapSources(project, static_cast<std::size_t>(camera), static_cast<std::size_t>(other));
    return Status();
  });
}

void CameraEdits::rename(int camera, const QString& name) {
  edit(tr("Rename camera"), [&](Project& project) {
    project.cameras[static_cast<std::size_t>(camera)].camera.name = name.trimmed().toStdString();
    return Status();
  });
}

void CameraEdits::setOrientation(int camera, int rotateDegrees, bool mirrored) {
  edit(tr("Rotate images"), [&](Project& project) {
    project = withImageOrientation(std::move(project), static_cast<std::size_t>(camera),
                                   rotateDegrees, mirrored);
    return Status();
  });
}

void CameraEdits::crop(int camera, const ImageMargins& margins) {
  edit(tr("Crop images"), [&](Project& project) {
    return withImageCrop(project, static_cast<std::size_t>(camera), margins)
        .map([&](Project cropped) { project = std::move(cropped); });
  });
}

void CameraEdits::setFormats(const std::map<int, capture::DeviceFormat>& formats) {
  edit(tr("Change image format"), [&](Project& project) {
    for (const auto& [camera, format] : formats) {
      project.cameras[static_cast<std::size_t>(camera)].device.format = format;
    }
    return Status();
  });
}

void CameraEdits::setControl(int camera, const std::string& name, std::int64_t value) {
  const auto edited = document_.edit(
      tr("Change camera setting"),
      [&](Project& project) {
        project.cameras[static_cast<std::size_t>(camera)].device.controls[name] = value;
      },
      "control " + std::to_string(camera) + " " + name);
  if (!edited) {
    Q_EMIT failed(errorText(edited.error()));
  }
}

void CameraEdits::lockColors(const std::map<int, capture::ControlValues>& values) {
  const auto edited = document_.edit(tr("Lock colors"), [&](Project& project) {
    for (const auto& [camera, locked] : values) {
      auto& controls = project.cameras[static_cast<std::size_t>(camera)].device.controls;
      for (const auto& [name, value] : locked) {
        controls[name] = value;
      }
    }
  });
  if (!edited) {
    Q_EMIT failed(errorText(edited.error()));
  }
}

} // namespace dewpoint::ui
