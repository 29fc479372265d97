// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QImage>
#include <QPoint>
#include <QSize>

#include <functional>
#include <memory>
#include <string>

class vtkRenderer;

namespace dewpoint::ui {

/// Renders a VTK scene in an OpenGL context of its own that belongs to no window, and hands out
/// pictures. Only for the GUI thread. No VTK or OpenGL header is needed to use it.
class OffscreenVtk {
public:
  enum class Pointer {
    Move,
    LeftPress,
    LeftRelease,
    MiddlePress,
    MiddleRelease,
    RightPress,
    RightRelease,
    WheelUp,
    WheelDown
  };

  explicit OffscreenVtk(vtkRenderer* renderer);
  ~OffscreenVtk();
  OffscreenVtk(const OffscreenVtk&) = delete;
  OffscreenVtk& operator=(const OffscreenVtk&) = delete;

  /// Makes the context; to be called once. False when there is no usable OpenGL: `reason()` then
  /// says why, in English, and nothing else may be called.
  bool start();
  const std::string& reason() const;

  /// One picture of this size in device pixels.
  QImage render(QSize size);

  /// Feeds the trackball camera; `position` in device pixels from the top left corner.
  void pointer(Pointer what, QPoint position, bool shift, bool control);
  /// Called when the trackball has moved the camera.
  std::function<void()> onCameraMoved;

private:
  class Context;
  std::unique_ptr<Context> context_;
};

} // namespace dewpoint::ui
