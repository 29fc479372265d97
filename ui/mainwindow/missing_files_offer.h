// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/project_loader.h"
#include "ui/workbench/workbench.h"

namespace dewpoint::ui {

/// Offers to locate moved files without which a project cannot be opened. The project is then
/// opened with the new paths. The project file contains these paths once the user saves the
/// project.
class MissingFilesOffer : public QObject {
  Q_OBJECT
public:
  explicit MissingFilesOffer(const Workbench& bench);

private:
  void offer(const OpenRequest& request, const MissingFiles& missing);
  void locate(const OpenRequest& request, const MissingFiles& missing);

  Workbench bench_;
};

} // namespace dewpoint::ui
