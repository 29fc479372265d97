// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace dewpoint::experiment {

/// Purpose of a block of seeds.
enum class SeedPurpose { Tuning, Validation, Reporting, Reserve };

/// Range of seeds from `first` to `last`, inclusive. The blocks apply to every study: the accuracy
/// suite, people, boxes, the papers' experiments and wand calibration.
struct SeedBlock {
  SeedPurpose purpose = SeedPurpose::Tuning;
  std::string_view name; ///< name of the block, for example "tuning"
  std::uint64_t first = 0;
  std::uint64_t last = 0;
  std::string_view description; ///< what the seeds are used for, and when their results may be read
};

/// First seed of tuning runs, whose results may be read at any time.
inline constexpr std::uint64_t kFirstTuningSeed = 1;
/// First seed of reported results, in the suite and in every study. If a result with these seeds
/// leads to a change in a method or in the tables, the block is used up. It then becomes part of
/// the validation block, and the next thousand seeds of the reserve become the reporting block.
inline constexpr std::uint64_t kFirstReportingSeed = 1006001;
inline constexpr std::uint64_t kLastReportingSeed = kFirstReportingSeed + 999;

/// All blocks, in ascending order and without gaps.
inline constexpr std::array<SeedBlock, 4> kSeedBlocks{{
    {SeedPurpose::Tuning, "tuning", 0, 1000000,
     "Methods and their constants are chosen on these; results on them are not quoted."},
    {SeedPurpose::Validation, "validation", 1000001, kFirstReportingSeed - 1,
     "A finished change is checked on these before it is reported. They hold all former reporting "
     "blocks, which were looked at (from 1000001, 1002001, 1004001 and 1005001 on)."},
    {SeedPurpose::Reporting, "reporting", kFirstReportingSeed, kLastReportingSeed,
     "The tables of the documentation; no method was changed after a look at them."},
    {SeedPurpose::Reserve, "reserve", kLastReportingSeed + 1,
     std::numeric_limits<std::uint64_t>::max(),
     "Nobody looks at these; the next reporting block is taken from their beginning."},
}};

/// Returns the block that contains a seed.
const SeedBlock& seedBlockOf(std::uint64_t seed);

/// Returns whether the list is not empty and all its seeds are in the reporting block, which is
/// reserved for reported results.
bool areReportingSeeds(const std::vector<std::uint64_t>& seeds);

/// Describes the seeds (ascending, without duplicates) and their block, with a warning unless all
/// are in the reporting block: "1006001 to 1006020, 20 in all: reporting seeds, ...".
std::string describeSeeds(const std::vector<std::uint64_t>& seeds);
/// Describes `count` seeds from `first` on and their block, with a warning unless all are in the
/// reporting block.
std::string describeSeeds(std::uint64_t first, int count);

} // namespace dewpoint::experiment
