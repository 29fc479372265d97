// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <vtkOpenGLRenderer.h>

namespace dewpoint::ui {

/// Renderer that blends translucent objects in the order in which they were added, so that the
/// scene controls what covers what. VTK's own method (depth peeling) sorts them by depth in
/// additional passes. With it, a cloud inside a shell would not be visible, and rendering with
/// software OpenGL would be slower.
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
