// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/connected_cameras.h"
#include "ui/jobs/latest_job.h"

#include <QObject>
#include <QString>

#include <map>
#include <string>
#include <vector>

namespace dewpoint::ui {

class DeviceWatch;
class Document;

/// Sets the controls of connected devices whenever their values in the project change, for example
/// while a slider is dragged or when a change is undone. Works in another thread, and skips values
/// that have changed again meanwhile.
class ControlSync : public QObject {
  Q_OBJECT
public:
  ControlSync(Document& document, DeviceWatch& watch, QObject* parent = nullptr);

  /// Stores the current values of a device's controls. If the project no longer sets a control
  /// after an undo, the control gets its stored value back.
  void rememberControls(const std::string& path,
                        const std::vector<capture::DeviceControl>& controls);

Q_SIGNALS:
  /// Emitted when controls were set. Other controls of the device may have changed as a
  /// consequence.
  void controlsWritten();
  /// Emitted with a sentence about a control that could not be set.
  void failed(const QString& sentence);

private:
  using ValuesByPath = std::map<std::string, capture::ControlValues>;
  /// Returns the values in the project, by device path.
  ValuesByPath wanted() const;
  void apply();

  Document& document_;
  DeviceWatch& watch_;
  ValuesByPath applied_; ///< values that the devices have, as far as the project sets them
  ValuesByPath before_;  ///< values before the project set them
  LatestJob job_{LatestJob::SupersededJob::Kept};
};

} // namespace dewpoint::ui
