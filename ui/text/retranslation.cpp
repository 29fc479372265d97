// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/retranslation.h"

#include <QEvent>
#include <QWidget>

#include <utility>

namespace dewpoint::ui {

namespace {

class LanguageChangeFilter : public QObject {
public:
  LanguageChangeFilter(QWidget* widget, std::function<void()> say)
      : QObject(widget), say_(std::move(say)) {
    widget->installEventFilter(this);
  }

  bool eventFilter(QObject* watched, QEvent* event) override {
    if (watched == parent() && event->type() == QEvent::LanguageChange) {
      say_();
    }
    return false;
  }

private:
  std::function<void()> say_;
};

} // namespace

void onRetranslate(QWidget* widget, std::function<void()> say) {
  say();
  new LanguageChangeFilter(widget, std::move(say)); // the widget owns it
}

} // namespace dewpoint::ui
