// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/workbench/volume_layer.h"

#include "core/project/project.h"
#include "ui/document/document.h"
#include "ui/document/method_presentation.h"
#include "ui/workbench/workbench.h"

#include <QAction>

namespace dewpoint::ui {

void connectVolume(const Workbench& bench, QObject* view,
                   const std::function<void(const std::optional<WorldBox>&)>& show) {
  const Document* document = &bench.document;
  const QAction* layer = bench.action("actionShowVolumeOfInterest");
  const auto update = [document, layer, show] {
    const bool isShown = layer->isChecked() && document->methodPresentation().limitsSearchToVolume;
    show(isShown ? document->project().volumeOfInterest : std::nullopt);
  };
  QObject::connect(document, &Document::volumeChanged, view, update);
  QObject::connect(document, &Document::methodChanged, view, update);
  QObject::connect(document, &Document::projectReplaced, view, update);
  QObject::connect(layer, &QAction::toggled, view, update);
  update();
}

} // namespace dewpoint::ui
