// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <vtkOpenGLRenderer.h>

namespace dewpoint::ui {

/// VTK renderer that blends translucent objects in the order in which they were added, so that the
/// scene controls which object covers which. VTK's own method (depth peeling) would hide a cloud
/// inside a shell, and would be slower with software OpenGL.
class OrderedRenderer : public vtkOpenGLRenderer {
public:
  static OrderedRenderer* New();
  vtkTypeMacro(OrderedRenderer, vtkOpenGLRenderer)

      void DeviceRenderTranslucentPolygonalGeometry(vtkFrameBufferObjectBase* frame) override;

  OrderedRenderer(const OrderedRenderer&) = delete;
  void operator=(const OrderedRenderer&) = delete;

protected:
  OrderedRenderer() = default;
  ~OrderedRenderer() override = default;
};

} // namespace dewpoint::ui
