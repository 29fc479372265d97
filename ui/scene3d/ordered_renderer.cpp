// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scene3d/ordered_renderer.h"

#include <vtkObjectFactory.h>

namespace dewpoint::ui {

vtkStandardNewMacro(OrderedRenderer);

void OrderedRenderer::DeviceRenderTranslucentPolygonalGeometry(vtkFrameBufferObjectBase*) {
  LastRenderingUsedDepthPeeling = 0; // else translucent actors would write depths
  UpdateTranslucentPolygonalGeometry();
}

} // namespace dewpoint::ui
