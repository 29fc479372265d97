// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/offscreen_vtk.h"

#include "ui/view3d/gl_context.h"

#include <vtkCallbackCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkGenericRenderWindowInteractor.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLState.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtk_glew.h>

#include <string>

namespace dewpoint::ui {
namespace {

/// Per pixel: thin lines are as wide everywhere. As fast by software as smoothing afterwards
/// (FXAA).
constexpr int kSamples = 4;

/// Debian's GLEW knows GLX only: on Wayland or EGL it reports "no GLX display" after having loaded
/// every function it needs. That is no failure.
class GenericWindow : public vtkGenericOpenGLRenderWindow {
public:
  static GenericWindow* New();
  vtkTypeMacro(GenericWindow, vtkGenericOpenGLRenderWindow)

      void OpenGLInitContext() override {
    if (this->Initialized) {
      return;
    }
    glewExperimental = GL_TRUE;
    const GLenum result = glewInit();
    const bool loaded = result == GLEW_OK || result == GLEW_ERROR_NO_GLX_DISPLAY;
    this->GlewInitValid = loaded;
    if (loaded) {
      this->Initialized = true;
    }
  }
};
vtkStandardNewMacro(GenericWindow);

vtkSmartPointer<vtkCallbackCommand> observer(void* client, void (*call)(vtkObject*, unsigned long,
                                                                        void*, void*)) {
  auto command = vtkSmartPointer<vtkCallbackCommand>::New();
  command->SetClientData(client);
  command->SetCallback(call);
  return command;
}

} // namespace

class OffscreenVtk::Context {
public:
  Context(OffscreenVtk* owner, vtkRenderer* renderer) : owner_(owner), renderer_(renderer) {}
  ~Context();

  bool start();
  QImage render(QSize size);
  void sendPointerEvent(PointerEvent event, QPoint position, bool shift, bool control);

  std::string reason;

private:
  void makeWindow();
  QImage readBack(QSize size);

  OffscreenVtk* owner_;
  vtkRenderer* renderer_;
  GlContext gl_;
  vtkSmartPointer<GenericWindow> window_;
  vtkSmartPointer<vtkGenericRenderWindowInteractor> interactor_;
  QSize size_{1, 1};
};

OffscreenVtk::Context::~Context() {
  if (!window_) {
    return;
  }
  gl_.makeCurrent();
  interactor_->SetRenderWindow(nullptr);
  window_->Finalize();
  window_->RemoveRenderer(renderer_);
  renderer_->SetRenderWindow(nullptr);
  interactor_ = nullptr;
  window_ = nullptr;
  gl_.doneCurrent();
}

bool OffscreenVtk::Context::start() {
  reason = gl_.start();
  if (reason.empty()) {
    makeWindow();
  }
  return reason.empty();
}

void OffscreenVtk::Context::makeWindow() {
  window_ = vtkSmartPointer<GenericWindow>::New();
  window_->SetMultiSamples(kSamples);
  window_->SetFrameBlitModeToNoBlit();
  window_->SetReadyForRendering(false);
  window_->AddObserver(vtkCommand::WindowMakeCurrentEvent,
                       observer(this, [](vtkObject*, unsigned long, void* client, void*) {
                         static_cast<Context*>(client)->gl_.makeCurrent();
                       }));
  window_->AddObserver(vtkCommand::WindowIsCurrentEvent,
                       observer(this, [](vtkObject*, unsigned long, void* client, void* data) {
                         *static_cast<bool*>(data) = static_cast<Context*>(client)->gl_.isCurrent();
                       }));
  window_->AddObserver(vtkCommand::WindowSupportsOpenGLEvent,
                       observer(this, [](vtkObject*, unsigned long, void*, void* data) {
                         *static_cast<int*>(data) = 1;
                       }));
  window_->AddRenderer(renderer_);

  interactor_ = vtkSmartPointer<vtkGenericRenderWindowInteractor>::New();
  interactor_->SetRenderWindow(window_);
  interactor_->EnableRenderOff();
  vtkNew<vtkInteractorStyleTrackballCamera> style;
  style->AutoAdjustCameraClippingRangeOff();
  interactor_->SetInteractorStyle(style);
  interactor_->AddObserver(vtkCommand::RenderEvent,
                           observer(this, [](vtkObject*, unsigned long, void* client, void*) {
                             const auto* self = static_cast<Context*>(client);
                             if (self->owner_->onCameraMoved) {
                               self->owner_->onCameraMoved();
                             }
                           }));
  interactor_->Initialize();

  gl_.makeCurrent();
  window_->SetMapped(1);
  window_->SetReadyForRendering(true);
  window_->OpenGLInit();
}

QImage OffscreenVtk::Context::render(QSize size) {
  gl_.makeCurrent();
  if (size != size_) {
    size_ = size;
    window_->SetSize(size.width(), size.height());
    interactor_->UpdateSize(size.width(), size.height());
  }
  window_->Render();
  return readBack(size);
}

QImage OffscreenVtk::Context::readBack(QSize size) {
  vtkOpenGLFramebufferObject* frame = window_->GetDisplayFramebuffer();
  if (frame == nullptr || frame->GetFBOIndex() == 0) {
    return {};
  }
  // RGB32 leaves out alpha, which VTK sets to 0 on the background.
  QImage picture(size, QImage::Format_RGB32);
  vtkOpenGLState* state = window_->GetState();
  state->PushReadFramebufferBinding();
  frame->Bind(GL_READ_FRAMEBUFFER);
  glReadBuffer(GL_COLOR_ATTACHMENT0);
  state->vtkglPixelStorei(GL_PACK_ALIGNMENT, 4);
  glReadPixels(0, 0, size.width(), size.height(), GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV,
               picture.bits());
  state->PopReadFramebufferBinding();
  return picture.mirrored();
}

void OffscreenVtk::Context::sendPointerEvent(PointerEvent event, QPoint position, bool shift,
                                             bool control) {
  interactor_->SetEventInformationFlipY(position.x(), position.y(), control ? 1 : 0, shift ? 1 : 0);
  switch (event) {
  case PointerEvent::Move:
    interactor_->MouseMoveEvent();
    break;
  case PointerEvent::LeftPress:
    interactor_->LeftButtonPressEvent();
    break;
  case PointerEvent::LeftRelease:
    interactor_->LeftButtonReleaseEvent();
    break;
  case PointerEvent::MiddlePress:
    interactor_->MiddleButtonPressEvent();
    break;
  case PointerEvent::MiddleRelease:
    interactor_->MiddleButtonReleaseEvent();
    break;
  case PointerEvent::RightPress:
    interactor_->RightButtonPressEvent();
    break;
  case PointerEvent::RightRelease:
    interactor_->RightButtonReleaseEvent();
    break;
  case PointerEvent::WheelUp:
    interactor_->MouseWheelForwardEvent();
    break;
  case PointerEvent::WheelDown:
    interactor_->MouseWheelBackwardEvent();
    break;
  }
}

OffscreenVtk::OffscreenVtk(vtkRenderer* renderer)
    : context_(std::make_unique<Context>(this, renderer)) {}

OffscreenVtk::~OffscreenVtk() = default;

bool OffscreenVtk::start() {
  return context_->start();
}

const std::string& OffscreenVtk::startError() const {
  return context_->reason;
}

QImage OffscreenVtk::render(QSize size) {
  return context_->render(size);
}

void OffscreenVtk::sendPointerEvent(PointerEvent event, QPoint position, bool shift, bool control) {
  context_->sendPointerEvent(event, position, shift, control);
}

} // namespace dewpoint::ui
