// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/motion_csv.h"

#include "core/trajectory/csv_line.h"

namespace dewpoint::trajectory {

std::string motionCsv(std::span<const MotionLog::Row> rows) {
  std::string text = "time_s,frame,target,x_m,y_m,z_m,sigma_x_m,sigma_y_m,sigma_z_m,speed_m_s,"
                     "cameras,existence,valid\n";
  for (const MotionLog::Row& row : rows) {
    const TrajectorySample& sample = row.sample;
    CsvLine line(text);
    line.put(sample.time).put(sample.frame).put(std::string_view(sample.target));
    for (int axis = 0; axis < 3; ++axis) {
      line.put(sample.position[axis]);
    }
    for (int axis = 0; axis < 3; ++axis) {
      line.put(positionSigma(sample, axis));
    }
    line.put(row.speed)
        .put(sample.cameraCount)
        .put(sample.existenceProbability)
        .put(sample.isValid ? 1 : 0);
  }
  return text;
}

} // namespace dewpoint::trajectory
