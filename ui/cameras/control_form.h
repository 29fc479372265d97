// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/connected_cameras.h"

#include <QWidget>

#include <cstdint>
#include <string>
#include <vector>

class QFormLayout;

namespace dewpoint::ui {

/// Form with the controls of a device: a slider for a number, a check box, or a list. A control
/// that the device currently sets automatically is disabled and shows the value chosen by the
/// device.
class ControlForm : public QWidget {
  Q_OBJECT
public:
  explicit ControlForm(QWidget* parent = nullptr);

  /// Shows the controls of a device with their current values.
  void setControls(const std::vector<capture::DeviceControl>& controls);

Q_SIGNALS:
  /// Emitted when the user changes a control, including while a slider is dragged.
  void changed(const std::string& name, qint64 value);
  /// Emitted when a slider is released.
  void dragEnded();

protected:
  void changeEvent(QEvent* event) override; ///< translates the texts of the controls

private:
  QWidget* makeField(const capture::DeviceControl& control);
  QWidget* makeSlider(const capture::DeviceControl& control);
  void rebuild();
  void showValues();

  QFormLayout* form_;
  std::vector<capture::DeviceControl> controls_;
  bool isDragged_ = false;
};

} // namespace dewpoint::ui
