// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/connected_cameras.h"
#include "ui/cameras/camera_parts.h"
#include "ui/workbench/workbench.h"

#include <QDialog>
#include <QTimer>

#include <vector>

class QDialogButtonBox;
class QLabel;
class QPushButton;

namespace dewpoint::ui {

class ProjectPane;
class SourcePane;

/// Dialog *Cameras*. The left side shows the cameras of the project, the right side the devices,
/// addresses and recordings that can be added. Changes take effect immediately and can be undone.
class CamerasDialog : public QDialog {
  Q_OBJECT
public:
  CamerasDialog(const Workbench& bench, const CameraParts& parts);

protected:
  void showEvent(QShowEvent* event)
      override; ///< starts the previews, which run only while the dialog is visible
  void hideEvent(QHideEvent* event) override;

private:
  void arrange();
  void connectSnapshots();
  void retranslateUi();
  void setMessage(const QString& text);
  void updateBandwidth();
  void useProposals();

  Workbench bench_;
  CameraParts parts_;
  ProjectPane* project_;
  SourcePane* sources_;
  QLabel* bandwidth_;
  QPushButton* fit_;
  QLabel* message_;
  QDialogButtonBox* buttons_;
  QTimer redraw_; ///< limits how often the images of the snapshots are drawn
  std::vector<capture::BandwidthShortage> shortages_;
};

} // namespace dewpoint::ui
