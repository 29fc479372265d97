// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/calibration/board/board.h"

#include <filesystem>
#include <string>
#include <vector>

namespace dewpoint::calibration {

/// A sheet of paper, millimeters, upright.
struct Paper {
  std::string name;
  double width = 0.0;
  double height = 0.0;
};

/// A4, A3 and letter.
const std::vector<Paper>& papers();

/// The paper of that name, in any case of letters; BadValue names `field` and those known.
Result<Paper> paperNamed(const std::string& name, const std::string& field = "--paper");

/// Writes the board in its true size as a PDF of one page, with a scale bar to check the print
/// with a ruler, and the text parseBoard() reads. Upright or lengthwise, as it fits. BadValue when
/// it does not fit the paper (with the largest square that would), FileUnwritable.
Status printBoard(const BoardDescription& board, const Paper& paper,
                  const std::filesystem::path& file);

} // namespace dewpoint::calibration
