// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <vtkOpenGLRenderer.h>

namespace dewpoint::ui {

/// Blends translucent things in the order in which they were added, so that a scene decides what
/// lies over what. VTK's own way mixes all of them by their depth, in pictures of their own: a
/// cloud inside of a shell is lost there, and software OpenGL takes longer.
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
