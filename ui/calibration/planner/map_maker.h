// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/planning/rig_map.h"

#include <QObject>

#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

namespace dewpoint::ui {

/// Makes maps of a rig in a thread of its own. While it is busy, only the newest order waits: maps
/// follow a hand that drags a camera as fast as they can be made.
class MapMaker : public QObject {
  Q_OBJECT
public:
  struct Order {
    VolumeGrid grid;
    double pixelSigma = 0.5;
    CameraRig rig;

    bool operator==(const Order&) const = default;
  };

  explicit MapMaker(QObject* parent = nullptr);
  ~MapMaker() override; ///< waits for the map under way: some milliseconds

  /// An order like the one before it is left out.
  void ask(const Order& order);

Q_SIGNALS:
  void made(std::shared_ptr<const dewpoint::calibration::RigMap> map);

private:
  void work(const std::stop_token& stop);

  std::optional<Order> last_; ///< of the window's thread
  std::mutex mutex_;
  std::condition_variable_any asked_;
  std::optional<Order> waiting_; ///< guarded by mutex_
  std::jthread thread_;          // last: it uses the rest
};

} // namespace dewpoint::ui
