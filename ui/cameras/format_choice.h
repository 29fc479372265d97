// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/connected_cameras.h"

#include <QWidget>

#include <vector>

class QComboBox;
class QLabel;

namespace dewpoint::ui {

/// Combo boxes with the pixel formats, image sizes and frame rates that a device offers, from which
/// the user selects what to request. Each choice can also be left to the device.
class FormatChoice : public QWidget {
  Q_OBJECT
public:
  explicit FormatChoice(QWidget* parent = nullptr);

  /// Shows the formats that a device offers, and selects the one that the project requests.
  void setFormats(const std::vector<capture::OfferedFormat>& offered,
                  const capture::DeviceFormat& requested);

Q_SIGNALS:
  /// Emitted when the user has chosen another format.
  void formatChosen(const dewpoint::capture::DeviceFormat& format);

private:
  void retranslateUi();
  void fill();
  void apply();
  /// Returns the sizes of the requested pixel format, or those of all formats.
  std::vector<capture::OfferedSize> sizes() const;

  QLabel* pixelLabel_;
  QComboBox* pixel_;
  QLabel* sizeLabel_;
  QComboBox* size_;
  QLabel* rateLabel_;
  QComboBox* rate_;
  std::vector<capture::OfferedFormat> offered_;
  capture::DeviceFormat requested_;
};

} // namespace dewpoint::ui
