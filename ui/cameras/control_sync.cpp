// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cameras/control_sync.h"

#include "core/project/project.h"
#include "core/setup/connected_cameras.h"
#include "core/setup/new_project/project_devices.h"
#include "ui/cameras/device_watch.h"
#include "ui/document/document.h"
#include "ui/text/error_sentence.h"

#include <utility>

namespace dewpoint::ui {

ControlSync::ControlSync(Document& document, DeviceWatch& watch, QObject* parent)
    : QObject(parent), document_(document), watch_(watch) {
  connect(&document_, &Document::projectReplaced, this, [this] { applied_ = wanted(); });
  connect(&watch_, &DeviceWatch::changed, this, [this] {
    for (const auto& [path, values] : wanted()) {
      applied_.try_emplace(path, values); // set by its connection
    }
  });
  connect(&document_, &Document::changed, this, [this](const ProjectChanges& changes) {
    if (changes.sourcesChanged) {
      applied_ = wanted(); // the cameras are opened again
    } else if (changes.controlsChanged) {
      apply();
    }
  });
}

void ControlSync::rememberControls(const std::string& path,
                                   const std::vector<capture::DeviceControl>& controls) {
  const capture::ControlValues set = applied_[path];
  const capture::ControlValues due = wanted()[path]; // perhaps set, but not reported yet
  for (const capture::DeviceControl& control : controls) {
    if (!set.contains(control.name) && !due.contains(control.name)) {
      before_[path][control.name] = control.value;
    }
  }
}

ControlSync::ValuesByPath ControlSync::wanted() const {
  ValuesByPath values;
  const Project& project = document_.project();
  const auto matches = matchProjectDevices(project, watch_.devices());
  for (std::size_t k = 0; k < matches.size(); ++k) {
    if (matches[k].deviceIndex) {
      values[watch_.devices()[*matches[k].deviceIndex].path] = project.cameras[k].device.controls;
    }
  }
  return values;
}

void ControlSync::apply() {
  const ValuesByPath all = wanted();
  ValuesByPath changed;
  for (const auto& [path, values] : all) {
    const capture::ControlValues& has = applied_[path];
    capture::ControlValues& set = changed[path];
    for (const auto& [name, value] : values) {
      const auto present = has.find(name);
      if (present == has.end() || present->second != value) {
        set[name] = value;
      }
    }
    for (const auto& [name, value] : has) {
      const auto before = before_[path].find(name);
      if (!values.contains(name) && before != before_[path].end()) {
        set[name] = before->second;
      }
    }
  }
  std::erase_if(changed, [](const auto& one) { return one.second.empty(); });
  if (changed.empty()) {
    return;
  }
  job_.start([this, access = watch_.deviceAccess(), all, changed](const BackgroundJob::Progress&) {
    std::vector<Error> errors;
    for (const auto& [path, values] : changed) {
      for (Error& error : capture::applyControls(*access, path, values)) {
        errors.push_back(std::move(error));
      }
    }
    return [this, all, errors] {
      for (const auto& [path, values] : all) {
        applied_[path] = values;
      }
      Q_EMIT controlsWritten();
      if (!errors.empty()) {
        Q_EMIT failed(errorText(errors.front()));
      }
    };
  });
}

} // namespace dewpoint::ui
