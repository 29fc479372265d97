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

/// Renders a VTK scene in its own off-screen OpenGL context, and returns images. Use this class
/// only in the GUI thread. This header includes no VTK or OpenGL headers.
class OffscreenVtk {
public:
  enum class PointerEvent {
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

  /// Creates the OpenGL context; must be called once, first. Returns false if OpenGL is not usable.
  /// Then only `startError()` may be called, which returns the reason in English.
  bool start();
  const std::string& startError() const;

  /// Renders one image of this size in device pixels.
  QImage render(QSize size);

  /// Passes a mouse event to the trackball camera. `position` is in device pixels from the top left
  /// corner.
  void sendPointerEvent(PointerEvent event, QPoint position, bool shift, bool control);
  /// Function that is called when the user has moved the view with the mouse.
  std::function<void()> onCameraMoved;

private:
  class Context;
  std::unique_ptr<Context> context_;
};

} // namespace dewpoint::ui
