// As which control a text was read. Only files of this folder include this.
#pragma once

#include "server/app/base/report.h"
#include "server/json/parse.h"
#include "server/json/profile_words.h"

namespace dripfeed::json {

inline Document control_document(const app::CheckReport& report) {
  return {{"title", report.control_title},
          {"kind", ir::name_of(report.kind)},
          {"g_system", kGSystemWords[static_cast<std::size_t>(report.g_system)]},
          {"feed_mode", kFeedModeWords[static_cast<std::size_t>(report.feed_mode)]},
          {"because_line", report.because_line},
          {"inferred", report.inferred}};
}

}  // namespace dripfeed::json
